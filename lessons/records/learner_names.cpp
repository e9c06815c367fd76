#include "lessons/records/learner_names.h"

#include "textures/base/utf8.h"

namespace moontrace {

std::vector<std::string> PeopleAmong(const std::vector<LearnerEntry>& known) {
  std::vector<std::string> names;
  for (const LearnerEntry& learner : known) {
    if (!learner.simulated) names.push_back(learner.pseudonym);
  }
  return names;
}

std::string KeptName(std::string_view given, const std::vector<LearnerEntry>& known) {
  std::string kept;
  for (const LearnerEntry& learner : known) {
    if (learner.pseudonym == given) return std::string(given);
    if (learner.simulated || CaseFolded(learner.pseudonym) != CaseFolded(given)) continue;
    if (!kept.empty()) return std::string(given);
    kept = learner.pseudonym;
  }
  return kept.empty() ? std::string(given) : kept;
}

}  // namespace moontrace

#include "sim/app/learn_learner.h"

#include <ctime>
#include <optional>
#include <utility>
#include <vector>

#include "sim/app/learn_messages.h"
#include "textures/text_file.h"

namespace moontrace {

namespace {

/// Version of the question in say::AskConsent that a learner agreed to.
constexpr const char* kConsent = "tracks-1";
constexpr int kPoll = 50;  ///< [ms]

/// The next line that somebody types; none: there will be no more.
std::optional<std::string> Ask(LineReader& lines, LearnTeller& teller, const std::string& question,
                               const Console& console) {
  teller.Say(Priority::kText, question);
  teller.EndTurn();
  for (;;) {
    console.CheckStop();
    if (std::optional<std::string> line = lines.Next(kPoll)) return line;
    if (lines.ended()) return std::nullopt;
  }
}

std::string Trimmed(const std::string& line) {
  const auto begin = line.find_first_not_of(" \t");
  if (begin == std::string::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t") - begin + 1);
}

std::string WhoLearns(const LearnOptions& options, const std::vector<LearnerEntry>& known,
                      bool may_ask, LineReader& lines, LearnTeller& teller,
                      const Console& console) {
  if (!options.learner.empty()) return options.learner;
  std::vector<std::string> names;
  for (const LearnerEntry& learner : known) {
    if (!learner.simulated) names.push_back(learner.pseudonym);
  }
  if (names.size() == 1) return names.front();
  if (!may_ask) throw UsageError(say::NoLearner());
  const std::string question = names.empty() ? say::AskLearner() : say::AskWhich(names);
  for (;;) {
    const std::optional<std::string> line = Ask(lines, teller, question, console);
    if (!line) throw UsageError(say::NoLearner());
    if (std::string name = Trimmed(*line); !name.empty()) return name;
  }
}

bool MayKeepTracks(bool may_ask, LineReader& lines, LearnTeller& teller, const Console& console) {
  if (!may_ask) {
    teller.Remark(say::NoConsentAsked());
    return false;
  }
  std::string question = say::AskConsent();
  for (;;) {
    const std::optional<std::string> line = Ask(lines, teller, question, console);
    const std::string answer = line ? LowerCase(Trimmed(*line)) : "";
    const bool yes = answer == "yes" || answer == "y";
    if (!yes && answer != "no" && answer != "n" && !answer.empty()) {
      question = say::YesOrNo();
      continue;
    }
    teller.Say(Priority::kText, say::ConsentGiven(yes));
    return yes;
  }
}

}  // namespace

LearnMemory OpenMemory(const LearnOptions& options, const Course& course, bool may_ask,
                       LineReader& lines, LearnTeller& teller, const Console& console) {
  if (!Records::Available()) {
    teller.Say(Priority::kText, say::NoRecords());
    return {};
  }
  Records records =
      Records::Open(options.records.empty() ? Records::DefaultPath() : options.records);
  const std::string name = WhoLearns(options, records.Learners(), may_ask, lines, teller, console);
  std::optional<LearnerEntry> learner = records.Find(name);
  if (learner && learner->simulated) throw UsageError(say::SimulatedOnly(name));
  const bool fresh = !learner;
  if (fresh) {
    learner = LearnerEntry{name, static_cast<std::int64_t>(std::time(nullptr)), false, {}, false};
    records.AddLearner(*learner);
    learner->keeps_tracks = MayKeepTracks(may_ask, lines, teller, console);
    if (may_ask) records.SetConsent(name, learner->keeps_tracks, kConsent);
  }
  LearnMemory memory(std::move(records), *learner, course.id);
  teller.Say(Priority::kText, say::Learner(name, memory.trials(), fresh));
  return memory;
}

}  // namespace moontrace

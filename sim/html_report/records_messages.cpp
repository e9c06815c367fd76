#include "sim/html_report/records_messages.h"

#include <fmt/core.h>

#include "lessons/records/learner_history.h"
#include "lessons/records/report_facts.h"
#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string ReportsItself() { return "records cannot report: write moontrace report NAME"; }
std::string NoSubject(std::string_view action) {
  if (action == "import")
    return "records import lacks its file: write moontrace records import FILE";
  return fmt::format("records {0} lacks a learner: write moontrace records {0} NAME", action);
}

std::string NoConsentAnswer() {
  return "records consent lacks its answer: write yes or no behind the name";
}

std::string OnlyWith(std::string_view option, std::string_view action) {
  return fmt::format("{} goes with records {} only: leave it out", option, action);
}

std::string NoSuchLearner(std::string_view given, std::string_view nearest) {
  return fmt::format(
      "no learner \"{}\" in the records: {}\"moontrace records list\" names them", OneLine(given),
      nearest.empty() ? "" : fmt::format("did you mean {}? ", ShownPseudonym(nearest)));
}

std::string NobodyHasLearnt() { return "Nobody has learnt here yet. To begin: moontrace learn."; }

std::string LearnersOutcome(std::size_t count) {
  return fmt::format("{} in the records.", Counted(count, "learner", "learners"));
}

std::string LearnerLine(const LearnerEntry& learner, std::size_t trials) {
  return fmt::format("{}: {}{}, tracks {}, since {}", ShownPseudonym(learner.pseudonym),
                     Counted(trials, "trial", "trials"), learner.simulated ? ", simulated" : "",
                     learner.keeps_tracks ? "kept" : "not kept", DayOf(learner.since));
}

std::string Exported(bool anonymous) {
  return anonymous ? "Exported without name, dates, words and tracks to:"
                   : "Exported with all that is known to:";
}

std::string Imported(std::string_view name, std::size_t trials) {
  return fmt::format("Imported: {} of {}.", Counted(trials, "row", "rows"), ShownPseudonym(name));
}

std::string EraseNeedsYes(std::string_view name) {
  return fmt::format("nothing erased: add --yes to erase {} without being asked",
                     ShownPseudonym(name));
}

std::string AskErase(std::string_view name) {
  return fmt::format("All of {} will be gone for ever. To erase it, type the name:",
                     ShownPseudonym(name));
}

std::string NotErased(std::string_view name) {
  return fmt::format("nothing erased: that was not the name {}", ShownPseudonym(name));
}

std::string Erased(std::string_view name) {
  return fmt::format("Erased: {}. No byte is left in the records.", ShownPseudonym(name));
}

std::string ConsentNow(std::string_view name, bool yes) {
  return fmt::format("{}: raw tracks of the hand are {}.", ShownPseudonym(name),
                     yes ? "kept from now on" : "not kept; those that were there are erased");
}

}  // namespace moontrace::say

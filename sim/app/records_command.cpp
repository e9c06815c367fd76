#include "sim/app/commands.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "lessons/records/learner_history.h"
#include "lessons/records/records.h"
#include "sim/app/messages.h"
#include "sim/console/line_reader.h"
#include "sim/html_report/records_messages.h"
#include "sim/learn/learn_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/metrics_json.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/output_file.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kGreatestImport = std::size_t{256} << 20U;

const std::vector<std::string> kActions{"list", "export", "import", "erase", "consent"};

void CheckUse(const RecordsOptions& options) {
  const std::string& action = options.action;
  if (action == "report") throw UsageError(say::ReportsItself());
  if (std::find(kActions.begin(), kActions.end(), action) == kActions.end()) {
    throw UsageError(say::NotAnAction("records", action, NearestWord(action, kActions),
                                      "list, export NAME, import FILE, erase NAME or consent NAME "
                                      "yes|no"));
  }
  if (action == "list" ? !options.subject.empty() : options.subject.empty()) {
    throw UsageError(action == "list" ? say::SpareArgument(options.subject, "records list", false)
                                      : say::NoSubject(action));
  }
  const bool consent = action == "consent";
  if (consent && options.answer != "yes" && options.answer != "no") {
    throw UsageError(say::NoConsentAnswer());
  }
  if (!consent && !options.answer.empty()) {
    throw UsageError(say::SpareArgument(options.answer, "records " + action, false));
  }
  const auto only = [&](bool given, const char* option, const char* with) {
    if (given && action != with) throw UsageError(say::OnlyWith(option, with));
  };
  only(!options.to.empty(), "--output", "export");
  only(options.anonymous, "--anonymous", "export");
  only(options.yes, "--yes", "erase");
}

/// No file of records yet is no error, but one that was named and is not there.
int List(const std::string& path, const RecordsOptions& options, Console& console) {
  std::error_code ignored;
  const bool none = options.records.empty() && !fs::exists(fs::symlink_status(path, ignored));
  if (none) {
    console.Result(say::NobodyHasLearnt());
    if (options.output.json) console.Json(Dump(Json{{"learners", Json::array()}}));
    return exit_code::kGood;
  }
  const Records records = Records::OpenToRead(path);
  const std::vector<LearnerEntry> learners = records.Learners();
  Json list = Json::array();
  console.Result(say::LearnersOutcome(learners.size()));
  for (const LearnerEntry& learner : learners) {
    console.CheckStop();
    std::size_t trials = 0;
    for (const Trial& trial : records.Trials(learner.pseudonym)) {
      if (!trial.item.empty()) ++trials;
    }
    console.Result(say::LearnerLine(learner, trials));
    list.push_back({{"learner", learner.pseudonym},
                    {"since_unix_s", learner.since},
                    {"trials", trials},
                    {"courses", records.Courses(learner.pseudonym)},
                    {"keeps_tracks", learner.keeps_tracks},
                    {"consent", learner.consent},
                    {"simulated", learner.simulated}});
  }
  if (options.output.json) console.Json(Dump(Json{{"learners", std::move(list)}}));
  return exit_code::kGood;
}

int Export(const Records& records, const RecordsOptions& options, Console& console) {
  KnownLearner(records, options.subject);
  const std::string text = options.anonymous ? records.ExportAnonymous(options.subject)
                                             : records.Export(options.subject);
  if (options.to.empty()) {
    console.out() << text;
    return exit_code::kGood;
  }
  WriteWhole(options.to, text);
  console.Result(say::Exported(options.anonymous));
  console.Path(options.to);
  if (options.output.json) {
    console.Json(Dump(Json{{"file", options.to}, {"anonymous", options.anonymous}}));
  }
  return exit_code::kGood;
}

/// The records are opened once the file is known to be good: a bad one must not leave new ones.
int Import(const std::string& path, const RecordsOptions& options, Console& console) {
  const bool piped = options.subject == "-";
  TextOptions from;
  from.text = "-";
  const std::string text =
      piped ? ReadText(from, "records", console) : ReadTextFile(options.subject, kGreatestImport);
  const std::string file = piped ? "standard input" : options.subject;
  const LearnerHistory history = HistoryFromJson(text, file);
  const std::string& name = history.learner.pseudonym;
  Records records = Records::Open(path);
  records.Import(history, file);
  const std::size_t trials = records.Trials(name).size();
  console.Result(say::Imported(name, trials));
  if (options.output.json) console.Json(Dump(Json{{"learner", name}, {"rows", trials}}));
  return exit_code::kGood;
}

/// Whoever sits at a terminal types the name again; elsewhere `--yes` stands for that.
bool Confirmed(const RecordsOptions& options, Console& console) {
  if (options.yes) return true;
  if (&console.in() != &std::cin || isatty(STDIN_FILENO) == 0) {
    throw UsageError(say::EraseNeedsYes(options.subject));
  }
  LineReader lines(console.in());  // before the question: keys that answer it are its own
  console.Remark(say::AskErase(options.subject));
  for (;;) {
    console.CheckStop();
    if (const std::optional<std::string> line = lines.Next(50)) return *line == options.subject;
    if (lines.ended()) return false;
  }
}

int Erase(Records records, const RecordsOptions& options, Console& console) {
  KnownLearner(records, options.subject);
  if (!Confirmed(options, console)) {
    throw WorkFailed(say::NotErased(options.subject));
  }
  records.Erase(options.subject);
  console.Result(say::Erased(options.subject));
  if (options.output.json) console.Json(Dump(Json{{"erased", options.subject}}));
  return exit_code::kGood;
}

int Consent(Records records, const RecordsOptions& options, Console& console) {
  KnownLearner(records, options.subject);
  const bool yes = options.answer == "yes";
  records.SetConsent(options.subject, yes, say::kConsentVersion);  // no is an answer too
  console.Result(say::ConsentNow(options.subject, yes));
  if (options.output.json) {
    console.Json(Dump(Json{{"learner", options.subject}, {"keeps_tracks", yes}}));
  }
  return exit_code::kGood;
}

}  // namespace

std::string RecordsPathOf(const std::string& given) {
  return given.empty() ? Records::DefaultPath() : given;
}

LearnerEntry KnownLearner(const Records& records, const std::string& name) {
  if (const std::optional<LearnerEntry> found = records.Find(name)) return *found;
  std::vector<std::string> names;
  for (const LearnerEntry& learner : records.Learners()) names.push_back(learner.pseudonym);
  throw InputError(say::NoSuchLearner(name, NearestWord(name, names)));
}

void AddOptions(CLI::App& app, RecordsOptions& options) {
  namespace help = say::help;
  AddPath(app, "ACTION", "WORD", options.action, help::kRecordsAction);
  AddPath(app, "NAME", "NAME", options.subject, help::kRecordsSubject);
  AddPath(app, "ANSWER", "WORD", options.answer, help::kRecordsAnswer);
  AddPath(app, "--records", "FILE", options.records, help::kRecords);
  AddPath(app, "--output", "FILE", options.to, help::kRecordsOutput);
  AddFlag(app, "--anonymous", options.anonymous, help::kAnonymous);
  AddFlag(app, "--yes", options.yes, help::kEraseYes);
  AddOptions(app, options.output);
}

int Run(const RecordsOptions& options, Console& console) {
  CheckUse(options);
  const std::string path = RecordsPathOf(options.records);
  if (options.action == "import") return Import(path, options, console);
  if (options.action == "list") return List(path, options, console);
  if (options.action == "export") return Export(Records::OpenToRead(path), options, console);
  Records::OpenToRead(path);  // it must be there: to be written to it would be made
  if (options.action == "erase") return Erase(Records::Open(path), options, console);
  return Consent(Records::Open(path), options, console);
}

}  // namespace moontrace

#include "sim/study/study_protocol.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/study/item_page.h"
#include "textures/base/digest.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"
#include "textures/base/units.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;
constexpr int kMostTrials = 10000;
constexpr int kMostLearners = 100000;  ///< of all conditions together
constexpr std::size_t kMostNames = 1000;

int Count(const TomlTable& table, const char* key, std::int64_t otherwise, int most,
          int least = 0) {
  const auto value = static_cast<double>(table.Integer(key, otherwise));
  return static_cast<int>(InRange(table, key, value, least, most));
}

std::vector<std::string> Letters(const TomlTable& table, const char* key) {
  std::vector<std::string> letters = table.Strings(key);
  if (letters.empty() || letters.size() > kMostNames) {
    table.Fail(key, fmt::format("{} letters: give 1 to {}", letters.size(), kMostNames));
  }
  for (const std::string& letter : letters) {
    if (letter.empty() || letter.size() > 60)
      table.Fail(key, "an empty or long letter: give signs");
    // They stand in a CSV file.
    if (letter.find_first_of(",\"\n\r") != std::string::npos) {
      table.Fail(key, "a comma, quotation mark or line's end: give other signs");
    }
  }
  return letters;
}

double Millimetres(const TomlTable& table, const char* key, double otherwise) {
  return kMillimetre * InRange(table, key, table.Number(key, otherwise), 1, 100);
}

StudyCondition ReadCondition(const TomlTable& table) {
  StudyCondition condition;
  condition.name = table.String("name");
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  if (condition.name.empty() || condition.name.size() > 40 ||
      !std::all_of(condition.name.begin(), condition.name.end(), plain)) {
    table.Fail("name", "give 1 to 40 of a to z, 0 to 9, - and _");
  }
  const std::string mode = table.String("mode", "off");
  const std::optional<GuidanceMode> known = GuidanceModeOf(mode);
  if (!known) table.Fail("mode", fmt::format("no mode of guidance: give {}", kGuidanceModes));
  condition.mode = *known;
  if (table.Has("help")) {
    const std::vector<double> help = table.Numbers("help");
    if (help.size() != 2) table.Fail("help", "give two numbers: the first trial's and the last's");
    condition.help_first = InRange(table, "help", help[0], 0, 10);
    condition.help_last = InRange(table, "help", help[1], 0, 10);
  } else if (condition.mode != GuidanceMode::kOff) {
    table.Fail("help", "is missing: give two numbers, the first trial's and the last's");
  }
  condition.probe_every = Count(table, "probe_every", 0, kMostTrials);
  table.FailUnknown();
  return condition;
}

void ReadTrials(const TomlTable& table, StudyProtocol& protocol) {
  protocol.pre_test = Count(table, "pre_test", 0, kMostTrials);
  protocol.training = Count(table, "training", 0, kMostTrials);
  protocol.retention = Count(table, "retention", 0, kMostTrials);
  protocol.transfer = Count(table, "transfer", 0, kMostTrials);
  table.FailUnknown();
}

void ReadRetention(const TomlTable& table, StudyProtocol& protocol) {
  protocol.retention_days = table.Numbers("days");
  if (protocol.retention_days.size() > 100) table.Fail("days", "give at most 100");
  double last = 0;
  for (const double day : protocol.retention_days) {
    InRange(table, "days", day, 0, 10000);
    if (day < last) table.Fail("days", "give days that ascend");
    last = day;
  }
  table.FailUnknown();
}

void ReadTransfer(const TomlTable& table, StudyProtocol& protocol) {
  if (table.Has("letters")) protocol.transfer_letters = Letters(table, "letters");
  for (const std::string& letter : protocol.transfer_letters) {
    const auto& trained = protocol.letters;
    if (std::find(trained.begin(), trained.end(), letter) != trained.end()) {
      table.Fail("letters", fmt::format("{} is trained: give letters that are not", letter));
    }
  }
  if (table.Has("size_mm")) protocol.transfer_size = Millimetres(table, "size_mm", 0);
  table.FailUnknown();
}

StudyStaircase ReadStaircase(const TomlTable& table) {
  StudyStaircase stairs;
  stairs.start = Millimetres(table, "start_mm", 20);
  stairs.least = Millimetres(table, "least_mm", 3);
  if (stairs.least >= stairs.start) table.Fail("least_mm", "give less than start_mm");
  stairs.down = static_cast<int>(InRange(table, "down", Count(table, "down", 2, 100), 1, 3));
  stairs.trials =
      static_cast<int>(InRange(table, "trials", Count(table, "trials", 40, 1000), 1, 1000));
  stairs.staircases =
      static_cast<int>(InRange(table, "staircases", Count(table, "staircases", 2, 20), 1, 20));
  stairs.lessons = Count(table, "lessons", 2, 100);
  table.FailUnknown();
  return stairs;
}

void ReadConditions(const TomlTable& root, StudyProtocol& protocol) {
  std::set<std::string> names;
  for (const TomlTable& table : root.Tables("conditions")) {
    protocol.conditions.push_back(ReadCondition(table));
    if (!names.insert(protocol.conditions.back().name).second) {
      table.Fail("name", "is another condition's too: give each its own");
    }
    if (names.size() > kMostNames) table.Fail("name", "too many conditions: give at most 1000");
  }
  if (protocol.conditions.empty()) {
    root.Fail("conditions", "is missing: give at least one [[conditions]] table");
  }
}

/// Adds trials of one phase, letters in turn.
void AddPhase(std::vector<StudyTrial>& trials, const StudyTrial& like,
              const std::vector<std::string>& letters, int count, std::uint64_t seed) {
  for (int i = 0; i < count; ++i) {
    StudyTrial trial = like;
    trial.letter = letters[(static_cast<std::size_t>(i) + seed) % letters.size()];
    trials.push_back(trial);
  }
}

void AddTraining(std::vector<StudyTrial>& trials, const StudyProtocol& protocol,
                 const StudyCondition& condition, std::uint64_t seed) {
  const std::size_t first = trials.size();
  AddPhase(trials, {"training", 0, "", protocol.size}, protocol.letters, protocol.training, seed);
  for (int i = 0; i < protocol.training; ++i) {
    StudyTrial& trial = trials[first + static_cast<std::size_t>(i)];
    const bool probe = condition.probe_every > 0 && (i + 1) % condition.probe_every == 0;
    const double share = protocol.training > 1 ? i / (protocol.training - 1.0) : 0;
    const double help = condition.help_first + share * (condition.help_last - condition.help_first);
    if (probe || condition.mode == GuidanceMode::kOff || !(help > 0)) continue;
    trial.mode = condition.mode;
    trial.help = help;
  }
}

/// Pages in place of learners, combinations in place of conditions.
void ReadReading(const TomlTable& root, StudyProtocol& protocol) {
  const TomlTable table = root.Table("reading");
  protocol.learners = Count(table, "pages", 20, kMostLearners, 1);
  protocol.reading = ReadSweep(table);
  std::set<std::string> names;
  for (const ReadingCell& cell : protocol.reading->cells) {
    protocol.conditions.emplace_back().name = cell.name;
    if (!names.insert(cell.name).second) {
      root.Fail("reading", fmt::format("{} stands there twice: give each value once", cell.name));
    }
  }
}

void CheckTogether(const TomlTable& root, const StudyProtocol& protocol) {
  const double together = 1.0 * protocol.learners * static_cast<double>(protocol.conditions.size());
  if (together > kMostLearners) {
    root.Fail(
        protocol.reading ? "reading" : "learners",
        fmt::format("{} in all conditions together: give at most {}", together, kMostLearners));
  }
}

/// Whether the script sets all of the letter, and as one sign.
bool IsOneSign(const std::string& letter, const Script& script) {
  try {
    const std::vector<PlacedGlyph> glyphs =
        SetItem(letter, script, script.size, {1, 0}).page.glyphs;
    return glyphs.size() == 1 && glyphs.front().source_begin == 0 &&
           glyphs.front().source_end == letter.size();
  } catch (const InputError&) {
    return false;  // nothing of it
  }
}

void CheckLetters(const TomlTable& table, const std::vector<std::string>& letters,
                  const Script& script) {
  for (const std::string& letter : letters) {
    if (IsOneSign(letter, script)) continue;
    table.Fail("letters", fmt::format("'{}' is not one sign of {}: give letters that are",
                                      OneLine(letter), OneLine(script.name)));
  }
}

}  // namespace

StudyProtocol ParseStudy(std::string_view text, const std::string& name) {
  const TomlTable root = TomlTable::Parse(text, name);
  StudyProtocol protocol;
  protocol.file = name;
  protocol.digest = DigestOf(text);
  protocol.title = root.String("title");
  protocol.first_seed = static_cast<std::uint64_t>(
      InRange(root, "first_seed", static_cast<double>(root.Integer("first_seed", 1)), 0, 1e15));
  if (root.Has("reading")) {
    ReadReading(root, protocol);
    CheckTogether(root, protocol);
    root.FailUnknown();
    return protocol;
  }
  protocol.script = root.String("script", "moon");
  protocol.learners = static_cast<int>(
      InRange(root, "learners", Count(root, "learners", 20, kMostLearners), 1, kMostLearners));
  protocol.letters = Letters(root, "letters");
  protocol.size = Millimetres(root, "size_mm", 12);
  protocol.groove_depth_share =
      InRange(root, "groove_depth_share", root.Number("groove_depth_share", 1), 0.01, 1);
  if (root.Has("press_n")) {
    protocol.press = InRange(root, "press_n", root.Number("press_n"), 0.01, 5);
  }
  protocol.device = root.String("device", "");
  protocol.learner = root.String("learner", "");
  ReadTrials(root.Table("trials"), protocol);
  if (root.Has("retention")) ReadRetention(root.Table("retention"), protocol);
  if (root.Has("transfer")) ReadTransfer(root.Table("transfer"), protocol);
  if (root.Has("staircase")) protocol.staircase = ReadStaircase(root.Table("staircase"));
  ReadConditions(root, protocol);
  CheckTogether(root, protocol);
  root.FailUnknown();
  return protocol;
}

StudyProtocol LoadStudy(const std::string& path) {
  const std::string text = ReadTextFile(path, kMostBytes);
  StudyProtocol protocol = ParseStudy(text, path);
  if (protocol.reading) return protocol;
  Script script;
  try {
    script = FindScript(protocol.script);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: script: {}", path, error.what()));
  }
  const TomlTable root = TomlTable::Parse(text, path);
  CheckLetters(root, protocol.letters, script);
  if (!protocol.transfer_letters.empty()) {
    CheckLetters(root.Table("transfer"), protocol.transfer_letters, script);
  }
  return protocol;
}

std::vector<StudyTrial> TrialsOf(const StudyProtocol& protocol, const StudyCondition& condition,
                                 std::uint64_t seed) {
  std::vector<StudyTrial> trials;
  AddPhase(trials, {"pre-test", 0, "", protocol.size}, protocol.letters, protocol.pre_test, seed);
  AddTraining(trials, protocol, condition, seed);
  double day = 0;
  for (const double days : protocol.retention_days) {
    day = days;
    const std::string phase = fmt::format("retention-{:.6g}", days);
    AddPhase(trials, {phase, day, "", protocol.size}, protocol.letters, protocol.retention, seed);
  }
  if (!protocol.transfer_letters.empty()) {
    AddPhase(trials, {"transfer-letters", day, "", protocol.size}, protocol.transfer_letters,
             protocol.transfer, seed);
  }
  if (protocol.transfer_size) {
    AddPhase(trials, {"transfer-size", day, "", *protocol.transfer_size}, protocol.letters,
             protocol.transfer, seed);
  }
  return trials;
}

}  // namespace moontrace

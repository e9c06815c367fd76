#include "sim/book/read_list.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "lessons/records/learner_names.h"
#include "lessons/records/records.h"
#include "sim/book/book_messages.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

/// Whether a file still holds what was read in it, as far as is known without opening it.
enum class File : std::uint8_t { kThere, kGone, kHoldsAnother, kWasInput };

struct KnownReading {
  ReadDocument reading;
  std::string learner;
  File file = File::kThere;
};

/// The newest first.
std::vector<KnownReading> KnownReadings(const std::string& learner, const std::string& records) {
  std::vector<KnownReading> all;
  std::error_code ignored;
  if (!Records::Available() || !std::filesystem::exists(records, ignored)) return all;
  const Records file = Records::OpenToRead(records);
  const std::vector<LearnerEntry> known = file.Learners();
  const std::string wanted = learner.empty() ? std::string() : KeptName(learner, known);
  for (const LearnerEntry& one : known) {
    if (!learner.empty() && one.pseudonym != wanted) continue;
    std::set<std::string> paths;  // newest first: whoever comes later was replaced
    for (ReadDocument& reading : file.Readings(one.pseudonym)) {
      auto state = File::kThere;
      if (reading.path.empty()) {
        state = File::kWasInput;
      } else if (!std::filesystem::exists(reading.path, ignored)) {
        state = File::kGone;
      } else if (!paths.insert(reading.path).second) {
        state = File::kHoldsAnother;
      }
      all.push_back({std::move(reading), one.pseudonym, state});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const KnownReading& a, const KnownReading& b) {
    return a.reading.time > b.reading.time;
  });
  return all;
}

/// By its number, or by its file.
KnownReading ReadingMeant(const std::string& given, const std::string& learner,
                          const std::string& records) {
  std::vector<KnownReading> all = KnownReadings(learner, records);
  std::error_code ignored;
  const bool is_file = std::filesystem::exists(given, ignored);
  std::size_t number = 0;
  const auto read = std::from_chars(given.data(), given.data() + given.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == given.data() + given.size();
  if (!is_file && whole) {
    if (number < 1 || number > all.size()) {
      throw InputError(say::NoReadingNumbered(given, all.size()));
    }
    return std::move(all[number - 1]);
  }
  const std::string path = KeptReadText(PathOfRead(given));
  for (KnownReading& one : all) {
    if (one.reading.path == path) return std::move(one);
  }
  throw InputError(say::NeverRead(given));
}

}  // namespace

std::string PathOfRead(const std::string& file) {
  if (file == "-") return {};
  std::error_code ignored;
  const std::filesystem::path path = std::filesystem::weakly_canonical(file, ignored);
  return ignored ? file : path.string();
}

void ListReadings(const std::string& learner, const std::string& records, bool json,
                  Console& console) {
  const std::vector<KnownReading> readings = KnownReadings(learner, records);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  console.Result(readings.empty() ? say::NothingRead() : say::ReadOutcome(readings.size()));
  for (const KnownReading& one : readings) {
    const ReadDocument& reading = one.reading;
    console.Result(say::ReadLineOf(list.size() + 1, reading, learner.empty() ? one.learner : ""));
    if (one.file == File::kGone) console.Result(say::FileIsGone());
    if (one.file == File::kHoldsAnother) console.Result(say::FileHoldsAnother());
    if (!reading.path.empty()) console.Path(reading.path);
    list.push_back({{"learner", one.learner},
                    {"title", reading.title},
                    {"path", reading.path},
                    {"file_there", one.file == File::kThere},
                    {"time_unix_s", reading.time},
                    {"letter", reading.place.letter},
                    {"where", reading.where},
                    {"bookmarks", reading.marks.size()}});
  }
  if (!readings.empty()) console.Result(say::HowToReadNumbered());
  if (json) console.Json(Dump({{"readings", std::move(list)}}));
}

ListedFile FileNumbered(const std::string& number, const std::string& learner,
                        const std::string& records) {
  KnownReading meant = ReadingMeant(number, learner, records);
  const std::string& path = meant.reading.path;
  switch (meant.file) {
    case File::kGone:
      throw InputError(say::NumberIsGone(number, path));
    case File::kHoldsAnother:
      throw InputError(say::NumberHoldsAnother(number, path));
    case File::kWasInput:
      throw InputError(say::NotInFile(number));
    case File::kThere:
      break;
  }
  return {path, std::move(meant.learner), std::move(meant.reading.title)};
}

std::vector<ListedFile> FilesToReadOn(const std::string& learner, const std::string& records) {
  std::vector<ListedFile> files;
  for (KnownReading& one : KnownReadings(learner, records)) {
    if (one.file != File::kThere) continue;
    files.push_back(
        {std::move(one.reading.path), std::move(one.learner), std::move(one.reading.title)});
  }
  return files;
}

void ForgetReading(const std::string& given, const std::string& learner, const std::string& records,
                   Console& console) {
  const KnownReading meant = ReadingMeant(given, learner, records);
  Records::Open(records).Forget(meant.learner, meant.reading.id);
  console.Result(say::ReadingForgotten(meant.reading, meant.learner));
}

}  // namespace moontrace

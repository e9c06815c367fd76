#include "sim/audio/sound_table.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

#include "sim/audio/wav.h"
#include "textures/base/enum_names.h"
#include "textures/base/nearest_word.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr double kLongest = 0.5;                  // of an earcon [s]
constexpr double kLowest = 150, kHighest = 5000;  // pitches [Hz]
constexpr std::size_t kMostNotes = 20;
constexpr std::size_t kLargestWav = std::size_t{1} << 20U;  // [bytes]
constexpr std::string_view NameOf(Timbre timbre) {
  switch (timbre) {
    case Timbre::kPure:
      return "pure";
    case Timbre::kBell:
      return "bell";
    case Timbre::kReed:
      return "reed";
    case Timbre::kBrass:
      return "brass";
  }
  return {};
}

double Within(const TomlTable& table, const std::string& key, double otherwise, double low,
              double high) {
  const double value = table.Number(key, otherwise);
  if (value < low || value > high) {
    table.Fail(key, fmt::format("is out of range: {:g} to {:g}", low, high));
  }
  return value;
}

void ApplyNotes(const TomlTable& table, EarconSound& sound) {
  if (!table.Has("hz") && !table.Has("ms")) return;
  const std::vector<double> pitches = table.Numbers("hz");
  const std::vector<double> lengths = table.Numbers("ms");
  if (pitches.size() != lengths.size()) table.Fail("ms", "must have as many values as hz");
  if (pitches.empty() || pitches.size() > kMostNotes) {
    table.Fail("hz", fmt::format("must have 1 to {} values", kMostNotes));
  }
  sound.notes.clear();
  double total = 0;
  for (std::size_t i = 0; i < pitches.size(); ++i) {
    if (pitches[i] != 0 && (pitches[i] < kLowest || pitches[i] > kHighest)) {
      table.Fail("hz", fmt::format("holds {:g}: use 0 for a pause, or {:g} to {:g}", pitches[i],
                                   kLowest, kHighest));
    }
    if (lengths[i] < 10) table.Fail("ms", "holds less than 10: it would be a click");
    sound.notes.push_back({pitches[i], 1e-3 * lengths[i]});
    total += 1e-3 * lengths[i];
  }
  if (!(total < kLongest)) table.Fail("ms", "adds up to 500 or more: make it shorter");
  sound.recording.clear();
}

void ApplyEarcon(const TomlTable& table, const std::string& folder, EarconSound& sound) {
  sound.on = table.Bool("on", sound.on);
  sound.volume = Within(table, "volume", sound.volume, 0, 1);
  if (table.Has("timbre")) {
    const std::string name = table.String("timbre");
    const std::optional<Timbre> timbre = ValueNamed(name, &NameOf);
    if (!timbre) {
      const std::vector<std::string> names = AllNames(&NameOf);
      table.Fail("timbre", fmt::format("is {}: did you mean {}? There are {}", OneLine(name),
                                       NearestWord(name, names), fmt::join(names, ", ")));
    }
    sound.timbre = *timbre;
  }
  ApplyNotes(table, sound);
  if (table.Has("file")) {
    const std::string path = (fs::path(folder) / table.String("file")).string();
    const Wav wav = ParseWav(ReadTextFile(path, kLargestWav), path, kLongest);
    sound.recording = MonoAt(wav, kSoundRate);
  }
  table.FailUnknown();
}

void ApplyPath(const TomlTable& table, PathTone& path) {
  path.on = table.Bool("on", path.on);
  path.low = Within(table, "low_hz", path.low, kLowest, kHighest);
  path.high = Within(table, "high_hz", path.high, kLowest, kHighest);
  path.volume = Within(table, "volume", path.volume, 0, 1);
  path.off_line_pitch = Within(table, "off_line_hz", path.off_line_pitch, kLowest, kHighest);
  path.off_line_volume = Within(table, "off_line_volume", path.off_line_volume, 0, 1);
  if (path.low >= path.high) table.Fail("high_hz", "must be above low_hz");
  if (path.volume + path.off_line_volume > 1) {
    table.Fail("off_line_volume", "and volume are more than 1 together: lower one");
  }
  table.FailUnknown();
}

/// The user's own file, empty if there is none.
std::string UsersFile() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  const std::string config = variable("XDG_CONFIG_HOME");
  const std::string home = variable("HOME");
  if (config.empty() && home.empty()) return {};
  const std::string path = (config.empty() ? home + "/.config" : config) + "/moontrace/sounds.toml";
  std::error_code ignored;
  return fs::exists(path, ignored) ? path : std::string();
}

}  // namespace

void ApplySounds(const TomlTable& document, const std::string& folder, SoundTable& table) {
  table.volume = Within(document, "volume", table.volume, 0, 1);
  if (document.Has("path")) ApplyPath(document.Table("path"), table.path);
  for (const Earcon earcon : AllEarcons()) {
    const std::string key(KeyOf(earcon));
    EarconSound& sound = table.earcons[static_cast<std::size_t>(earcon)];
    if (document.Has(key)) ApplyEarcon(document.Table(key), folder, sound);
  }
  document.FailUnknown();
}

SoundTable LoadSounds(const std::string& own) {
  SoundTable table;
  const std::string shipped = ResourcePath("sim/app/sounds.toml");
  ApplySounds(TomlTable::Read(shipped), fs::path(shipped).parent_path().string(), table);
  const std::string path = own.empty() ? UsersFile() : own;
  if (!path.empty()) {
    ApplySounds(TomlTable::Read(path), fs::path(path).parent_path().string(), table);
  }
  return table;
}

}  // namespace moontrace

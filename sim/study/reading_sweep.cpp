#include "sim/study/reading_sweep.h"

#include <fmt/core.h>

#include <filesystem>
#include <functional>
#include <string_view>
#include <utility>

#include "textures/base/random.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostValues = 100;
constexpr double kMostCells = 10000;

/// One axis: what its value does to a cell, and how the value is called in the cell's name.
struct Axis {
  std::vector<std::function<void(ReadingCell&)>> set;
  std::vector<std::string> names;
};

/// A number or several, each from `low` to `high`.
Axis NumberAxis(const TomlTable& table, const char* key, double otherwise, double low, double high,
                double unit, const char* suffix, double ReadingCell::*member) {
  Axis axis;
  std::vector<double> values = {otherwise};
  if (table.Has(key)) values = table.Numbers(key);
  if (values.empty() || values.size() > kMostValues) {
    table.Fail(key, fmt::format("{} values: give 1 to {}", values.size(), kMostValues));
  }
  for (const double value : values) {
    InRange(table, key, value, low, high);
    axis.set.emplace_back(
        [member, given = unit * value](ReadingCell& cell) { cell.*member = given; });
    axis.names.push_back(fmt::format("{}{}", value, suffix));
  }
  return axis;
}

/// One that stands in a file's name.
std::string PlainName(const std::string& given) {
  std::string name = std::filesystem::path(given).stem().string();
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    if (!plain) c = '_';
  }
  return name.substr(0, 40);
}

Axis NameAxis(const TomlTable& table, const char* key, const std::string& otherwise,
              const std::string& none, std::string ReadingCell::*member) {
  Axis axis;
  std::vector<std::string> values = {otherwise};
  if (table.Has(key)) values = table.Strings(key);
  if (values.empty() || values.size() > kMostValues) {
    table.Fail(key, fmt::format("{} names: give 1 to {}", values.size(), kMostValues));
  }
  for (const std::string& value : values) {
    if (value.find_first_of(",\"\n\r") != std::string::npos) {
      table.Fail(key, "a comma, quotation mark or line's end: give other names");
    }
    axis.set.emplace_back([member, value](ReadingCell& cell) { cell.*member = value; });
    axis.names.push_back(value.empty() ? none : PlainName(value));
  }
  return axis;
}

Axis ReliefAxis(const TomlTable& table) {
  Axis axis;
  std::vector<std::string> values = {"engraved"};
  if (table.Has("relief")) values = table.Strings("relief");
  for (const std::string& value : values) {
    if (value != "engraved" && value != "embossed") {
      table.Fail("relief", "give \"engraved\", \"embossed\" or both");
    }
    const Relief relief = value == "embossed" ? Relief::kEmbossed : Relief::kEngraved;
    axis.set.emplace_back([relief](ReadingCell& cell) { cell.relief = relief; });
    axis.names.push_back(value);
  }
  if (values.empty() || values.size() > 2) table.Fail("relief", "give one or two");
  return axis;
}

/// How many combinations there are; of very many only that.
double Combinations(const std::vector<Axis>& axes) {
  double count = 1;
  for (const Axis& axis : axes) count *= static_cast<double>(axis.set.size());
  return count;
}

/// All combinations, named by what differs.
std::vector<ReadingCell> Combined(const std::vector<Axis>& axes) {
  std::vector<ReadingCell> cells = {ReadingCell()};
  for (const Axis& axis : axes) {
    std::vector<ReadingCell> more;
    for (const ReadingCell& cell : cells) {
      for (std::size_t i = 0; i < axis.set.size(); ++i) {
        more.push_back(cell);
        axis.set[i](more.back());
        if (axis.set.size() < 2) continue;
        more.back().name += (cell.name.empty() ? "" : "-") + axis.names[i];
      }
    }
    cells = std::move(more);
  }
  for (ReadingCell& cell : cells) {
    if (cell.name.empty()) cell.name = "page";
  }
  return cells;
}

char Chosen(std::string_view from, Random& random) {
  return from[static_cast<std::size_t>(random.Uniform() * static_cast<double>(from.size()))];
}

}  // namespace

ReadingSweep ReadSweep(const TomlTable& table) {
  ReadingSweep sweep;
  const std::string text = table.String("text", "letters");
  if (text == "signs") {
    sweep.text = ReadingSweep::Text::kSigns;
  } else if (text != "letters") {
    table.Fail("text", "give \"letters\" or \"signs\"");
  }
  const auto letters = static_cast<double>(table.Integer("letters", sweep.letters));
  sweep.letters = static_cast<int>(InRange(table, "letters", letters, 1, 10000));
  const std::vector<Axis> axes = {
      NameAxis(table, "script", "moon", "moon", &ReadingCell::script),
      ReliefAxis(table),
      NameAxis(table, "device", "", "exact", &ReadingCell::device),
      NumberAxis(table, "size_mm", 12, 1, 100, kMillimetre, "mm", &ReadingCell::size),
      NumberAxis(table, "width_share", 1, 0.1, 5, 1, "width", &ReadingCell::width_share),
      NumberAxis(table, "depth_share", 1, 0.1, 5, 1, "depth", &ReadingCell::depth_share),
      NumberAxis(table, "rounding_share", 1, 0.1, 5, 1, "round", &ReadingCell::rounding_share),
      NumberAxis(table, "press_n", 0, 0, 20, 1, "n", &ReadingCell::press),
      NumberAxis(table, "friction", 0, 0, 2, 1, "friction", &ReadingCell::friction),
      NumberAxis(table, "drift_share", 1, 0, 10, 1, "drift", &ReadingCell::drift_share),
      NumberAxis(table, "unsure_mm", 0, 0, 20, kMillimetre, "unsure", &ReadingCell::unsure),
      NameAxis(table, "paper", "", "reach", &ReadingCell::paper)};
  if (Combinations(axes) > kMostCells) {
    table.Fail("", fmt::format("more than {} combinations: give fewer values", kMostCells));
  }
  sweep.cells = Combined(axes);
  table.FailUnknown();
  return sweep;
}

std::string SweepText(const ReadingSweep& sweep, std::uint64_t seed) {
  constexpr int kWord = 5;
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz", kMarks = ".,;:?!";
  constexpr std::string_view kDigits = "0123456789";
  constexpr double kMarked = 0.25, kBrackets = 0.33, kNumbers = 0.40;  // shares, each with the last
  // apart from the reader's own chances by the same seed
  Random random(~seed);
  std::string text;
  for (int letters = 0; letters < sweep.letters; letters += kWord) {
    std::string word;
    for (int i = 0; i < kWord; ++i) word += Chosen(kLetters, random);
    if (sweep.text == ReadingSweep::Text::kSigns) {
      const double kind = random.Uniform();
      if (kind < kMarked) {
        word += Chosen(kMarks, random);
      } else if (kind < kBrackets) {
        word.insert(word.begin(), '(');
        word += ')';
      } else if (kind < kNumbers) {
        for (char& c : word) c = Chosen(kDigits, random);
      }
    }
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

}  // namespace moontrace

#include "sim/study/study_row.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr const char* kColumns =
    "study,condition,seed,trial,phase,day,letter,size_mm,mode,help,coverage,mean_error_mm,"
    "rms_error_mm,wander_offs,duration_s,mean_force_n,mean_guidance_n,felt_error,excluded";
constexpr const char* kReadingColumns =
    "study,condition,seed,trial,script,relief,device,size_mm,width_share,depth_share,rounding_"
    "share,"
    "press_n,friction,drift_share,unsure_mm,paper,signs,signs_right,wrong,missed,extra,duration_s,"
    "through,ended";
constexpr std::size_t kColumnCount = 19, kReadingColumnCount = 24;

constexpr const char *kEngraved = "engraved", *kEmbossed = "embossed";

using Cells = std::array<std::string_view, kReadingColumnCount>;

[[noreturn]] void Fail(const std::string& where, std::size_t line, const std::string& problem) {
  throw InputError(fmt::format("{}:{}: {}", where, line, problem));
}

/// Reads the cells of one row; every failure names file, line and column.
class RowReader {
 public:
  RowReader(std::string_view line, std::size_t columns, const std::string& where,
            std::size_t number)
      : where_(where), number_(number) {
    std::size_t count = 0;
    while (true) {
      const std::size_t comma = line.find(',');
      if (count == columns) count = columns + 1;
      if (count > columns) break;
      cells_[count++] = line.substr(0, comma);
      if (comma == std::string_view::npos) break;
      line.remove_prefix(comma + 1);
    }
    if (count != columns) {
      Fail(where_, number_,
           fmt::format("not {} cells as a study writes: take the file away and run the study again",
                       columns));
    }
  }
  std::string Text() { return std::string(cells_[next_++]); }
  Relief OneRelief() {
    const std::string_view cell = cells_[next_++];
    if (cell != kEmbossed && cell != kEngraved) Refuse(cell);
    return cell == kEmbossed ? Relief::kEmbossed : Relief::kEngraved;
  }
  template <typename T>
  T Number() {
    const std::string_view cell = cells_[next_++];
    T value{};
    const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (read.ec != std::errc() || read.ptr != cell.data() + cell.size()) Refuse(cell);
    if constexpr (std::is_floating_point_v<T>) {
      if (!std::isfinite(value)) Refuse(cell);
    }
    return value;
  }
  std::uint64_t Hexadecimal() {
    const std::string_view cell = cells_[next_++];
    std::uint64_t value = 0;
    const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), value, 16);
    if (read.ec != std::errc() || read.ptr != cell.data() + cell.size()) Refuse(cell);
    return value;
  }
  [[noreturn]] void Refuse(std::string_view cell) const {
    Fail(where_, number_,
         fmt::format("'{}' in column {} is not what a study writes: run the study again",
                     OneLine(cell), next_));
  }

 private:
  const std::string& where_;
  std::size_t number_ = 0, next_ = 0;
  Cells cells_{};
};

/// The columns that all rows begin with.
void ReadWho(RowReader& cells, StudyRow& row) {
  row.study = cells.Hexadecimal();
  row.condition = cells.Text();
  row.seed = cells.Number<std::uint64_t>();
  row.trial = cells.Number<std::size_t>();
}

StudyRow ParseRow(std::string_view line, const std::string& where, std::size_t number) {
  RowReader cells(line, kColumnCount, where, number);
  StudyRow row;
  ReadWho(cells, row);
  row.given.phase = cells.Text();
  row.given.day = cells.Number<double>();
  row.given.letter = cells.Text();
  row.given.size = cells.Number<double>() / 1e3;
  const std::string mode = cells.Text();
  const auto known = GuidanceModeOf(mode);
  if (!known) cells.Refuse(mode);
  row.given.mode = *known;
  row.given.help = cells.Number<double>();
  row.coverage = cells.Number<double>();
  row.mean_error = cells.Number<double>() / 1e3;
  row.rms_error = cells.Number<double>() / 1e3;
  row.wander_offs = cells.Number<std::int64_t>();
  row.duration = cells.Number<double>();
  row.mean_force = cells.Number<double>();
  row.mean_guidance = cells.Number<double>();
  row.felt_error = cells.Number<double>();
  row.excluded = cells.Text();
  row.line = std::string(line) + "\n";
  return row;
}

StudyRow ParsePage(std::string_view line, const std::string& where, std::size_t number) {
  RowReader cells(line, kReadingColumnCount, where, number);
  StudyRow row;
  ReadWho(cells, row);
  ReadingCell& cell = row.page.emplace().cell;
  cell.script = cells.Text();
  cell.relief = cells.OneRelief();
  cell.device = cells.Text();
  cell.size = cells.Number<double>() / 1e3;
  cell.width_share = cells.Number<double>();
  cell.depth_share = cells.Number<double>();
  cell.rounding_share = cells.Number<double>();
  cell.press = cells.Number<double>();
  cell.friction = cells.Number<double>();
  cell.drift_share = cells.Number<double>();
  cell.unsure = cells.Number<double>() / 1e3;
  cell.paper = cells.Text();
  PageReading& read = row.page->read;
  read.signs = cells.Number<std::size_t>();
  read.signs_right = cells.Number<std::size_t>();
  read.wrong = cells.Number<std::size_t>();
  read.missed = cells.Number<std::size_t>();
  read.extra = cells.Number<std::size_t>();
  read.duration = cells.Number<double>();
  read.through = cells.Number<std::size_t>();
  read.ended = cells.Number<int>() != 0;
  row.line = std::string(line) + "\n";
  return row;
}

std::string FormatPage(const StudyRow& row) {
  const ReadingCell& cell = row.page->cell;
  const PageReading& read = row.page->read;
  return fmt::format(
      "{:016x},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.study,
      row.condition, row.seed, row.trial, cell.script,
      cell.relief == Relief::kEmbossed ? kEmbossed : kEngraved, cell.device, 1e3 * cell.size,
      cell.width_share, cell.depth_share, cell.rounding_share, cell.press, cell.friction,
      cell.drift_share, 1e3 * cell.unsure, cell.paper, read.signs, read.signs_right, read.wrong,
      read.missed, read.extra, read.duration, read.through, read.ended ? 1 : 0);
}

}  // namespace

std::string StudyHeader(StudyKind kind) {
  return std::string(kind == StudyKind::kReading ? kReadingColumns : kColumns) + "\n";
}

std::string FormatRow(const StudyRow& row) {
  if (row.page) return FormatPage(row);
  const StudyTrial& given = row.given;
  return fmt::format("{:016x},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.study,
                     row.condition, row.seed, row.trial, given.phase, given.day, given.letter,
                     1e3 * given.size, NameOf(given.mode), given.help, row.coverage,
                     1e3 * row.mean_error, 1e3 * row.rms_error, row.wander_offs, row.duration,
                     row.mean_force, row.mean_guidance, row.felt_error, row.excluded);
}

std::vector<StudyRow> ParseRows(std::string_view text, const std::string& where) {
  std::vector<StudyRow> rows;
  std::size_t number = 0;
  bool pages = false;
  while (true) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) break;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (++number == 1) {
      pages = line == kReadingColumns;
      if (!pages && line != kColumns) {
        Fail(where, 1, "no study's file: its first line is not the columns'");
      }
    } else {
      rows.push_back(pages ? ParsePage(line, where, number) : ParseRow(line, where, number));
    }
  }
  return rows;
}

}  // namespace moontrace

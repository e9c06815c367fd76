#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/trial.h"
#include "sim/study/page_reading.h"
#include "sim/study/reading_sweep.h"
#include "sim/study/study_protocol.h"

namespace moontrace {

/// A page that a simulated reader was given, and how it read it.
struct StudyPage {
  ReadingCell cell;  ///< without its name, which is the row's condition
  PageReading read;
};

/// One trial of a study as a line of its CSV file, numbers with all their digits.
struct StudyRow {
  std::uint64_t study = 0;  ///< StudyProtocol::digest
  std::string condition;
  std::uint64_t seed = 0;  ///< of the learner
  std::size_t trial = 0;   ///< of the learner, from 1
  StudyTrial given;        ///< of phase "size-threshold": the size known by touch, 0 for none
  double coverage = 0;     ///< 0-1
  double mean_error = 0, rms_error = 0;  ///< [m]
  std::int64_t wander_offs = 0;
  double duration = 0;                       ///< [s]
  double mean_force = 0, mean_guidance = 0;  ///< [N]
  double felt_error = 0;                     ///< TracedItem::felt_error
  std::optional<StudyPage> page;             ///< of a study of reading, in place of the above
  std::string excluded;                      ///< why it does not count; empty: it does
  std::string line;                          ///< as read from a file, its end included
};

/// The columns' names, with a line's end, of rows of that kind.
std::string StudyHeader(StudyKind kind);
/// One line, its end included.
std::string FormatRow(const StudyRow& row);
/// The rows of a file with its header. `where` stands in messages. A last line without an end is
/// left out. Throws InputError: file:line, cause, cure.
std::vector<StudyRow> ParseRows(std::string_view text, const std::string& where);

}  // namespace moontrace

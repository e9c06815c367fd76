#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "textures/base/toml_reader.h"
#include "textures/typeset/style.h"

namespace moontrace {

/// What a page that is read by touch is like: one value of each axis of a sweep.
struct ReadingCell {
  std::string name;  ///< of what differs between the cells, "6mm-0.5n"; of a single one "page"
  std::string script = "moon";
  Relief relief = Relief::kEngraved;
  std::string device;         ///< profile, a name or a file; empty: read exactly
  double size = 0.012;        ///< [m]
  double width_share = 1;     ///< of the groove's default width for that size
  double depth_share = 1;     ///< of its default depth
  double rounding_share = 1;  ///< of its default rounding
  double press = 0;           ///< [N]; 0 until CompleteSweep: the hand's usual one
  double friction = 0;        ///< Coulomb's, of the page
  double drift_share = 1;     ///< of the shipped hand's sideways drift
  double unsure = 0;          ///< how wrongly the hand feels its place, rms [m]
  std::string paper;          ///< as FindPage; empty: A4, within the device's reach
};

/// Pages that a simulated reader reads, for every combination of its axes' values. From the table
/// [reading] of a study's file; `lessons/studies/reading.toml` shows all keys.
struct ReadingSweep {
  enum class Text {
    kLetters,  ///< words of five random letters
    kSigns     ///< the same with marks and numbers
  } text = Text::kLetters;
  int letters = 500;               ///< at least, on each page
  std::vector<ReadingCell> cells;  ///< the last axis goes fastest
};

/// Throws InputError: file:line:column, cause, cure.
ReadingSweep ReadSweep(const TomlTable& table);

/// The text of the page with this seed: the same in all cells, if their scripts have its signs.
std::string SweepText(const ReadingSweep& sweep, std::uint64_t seed);

}  // namespace moontrace

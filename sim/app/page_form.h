#pragma once

#include <optional>
#include <string>

#include "textures/paper.h"
#include "textures/texture.h"

namespace moontrace {

/// How the letters and the paper that are felt differ from what is usual at their size. Factors
/// keep their meaning when the size changes.
struct PageForm {
  double depth = 1;                ///< of grooves, 0.2 to 2
  double width = 1;                ///< of grooves, with depth and rounding in proportion, 0.5 to 2
  double spacing = 1;              ///< from letter to letter and line to line, 1 to 3
  double pitch = 1;                ///< from line to line alone, on top of `spacing`, 1 to 3
  std::optional<Relief> relief;    ///< none: as the command line or lesson has it
  std::string h_form;              ///< as --h-form takes it; empty: as it was
  std::optional<PaperKind> paper;  ///< rough paper all over the sheet; none: smooth
  bool operator==(const PageForm&) const = default;
};

}  // namespace moontrace

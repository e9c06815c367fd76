#pragma once

#include <optional>
#include <string>

#include "textures/field/paper.h"
#include "textures/field/texture.h"

namespace moontrace {

struct Label;
struct LayoutOptions;
struct Script;
struct StyleOptions;

/// How letters and paper differ from what is usual at their size. Factors keep their meaning when
/// the size changes.
struct PageForm {
  double depth = 1;              ///< of grooves, 0.2 to 2
  double width = 1;              ///< of grooves, with depth and rounding in proportion, 0.5 to 2
  double spacing = 1;            ///< from letter to letter and line to line, 1 to 3
  double pitch = 1;              ///< from line to line alone, on top of `spacing`, 1 to 3
  std::optional<Relief> relief;  ///< none: as the command line or lesson has it
  std::string h_form;            ///< as --h-form takes it; empty: as it was
  /// Rough paper all over the sheet; none: smooth. The kind that the command line or model has
  /// stays as they have it.
  std::optional<PaperKind> paper;
  bool operator==(const PageForm&) const = default;
};

/// Makes options of a text those of the form; lengths in them are of letters of the size that
/// `letters`, `from` or the script say. `from` may be null.
void ApplyForm(const PageForm& form, const Script& script, const Label* from, StyleOptions& letters,
               LayoutOptions& layout);

}  // namespace moontrace

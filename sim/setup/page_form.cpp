#include "sim/setup/page_form.h"

#include "sim/setup/options.h"

namespace moontrace {

namespace {

/// Half an em stands between the strokes of neighbouring letters.
constexpr double kBetweenLetters = 0.5;  // [em]

void SetPaper(std::optional<PaperKind> paper, const TypeStyle& usual, SheetOptions& sheet) {
  const std::optional<PaperTexture>& given = usual.texture.paper;
  if (given ? paper == given->kind : !paper) return;
  sheet.texture = paper ? NameOf(*paper) : "none";
  const bool sizes_fit = paper && given && given->kind != PaperKind::kSampled;
  if (sizes_fit) return;
  sheet.amplitude = sheet.wavelength = sheet.angle = std::nullopt;
}

}  // namespace

void ApplyForm(const PageForm& form, const Script& script, const Label* from, StyleOptions& letters,
               LayoutOptions& layout) {
  if (form.relief) letters.embossed = *form.relief == Relief::kEmbossed;
  if (!form.h_form.empty()) letters.h_form = form.h_form;
  Script unchanged = script;  // StyleOf may reshape it
  const TypeStyle usual = StyleOf(letters, layout, unchanged, from);
  letters.width = form.width * usual.width;
  letters.depth = form.width * form.depth * usual.depth;
  letters.rounding = form.width * usual.rounding;
  layout.usual_pitch = layout.usual_pitch || !layout.line_pitch;
  layout.line_pitch = form.spacing * form.pitch * usual.line_pitch;
  layout.letter_gap = usual.letter_gap + (form.spacing - 1) * kBetweenLetters * usual.size;
  SetPaper(form.paper, usual, layout.sheet);
}

}  // namespace moontrace

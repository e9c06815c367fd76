#include "textures/typeset/sheet_texture.h"

#include <fmt/core.h>

#include <memory>

#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/field/pgm.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

namespace {

constexpr double kSteepest = 5;  // as of grooves

}  // namespace

bool IsTextureWord(std::string_view word) {
  const std::optional<PaperKind> kind = PaperKindOf(word);
  const std::string lower = LowerCase(word);
  const bool picture = lower.size() > 4 && lower.substr(lower.size() - 4) == ".pgm";
  return word == "none" || (kind && *kind != PaperKind::kSampled) || picture;
}

void ReadHeights(SheetTexture& texture) {
  if (texture.file.empty() || !texture.paper) return;
  texture.paper->heights = std::make_shared<const SampledHeights>(ReadPgm(texture.file));
}

void CheckSheetTexture(const TypeStyle& style, const Box& sheet_P) {
  if (!style.texture.paper) return;
  const PaperPatch patch{sheet_P, *style.texture.paper};
  Check(patch);
  const double strokes = GreatestSlope(Profile{style.width, style.depth, style.rounding});
  const double slope = BoundsOf(patch).slope;
  if (strokes + slope <= kSteepest) return;
  throw InputError(fmt::format(
      "texture slope {:.2f} on strokes of slope {:.2f}: above {:g}, choose a flatter one", slope,
      strokes, kSteepest));
}

void AddSheetTexture(const TextPage& page, const TypeStyle& style, Texture& texture) {
  if (!style.texture.paper || page.sheet_P.min.x >= page.sheet_P.max.x) return;
  texture.paper.push_back({page.sheet_P, *style.texture.paper});
}

}  // namespace moontrace

#include "sim/picture/sheet_messages.h"

#include <fmt/core.h>

#include <vector>

#include "sim/console/wording.h"
#include "textures/base/units.h"
#include "textures/typeset/rules.h"

namespace moontrace::say {

namespace {

std::string Mm(double metres) { return fmt::format("{:.3g} mm", kMillimetres * metres); }

std::string TextureName(const PaperTexture& paper) {
  switch (paper.kind) {
    case PaperKind::kSine:
      return "parallel waves";
    case PaperKind::kGrid:
      return "waves both ways";
    case PaperKind::kNoise:
      return "hills anyhow";
    case PaperKind::kSampled:
      break;
  }
  return fmt::format("a picture of {} by {} heights", paper.heights->columns(),
                     paper.heights->rows());
}

std::string TextureShape(const PaperTexture& paper) {
  const std::string height = fmt::format("{} up and down", Mm(paper.amplitude));
  if (paper.kind == PaperKind::kSampled && !paper.tiled) return height + ", stretched";
  return fmt::format("{}, {} {}", height, paper.kind == PaperKind::kSampled ? "tiles of" : "every",
                     Mm(paper.wavelength));
}

const char* HowDrawn(PaperDrawn drawn) {
  switch (drawn) {
    case PaperDrawn::kShaded:
      return "its crests shaded";
    case PaperDrawn::kTooFine:
      return "too fine to be drawn";
    case PaperDrawn::kLeftOut:
      return "left out here";
  }
  return "";
}

}  // namespace

std::string Rules(const TypeStyle& style, std::size_t count) {
  const Profile rule = RuleProfile(style);
  return fmt::format("Line rules: {}, {} wide, {} high.", count, Mm(rule.width), Mm(rule.depth));
}

std::string RaisedMargin(const TypeStyle& style) {
  const Profile ridge = MarginProfile(style);
  return fmt::format("Raised margin: {} wide, {} high.", Mm(ridge.width), Mm(ridge.depth));
}

std::string TurnsBack(const char* what, const Profile& ridge) {
  return fmt::format("{} turns the tip back up to {:.2f} N at 1 N of press.", what,
                     TurningForce(ridge, 1));
}

std::string SheetTexture(const TypeStyle& style) {
  const PaperTexture& paper = *style.texture.paper;
  return fmt::format("Texture: {}, {}.", TextureName(paper), TextureShape(paper));
}

std::string SheetWords(const TypeStyle& style, PaperDrawn drawn) {
  std::string words;
  if (style.rules.lines) {
    words += fmt::format(" Line rules {} wide, green.", Mm(RuleProfile(style).width));
  }
  if (style.rules.margin) {
    words += fmt::format(" Raised margin {} wide, green.", Mm(MarginProfile(style).width));
  }
  if (style.texture.paper) {
    const PaperTexture& paper = *style.texture.paper;
    words += fmt::format(" Paper rough with {}, {}, {}.", TextureName(paper), TextureShape(paper),
                         HowDrawn(drawn));
  }
  return words;
}

}  // namespace moontrace::say

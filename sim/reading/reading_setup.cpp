#include "sim/reading/reading_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/reading/known_links.h"
#include "textures/base/random.h"
#include "textures/base/units.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kGreatestTurn = 3 * kDegree;
constexpr double kPutWithin = 0.5;  ///< sizes

/// Alternating lines begin to the right, and guide lines tell of the others.
LinesRun RunOf(LineDirection lines) {
  switch (lines) {
    case LineDirection::kRightToLeft:
      return LinesRun::kLeft;
    case LineDirection::kVertical:
      return LinesRun::kDown;
    case LineDirection::kLeftToRight:
    case LineDirection::kAlternate:
      break;
  }
  return LinesRun::kRight;
}

}  // namespace

bool IsFollowed(const TypeStyle& style, const Script& script) {
  return style.relief == Relief::kEngraved && script.braille_tables.empty() &&
         style.links.reach == LinkReach::kNone;
}

std::shared_ptr<const SignShapes> KnownShapes(const Script& script,
                                              const std::vector<TextPage>& pages) {
  constexpr double kSixDots = -0.25;  // lowest ink is above this [em]
  const bool dots = !script.braille_tables.empty();
  const auto has_more = [&script](std::size_t glyph) {
    for (const Stroke& stroke : script.glyphs[glyph].strokes) {
      for (const Piece& piece : stroke.pieces) {
        if (BoundsOf(piece).min.y < kSixDots) return true;
      }
    }
    return false;
  };
  bool eight = !dots;
  for (const TextPage& page : pages) {
    for (const PlacedGlyph& placed : page.glyphs) eight = eight || has_more(placed.glyph);
  }
  std::vector<std::size_t> which = WrittenGlyphs(script);
  if (!eight) std::erase_if(which, has_more);
  return std::make_shared<const SignShapes>(
      script, which, dots ? SignShapes::Dots::kMiddles : SignShapes::Dots::kFloors);
}

double ReadingPress(const HandModel& hand, const TypeStyle& style, const Script& script) {
  // shares of the light press, chosen on seeds 1 to 20
  constexpr double kRaisedDots = 0.3, kDots = 1.75;
  if (IsFollowed(style, script)) return hand.press;
  if (script.braille_tables.empty()) return hand.light_press;
  return hand.light_press * (style.relief == Relief::kEmbossed ? kRaisedDots : kDots);
}

ReaderKnowledge ToldOf(const LedHandSetup& setup, const TypeStyle& style) {
  ReaderKnowledge knowledge;
  knowledge.press = setup.hand.press;
  knowledge.hand_mass = setup.hand.mass;
  knowledge.hand_stiffness = setup.hand.stiffness;
  knowledge.hand_damping = setup.hand.damping;
  knowledge.delay = setup.senses.delay;
  knowledge.lag = setup.muscle.lag;
  knowledge.unsure = setup.senses.unsure;
  knowledge.width = style.width;
  knowledge.depth = style.depth;
  knowledge.raised = style.relief == Relief::kEmbossed;
  knowledge.device_stiffness = setup.scene.rendering == Rendering::kProxy
                                   ? setup.scene.coupling_stiffness
                                   : std::numeric_limits<double>::infinity();
  return knowledge;
}

void CompleteSetup(ReadingSetup& setup, std::shared_ptr<const SignShapes> shapes,
                   const Script& script, const TypeStyle& style, std::uint64_t seed) {
  ReaderKnowledge& knowledge = setup.knowledge;
  knowledge = ToldOf(setup, style);
  knowledge.shapes = std::move(shapes);
  knowledge.space = script.space_advance;
  knowledge.followed = IsFollowed(style, script);
  if (style.links.reach != LinkReach::kNone) {
    knowledge.link_depth = style.links.depth;
    knowledge.links = KnownLinks(knowledge.shapes, script, style);
  }
  knowledge.lines = RunOf(style.lines);
  if (style.structure.read) knowledge.heading_scale = style.structure.heading_scale;
  // one draw a statement: compilers differ in the order of arguments
  Random random(seed);
  setup.hand_seed = random.Bits();
  setup.reader_seed = random.Bits();
  knowledge.least_size = style.size * std::exp2(-random.Uniform());
  knowledge.greatest_size = 2 * knowledge.least_size;
  setup.page_turn = kGreatestTurn * (2 * random.Uniform() - 1);
  const double up = 2 * random.Uniform() - 1;
  const double right = 2 * random.Uniform() - 1;
  const Box& area = setup.page->text_area_P;
  const double side = knowledge.lines == LinesRun::kRight ? area.min.x : area.max.x;
  setup.start_P = glm::dvec2(side, area.max.y) + kPutWithin * style.size * glm::dvec2(right, up);
}

bool CanBeReadOn(const DeviceLimits& limits, bool followed) {
  return (followed || limits.measures.z) && limits.measures.x && limits.measures.y &&
         limits.pushes.x && limits.pushes.y;
}

PageSpec SheetWithin(const DeviceLimits& limits) {
  constexpr double kMargin = 0.005;  // [m]
  PageSpec sheet = FindPage("a4");
  const glm::dvec2 reach = 2.0 * glm::dvec2(limits.workspace_D);
  if (!(reach.x < sheet.width) && !(reach.y < sheet.height)) return sheet;
  return {"custom", std::min(sheet.width, reach.x), std::min(sheet.height, reach.y), kMargin};
}

}  // namespace moontrace

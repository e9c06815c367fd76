#include "sim/reading/known_links.h"

#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "textures/relief/letter_links.h"

namespace moontrace {
namespace {

constexpr double kApart = 0.03;  ///< from one point of a way to the next [em]

/// Adds what lies along a link; its first and last `from` and `to` [m] are as deep as letters.
void AddWay(const std::vector<Piece>& spine, double from, double to, double size, LinkWay& way) {
  const double all = Length(spine);
  double before = 0;
  for (const Piece& piece : spine) {
    const double length = Length(piece);
    const int count = 1 + static_cast<int>(length / (kApart * size));
    for (int i = 0; i <= count; ++i) {
      const double s = length * i / count;
      const glm::dvec2 p = PointAt(piece, s) / size;
      way.all.push_back(p);
      if (before + s < from || before + s > all - to) way.deep.push_back(p);
    }
    before += length;
  }
}

class Finder {
 public:
  Finder(const SignShapes& shapes, const Script& script, const TypeStyle& told, double size)
      : shapes_(shapes), style_(DefaultStyle(size, told.relief, script)) {
    style_.width = told.width;
    style_.depth = told.depth;
    style_.links = told.links;
    links_.emplace(script, style_, LineKind::kPlain);
  }

  LinkWay Between(std::size_t a, std::size_t b, double gap) {
    const double size = style_.size;
    const LetterLink link = links_->Between(shapes_.GlyphOf(a), shapes_.GlyphOf(b),
                                            {(shapes_.Advance(a) + gap) * size, 0}, {});
    LinkWay way;
    AddWay(link.spine, link.from_level, link.to_level, size, way);
    return way;
  }

  LinkWay Within(std::size_t sign) {
    LinkWay way;
    const double level = links_->OpenLevel();
    for (const std::vector<Piece>& spine : links_->LetterOf(shapes_.GlyphOf(sign)).inner) {
      AddWay(spine, level, level, style_.size, way);
    }
    return way;
  }

 private:
  const SignShapes& shapes_;
  TypeStyle style_;
  std::optional<LetterLinks> links_;
};

}  // namespace

std::function<std::shared_ptr<const LinkShapes>(double size)> KnownLinks(
    std::shared_ptr<const SignShapes> shapes, const Script& script, const TypeStyle& style) {
  return [shapes = std::move(shapes), script = std::make_shared<const Script>(script),
          style](double size) {
    Finder finder(*shapes, *script, style, size);
    const auto over = [&finder](double gap) {
      return [&finder, gap](std::size_t a, std::size_t b) { return finder.Between(a, b, gap); };
    };
    LinkShapes::Between across;
    if (style.links.reach == LinkReach::kWords) across = over(script->space_advance);
    return std::make_shared<const LinkShapes>(
        shapes->size(), over(0), across,
        [&finder](std::size_t sign) { return finder.Within(sign); });
  };
}

}  // namespace moontrace

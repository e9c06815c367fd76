#include "lessons/course/likeness.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "lessons/course/lesson_items.h"
#include "lessons/course/taught_signs.h"
#include "textures/field/piece.h"
#include "textures/fonts/script_library.h"

namespace moontrace {

namespace {

using Points = std::vector<glm::dvec2>;

// Ours, [em]. Mates of a font differ by some hundredths in width, and by the radius of a corner.
constexpr double kSame = 0.12;
constexpr double kStep = 0.02;          ///< between points of a line
constexpr double kBeginning = 0.45;     ///< length of line that is a beginning
constexpr double kSameBeginning = 0.1;  ///< mean distance of two that are alike

Points PointsOf(const Stroke& stroke, double most) {
  Points points;
  const double length = std::min(most, Length(stroke.pieces));
  for (double s = 0; s <= length && !stroke.pieces.empty(); s += kStep) {
    points.push_back(PointAlong(stroke.pieces, s));
  }
  return points;
}

/// All lines of a sign, the middle of their box at the origin.
Points Centred(const Glyph& glyph) {
  Points all;
  Box box;
  for (const Stroke& stroke : glyph.strokes) {
    for (const glm::dvec2 p : PointsOf(stroke, std::numeric_limits<double>::infinity())) {
      all.push_back(p);
      Include(box, p);
    }
  }
  for (glm::dvec2& p : all) p -= 0.5 * (box.min + box.max);
  return all;
}

double FarthestFrom(const Points& from, const Points& to) {
  double farthest = 0;
  for (const glm::dvec2 p : from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::dvec2 q : to) nearest = std::min(nearest, glm::distance(p, q));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

/// Whether b is a once its axes are laid along these.
bool Becomes(Points a, const Points& b, glm::dvec2 x_axis, glm::dvec2 y_axis) {
  for (glm::dvec2& p : a) p = p.x * x_axis + p.y * y_axis;
  return std::max(FarthestFrom(a, b), FarthestFrom(b, a)) <= kSame;
}

bool BeginAlike(const Glyph& a, const Glyph& b) {
  if (a.strokes.empty() || b.strokes.empty()) return false;
  const Points first = PointsOf(a.strokes.front(), kBeginning);
  const Points second = PointsOf(b.strokes.front(), kBeginning);
  const std::size_t count = std::min(first.size(), second.size());
  if (static_cast<double>(count) * kStep < 0.5 * kBeginning) return false;  // a dot begins nothing
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += glm::distance(first[i] - first[0], second[i] - second[0]);
  }
  return sum <= kSameBeginning * static_cast<double>(count);
}

}  // namespace

std::string_view NameOf(Likeness likeness) {
  switch (likeness) {
    case Likeness::kTurned:
      return "turned";
    case Likeness::kMirrored:
      return "mirrored";
    case Likeness::kBeginsAlike:
      return "begins alike";
    case Likeness::kOther:
      break;
  }
  return "otherwise";
}

Likeness LikenessOf(const Glyph& a, const Glyph& b) {
  const Points first = Centred(a), second = Centred(b);
  if (first.empty() || second.empty()) return Likeness::kOther;
  if (Becomes(first, second, {-1, 0}, {0, 1}) || Becomes(first, second, {1, 0}, {0, -1})) {
    return Likeness::kMirrored;
  }
  // by a quarter to the left, to the right, by a half
  const bool turned = Becomes(first, second, {0, 1}, {-1, 0}) ||
                      Becomes(first, second, {0, -1}, {1, 0}) ||
                      Becomes(first, second, {-1, 0}, {0, -1});
  if (turned) return Likeness::kTurned;
  return BeginAlike(a, b) ? Likeness::kBeginsAlike : Likeness::kOther;
}

ItemLikeness::ItemLikeness(const Course& course) {
  for (const Lesson& lesson : course.lessons) {
    try {
      std::string text;
      for (const std::string& item : lesson.items) text += item + "\n";
      const Script script = FindScript(lesson.script.empty() ? course.script : lesson.script, text);
      for (const std::string& item : lesson.items) {
        const SignUse use = SignsOf(item, script, lesson.grade, nullptr);
        if (!TeachesSigns(item, use)) continue;
        const std::size_t sign = script.Find(use.signs.back());
        if (sign != Script::npos) glyphs_[item] = script.glyphs[sign];
      }
    } catch (const std::exception&) {
      continue;  // what the script cannot tell, the texts do
    }
  }
}

Likeness ItemLikeness::Of(const std::string& a, const std::string& b) const {
  const auto first = glyphs_.find(a), second = glyphs_.find(b);
  if (first != glyphs_.end() && second != glyphs_.end()) {
    return LikenessOf(first->second, second->second);
  }
  if (first != glyphs_.end() || second != glyphs_.end()) return Likeness::kOther;
  const bool alike = !a.empty() && !b.empty() && a.front() == b.front();
  return alike ? Likeness::kBeginsAlike : Likeness::kOther;
}

}  // namespace moontrace

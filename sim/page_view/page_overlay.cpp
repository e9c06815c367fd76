#include "sim/page_view/page_overlay.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace moontrace {

namespace {

/// Where a point of the page is seen [points], in this part of the picture or beside it; none:
/// behind the eye.
std::optional<glm::dvec2> SeenAt(glm::dvec3 p_P, const PageCamera& camera, const PixelBox& box) {
  const double aspect = static_cast<double>(box.width) / box.height;
  const std::optional<glm::dvec2> share = ShareOf(camera, aspect, p_P);
  if (!share) return std::nullopt;
  return glm::dvec2(box.x + share->x * box.width, box.y + share->y * box.height);
}

/// Points of the page as lines in the picture; what is far beyond the view is left out.
class Lines {
 public:
  Lines(const PageCamera& camera, const PixelBox& box, Canvas& canvas)
      : camera_(camera), box_(box), canvas_(canvas) {}

  void Line(glm::dvec2 from_P, glm::dvec2 to_P, double thick, const Color& color) {
    const std::optional<glm::dvec2> from = At(from_P), to = At(to_P);
    if (from && to) canvas_.Line({*from, *to}, thick, color);
  }

  void Outline(const Box& area, double thick, const Color& color) {
    const glm::dvec2 b(area.max.x, area.min.y), d(area.min.x, area.max.y);
    Line(area.min, b, thick, color);
    Line(b, area.max, thick, color);
    Line(area.max, d, thick, color);
    Line(d, area.min, thick, color);
  }

  void Stroke(const std::vector<Piece>& pieces, double thick, const Color& color) {
    constexpr double kStep = 0.005;  // of the picture's height
    for (const Piece& piece : pieces) {
      const double length = Length(piece);
      const int count = std::clamp(static_cast<int>(length / (kStep * camera_.height)), 1, 100);
      for (int i = 0; i < count; ++i) {
        Line(PointAt(piece, length * i / count), PointAt(piece, length * (i + 1) / count), thick,
             color);
      }
    }
  }

  void Way(const std::vector<ViewMarks::PathPoint>& path, double thick) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (path[i].begins) continue;
      Line(glm::dvec2(path[i - 1].p_P), glm::dvec2(path[i].p_P), thick,
           Mixed(view_color::kOnStroke, view_color::kOffStroke, std::min(path[i].off, 1.0)));
    }
  }

 private:
  std::optional<glm::dvec2> At(glm::dvec2 p_P) const {
    constexpr double kFar = 20;  // pictures
    const std::optional<glm::dvec2> at = SeenAt(glm::dvec3(p_P, 0), camera_, box_);
    const bool far = at && (std::abs(at->x - box_.x) > kFar * box_.width ||
                            std::abs(at->y - box_.y) > kFar * box_.height);
    return far ? std::nullopt : at;
  }

  const PageCamera& camera_;
  const PixelBox& box_;
  Canvas& canvas_;
};

/// The same; none: not in this part.
std::optional<glm::dvec2> PlaceOf(glm::dvec3 p_P, const PageCamera& camera, const PixelBox& box) {
  const std::optional<glm::dvec2> at = SeenAt(p_P, camera, box);
  return at && box.Has(at->x, at->y) ? at : std::nullopt;
}

void DrawPrint(const ViewMarks::Print& print, const PageCamera& camera, const PixelBox& box,
               Canvas& canvas) {
  const std::optional<glm::dvec2> at = PlaceOf(glm::dvec3(print.at_P, 0), camera, box);
  if (!at) return;
  const int width = canvas.TextWidth(print.text, print.big);
  const int height = canvas.TextHeight(print.big);
  const int x = static_cast<int>(at->x) - width / 2, y = static_cast<int>(at->y) - height / 2;
  const bool inside = x >= box.x && y >= box.y && x + width <= box.x + box.width &&
                      y + height <= box.y + box.height;
  if (inside) canvas.Text(print.text, x, y, print.big, view_color::kPrint);
}

/// A piece of the pen: so far from its point [units] and so wide there.
struct PenPart {
  double from, half_from, to, half_to;
  Color color;
};

constexpr double kPenLength = 20, kPenHalf = 0.8;  // [units]
constexpr Color kBarrel{0.16, 0.22, 0.32}, kShine{0.42, 0.50, 0.62}, kCone{0.66, 0.68, 0.71},
    kPoint{0.08, 0.08, 0.10};
constexpr PenPart kPen[] = {{0, 0.08, 1.1, 0.33, kPoint},
                            {1.1, 0.33, 3.6, kPenHalf, kCone},
                            {3.6, kPenHalf, kPenLength, kPenHalf, kBarrel},
                            {kPenLength - 1.6, kPenHalf, kPenLength, kPenHalf, kCone}};

/// The pen with its point at `at`: it leans to the lower right, where it hides little of the line
/// that is read.
struct Pen {
  glm::dvec2 at;
  double unit;
  glm::dvec2 along{0.60, -0.80}, across{0.80, 0.60};

  std::vector<glm::dvec2> Part(double from, double low_from, double high_from, double to,
                               double low_to, double high_to) const {
    const auto corner = [&](double far, double side) {
      return at + unit * (far * along + side * across);
    };
    return {corner(from, low_from), corner(from, high_from), corner(to, high_to),
            corner(to, low_to)};
  }
  std::vector<glm::dvec2> Part(const PenPart& part) const {
    return Part(part.from, -part.half_from, part.half_from, part.to, -part.half_to, part.half_to);
  }
};

void DrawStylus(glm::dvec3 tip_P, const PageCamera& camera, const PixelBox& box, Canvas& canvas) {
  constexpr double kMostLift = 8, kShadow = 0.35;  // [units]
  // what lies in a groove is seen where the paper is, as the page is drawn flat
  const glm::dvec3 point(tip_P.x, tip_P.y, std::max(tip_P.z, 0.0));
  const std::optional<glm::dvec2> at = PlaceOf(point, camera, box);
  const std::optional<glm::dvec2> foot = PlaceOf(glm::dvec3(tip_P.x, tip_P.y, 0), camera, box);
  if (!at || !foot) return;
  const double unit = std::max(0.01 * box.height, 2.0);
  const double lift = std::min(point.z / camera.height * 100, kMostLift);
  const Pen shadow{*foot + unit * (lift + kShadow) * glm::dvec2(0.9, -0.3), unit};
  for (const PenPart& part : kPen) canvas.Shape(shadow.Part(part), {0, 0, 0}, 0.16);
  const Pen pen{*at, unit};
  for (const PenPart& part : kPen) canvas.Shape(pen.Part(part), part.color);
  canvas.Shape(pen.Part(3.6, 0.15, 0.6, kPenLength - 1.6, 0.15, 0.6), kShine);
}

}  // namespace

void DrawPageOverlay(const ViewMarks& marks, const PageCamera& camera, const PixelBox& box,
                     Canvas& canvas) {
  Lines lines(camera, box, canvas);
  if (marks.letter_P) lines.Outline(*marks.letter_P, 2, view_color::kLetter);
  for (const std::vector<Piece>& stroke : marks.stroke_P) {
    lines.Stroke(stroke, 3, view_color::kLetter);
  }
  lines.Way(marks.path, 3.5);
  for (const ViewMarks::Print& print : marks.print) DrawPrint(print, camera, box, canvas);
  if (marks.tip_P) DrawStylus(*marks.tip_P, camera, box, canvas);
}

}  // namespace moontrace

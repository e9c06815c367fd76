#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim/page_view/view_look.h"
#include "sim/picture/drawing.h"

namespace moontrace {

/// The mouse as controls see it.
struct CanvasMouse {
  glm::dvec2 at{-1, -1};  ///< from the lower left [points]
  bool left = false;      ///< held down
  double wheel = 0;       ///< notches since the frame before
};

/// Letters and shapes with smooth edges, over whatever OpenGL drew before, by Dear ImGui. Points
/// are those of the picture, from its lower left. All calls on the thread of the OpenGL context
/// that was current when it was made, and before that ends; what is drawn, between Begin and End.
class Canvas {
 public:
  /// `text` is the height of its letters [points]; big ones are kBig times as high. Throws
  /// LackError: built without Dear ImGui, or no TrueType font is installed.
  explicit Canvas(int text);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  static constexpr double kBig = 1.4;

  /// A frame of this size. One canvas at a time in a program: others wait for its end.
  void Begin(int width, int height, const CanvasMouse& mouse);
  /// Draws it into the buffer that OpenGL draws into, or forgets it.
  void End(bool draw);
  int height() const;  ///< of this frame [points]

  int TextHeight(bool big) const;
  int TextWidth(std::string_view text, bool big) const;
  /// With its left lower corner at a point.
  void Text(std::string_view text, int x, int y, bool big, const Color& color);

  void Fill(const PixelBox& box, const Color& color);
  /// Round a box, outside it, so many points thick.
  void Frame(const PixelBox& box, int thick, const Color& color);
  void Line(const std::vector<glm::dvec2>& points, double thick, const Color& color);
  /// A convex shape; `alpha` 0 to 1.
  void Shape(const std::vector<glm::dvec2>& corners, const Color& color, double alpha = 1);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace

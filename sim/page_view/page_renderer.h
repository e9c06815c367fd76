#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/page_view/page_camera.h"
#include "sim/picture/drawing.h"
#include "sim/picture/raster.h"
#include "textures/field/element.h"

namespace moontrace {

/// Colours that colour-blind people tell apart (after Okabe and Ito, 2008), dark enough to be seen
/// on paper: contrast of 3 and more, the print of 4.5 (WCAG 2.1 AA).
namespace view_color {
inline constexpr Color kForce{0.00, 0.45, 0.70};      ///< blue
inline constexpr Color kGuidance{0.72, 0.44, 0.00};   ///< orange
inline constexpr Color kOnStroke{0.00, 0.55, 0.40};   ///< bluish green
inline constexpr Color kOffStroke{0.80, 0.30, 0.00};  ///< vermilion
inline constexpr Color kLetter{0.70, 0.36, 0.56};     ///< reddish purple
inline constexpr Color kPrint{0.35, 0.12, 0.30};      ///< letters for the sighted
}  // namespace view_color

/// What is drawn over the page, frame P: here what stands in space (proxy, bead, forces), by
/// DrawPageOverlay the rest.
struct ViewMarks {
  std::optional<glm::dvec3> tip_P, proxy_P;  ///< [m]
  glm::dvec3 force_P{0, 0, 0};               ///< on the hand [N]
  glm::dvec3 guidance_P{0, 0, 0};            ///< the push within it [N]
  std::optional<glm::dvec2> bead_P;          ///< [m]
  /// The tip's path: `off` 0 on the stroke, 1 at half a groove's width and beyond.
  struct PathPoint {
    glm::dvec3 p_P{0, 0, 0};  ///< [m]
    double off = 0;
    bool begins = false;  ///< no line from the point before
  };
  std::vector<PathPoint> path;
  std::optional<Box> letter_P;               ///< the current one [m]
  std::vector<std::vector<Piece>> stroke_P;  ///< the current stroke's centre line [m]
  struct Print {
    glm::dvec2 at_P{0, 0};  ///< its middle [m]
    std::string text;       ///< UTF-8
    bool big = false;
  };
  std::vector<Print> print;  ///< letters for the sighted
};

/// What a renderer is made for.
struct RendererSize {
  int width = 0, height = 0;  ///< of the picture, and the most that a surface has [points]
};

/// Draws the page by MuJoCo's renderer into whatever OpenGL context is current when it is made; all
/// calls on that thread. The page's surface is a picture that was shaded elsewhere
/// (field_shading.h), laid where it was shaded for.
class PageRenderer {
 public:
  /// Throws LackError: OpenGL too old, no memory.
  explicit PageRenderer(const RendererSize& size);
  PageRenderer(int width, int height) : PageRenderer(RendererSize{width, height}) {}
  ~PageRenderer();
  PageRenderer(PageRenderer&&) noexcept;
  PageRenderer& operator=(PageRenderer&&) noexcept;

  const RendererSize& size() const;

  /// The surface from now on; `raster` is no larger than size(). Costs some 10 ms.
  void SetSurface(const Raster& raster, const Box& covers_P);
  /// Colour of what no surface covers.
  void SetDesk(const Color& color);
  /// From now on all is drawn into the window, or into the picture.
  void Aim(bool window);
  /// Draws into a rectangle; `x`, `y` its lower left corner.
  void Draw(const PageCamera& camera, const ViewMarks& marks, int x, int y, int width, int height);
  /// The picture as it is now.
  Raster Picture();
  /// All of the picture drawn with these.
  Raster DrawToPicture(const PageCamera& camera, const ViewMarks& marks);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace

#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "sim/model_view/model_camera.h"
#include "sim/model_view/sight.h"
#include "sim/model_view/view_model.h"
#include "sim/picture/drawing.h"
#include "sim/picture/raster.h"

namespace moontrace {

/// What is drawn into the model's world besides.
struct SceneMarks {
  struct Ball {
    glm::dvec3 p_W{0, 0, 0};  ///< [m]
    double radius = 0;        ///< [m]
    Color color;
    double alpha = 1;
  };
  struct Arrow {
    glm::dvec3 from_W{0, 0, 0}, to_W{0, 0, 0};  ///< [m]
    double width = 0;                           ///< [m]
    Color color;
  };
  struct Line {
    glm::dvec3 from_W{0, 0, 0}, to_W{0, 0, 0};  ///< [m]
    double width = 3;                           ///< [points]
    Color color;
  };
  std::vector<Ball> balls;
  std::vector<Arrow> arrows;
  std::vector<Line> lines;
};

/// Draws a model by MuJoCo's renderer, with what its <visual> asks for, and its labels on the geoms
/// that carry them, into whatever OpenGL context is current when it is made; all calls on that
/// thread.
class ModelScene {
 public:
  /// For pictures up to this size [points]. Throws LackError: no memory, OpenGL too old.
  ModelScene(std::shared_ptr<const ViewModel> model, int width, int height);
  ~ModelScene();
  ModelScene(ModelScene&&) noexcept;
  ModelScene& operator=(ModelScene&&) noexcept;

  const ViewModel& model() const;
  /// As everything stands.
  const mjData& data() const;
  void SetPose(const ScenePose& pose);
  /// What lies on the label that is the page, and where there may be something of it [m].
  void SetPage(std::shared_ptr<const TextureField> field, const Box& area_P);
  /// Whether there is a stylus.
  void ShowTip(bool shown);
  /// Deep grooves are black.
  void SetHighContrast(bool wanted);

  mjvCamera camera;  ///< from where it is looked at; first at the page's label
  /// Where that is, for a part of the picture of this width over height.
  Sight Look(double aspect);

  /// From now on all is drawn into the window, or into the picture.
  void Aim(bool window);
  /// Draws into a rectangle; `x`, `y` its lower left corner.
  void Draw(const SceneMarks& marks, int x, int y, int width, int height);
  /// The picture as it is now.
  Raster Picture();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace

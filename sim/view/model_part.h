#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/model_view/model_scene.h"
#include "sim/page_view/canvas.h"
#include "sim/page_view/view_look.h"
#include "sim/page_view/view_page.h"
#include "sim/view/view_history.h"
#include "sim/view/view_marks.h"

namespace moontrace {

/// The part of the view that shows a model in place of a page: all its geoms, its labels, the hand
/// and its way. Belongs to the thread of the OpenGL context that was current when it was made.
class ModelPart {
 public:
  /// For pictures up to this size [points]. Throws LackError: no memory.
  ModelPart(std::shared_ptr<const ViewModel> model, int width, int height);

  bool Holds(int width, int height) const { return width <= width_ && height <= height_; }
  std::shared_ptr<const ViewModel> model() const { return model_; }
  ModelScene& scene() { return scene_; }
  /// Keeps view and pose of a part that was smaller.
  void Continue(const ModelPart& before);

  /// The page that lies on its label now.
  void ShowPage(const ViewPage& page);
  void Add(const ViewMoment& moment);

  void LookAt(const ViewTarget& target, double aspect);
  void SetFollow(bool follow) { follow_ = follow; }
  /// See model_camera.h; `by` in heights of the picture.
  void Turn(glm::dvec2 by, double aspect);
  void Shift(glm::dvec2 by, double aspect);
  void Zoom(glm::dvec2 share, double factor, double aspect);
  /// The point of the page under a point of the picture [m]; none: its geom is not there.
  std::optional<glm::dvec2> PointUnder(glm::dvec2 share, double aspect);

  /// Draws it into `box`. `letter`: heights of a small and a big print letter [points].
  struct Letters {
    double small = 0, big = 0;
  };
  void Draw(const ViewPage* page, const ViewHistory& history, const ViewLook& look,
            const PixelBox& box, const Letters& letters);
  /// The letters in print of what was drawn last.
  void DrawPrint(const PixelBox& box, Canvas& canvas) const;
  /// What is seen there, in sentences.
  std::vector<std::string> Seen(double aspect);

 private:
  glm::dvec3 OnLabel(glm::dvec3 p_P) const;
  SceneMarks MarksInWorld(const ViewMarks& marks, const Sight& sight) const;
  void Follow(double aspect);
  void Free(double aspect);

  std::shared_ptr<const ViewModel> model_;
  int width_, height_;
  ModelScene scene_;
  Pose X_WP_;
  std::optional<ViewMoment> now_;
  bool looks_ = false, follow_ = false;
  ViewTarget target_;
  struct Print {
    glm::dvec2 share;
    std::string text;
    bool big = false;
  };
  std::vector<Print> print_;
};

}  // namespace moontrace

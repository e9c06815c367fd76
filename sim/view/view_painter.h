#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/model_view/view_model.h"
#include "sim/page_view/page_camera.h"
#include "sim/page_view/view_look.h"
#include "sim/picture/raster.h"
#include "sim/view/view_history.h"
#include "sim/view/view_panel.h"

namespace moontrace {

/// Draws all that the view shows, into a window or a picture: page, marks, panel, plots and lines.
/// All calls on the thread of the OpenGL context that was current when it was made, and before that
/// ends.
class ViewPainter {
 public:
  /// Throws LackError: no memory.
  ViewPainter(bool window, int width, int height, const ViewLook& look);
  ~ViewPainter();
  ViewPainter(const ViewPainter&) = delete;
  ViewPainter& operator=(const ViewPainter&) = delete;

  void Show(std::shared_ptr<const ViewPage> page);
  /// From now on this model is shown; pages lie on its label.
  void ShowModel(std::shared_ptr<const ViewModel> model);
  void Add(const ViewMoment& moment);
  /// The lower edge: the last line shown, the line being typed, and what the mouse does.
  /// Lines that come together stand whole, over the page, as long as it takes to read them; then
  /// the last, as far as it has room.
  void ShowLines(std::vector<std::string> lines);
  void SetTyped(std::string_view typed);
  void SetHint(std::string_view hint);
  void SetControls(std::vector<PanelControl> controls);
  ViewPanel& panel();

  const ViewLook& look() const;
  void SetLook(const ViewLook& look);
  void Resize(int width, int height);
  const ViewLayout& layout() const;
  /// It is too small for the panel or the lines that it should have.
  bool cramped() const;
  /// Where the panel's mouse is answered.
  void PanelEvent(const WindowEvent& event, double now);

  double aspect() const;  ///< of the page's part
  bool shows_model() const;
  const PageCamera& camera() const;  ///< on a page
  void SetCamera(const PageCamera& camera);
  /// What is under a share of the page's part comes to be under another.
  void Drag(glm::dvec2 from, glm::dvec2 to);
  /// Leans a page, turns round a model; `by` in heights of the page's part.
  void TurnBy(glm::dvec2 by);
  void ZoomBy(double factor, glm::dvec2 share);
  /// Or the whole model.
  void ShowWholePage();
  /// At a label, geom, body or camera of the model that is shown.
  void LookAt(const ViewTarget& target);
  /// The point of the page under a share of its part [m]; none: it is not there.
  std::optional<glm::dvec2> PointUnder(glm::dvec2 share);
  /// What is seen of a model, in sentences.
  std::vector<std::string> Seen();
  void SetFollow(bool follow);

  /// Whether Draw would show anything new.
  bool changed();
  void Draw();
  Raster Picture();
  /// Waits until the surface of what is to be seen is there.
  void Await();
  /// How long the last change of view or page took until it was drawn whole [ms]; given once.
  std::optional<double> TakeChange();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace

#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/picture/raster.h"
#include "sim/view/page_camera.h"
#include "sim/view/view_history.h"
#include "sim/view/view_look.h"
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

  const PageCamera& camera() const;
  double aspect() const;  ///< of the page's part
  void SetCamera(const PageCamera& camera);
  void ZoomBy(double factor, glm::dvec2 share);
  void ShowWholePage();
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

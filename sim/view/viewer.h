#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/model_view/view_model.h"
#include "sim/page_view/view_page.h"
#include "sim/view/panel.h"
#include "sim/view/viewer_options.h"

namespace moontrace {

/// The view of the page, the hand on it and the tutor's panel, drawn by a thread of its own that
/// does all of OpenGL and of the window. But for DrawFrame nothing here ever waits for it, and it
/// never touches the loop: it is given what to show, and asked. All calls from one thread.
class Viewer {
 public:
  /// Throws LackError, one line: no display, no OpenGL, built without, or the folder of frames
  /// cannot be made; InputError: there are frames in it.
  explicit Viewer(const ViewerOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// From now on this model is shown, and pages lie on its label. Throws InputError: it has nothing
  /// of the name ViewerOptions::camera.
  void ShowModel(std::shared_ptr<const ViewModel> model);
  /// From now on this page is shown.
  void Show(std::shared_ptr<const ViewPage> page);
  /// The newest instant; those between are not lost to plots and to the tip's path, as long as
  /// there are fewer than 4000 between two frames.
  void Add(const ViewMoment& moment);
  /// Offline: the next frame shows what was given until now. Waits until it is written, so that the
  /// same calls write the same frames on every machine. Does nothing behind the last, or once
  /// nothing is drawn any more.
  void DrawFrame();
  /// What the panel holds; then its values, one a control, as often as they change.
  void SetPanel(std::vector<PanelControl> controls);
  void SetPanelValues(std::vector<PanelValue> values);
  /// A line of the text face, also shown in the window: its lower edge, with those of the same
  /// moment, and its title.
  void ShowLine(std::string_view line);

  /// What was said by panel or keyboard since the last call, in order.
  std::optional<ViewLine> NextLine();
  /// What the view has to say of itself, a sentence: too small for its panel, minimised.
  std::optional<std::string> NextNotice();
  /// A word that concerns the view alone ("zoom in", "whole page", "print off"): done, and answered
  /// by one sentence; none: no such word. The words: ViewWords. Of a model also "view NAME", and
  /// "view", which is answered by what can be looked at, and by a notice what is seen.
  std::optional<std::string> Obey(std::string_view line);
  /// The window was closed by its user.
  bool closed() const;
  /// Empty while it draws; otherwise why it does not any more, one sentence (display or device
  /// lost, no room for frames).
  std::string failure() const;
  ViewerReport report() const;
  /// Ends it; of frames at least one is there, if there was a page. Waits until it is done, but not
  /// for a display that hangs. Nothing is drawn from then on.
  void Finish();

 private:
  struct State;
  std::shared_ptr<State> state_;  // the thread's too: it outlives a viewer whose display hangs
};

/// One picture of a page, without a display: what a viewer of this size shows, with panel and
/// values where given, without plots where there are no moments. Of a model where one is given, on
/// whose label the page lies; then what is seen is given back, in sentences. Throws LackError as
/// Viewer, InputError as ShowModel.
std::vector<std::string> WriteViewPicture(const std::string& path, const ViewerOptions& options,
                                          const std::shared_ptr<const ViewPage>& page,
                                          const std::vector<ViewMoment>& moments,
                                          const std::vector<PanelControl>& controls,
                                          const std::vector<PanelValue>& values,
                                          const std::shared_ptr<const ViewModel>& model = nullptr);

}  // namespace moontrace

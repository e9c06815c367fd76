#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/console/console.h"
#include "sim/loop/loop.h"
#include "sim/model_view/view_model.h"
#include "sim/physics/pose.h"
#include "sim/session/felt_page.h"
#include "sim/session/live_device.h"
#include "sim/session/session_request.h"
#include "sim/setup/text_setup.h"

namespace moontrace {

/// Lets a text be felt page by page: sets it for the device's reach, runs the loop, turns pages and
/// sets them anew. One thread.
class LoopSession {
 public:
  /// Opens the device, sets the text, starts the loop. Throws DeviceError, InputError, UsageError.
  LoopSession(const SessionRequest& request, Console& console);

  Loop& loop() { return *loop_; }
  LiveDevice& device() { return device_; }
  const LiveDevice& device() const { return device_; }
  /// The page that is felt now.
  const FeltPage& felt() const { return felt_; }
  const TextSetup& text() const { return *felt_.text; }
  /// What the present text was made of.
  const TextRequest& request() const { return request_; }
  /// Standard input gave the text, so that no words can come from it.
  bool text_was_input() const { return input_taken_ || request_.text.text == "-"; }
  double rate() const { return rate_; }                              ///< [Hz]
  double force_bound() const { return force_bound_; }                ///< see ForceBound [N]
  double carried_press() const { return carried_press_; }            ///< of the first page [N]
  double coupling_stiffness() const { return coupling_stiffness_; }  ///< held by the device [N/m]

  /// The next or the last page, in the middle of the reach. False if there is none.
  bool Turn(bool forward);
  /// Likewise, the page `index` of the text, which it has.
  void TurnTo(std::size_t index);
  /// Likewise; its first letter comes to lie under the tip.
  void TurnToStartOf(std::size_t index);
  /// The letters a quarter larger or a fifth smaller, as SetSize.
  void Resize(bool bigger, glm::dvec2 tip_P);
  /// Letters of another size [m], set anew; the place of the letter that is nearest to `tip_P`
  /// stays under the tip. Throws InputError, and leaves all as it was: no room for such letters.
  void SetSize(double size, glm::dvec2 tip_P);
  /// Letters and paper of another form, likewise.
  void SetForm(const PageForm& form, glm::dvec2 tip_P);
  const PageForm& form() const { return form_; }
  /// Another text for the same device and loop: its first page is felt from now on, and a simulated
  /// hand begins it. Throws InputError, and leaves all as it was: it cannot be set, or not on
  /// `most_pages`.
  void ChangeText(TextRequest request, bool blank,
                  std::size_t most_pages = std::numeric_limits<std::size_t>::max());
  /// A line that is not of the text, such as an answer: its first letter lies under the tip. As
  /// ChangeText.
  void LayLine(TextRequest request);
  /// A text as it lies, to be laid again behind another one.
  struct Laid {
    TextRequest request;
    FeltPage page;
    PageForm form;
  };
  Laid Lies() const { return {request_, felt_, form_}; }
  /// The point `at_P` [m] of its page comes to lie under the tip.
  void LayAgain(Laid laid, glm::dvec2 at_P);
  /// The labels of the model that was named which bring a text, and that of the page, in the
  /// model's order; none: no model was named, or nothing else than the page.
  struct LabelOf {
    std::size_t number = 0;  ///< in the model, from 0
    std::string name;        ///< as NameOf (label.h) has it
    std::string geom;        ///< that carries it, as the model names it
    int carrier = -1;        ///< MuJoCo's number of what is felt there
    std::string face;        ///< of its geom; empty: it names none
    std::string text;
  };
  std::vector<LabelOf> labels() const;
  /// That is the page; 0 without a model.
  std::size_t label() const { return text().label.value_or(0); }
  /// Another label is the page from now on, as it was left if it has been the page before. Throws
  /// InputError, and leaves all as it was.
  void GoToLabel(std::size_t number);
  /// Force again after a stop. A simulated hand has run on meanwhile, and begins the page anew.
  void GoOn();
  /// The page raised at its far edge [rad], see PageChange::tilt; a simulated hand begins it anew,
  /// and works on it as on a level one. Throws InputError: the device lies in the page's plane.
  void Tilt(double tilt);
  double tilt() const { return tilt_; }
  /// The model that was named, as a view shows it; null: none was.
  std::shared_ptr<const ViewModel> view_model() const { return view_model_; }
  /// How long the simulated hand takes for the page once [s]; 0 of a device.
  double round() const { return round_; }

 private:
  Scene SetFirst(bool blank);
  std::shared_ptr<const TextSetup> SetUp(const TextRequest& request);
  void SetAnew(TextRequest request, glm::dvec2 tip_P);
  std::uint32_t FirstFree() const;
  void Show(FeltPage page, const std::optional<PageAnchor>& anchor);
  void LetFeel(const FeltPage& page, const std::optional<PageAnchor>& anchor,
               std::optional<double> tilt);
  Laid Lay(std::size_t label);

  Console& console_;
  double rate_ = 1000;  ///< [Hz]
  bool centred_ = false, input_taken_ = false;
  TextRequest given_, request_;  ///< at first, and now
  LiveDevice device_;
  FeltPage felt_;
  PageForm form_;
  double tilt_ = 0;  ///< [rad]
  Pose X_WP_;
  std::vector<LaidLabel> others_;     ///< of the model, felt beside the page
  std::map<std::size_t, Laid> left_;  ///< labels that were the page, as they were left
  std::shared_ptr<const ViewModel> view_model_;
  double force_bound_ = 0, carried_press_ = 0, coupling_stiffness_ = 0;
  double round_ = 0;
  std::unique_ptr<Loop> loop_;  ///< last: its threads use the rest
};

}  // namespace moontrace

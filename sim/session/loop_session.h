#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "devices/core/device.h"
#include "devices/hand/aimed_stylus.h"
#include "sim/loop/loop.h"
#include "sim/scene/pose.h"
#include "sim/session/device_choice.h"
#include "sim/setup/text_setup.h"
#include "sim/wording/console.h"

namespace moontrace {

/// A text to be felt in real time.
struct SessionRequest {
  TextRequest text;
  LiveOptions live;
  std::optional<double> press;  ///< [N]
  bool blank = false;
  /// A text of one line lies in the sheet's middle, not at its upper left.
  bool centred = false;
  std::uint64_t seed = 1;  ///< of the simulated hand
  /// Of the device "mouse", where a window's mouse means the tip to be, frame P; none: no window.
  std::shared_ptr<Mailbox<StylusAim>> aims = {};
};

/// The letter that is nearest to a place.
struct NearLetter {
  std::string name;       ///< the characters it stands for, otherwise the sign's name
  std::string word;       ///< that it belongs to
  std::size_t line = 0;   ///< on the page, from 0
  bool near = false;      ///< no farther than a quarter of its size
  glm::dvec2 in_P{0, 0};  ///< the place in its em box, 0-1 each way
};

/// A device, a text set for its reach, and the loop that lets it be felt, page by page.
class LoopSession {
 public:
  /// Opens the device, sets the text, starts the loop. Throws DeviceError, InputError, UsageError.
  LoopSession(SessionRequest request, Console& console);

  Loop& loop() { return *loop_; }
  const TextSetup& text() const { return text_; }
  const SessionRequest& request() const { return request_; }
  double rate() const { return request_.live.rate.value_or(1000); }  ///< [Hz]
  double scale() const { return request_.live.scale.value_or(1); }   ///< see DevicePlace
  const DeviceLimits& limits() const { return limits_; }
  double force_bound() const { return force_bound_; }  ///< see ForceBound [N]
  double coupling_stiffness() const { return scene_options_.coupling_stiffness; }
  std::size_t page() const { return page_; }  ///< that is felt, from 0

  /// The next or the last page, in the middle of the reach. False if there is none.
  bool Turn(bool forward);
  /// The letters a quarter larger or a fifth smaller, as SetSize.
  void Resize(bool bigger, glm::dvec2 tip_P);
  /// Letters of another size [m], set anew; the place of the letter that is nearest to `tip_P`
  /// stays under the tip. Throws InputError, and leaves all as it was: no room for such letters.
  void SetSize(double size, glm::dvec2 tip_P);
  /// Letters and paper of another form, likewise.
  void SetForm(const PageForm& form, glm::dvec2 tip_P);
  const PageForm& form() const { return form_; }
  /// Another text for the same device and loop: its first page is felt from now on, and a simulated
  /// hand begins it. Throws InputError, and leaves all as it was.
  void ChangeText(TextRequest request, bool blank);
  /// Force again after a stop. A simulated hand has run on meanwhile, and begins the page anew.
  void GoOn();
  /// The page raised at its far edge [rad], see PageChange::tilt; a simulated hand begins it anew,
  /// and works on it as on a level one. Throws InputError: the device lies in the page's plane.
  void Tilt(double tilt);
  double tilt() const { return tilt_; }
  /// Of LoopSample::page and LoopSnapshot::page while the present page of this text is felt; no
  /// page of another text has it.
  std::uint32_t number() const { return first_number_ + static_cast<std::uint32_t>(page_); }
  /// Changes whenever another page, or the same in another form, is let be felt.
  std::uint64_t shown() const { return shown_; }
  /// How long the simulated hand takes for the page once [s]; 0 of a device.
  double round() const { return round_; }
  bool simulated() const { return simulated_; }
  /// A mouse moves the tip, in the page's plane, and nothing can be felt of it.
  bool mouse() const { return mouse_; }
  /// None on an empty page.
  std::optional<NearLetter> Near(glm::dvec2 tip_P) const;
  /// What opening a lost device again has to say, since the last call.
  std::vector<std::string> TakeSentences();
  /// Where the tip is and what it feels, in words.
  std::string Where(const LoopSnapshot& now) const;
  /// Keeps the place of a letter for WayToMark.
  void SetMark(glm::dvec3 tip_P);
  /// Turns to the page of the mark and says the way there from the tip, in words.
  std::string WayToMark(const LoopSnapshot& now);

 private:
  std::unique_ptr<TextureField> FieldOf(std::size_t page) const;
  std::unique_ptr<Device> StylusFor(std::size_t page, double& round) const;
  std::unique_ptr<Device> MouseStylus() const;
  TextSetup SetUp(const TextRequest& request);
  DevicePlace PlaceOfDevice() const;
  void Show(std::size_t page, const std::optional<PageAnchor>& anchor);
  void SetAnew(TextRequest request, glm::dvec2 tip_P);

  SessionRequest request_;
  Console& console_;
  bool simulated_ = true, mouse_ = false;
  DeviceLimits limits_;
  TextSetup text_;
  PageForm form_;
  double tilt_ = 0;
  SceneOptions scene_options_;
  Pose X_WP_;
  double force_bound_ = 0;
  std::size_t page_ = 0;
  std::uint64_t shown_ = 0;
  std::uint32_t first_number_ = 0;
  double round_ = 0;
  /// A place of the text, which stays the same at another size.
  struct Mark {
    std::size_t source = 0;        ///< byte of the letter
    glm::dvec2 from_letter{0, 0};  ///< [em]
  };
  std::optional<Mark> mark_;
  std::mutex sentences_mutex_;
  std::vector<std::string> sentences_;
  std::unique_ptr<Loop> loop_;  ///< last: its threads use the rest
};

}  // namespace moontrace

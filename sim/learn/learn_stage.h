#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/core/profile.h"
#include "lessons/guide/guidance.h"
#include "lessons/progress/lesson_machine.h"
#include "sim/learn/learn_trace.h"
#include "sim/session/loop_session.h"

namespace moontrace {

/// A window can be opened, as far as is known: a display is named.
bool WindowMayOpen();

/// The device of a lesson: `named`, otherwise the first that is there, can be opened and has
/// motors. Where there is none, says so; empty. Throws DeviceError where the named one is not
/// there, LackError: a mouse, and no window can open.
std::string DeviceForLearning(const std::string& named, Console& console);
/// The smallest letter that the device renders at that press [N], by its profile [m]; 0 where
/// nothing is felt, or nothing is known of it. Opens a plug-in, and closes it.
double SmallestFelt(const std::string& device, double press);

/// Likewise at the usual press, by the shipped profiles: the device need not be there. Of several
/// ("openffboard-2") each is of one kind. 0: no such profile.
double SmallestByProfile(const std::string& device);

struct StageOptions {
  LiveOptions live;
  std::optional<double> press;                    ///< [N]
  std::uint64_t seed = 1;                         ///< of the simulated hand
  std::shared_ptr<Mailbox<StylusAim>> aims = {};  ///< see SessionRequest
  bool keep_tracks = false;
};

/// What is shown and felt in a lesson: the page under the hand, the push, and what the hand did on
/// it since.
class LearnStage {
 public:
  /// Opens the device and lets an empty page be felt. Throws DeviceError, InputError, UsageError.
  LearnStage(const StageOptions& options, Console& console);

  /// Throws InputError, and leaves all as it was: the text cannot be set at any size.
  void Show(const lesson_action::Show& show);
  /// The push from now on; it stays for the pages to come until there is another.
  void Push(const lesson_action::Push& push);
  /// A path that the hand is led along in place of what was wanted, until LetGo, Show or Push.
  void Lead(std::shared_ptr<const GuidancePath> path, double speed);
  /// The push is again as it was wanted, and the hand begins anew.
  void LetGo();
  /// The next or last page of a long text. False if there is none.
  bool Turn(bool forward);
  /// The page `index` of it, which it has.
  void TurnTo(std::size_t index);
  /// The hand begins anew on the page that lies there.
  void Restart();
  /// Force again after a stop; what a simulated hand did counts from now on.
  void GoOn();
  /// How letters and paper are from now on; the page is set anew. Throws InputError, and leaves all
  /// as it was.
  void SetForm(const PageForm& form);
  /// The far edge raised [rad]. Throws InputError: this device cannot.
  void SetTilt(double tilt);

  /// What the loop has felt, every tick. `counts`: for the trace, if it is of the page that lies
  /// there.
  void Add(const LoopSample& sample, bool counts);
  /// Is given every sample too; none: nobody.
  void SetTap(std::function<void(const LoopSample&)> tap) { tap_ = std::move(tap); }
  /// Likewise, for a view.
  void SetWatch(std::function<void(const LoopSample&)> watch) { watch_ = std::move(watch); }

  const LearnTrace& trace() const { return *trace_; }
  /// A hand can be pushed here.
  bool pushes() const;
  /// The tip can be lowered onto a paper that is felt, and lifted off it.
  bool lifts() const { return lifts_; }
  /// Of the device; of none that is known by a profile a plug-in.
  DeviceKind kind() const;
  bool simulated() const { return session_.device().simulated(); }
  LoopSession& session() { return session_; }
  const LoopSession& session() const { return session_; }
  const lesson_action::Show& shown() const { return shown_; }
  const PageForm& form() const { return form_; }
  /// Size of the letters that lie there [m]: smaller than was asked for where they had no room.
  double size() const { return session_.text().set.style.size; }
  bool shrunk() const { return shrunk_; }
  double tick() const { return 1 / session_.rate(); }

 private:
  TextRequest RequestFor(const lesson_action::Show& show, double size, double pitch) const;
  void SetAt(const lesson_action::Show& show, double size);
  void Set(const lesson_action::Show& show);
  void Guide();

  StageOptions options_;
  LoopSession session_;
  GuidanceTable gains_;
  lesson_action::Show shown_;
  lesson_action::Push push_;
  std::shared_ptr<const GuidancePath> led_path_;  ///< of Lead
  double led_speed_ = 1;
  PageForm form_;
  bool shrunk_ = false, lifts_ = true;
  std::unique_ptr<LearnTrace> trace_;
  std::function<void(const LoopSample&)> tap_, watch_;
};

}  // namespace moontrace

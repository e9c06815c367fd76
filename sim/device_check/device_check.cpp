#include "sim/device_check/device_check.h"

#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <ctime>
#include <exception>
#include <glm/glm.hpp>
#include <istream>
#include <limits>
#include <optional>
#include <ostream>

#include "devices/hid/homing.h"
#include "sim/device_check/device_session.h"
#include "sim/device_check/devices_messages.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

/// The steps of one check, with what they share.
class Check {
 public:
  Check(const CheckedDevice& checked, const CheckPlan& plan, Clock& clock,
        const std::function<void(const std::string&)>& tell, Console& console)
      : checked_(checked), plan_(plan), clock_(clock), tell_(tell), console_(console) {}

  std::vector<CheckStep> Run() {
    Say(say::TestBegins(checked_.name, checked_.title));
    Open();
    if (NeedsToBeHomed()) {
      Step("homing", [this] { return HomeIt(); });
      unhomed_ = steps_.empty() || steps_.back().result != StepResult::kGood;
    }
    Step("position and buttons", [this] { return Look(); });
    Step("small forces", [this] { return Push(); });
    Step("caps", [this] { return Caps(); });
    Step("dead-man", [this] { return DeadMan(); });
    return steps_;
  }

 private:
  void Step(const char* name, const std::function<StepResult()>& step) {
    if (lost_) return;
    Say(say::TestStep(steps_.size() + 1, name));
    StepResult result = step();
    if (lost_) {
      Say(say::TestLost(device_ != nullptr ? device_->WhyLost() : std::string()));
      result = StepResult::kFailed;
    }
    steps_.push_back({name, result});
  }

  void Say(const std::string& line) {
    tell_(line);
    console_.out().flush();
  }

  /// Asks with yes or no; nothing if no such answer came in three lines or the input has ended.
  std::optional<bool> Ask(const std::string& question) {
    std::string line;
    for (int tries = 0; tries < 3; ++tries) {
      Say(question);
      const bool read = static_cast<bool>(std::getline(console_.in(), line));
      console_.CheckStop();
      if (!read) break;
      const std::string answer = LowerCase(line);
      if (answer == "y" || answer == "yes") return true;
      if (answer == "n" || answer == "no") return false;
    }
    return std::nullopt;
  }

  void Open() {
    device_ = checked_.open();
    limits_ = device_->Limits();
    force_ = std::min(plan_.force, limits_.peak_force);
    session_.emplace(*device_, force_, clock_);
  }

  SessionView RunFor(double seconds, glm::dvec3 f_D) {
    SessionView view = session_->Run(seconds, f_D, console_);
    lost_ = lost_ || view.lost;
    if (view.stopped) Say(say::StoppedByButton());
    return view;
  }

  StepResult LeaveOut(const std::string& why) {
    Say(why);
    return StepResult::kLeftOut;
  }

  bool NeedsToBeHomed() const {
    const auto* arm = dynamic_cast<const NeedsHoming*>(device_.get());
    return arm != nullptr && arm->NextStep() != HomingStep::kDone;
  }

  StepResult HomeIt() {
    if (!Ask(say::AskForHoming()).value_or(false)) return LeaveOut(say::NotHomed());
    if (HomeNow()) return StepResult::kGood;
    DeviceState state;
    lost_ = device_->Read(state) == DeviceStatus::kLost;
    if (!lost_) Say(say::HomingFailed(plan_.home));
    return StepResult::kFailed;
  }

  bool HomeNow() {
    const std::int64_t until = clock_.Now() + static_cast<std::int64_t>(1e9 * plan_.home);
    const auto say = [this](HomingStep step) {
      if (step != HomingStep::kDone) Say(std::string(SentenceOf(step)));
    };
    const bool homed = Home(*device_, say, [this, until] {
      const std::atomic<bool>* stop = console_.stop();
      return clock_.Now() < until && (stop == nullptr || !stop->load());
    });
    console_.CheckStop();
    return homed;
  }

  StepResult Look() {
    Say(say::MoveAndPress(plan_.look, limits_.buttons));
    const SessionView view = RunFor(plan_.look, glm::dvec3(0.0));
    if (lost_) return StepResult::kFailed;
    motors_off_ = view.reports == 0 && view.not_ready;
    if (motors_off_) return LeaveOut(say::MotorsOff());
    if (view.reports == 0) {
      if (checked_.rests_silent) return LeaveOut(say::PuckAtRest());
      Say(say::NoReports());
      return StepResult::kFailed;
    }
    Say(say::SawPosition(limits_, view.low_D, view.high_D,
                         static_cast<double>(view.reports) / view.time));
    const bool moved = view.low_D != view.high_D;
    if (!moved) Say(say::DidNotMove());
    if (limits_.buttons > 0) Say(say::SawButtons(view.buttons, limits_.buttons));
    return moved ? StepResult::kGood : StepResult::kFailed;
  }

  StepResult Push() {
    if (!glm::any(limits_.pushes)) return LeaveOut(say::PushesNothing());
    if (motors_off_) return LeaveOut(say::MotorsOff());
    if (unhomed_) return LeaveOut(say::NotHomed());
    agreed_ = Ask(say::AskForForces(force_)).value_or(false);
    if (!agreed_) return LeaveOut(say::ForcesLeftOut());
    StepResult result = StepResult::kGood;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        if (!limits_.pushes[axis] || lost_ || !agreed_) continue;
        if (!PushOnce(axis, sign)) result = StepResult::kFailed;
      }
    }
    return agreed_ ? result : LeaveOut(say::PushesEnded());
  }

  /// False if somebody says that it went elsewhere.
  bool PushOnce(int axis, double sign) {
    for (int seconds = 3; seconds >= 0; --seconds) {
      Say(say::Countdown(seconds, axis, sign, force_));
      if (seconds > 0) RunFor(plan_.count, glm::dvec3(0.0));
    }
    glm::dvec3 f_D(0.0);
    f_D[axis] = sign * force_;
    const SessionView view = RunFor(plan_.push, f_D);
    if (lost_ || view.stopped) {
      agreed_ = agreed_ && !view.stopped;
      return !lost_;
    }
    Say(say::Pushed(view.last_D - view.first_D));
    const std::optional<bool> answer = Ask(say::AskDirection(axis, sign));
    if (!answer) agreed_ = false;
    return answer.value_or(true);
  }

  StepResult Caps() {
    if (!glm::any(limits_.pushes)) return LeaveOut(say::PushesNothing());
    if (!agreed_) return LeaveOut(say::ForcesLeftOut());
    const int axis = FirstPushed();
    glm::dvec3 much(0.0);
    much[axis] = 100 * force_;
    const SessionView view = RunFor(plan_.push, much);
    if (lost_) return StepResult::kFailed;
    const double commanded = view.greatest_force[axis];
    if (commanded > force_ * (1 + 1e-9)) {
      Say(say::CapBroken(much[axis], commanded));
      return StepResult::kFailed;
    }
    Say(say::CapHeld(much[axis], commanded));
    much[axis] = std::numeric_limits<double>::quiet_NaN();
    const SessionView none = RunFor(0.1 * plan_.push, much);
    if (none.greatest_force != glm::dvec3(0.0)) {
      Say(say::CapBroken(much[axis], none.greatest_force[axis]));
      return StepResult::kFailed;
    }
    Say(say::NoNumberHeld());
    return StepResult::kGood;
  }

  StepResult DeadMan() {
    if (!glm::any(limits_.pushes)) return LeaveOut(say::PushesNothing());
    if (!agreed_) return LeaveOut(say::ForcesLeftOut());
    if (limits_.dead_man <= 0) return LeaveOut(say::NeverLetsGo());
    if (!Ask(say::AskDeadMan(force_, limits_.dead_man)).value_or(false)) {
      return LeaveOut(say::ForcesLeftOut());
    }
    session_.reset();
    device_.reset();  // its threads end, so that the copy can be made
    if (!DieHolding()) return LeaveOut(say::HeldItNot());
    clock_.SleepUntil(clock_.Now() +
                      static_cast<std::int64_t>(1e9 * (limits_.dead_man + plan_.settle)));
    const std::optional<bool> gone = Ask(say::AskIsGone());
    Open();  // takes the device over: a force that was left over ends here
    if (!gone) return LeaveOut(say::ForcesLeftOut());
    return *gone ? StepResult::kGood : StepResult::kFailed;
  }

  /// A copy of this process opens the device, pushes, and is killed in mid-push, so that nothing of
  /// ours can let go. False if it came to no push.
  bool DieHolding() {
    const ::pid_t copy = fork();
    if (copy < 0) return false;
    if (copy == 0) {
      HoldUntilKilled();
      _exit(1);
    }
    int status = 0;
    while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  }

  /// In the copy. Returns only if the device was lost or could not be opened.
  void HoldUntilKilled() noexcept {
    try {
      Open();
      if (!HomeNow()) return;
      glm::dvec3 f_D(0.0);
      f_D[FirstPushed()] = force_;
      std::signal(SIGALRM, SIG_DFL);  // which kills, without any clean-up
      itimerval timer = {};
      timer.it_value.tv_sec = static_cast<std::time_t>(plan_.push);
      timer.it_value.tv_usec = 1 + static_cast<::suseconds_t>(1e6 * std::fmod(plan_.push, 1.0));
      setitimer(ITIMER_REAL, &timer, nullptr);
      RunFor(1e9, f_D);
    } catch (const std::exception&) {
    }
  }

  int FirstPushed() const { return limits_.pushes.x ? 0 : limits_.pushes.y ? 1 : 2; }

  const CheckedDevice& checked_;
  const CheckPlan& plan_;
  Clock& clock_;
  const std::function<void(const std::string&)>& tell_;
  Console& console_;
  std::unique_ptr<Device> device_;
  std::optional<DeviceSession> session_;
  DeviceLimits limits_;
  double force_ = 0;  ///< that is pushed with [N]
  bool agreed_ = false, motors_off_ = false, unhomed_ = false, lost_ = false;
  std::vector<CheckStep> steps_;
};

}  // namespace

std::vector<CheckStep> CheckDevice(const CheckedDevice& checked, const CheckPlan& plan,
                                   Clock& clock,
                                   const std::function<void(const std::string&)>& tell,
                                   Console& console) {
  return Check(checked, plan, clock, tell, console).Run();
}

}  // namespace moontrace

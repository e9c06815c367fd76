#include "sim/learn/learn_stage.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <glm/glm.hpp>
#include <utility>

#include "devices/catalogue/catalogue.h"
#include "devices/core/smallest_letter.h"
#include "lessons/guide/guidance_path.h"
#include "sim/learn/learn_messages.h"
#include "sim/session/device_choice.h"
#include "sim/view/view_window.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

/// A stroke is meant within a quarter em of it, as in traces with a device.
constexpr double kReachEm = 0.25;
/// Where letters have no room they are tried smaller, down to this.
constexpr double kSmallest = 0.003;  ///< [m]
constexpr double kSmaller = 0.8;
/// Lines that must share a page are closer by this share of their pitch at a time, at the most by
/// so much that Moon's 1.8 em become 1.5: half a letter of paper still lies between two lines.
/// Ours.
constexpr double kCloser = 0.05, kClosest = 0.84;

/// Without a height of its own, the tip goes down and up by a lever or a button.
bool HasLever(const std::string& device) {
  if (!PluginPathOf(device).empty()) return false;
  for (const DeviceEntry& entry : ListDevices(ProfilesFolder())) {
    if (entry.name == device) return entry.profile.stick.press != StickMap::Press::kSetting;
  }
  return false;
}

/// What lies there before the first page: nothing, at any size.
SessionRequest EmptyPage(const StageOptions& options) {
  SessionRequest request;
  request.text.text.text = "o";
  request.text.style.size = 0.012;
  request.text.command = "learn";
  request.live = options.live;
  request.press = options.press;
  request.blank = true;
  request.centred = true;
  request.seed = options.seed;
  request.aims = options.aims;
  return request;
}

/// Where no display is named, the learner is told what to do in place of that.
void RequireWindow() {
  const auto named = [](const char* name) {
    const char* display = std::getenv(name);
    return display != nullptr && *display != '\0';
  };
  if (!named("DISPLAY") && !named("WAYLAND_DISPLAY")) throw LackError(say::NoWindowForMouse());
  ViewWindow::RequireDisplayNamed();
}

}  // namespace

bool WindowMayOpen() {
  try {
    ViewWindow::RequireDisplayNamed();
    return true;
  } catch (const LackError&) {
    return false;
  }
}

std::string DeviceForLearning(const std::string& named, Console& console) {
  if (!named.empty()) {
    if (!IsSimulated(named) && !IsMouse(named)) RequireThere(named, ProfilesFolder());
    if (IsMouse(named)) RequireWindow();
    return named;
  }
  const std::optional<DeviceEntry> first = FirstForceDevice();
  if (first && first->problem.empty()) return first->name;
  console.Result(say::NoForceDevice());
  if (first) console.Result(say::DeviceProblem(first->name, first->problem));
  return {};
}

double SmallestFelt(const std::string& device, double press) {
  if (!PluginPathOf(device).empty()) return SmallestLetter(EntryOfPlugin(device).profile, press);
  for (const DeviceEntry& entry : ListDevices(ProfilesFolder())) {
    if (entry.name == device) return SmallestLetter(entry.profile, press);
  }
  return 0;
}

namespace {

/// By the shipped profiles: the device need not be there.
std::optional<DeviceProfile> ProfileOf(const std::string& device) {
  const std::size_t dash = device.rfind('-');
  const bool numbered = dash != std::string::npos && dash + 1 < device.size() &&
                        device.find_first_not_of("0123456789", dash + 1) == std::string::npos;
  const std::string kind = numbered ? device.substr(0, dash) : device;
  for (const DeviceProfile& profile : LoadProfiles(ProfilesFolder())) {
    if (profile.name == device || profile.name == kind) return profile;
  }
  return std::nullopt;
}

}  // namespace

double SmallestByProfile(const std::string& device) {
  const std::optional<DeviceProfile> profile = ProfileOf(device);
  return profile ? SmallestLetter(*profile) : 0;
}

LearnStage::LearnStage(const StageOptions& options, Console& console)
    : options_(options), session_(EmptyPage(options), console), gains_(GuidanceTable::Shipped()) {
  const LiveDevice& device = session_.device();
  lifts_ = simulated() || (pushes() && (device.limits().measures.z || HasLever(device.name())));
  Restart();
}

TextRequest LearnStage::RequestFor(const lesson_action::Show& show, double size,
                                   double pitch) const {
  TextRequest request = session_.request();
  request.text = {};
  // one sign, a hyphen, would ask for standard input; nothing at all is an empty sheet
  request.text.text = show.text == "-" ? "- " : show.text.empty() ? "o" : show.text;
  request.style = {};
  request.style.size = size;
  if (!show.text.empty() && !show.script.empty()) request.style.script = show.script;
  if (!show.text.empty() && show.grade != 1) request.style.grade = show.grade;
  request.layout = {};
  request.form = form_;
  request.form->pitch *= pitch;
  return request;
}

/// What is to be on one page has its lines closer before its letters are smaller. Throws
/// InputError.
void LearnStage::SetAt(const lesson_action::Show& show, double size) {
  const bool blank = show.text.empty();
  if (!show.one_page) return session_.ChangeText(RequestFor(show, size, 1), blank);
  for (double pitch = 1;; pitch -= kCloser) {
    try {
      return session_.ChangeText(RequestFor(show, size, pitch), blank, 1);
    } catch (const InputError&) {
      if (pitch - kCloser < kClosest) throw;
    }
  }
}

void LearnStage::Set(const lesson_action::Show& show) {
  double size = show.size;
  for (;;) {
    try {
      SetAt(show, size);
      break;
    } catch (const InputError&) {
      size *= kSmaller;
      if (size < kSmallest) throw;
    }
  }
  shrunk_ = size < show.size;
}

void LearnStage::Show(const lesson_action::Show& show) {
  Set(show);
  shown_ = show;
  led_path_.reset();
  Restart();
}

void LearnStage::Restart() {
  const FeltPage& page = session_.felt();
  std::vector<IntendedStroke> strokes;
  if (!page.blank) {
    strokes = IntendedStrokes(page.set(), page.text->script, page.text->set.style);
  }
  trace_ = std::make_unique<LearnTrace>(std::move(strokes), page.set().glyphs.size(), tick(),
                                        kReachEm * size(), options_.keep_tracks);
  Guide();
}

void LearnStage::GoOn() {
  session_.GoOn();
  if (simulated()) Restart();
}

void LearnStage::SetTilt(double tilt) {
  session_.Tilt(tilt);
  Restart();
}

void LearnStage::SetForm(const PageForm& form) {
  const PageForm before = std::exchange(form_, form);
  try {
    Set(shown_);
  } catch (...) {
    form_ = before;
    throw;
  }
  Restart();
}

bool LearnStage::Turn(bool forward) {
  if (!session_.Turn(forward)) return false;
  Restart();
  return true;
}

void LearnStage::TurnTo(std::size_t index) {
  session_.TurnTo(index);
  Restart();
}

void LearnStage::Push(const lesson_action::Push& push) {
  push_ = push;
  led_path_.reset();
  Guide();
}

void LearnStage::Lead(std::shared_ptr<const GuidancePath> path, double speed) {
  led_path_ = std::move(path);
  led_speed_ = speed;
  Guide();
}

void LearnStage::LetGo() {
  led_path_.reset();
  Restart();
}

/// The push as it is wanted, on the page that lies there.
void LearnStage::Guide() {
  const bool leads = led_path_ != nullptr;
  const GuidanceMode mode = leads ? GuidanceMode::kBead : push_.mode;
  const int help = leads ? kMostHelp : push_.help;
  GuidancePlan plan;
  plan.mode = mode;
  plan.gains = gains_.GainsOf(mode, help);
  plan.gains.bead_speed *= leads ? led_speed_ : push_.speed;
  const bool nothing = help <= 0 || mode == GuidanceMode::kOff;
  if (nothing || (!leads && trace_->strokes().empty())) return session_.loop().Guide(nullptr);
  plan.path = leads ? led_path_ : MakeGuidancePath(trace_->strokes());
  session_.loop().Guide(std::make_shared<const GuidancePlan>(std::move(plan)));
}

void LearnStage::Add(const LoopSample& sample, bool counts) {
  if (tap_) tap_(sample);
  if (watch_) watch_(sample);
  if (counts && sample.page == session_.felt().number) trace_->Add(sample);
}

DeviceKind LearnStage::kind() const {
  const std::optional<DeviceProfile> profile = ProfileOf(session_.device().name());
  return profile ? profile->kind : DeviceKind::kPlugin;
}

bool LearnStage::pushes() const { return !simulated() && session_.device().pushes(); }

}  // namespace moontrace

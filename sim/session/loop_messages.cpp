#include "sim/session/loop_messages.h"

#include <fmt/core.h>

#include <cmath>

#include "sim/console/wording.h"
#include "sim/session/place_messages.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string OnThePage(std::string_view text, bool chosen) {
  text = text.substr(0, text.find_last_not_of("\r\n") + 1);  // the end of a piped line
  return fmt::format("On the page: {}{}", OneLine(Unbroken(text)),
                     chosen ? "" : ". No text was given; write one after the command.");
}

std::string LoopBegins(std::string_view device) {
  return fmt::format("Running: {}.", OneLine(device));
}

std::string NotRealtime(std::string_view why) {
  return fmt::format("The force may come late: {}.", why);
}

std::string Scaled(double scale) {
  return fmt::format(
      "Scaled: {} mm on the page for each mm of the device; letters are not in true size, and "
      "this never counts for mastery.",
      Short(scale, 3));
}

std::string SetFor(const PageSpec& page, std::size_t pages) {
  return fmt::format("Set for this device's reach, {} by {} mm: {}.",
                     Short(kMillimetres * page.width, 0), Short(kMillimetres * page.height, 0),
                     Counted(pages, "page", "pages"));
}

std::string SofterThanUsual(double share) {
  return fmt::format("Softer than usual: this device holds {} percent of a firm page.",
                     Short(100 * share, 0));
}

std::string HowToSpeak() { return "To say a word, type it and Enter; ? tells the words."; }

std::string CannotSpeak() {
  return "No words can come: standard input gave the text. Ctrl-C ends this.";
}

std::string InputEnded() { return "End of input: no more words can come, so this ends."; }

std::string EndedLost(std::string_view why) {
  const std::string line = "the device did not come back";
  return why.empty() ? line : fmt::format("{}: {}", line, OneLine(why, 300));
}

namespace {

/// Of a device that pushes a hand.
std::string FeltEvent(SafetyEvent event) {
  switch (event) {
    case SafetyEvent::kNotANumber:
      return "No force: a false value came.";
    case SafetyEvent::kJump:
      return "No force: the tip jumped.";
    case SafetyEvent::kForceCap:
      return "The device pushes as hard as it can.";
    case SafetyEvent::kRateCap:
      return "A sudden rise of force was slowed.";
    case SafetyEvent::kPowerCap:
      return "Force lowered: the tip was pushed fast.";
    case SafetyEvent::kResting:
      return "Resting the motors: less force for a while.";
    case SafetyEvent::kSilence:
      return "No force: the device is silent.";
    case SafetyEvent::kDeviceLost:
      return DeviceLost({});
    case SafetyEvent::kNotReady:
      return "No force: the device's motors are off, or were let go of.";
    case SafetyEvent::kPhysicsFault:
      return "No force: the simulation failed for a moment.";
    case SafetyEvent::kStopped:
      return "Stopped: no force. Say go to go on.";
    case SafetyEvent::kLateLoop:
      return "No force for a moment: the computer was late.";
    case SafetyEvent::kStuck:
      return "No force: the position seems stuck. Move the tip.";
  }
  return {};
}

/// Where there is no force, its limits are nobody's matter.
std::string UnfeltEvent(SafetyEvent event) {
  switch (event) {
    case SafetyEvent::kSilence:
      return "The device is silent.";
    case SafetyEvent::kPhysicsFault:
      return "The simulation failed for a moment.";
    case SafetyEvent::kDeviceLost:
      return DeviceLost({});
    case SafetyEvent::kStopped:
      return "Stopped. Say go to go on.";
    case SafetyEvent::kStuck:
      return "The position seems stuck. Move the tip.";
    case SafetyEvent::kNotANumber:
    case SafetyEvent::kJump:
    case SafetyEvent::kForceCap:
    case SafetyEvent::kRateCap:
    case SafetyEvent::kPowerCap:
    case SafetyEvent::kResting:
    case SafetyEvent::kNotReady:
    case SafetyEvent::kLateLoop:
      break;
  }
  return {};
}

/// What happened, behind which a number of times stands.
std::string_view Clause(SafetyEvent event) {
  switch (event) {
    case SafetyEvent::kNotANumber:
      return "a false value came";
    case SafetyEvent::kJump:
      return "the tip jumped";
    case SafetyEvent::kForceCap:
      return "the device pushed its hardest";
    case SafetyEvent::kRateCap:
      return "a sudden rise slowed";
    case SafetyEvent::kPowerCap:
      return "force lowered for a fast tip";
    case SafetyEvent::kResting:
      return "the motors rested";
    case SafetyEvent::kSilence:
      return "the device was silent";
    case SafetyEvent::kDeviceLost:
      return "the device was lost";
    case SafetyEvent::kNotReady:
      return "the motors were off";
    case SafetyEvent::kPhysicsFault:
      return "the simulation failed";
    case SafetyEvent::kStopped:
      return "stopped";
    case SafetyEvent::kLateLoop:
      return "the computer was late";
    case SafetyEvent::kStuck:
      return "the position seemed stuck";
  }
  return {};
}

}  // namespace

std::string Event(SafetyEvent event, bool felt) {
  std::string sentence = felt ? FeltEvent(event) : UnfeltEvent(event);
  // where nothing is felt it is not summed up either
  if (sentence.empty() || !felt || !MayRepeat(event)) return sentence;
  return sentence + " From now on this is counted.";
}

bool MayRepeat(SafetyEvent event) {
  return event == SafetyEvent::kLateLoop || !TakesForceAway(event);
}

std::string Repeated(const std::array<std::uint64_t, kSafetyEvents>& counts) {
  std::vector<std::string> repeated;
  for (std::size_t i = 0; i < kSafetyEvents; ++i) {
    const auto event = static_cast<SafetyEvent>(i);
    const bool told_once = MayRepeat(event) || event == SafetyEvent::kNotReady;  // MotorsTold
    if (!told_once || counts[i] < 2) continue;
    repeated.push_back(fmt::format("{} {}", Clause(event), Times(counts[i])));
  }
  return repeated.empty() ? "" : fmt::format("In all: {}.", Joined(repeated, ", "));
}

std::string Event(const LoopEvent& event, bool felt) {
  switch (event.kind) {
    case LoopEventKind::kSafety:
      return Event(event.safety, felt);
    case LoopEventKind::kDeviceBack:
      return felt ? "Device back: force comes slowly." : "Device back.";
    case LoopEventKind::kWentOn:
      return felt ? "Going on: force comes slowly." : "Going on.";
    case LoopEventKind::kBookmark:
      return "Bookmark set.";
    case LoopEventKind::kThrough:
      return felt ? "Through the paper: no force. Lift the tip, then press less."
                  : "Through the paper. Lift the tip, then press less.";
    case LoopEventKind::kPageBack:
      return "The page lies in the middle of the reach again.";
    case LoopEventKind::kModelMoved:
      return "The model was moved, so that you reach that label.";
    case LoopEventKind::kPageGone:
      return fmt::format("The {}", kPageWentAway);
    case LoopEventKind::kSay:
    case LoopEventKind::kPageChanged:
      break;  // said with what they concern
  }
  return {};
}

std::string DeviceLost(std::string_view why) {
  return fmt::format("Device lost: no force{}{}. It is looked for twice a second.",
                     why.empty() ? "" : ": ", OneLine(why, 200));
}

std::string_view EventName(SafetyEvent event) {
  switch (event) {
    case SafetyEvent::kNotANumber:
      return "not_a_number";
    case SafetyEvent::kJump:
      return "jump";
    case SafetyEvent::kForceCap:
      return "force_cap";
    case SafetyEvent::kRateCap:
      return "rate_cap";
    case SafetyEvent::kPowerCap:
      return "power_cap";
    case SafetyEvent::kResting:
      return "resting";
    case SafetyEvent::kSilence:
      return "silence";
    case SafetyEvent::kDeviceLost:
      return "device_lost";
    case SafetyEvent::kNotReady:
      return "not_ready";
    case SafetyEvent::kPhysicsFault:
      return "physics_fault";
    case SafetyEvent::kStopped:
      return "stopped";
    case SafetyEvent::kLateLoop:
      return "late_loop";
    case SafetyEvent::kStuck:
      return "stuck";
  }
  return "";
}

std::string AlreadyStopped() { return "Stopped already. Say go to go on."; }
std::string NotStopped() { return "Not stopped: go on feeling."; }

std::string ForceIsBack() { return "Force is back."; }

std::string LoopSilent() { return "No force: the computer stands still for a while."; }

std::string StillLost(std::string_view why) {
  return fmt::format("Still lost: {}", OneLine(why, 300));
}

std::string NowPage(std::size_t page, std::size_t pages) {
  return fmt::format("Page {} of {}, in the middle of the reach.", page + 1, pages);
}

std::string NoOtherPage(bool forward, std::size_t pages) {
  if (pages == 1) return "There is one page only.";
  return forward ? "This is the last page." : "This is the first page.";
}

std::string NowSize(double size, std::size_t page, std::size_t pages) {
  return fmt::format("Letters of {} mm, page {} of {}; your letter stays under the tip.",
                     Short(kMillimetres * size, 1), page + 1, pages);
}

std::string CannotResize(std::string_view why) {
  return fmt::format("The size stays: {}.", OneLine(why, 200));
}

std::string SizeStays() { return "The size stays while a trace is scored."; }

std::string Where(std::string_view letter, std::size_t line, std::size_t page, std::size_t pages,
                  const Feeling& feeling) {
  const std::string at =
      letter.empty() ? std::string("Between letters") : fmt::format("At {}", OneLine(letter));
  const std::string touch = feeling.touching ? "touching" : "in the air";
  const std::string push = feeling.touching && !feeling.has_motors
                               ? fmt::format("; the page pushes with {} N", Short(feeling.force, 1))
                               : std::string();
  const std::string rest = feeling.stopped ? "; stopped" : push;
  return fmt::format("{}, line {}, page {} of {}, {}{}.", at, line + 1, page + 1, pages, touch,
                     rest);
}

std::string NoMotors() { return "This device has no motors: forces are told, not felt."; }

std::string NoMark() { return "No bookmark yet: press the button twice to set one."; }

std::string WayToMark(std::string_view letter, std::size_t page, std::size_t pages,
                      std::optional<glm::dvec2> way_P) {
  const std::string mark =
      fmt::format("Bookmark at {}, page {} of {}", OneLine(letter), page + 1, pages);
  if (!way_P) return mark + ", which you feel now.";
  return fmt::format("{}: {}.", mark, Way(*way_P));
}

std::string LoopOutcome(double seconds) { return fmt::format("Ran {} s.", Short(seconds, 1)); }

std::string Lateness(const LoopReport& report) {
  return fmt::format("Late by {} milliseconds at worst.", Short(1e-3 * report.lateness.max(), 1));
}

std::string SafetyActed(const LoopReport& report) {
  std::vector<std::string> acted;
  for (std::size_t i = 0; i < kSafetyEvents; ++i) {
    if (report.safety_counts[i] == 0) continue;
    const std::string_view what = Clause(static_cast<SafetyEvent>(i));
    acted.push_back(fmt::format("{} {}", what, Times(report.safety_counts[i])));
  }
  if (acted.empty()) return "The force was never held back.";
  return fmt::format("Force held back: {}.", Joined(acted, ", "));
}

std::string Touched(double share) {
  return fmt::format("Touching {} of the time.", Percent(share));
}

std::string Touched(double share, double mean_force, double peak_force) {
  return fmt::format("Touching {} of the time; force mean {} N, peak {} N.", Percent(share),
                     Short(mean_force, 2), Short(peak_force, 2));
}

std::string NotWithDevice(std::string_view option) {
  return fmt::format("{} is for the simulated stylus: leave it out, or leave out --device", option);
}

std::string OnlyWithDevice(std::string_view option) {
  return fmt::format("{} is for devices: name one with --device", option);
}

std::string DeviceTime(double seconds) {
  return fmt::format("Time: {} s, in real time.", Short(seconds, 1));
}

std::string NeverTouched(double seconds) {
  return fmt::format("Never touched the page in {} s: nothing to score.", Short(seconds, 1));
}

std::string NothingTraced() { return "the device was never there: nothing was traced"; }

}  // namespace moontrace::say

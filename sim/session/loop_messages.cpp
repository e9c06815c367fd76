#include "sim/session/loop_messages.h"

#include <fmt/core.h>

#include <cmath>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

namespace {

/// Of microseconds, where the unit has been said.
std::string Figure(double microseconds) { return Short(microseconds, microseconds < 10 ? 1 : 0); }
std::string Micro(double microseconds) { return Figure(microseconds) + " microseconds"; }

}  // namespace

std::string OnThePage(std::string_view text, bool chosen) {
  text = text.substr(0, text.find_last_not_of("\r\n") + 1);  // the end of a piped line
  return fmt::format("On the page: {}{}", OneLine(text),
                     chosen ? "" : ". No text was given; write one after the command.");
}

std::string LoopBegins(std::string_view device, double rate) {
  return fmt::format("Running: {}, {:.0f} ticks a second.", OneLine(device), rate);
}

std::string NotRealtime(std::string_view why) {
  return fmt::format("The loop may be late: {}.", why);
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

std::string SofterThanUsual(double stiffness) {
  return fmt::format("Softer than usual: this device holds {} N/m.", Short(stiffness, 0));
}

std::string HowToSpeak() { return "Type a word and Enter; ? tells the words."; }

std::string CannotSpeak() {
  return "No words can come: standard input has ended. Ctrl-C ends this.";
}

std::string EndedLost(std::string_view why) {
  return fmt::format("the device did not come back: {}", OneLine(why, 300));
}

std::string Event(SafetyEvent event) {
  switch (event) {
    case SafetyEvent::kNotANumber:
      return "No force: a value was no number.";
    case SafetyEvent::kJump:
      return "No force: the tip jumped.";
    case SafetyEvent::kForceCap:
      return "Force held at the device's greatest.";
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
      return "No force: MuJoCo reported a fault.";
    case SafetyEvent::kStopped:
      return "Stopped: no force. Say go to go on.";
    case SafetyEvent::kLateLoop:
      return "No force for a moment: the loop was late.";
    case SafetyEvent::kStuck:
      return "No force: the position seems stuck. Move the tip.";
  }
  return {};
}

std::string Event(const LoopEvent& event) {
  switch (event.kind) {
    case LoopEventKind::kSafety:
      return Event(event.safety);
    case LoopEventKind::kDeviceBack:
      return "Device back: force comes slowly.";
    case LoopEventKind::kWentOn:
      return "Going on: force comes slowly.";
    case LoopEventKind::kBookmark:
      return "Bookmark set.";
    case LoopEventKind::kThrough:
      return "Through the paper: no force. Lift the tip, then press less.";
    case LoopEventKind::kPageBack:
      return "The page lies in the middle of the reach again.";
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

std::string LoopSilent() {
  return "The loop stands still: it should tick a thousand times a second.";
}

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
  const std::string rest = feeling.stopped ? "; stopped: no force" : push;
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
  const auto part = [](double way, std::string_view low, std::string_view high) {
    return fmt::format("{} mm {}", Short(kMillimetres * std::abs(way), 1), way < 0 ? low : high);
  };
  return fmt::format("{}: {}, {}.", mark, part(way_P->x, "left", "right"),
                     part(way_P->y, "down", "up"));
}

std::string LoopOutcome(const LoopReport& report, double seconds) {
  return fmt::format("Ran {} s: {}, {} lost.", Short(seconds, 1),
                     Counted(report.ticks, "tick", "ticks"), report.lost_ticks);
}

std::string Lateness(const LoopReport& report) {
  return fmt::format("Late by at most {} in 999 of 1000 ticks, {} at worst.",
                     Micro(report.lateness.Percentile(0.999)), Figure(report.lateness.max()));
}

std::string Cost(const LoopReport& report) {
  return fmt::format("A tick takes at most {} in 999 of 1000, {} at worst.",
                     Micro(report.cost.Percentile(0.999)), Figure(report.cost.max()));
}

std::string Realtime(std::string_view not_realtime) {
  if (not_realtime.empty()) return "With real-time priority.";
  return fmt::format("Without real-time priority: {}.", not_realtime);
}

std::string SafetyActed(const LoopReport& report) {
  std::vector<std::string> acted;
  for (std::size_t i = 0; i < kSafetyEvents; ++i) {
    if (report.safety_counts[i] == 0) continue;
    std::string name(EventName(static_cast<SafetyEvent>(i)));
    for (char& c : name) c = c == '_' ? ' ' : c;
    acted.push_back(fmt::format("{} {}", name, Times(report.safety_counts[i])));
  }
  if (acted.empty()) return "Safety had nothing to do.";
  return fmt::format("Safety acted: {}.", Joined(acted, ", "));
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

#include "sim/device_check/devices_messages.h"

#include <fmt/core.h>

#include <cmath>
#include <glm/glm.hpp>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

namespace {

/// "x, y and z".
std::string Axes(glm::bvec3 axes) {
  std::string names;
  for (int i = 0; i < 3; ++i) {
    if (!axes[i]) continue;
    bool more = false;
    for (int j = i + 1; j < 3; ++j) more = more || axes[j];
    if (!names.empty()) names += more ? ", " : " and ";
    names += "xyz"[i];
  }
  return names;
}

std::string_view Direction(int axis, double sign) {
  constexpr std::string_view kNames[3][2] = {
      {"to the left", "to the right"}, {"towards you", "away from you"}, {"down", "up"}};
  return kNames[axis][sign > 0 ? 1 : 0];
}

std::string Newtons(double force) { return Short(force, 2) + " N"; }
std::string Milliseconds(double time) { return Short(1e3 * time, 1) + " ms"; }

}  // namespace

std::string DevicesOutcome(std::size_t there, std::size_t usable) {
  return fmt::format("{} found, {} can be opened", Counted(there, "device", "devices"),
                     usable == there ? (there == 1 ? "it" : "all") : fmt::format("{}", usable));
}

std::string NoDevice() {
  return "no device found: nothing that is plugged in is one that Moontrace knows";
}

std::string KnownProfiles(std::size_t count) {
  return fmt::format("{}, plugged in or not:", Counted(count, "kind is known", "kinds are known"));
}

std::string ProfileLine(const DeviceProfile& profile) {
  std::string reads;
  if (profile.read_size > 0) {
    reads = fmt::format(", letters read from {} mm", Short(kMillimetres * profile.read_size, 1));
  } else if (glm::any(profile.limits.pushes)) {
    reads = ", no letters surely read";
  }
  return fmt::format("{}: {}{}.", profile.name, OneLine(profile.title), reads);
}

std::string NoHidapi() {
  return "no device can be found: built without hidapi; install libhidapi-dev and build again";
}

std::string WithoutDevice() {
  return "Without one, a simulated stylus does the work. Begin with \"moontrace demo\", or "
         "\"moontrace learn --device simulated\". devices/README.md tells which to buy or to "
         "build. An arm with a driver of its own is used as --device plugin:PATH; "
         "devices/moontrace_device.h tells how.";
}

std::string DeviceLine(const DeviceEntry& entry) {
  if (!entry.problem.empty()) {
    return fmt::format("{}: cannot be opened: {} ({})", entry.name, OneLine(entry.problem, 600),
                       OneLine(entry.profile.title));
  }
  return fmt::format("{}: {}", entry.name, OneLine(entry.profile.title));
}

std::string FiguresFrom(const DeviceEntry& entry) {
  if (entry.asked) return "It says of itself:";
  if (!entry.problem.empty()) return "Its profile says, and it was not asked:";
  return "Its profile says, and nothing was measured:";
}

std::string MendByRule() { return "To mend that, put this line"; }
std::string MendInFile() { return "into the file"; }
std::string MendByCommand() { return "then, as root, say"; }
std::string MendByPlugging() { return "and plug the device in again."; }

std::string DevicePushes(const DeviceProfile& profile) {
  const DeviceLimits& limits = profile.limits;
  if (!glm::any(limits.pushes)) return "It pushes nothing: it moves the tip, the force is told.";
  std::string line =
      fmt::format("It pushes along {}: up to {}", Axes(limits.pushes), Newtons(limits.peak_force));
  if (std::isfinite(limits.continuous_force)) {
    line += fmt::format(" for a moment, {} for ever", Newtons(limits.continuous_force));
  }
  return line + ".";
}

std::string DeviceMeasures(const DeviceProfile& profile) {
  const DeviceLimits& limits = profile.limits;
  std::string size;
  for (int i = 0; i < 3; ++i) {
    if (!limits.measures[i] || !std::isfinite(limits.workspace_D[i])) continue;
    if (!size.empty()) size += " by ";
    size += Short(2 * kMillimetres * limits.workspace_D[i], 0);
  }
  return fmt::format("It measures {}, in a workspace of {} mm; {}.", Axes(limits.measures),
                     size.empty() ? "unknown" : size,
                     limits.buttons == 0
                         ? "no button"
                         : Counted(static_cast<std::size_t>(limits.buttons), "button", "buttons"));
}

std::string DeviceLetters(const DeviceProfile& profile, double smallest) {
  if (!glm::any(profile.limits.pushes)) return "Letters of every size can be seen, none felt.";
  std::string line = fmt::format("It holds {} N/m steady; ", Short(StableStiffness(profile), 0));
  if (smallest == 0) return line + "it cannot hold the tip in a groove.";
  if (!std::isfinite(smallest)) return line + "it is too weak to render letters well.";
  return line + fmt::format("the smallest letter that renders well is {} mm.",
                            Short(std::ceil(10 * kMillimetres * smallest - 1e-9) / 10, 1));
}

std::string DeviceReads(const DeviceProfile& profile) {
  return fmt::format(
      "The smallest letters that a simulated reader reads on it by touch are {} mm high.",
      Short(kMillimetres * profile.read_size, 1));
}

std::string DeviceCoupling(const DeviceProfile& profile) {
  const CouplingGains coupling = CouplingOf(profile);
  std::string line = fmt::format("The page is felt through a spring of {} N/m, damped by {} N s/m",
                                 Short(coupling.stiffness, 0), Short(coupling.damping, 1));
  if (profile.position_step > 0) {
    line += fmt::format("; its readings come in steps of {} micrometres",
                        Short(1e6 * profile.position_step, 0));
  }
  return line + ".";
}

std::string DeviceRate(const DeviceProfile& profile) {
  return fmt::format("It takes {} forces a second and answers {} later.", Short(profile.rate, 0),
                     Milliseconds(profile.delay));
}

std::string DeviceLetsGo(const DeviceProfile& profile) {
  if (!glm::any(profile.limits.pushes)) return "It has no force to let go of.";
  if (profile.limits.dead_man <= 0) {
    return "It never lets go by itself: should this computer fail, switch it off.";
  }
  return fmt::format("It lets go by itself {} after this computer falls silent.",
                     Milliseconds(profile.limits.dead_man));
}

std::string DeviceGuarded(const DeviceEntry& entry) {
  if (!entry.unguarded.empty()) return fmt::format("Not guarded: {}.", entry.unguarded);
  return "Guarded: when Moontrace dies or hangs, another process lets go in 25 ms.";
}

std::string TryDevice(std::string_view name) {
  return fmt::format("\"moontrace devices test {}\" tries it step by step.", name);
}

std::string NoDeviceNamed() {
  return "devices test needs the name of a device: \"moontrace devices\" lists them";
}

std::string NothingToTest() {
  return "simulated is the program's own hand, with nothing to test: \"moontrace trace moon\" "
         "shows what it does";
}

std::string UnknownDevicesWord(std::string_view given) {
  const std::string nearest = NearestListed(given, "list, test");
  return fmt::format("devices takes nothing, list, or test and a name, not {}{}", Quoted(given),
                     nearest.empty() ? "" : fmt::format(": did you mean {}?", nearest));
}

std::string TestBegins(std::string_view name, std::string_view title) {
  return fmt::format(
      "Testing {}: {}. Ctrl-C ends it at any time; so does a button while it pushes.", name,
      OneLine(title));
}

std::string TestStep(std::size_t number, std::string_view what) {
  return fmt::format("Step {}: {}.", number, what);
}

std::string AskForHoming() {
  return "It must learn where it is, by your hand; it pushes nothing before. Answer yes when you "
         "hold it, no to leave this out.";
}

std::string NotHomed() { return "Left out: the arm was not homed here, so it is given no force."; }

std::string HomingFailed(double seconds) {
  return fmt::format("Failed: not homed within {} seconds.", Short(seconds, 0));
}

std::string MoveAndPress(double seconds, int buttons) {
  return fmt::format("For {} seconds move the tip to all its sides{}.", Short(seconds, 1),
                     buttons > 0 ? " and press each button" : "");
}

std::string NoReports() { return "Failed: no report came from it."; }
std::string PuckAtRest() { return "No report came: it sends none while it rests."; }

std::string SawPosition(const DeviceLimits& limits, glm::dvec3 low_D, glm::dvec3 high_D,
                        double reports_a_second) {
  std::string line;
  for (int i = 0; i < 3; ++i) {
    if (!limits.measures[i]) continue;
    line += fmt::format("{} from {} to {} mm, ", "xyz"[i], Short(kMillimetres * low_D[i], 1),
                        Short(kMillimetres * high_D[i], 1));
  }
  return fmt::format("Position: {}{} reports a second.", line, Short(reports_a_second, 0));
}

std::string SawButtons(std::uint32_t buttons, int count) {
  std::string held;
  for (int i = 0; i < 32; ++i) {
    if (((buttons >> i) & 1U) != 0) held += fmt::format("{}{}", held.empty() ? "" : ", ", i + 1);
  }
  if (held.empty()) return fmt::format("Buttons: none of {} was pressed.", count);
  return fmt::format("Buttons pressed: {} of {}.", held, count);
}

std::string DidNotMove() {
  return "The tip did not move: if you moved it, it is no good, or not switched on.";
}

std::string PushesNothing() { return "Left out: it pushes nothing."; }

std::string AskForForces(double force) {
  return fmt::format(
      "Forces of at most {} come next, one direction after the other, each after a "
      "countdown. Hold the device loosely. Answer yes to go on, no to leave them out.",
      Newtons(force));
}

std::string ForcesLeftOut() { return "Left out: nobody agreed to forces."; }

std::string PushesEnded() { return "Left out from here: stopped, or no answer came."; }

std::string Countdown(int seconds, int axis, double sign, double force) {
  return seconds > 0 ? fmt::format("{}", seconds)
                     : fmt::format("Now {}, {}.", Direction(axis, sign), Newtons(force));
}

std::string Pushed(glm::dvec3 moved_D) {
  return fmt::format("The tip went {} mm along x, {} along y, {} along z.",
                     Short(kMillimetres * moved_D.x, 1), Short(kMillimetres * moved_D.y, 1),
                     Short(kMillimetres * moved_D.z, 1));
}

std::string AskDirection(int axis, double sign) {
  return fmt::format("Did it push {}? Answer yes or no.", Direction(axis, sign));
}

std::string StoppedByButton() { return "Stopped by a button: no force any more."; }

std::string CapHeld(double asked, double commanded) {
  return fmt::format("Good: asked for {}, it was given {} at most.", Newtons(asked),
                     Newtons(commanded));
}

std::string NoNumberHeld() { return "Good: a force that is no number became zero."; }

std::string CapBroken(double asked, double commanded) {
  return fmt::format("Failed: asked for {}, it was given {}.", Newtons(asked), Newtons(commanded));
}

std::string NeverLetsGo() {
  return "Left out: it never lets go by itself. Should this computer fail, switch it off.";
}

std::string AskDeadMan(double force, double dead_man) {
  return fmt::format(
      "A second copy of this program will push with {} and then be killed; the force "
      "should be gone {} later. Answer yes to go on, no to leave it out.",
      Newtons(force), Milliseconds(dead_man));
}

std::string AskIsGone() { return "The copy is dead. Is the force gone? Answer yes or no."; }
std::string HeldItNot() { return "Left out: the copy could not push."; }

std::string MotorsOff() {
  return "Left out: its motors are off. Look for a safety switch, then try again.";
}

std::string TestLost(std::string_view why) {
  if (why.empty()) return "Failed: the device was lost. Plug it in again.";
  return fmt::format("Failed: the device was lost: {}.", OneLine(why, 200));
}

std::string TestPassed(std::size_t good, std::size_t left_out) {
  const std::string steps = Counted(good, "step good", "steps good");
  if (left_out == 0) return fmt::format("Passed: {}.", steps);
  return fmt::format("No fault found, but not all was tried: {}, {} left out.", steps, left_out);
}

std::string TestFailed(std::string_view steps) {
  return fmt::format("the device did not pass: {}", steps);
}

}  // namespace moontrace::say

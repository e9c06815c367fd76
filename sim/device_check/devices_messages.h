#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "devices/catalogue/catalogue.h"

/// Sentences of `moontrace devices` and `moontrace devices test`; see messages.h.
namespace moontrace::say {

// The list.
std::string DevicesOutcome(std::size_t there, std::size_t usable);
std::string NoDevice();
std::string KnownProfiles(std::size_t count);
std::string ProfileLine(const DeviceProfile& profile);
std::string NoHidapi();
std::string WithoutDevice();
std::string DeviceLine(const DeviceEntry& entry);
/// Whose word the figures are.
std::string FiguresFrom(const DeviceEntry& entry);
// Of a refused permission, each before what stands alone on its line; and the last.
std::string MendByRule();
std::string MendInFile();
std::string MendByCommand();
std::string MendByPlugging();
std::string DevicePushes(const DeviceProfile& profile);
std::string DeviceMeasures(const DeviceProfile& profile);
std::string DeviceLetters(const DeviceProfile& profile, double smallest);
/// Of a profile with DeviceProfile::read_size.
std::string DeviceReads(const DeviceProfile& profile);
std::string DeviceCoupling(const DeviceProfile& profile);
std::string DeviceRate(const DeviceProfile& profile);
std::string DeviceLetsGo(const DeviceProfile& profile);
std::string DeviceGuarded(const DeviceEntry& entry);
std::string TryDevice(std::string_view name);
std::string NoDeviceNamed();
std::string NothingToTest();
std::string UnknownDevicesWord(std::string_view given);

// The test, step by step.
std::string TestBegins(std::string_view name, std::string_view title);
std::string TestStep(std::size_t number, std::string_view what);
std::string AskForHoming();
std::string NotHomed();
std::string HomingFailed(double seconds);
std::string MoveAndPress(double seconds, int buttons);
std::string NoReports();
std::string PuckAtRest();
std::string SawPosition(const DeviceLimits& limits, glm::dvec3 low_D, glm::dvec3 high_D,
                        double reports_a_second);
std::string SawButtons(std::uint32_t buttons, int count);
std::string DidNotMove();
std::string PushesNothing();
std::string AskForForces(double force);
std::string ForcesLeftOut();
std::string PushesEnded();
std::string Countdown(int seconds, int axis, double sign, double force);
std::string Pushed(glm::dvec3 moved_D);
std::string AskDirection(int axis, double sign);
std::string StoppedByButton();
std::string CapHeld(double asked, double commanded);
std::string NoNumberHeld();
std::string CapBroken(double asked, double commanded);
std::string NeverLetsGo();
std::string AskDeadMan(double force, double dead_man);
std::string AskIsGone();
std::string HeldItNot();
std::string MotorsOff();
std::string TestLost(std::string_view why);
std::string TestPassed(std::size_t good, std::size_t left_out);
std::string TestFailed(std::string_view steps);

}  // namespace moontrace::say

#include "sim/app/commands.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "devices/catalogue/catalogue.h"
#include "devices/core/smallest_letter.h"
#include "devices/hid/hid_port.h"
#include "devices/hid/udev_rule.h"
#include "sim/app/messages.h"
#include "sim/device_check/device_check.h"
#include "sim/device_check/devices_messages.h"
#include "sim/loop/clock.h"
#include "sim/session/device_choice.h"
#include "sim/setup/help.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/metrics_json.h"
#include "textures/base/resources.h"
#include "textures/base/units.h"

namespace moontrace {

void SayMending(const DeviceEntry& entry, Console& console) {
  if (entry.rule.empty()) return;
  console.Result(say::MendByRule());
  console.Path(entry.rule);
  console.Result(say::MendInFile());
  console.Path(kUdevFile);
  console.Result(say::MendByCommand());
  console.Path(kUdevReload);
  console.Result(say::MendByPlugging());
}

namespace {

Json AxesJson(glm::bvec3 axes) {
  std::string names;
  for (int i = 0; i < 3; ++i) {
    if (axes[i]) names += "xyz"[i];
  }
  return names;
}

Json EntryJson(const DeviceEntry& entry) {
  const DeviceProfile& profile = entry.profile;
  const DeviceLimits& limits = profile.limits;
  Json json;
  json["name"] = entry.name;
  json["title"] = profile.title;
  json["path"] = entry.path;
  json["problem"] = entry.problem.empty() ? Json(nullptr) : Json(entry.problem);
  json["udev_rule"] = entry.rule.empty() ? Json(nullptr) : Json(entry.rule);
  json["figures_from"] = entry.asked ? "device" : "profile";
  json["measures"] = AxesJson(limits.measures);
  json["pushes"] = AxesJson(limits.pushes);
  Json workspace = Json::array();
  for (int i = 0; i < 3; ++i) {
    workspace.push_back(limits.measures[i] ? OrNull(2 * kMillimetres * limits.workspace_D[i])
                                           : Json(nullptr));
  }
  json["workspace_mm"] = workspace;
  json["buttons"] = limits.buttons;
  json["peak_force_n"] = OrNull(limits.peak_force);
  json["continuous_force_n"] = OrNull(limits.continuous_force);
  json["stable_stiffness_n_per_m"] = OrNull(StableStiffness(profile));
  const CouplingGains coupling = CouplingOf(profile);
  json["coupling_stiffness_n_per_m"] = coupling.stiffness;
  json["coupling_damping_ns_per_m"] = coupling.damping;
  json["position_step_um"] =
      profile.position_step > 0 ? Json(1e6 * profile.position_step) : Json(nullptr);
  json["smallest_letter_mm"] = OrNull(kMillimetres * SmallestLetter(profile));
  json["read_letter_mm"] = profile.read_size > 0 ? Json(kMillimetres * profile.read_size) : Json();
  json["rate_hz"] = profile.rate;
  json["delay_ms"] = kMillimetres * profile.delay;
  json["dead_man_ms"] = limits.dead_man > 0 ? Json(kMillimetres * limits.dead_man) : Json(nullptr);
  json["guarded"] = entry.unguarded.empty();
  json["not_guarded_because"] = entry.unguarded.empty() ? Json(nullptr) : Json(entry.unguarded);
  return json;
}

void SayFigures(const DeviceEntry& entry, Console& console) {
  const DeviceProfile& profile = entry.profile;
  console.Result(say::FiguresFrom(entry));
  console.Result(say::DevicePushes(profile));
  console.Result(say::DeviceMeasures(profile));
  console.Result(say::DeviceLetters(profile, SmallestLetter(profile)));
  if (profile.read_size > 0) console.Result(say::DeviceReads(profile));
  if (glm::any(profile.limits.pushes)) console.Result(say::DeviceCoupling(profile));
  console.Result(say::DeviceRate(profile));
  console.Result(say::DeviceLetsGo(profile));
  console.Result(say::DeviceGuarded(entry));
}

/// What would be recognised, so that somebody who has no device yet finds the names.
void SayProfiles(const std::vector<DeviceProfile>& profiles, Console& console) {
  console.Result(say::KnownProfiles(profiles.size()));
  for (const DeviceProfile& profile : profiles) console.Result(say::ProfileLine(profile));
}

int List(const DevicesOptions& options, Console& console) {
  const std::vector<DeviceProfile> profiles = LoadProfiles(ProfilesFolder());
  const std::vector<DeviceEntry> entries = ListDevices(ProfilesFolder());
  if (options.output.json) {
    Json json;
    json["hidapi"] = HidIsBuiltIn();
    json["devices"] = Json::array();
    for (const DeviceEntry& entry : entries) json["devices"].push_back(EntryJson(entry));
    json["profiles"] = Json::array();
    for (const DeviceProfile& profile : profiles) {
      json["profiles"].push_back(
          {{"name", profile.name},
           {"title", profile.title},
           {"smallest_letter_mm", OrNull(kMillimetres * SmallestLetter(profile))},
           {"read_letter_mm",
            profile.read_size > 0 ? Json(kMillimetres * profile.read_size) : Json()}});
    }
    console.Json(Dump(json));
    return exit_code::kGood;
  }
  if (entries.empty()) {
    console.Result(HidIsBuiltIn() ? say::NoDevice() : say::NoHidapi());
    console.Result(say::WithoutDevice());
    SayProfiles(profiles, console);
    return exit_code::kGood;
  }
  const auto usable = std::count_if(entries.begin(), entries.end(),
                                    [](const DeviceEntry& e) { return e.problem.empty(); });
  console.Result(say::DevicesOutcome(entries.size(), static_cast<std::size_t>(usable)));
  for (const DeviceEntry& entry : entries) {
    console.Result(say::DeviceLine(entry));
    SayMending(entry, console);
    SayFigures(entry, console);
    if (entry.problem.empty()) console.Result(say::TryDevice(entry.name));
  }
  SayProfiles(profiles, console);
  return exit_code::kGood;
}

/// What is known of a device before it is opened; only its name if it is not there.
DeviceEntry EntryOfName(const std::string& name) {
  if (!PluginPathOf(name).empty()) return EntryOfPlugin(name);
  for (DeviceEntry& entry : ListDevices(ProfilesFolder())) {
    if (entry.name == name) return std::move(entry);
  }
  DeviceRequest request;
  request.name = name;
  OpenDevice(request, ProfilesFolder());  // says what there is instead
  return {};
}

std::string_view ResultWord(StepResult result) {
  if (result == StepResult::kGood) return "good";
  return result == StepResult::kFailed ? "failed" : "left out";
}

int Test(const std::string& name, const DevicesOptions& options, Console& console) {
  const DeviceEntry entry = EntryOfName(name);
  console.Result(say::DeviceLine(entry));
  SayMending(entry, console);
  SayFigures(entry, console);
  CheckedDevice checked;
  checked.name = name;
  checked.title = entry.profile.title;
  checked.rests_silent = entry.profile.kind == DeviceKind::kPuck;
  std::string remark;
  checked.open = [&] {
    DeviceRequest request;
    request.name = name;
    request.remark = &remark;
    std::unique_ptr<Device> device = OpenDevice(request, ProfilesFolder());
    if (!remark.empty()) console.Remark(remark);
    return device;
  };
  SteadyClock clock;
  const std::vector<CheckStep> steps = CheckDevice(
      checked, CheckPlan(), clock,
      [&](const std::string& line) {
        if (options.output.json) {
          console.Remark(line);
        } else {
          console.Result(line);
        }
      },
      console);

  std::string failed;
  std::size_t good = 0;
  Json json;
  json["name"] = name;
  json["steps"] = Json::array();
  for (const CheckStep& step : steps) {
    if (step.result == StepResult::kGood) ++good;
    if (step.result == StepResult::kFailed) failed += (failed.empty() ? "" : ", ") + step.name;
    Json one;
    one["step"] = step.name;
    one["result"] = ResultWord(step.result);
    json["steps"].push_back(one);
  }
  if (options.output.json) console.Json(Dump(json));
  if (!failed.empty()) throw WorkFailed(say::TestFailed(failed));
  console.Result(say::TestPassed(good, steps.size() - good));
  return exit_code::kGood;
}

}  // namespace

void AddOptions(CLI::App& app, DevicesOptions& options) {
  AddWords(app, options.words, say::help::kDevicesWords);
  AddFlag(app, "--udev", options.udev, say::help::kUdev);
  AddOptions(app, options.output);
}

int Run(const DevicesOptions& options, Console& console) {
  const std::vector<std::string>& words = options.words;
  if (options.udev) {
    console.out() << UdevFile(LoadProfiles(ProfilesFolder()));
    return exit_code::kGood;
  }
  if (words.empty() || (words.size() == 1 && words[0] == "list")) return List(options, console);
  if (words[0] == "list") throw UsageError(say::SpareArgument(words[1], "devices list", false));
  if (words[0] != "test") throw UsageError(say::UnknownDevicesWord(words[0]));
  if (words.size() < 2 || words[1].empty()) throw UsageError(say::NoDeviceNamed());
  if (IsSimulated(words[1])) throw UsageError(say::NothingToTest());
  if (words.size() > 2) throw UsageError(say::SpareArgument(words[2], "devices test NAME", false));
  return Test(words[1], options, console);
}

}  // namespace moontrace

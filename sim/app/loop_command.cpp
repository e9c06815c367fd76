#include "sim/app/commands.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "sim/session/device_choice.h"
#include "sim/session/loop_drive.h"
#include "sim/session/loop_messages.h"
#include "sim/session/loop_session.h"
#include "sim/session/view_feed.h"
#include "sim/session/view_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/metrics_json.h"
#include "sim/trial/touch_energy.h"
#include "textures/base/error.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

/// What was felt, summed up off the tick.
struct Felt {
  std::uint64_t samples = 0, contacts = 0;
  double force_sum = 0, peak_force = 0;  ///< [N]
  TouchEnergy energy;

  void Add(const LoopSample& sample) {
    ++samples;
    energy.Add(sample.energy_out, sample.in_contact);
    if (!sample.in_contact) return;
    const double force = glm::length(sample.force_P);
    ++contacts;
    force_sum += force;
    peak_force = std::max(peak_force, force);
  }
  double Share() const {
    return samples > 0 ? static_cast<double>(contacts) / static_cast<double>(samples) : 0;
  }
  double Mean() const { return contacts > 0 ? force_sum / static_cast<double>(contacts) : 0; }
};

Json PercentilesJson(const Histogram& histogram) {
  return {{"p50", histogram.Percentile(0.5)},
          {"p99", histogram.Percentile(0.99)},
          {"p999", histogram.Percentile(0.999)},
          {"max", histogram.max()}};
}

Json DeviceJson(const LoopSession& session) {
  const LiveDevice& device = session.device();
  const DeviceLimits& limits = device.limits();
  Json json;
  json["name"] = device.simulated() ? "simulated" : device.name();
  json["peak_force_n"] = OrNull(limits.peak_force);
  json["continuous_force_n"] = OrNull(limits.continuous_force);
  json["stiffness_n_m"] = limits.stiffness;
  json["late_ticks"] = limits.late_ticks;
  json["dead_man_ms"] = 1e3 * limits.dead_man;
  json["axes"] = int{limits.measures.x} + int{limits.measures.y} + int{limits.measures.z};
  json["buttons"] = limits.buttons;
  Json reach = Json::array();
  for (int i = 0; i < 3; ++i) reach.push_back(OrNull(2e3 * limits.workspace_D[i]));
  json["workspace_mm"] = std::move(reach);
  return json;
}

/// How long the loop ran, with a device or without [s].
double TimeOf(const LoopSession& session, const LoopReport& report) {
  return static_cast<double>(report.ticks + report.lost_ticks) / session.rate();
}

Json LoopJson(const LoopSession& session, const LoopReport& report, const std::string& why_not,
              const Felt& felt) {
  const double seconds = TimeOf(session, report);
  Json json = TypesetJson(session.text().set, session.text().script);
  json["pages"] = session.text().set.pages.size();
  json["device"] = DeviceJson(session);
  json["scale"] = session.device().scale();
  json["tilt_deg"] = InDegrees(session.tilt());
  json["rate_hz"] = session.rate();
  json["seconds"] = seconds;
  json["ticks"] = report.ticks;
  json["lost_ticks"] = report.lost_ticks;
  json["lateness_us"] = PercentilesJson(report.lateness);
  json["cost_us"] = PercentilesJson(report.cost);
  json["realtime"] = why_not.empty() ? Json(true) : Json(why_not);
  json["silences"] = report.late_loops;
  Json safety;
  for (std::size_t i = 0; i < kSafetyEvents; ++i) {
    safety[std::string(say::EventName(static_cast<SafetyEvent>(i)))] = report.safety_counts[i];
  }
  json["safety"] = std::move(safety);
  json["touching"] = felt.Share();
  json["mean_force_n"] = felt.Mean();
  json["peak_force_n"] = felt.peak_force;
  json["force_bound_n"] = session.force_bound();
  json["carried_press_n"] = session.carried_press();
  json["energy_out_uj"] = 1e6 * felt.energy.value();
  json["samples_dropped"] = report.samples_dropped;
  json["events_dropped"] = report.events_dropped;
  return json;
}

SessionRequest RequestOf(const LoopCommandOptions& options) {
  SessionRequest request;
  request.text = {options.text, options.style, options.layout,
                  options.feel, "loop",        say::help::kDefaultText};
  ChooseLabel(request.text.feel);
  request.live = options.live;
  request.press = options.press;
  request.seed = options.seed;
  return request;
}

}  // namespace

void AddOptions(CLI::App& app, LoopCommandOptions& options) {
  AddLoopOptions(app, options);
  AddOptions(app, options.view);
  AddCamera(app, options.view);
}

void AddLoopOptions(CLI::App& app, LoopCommandOptions& options) {
  AddOptions(app, options.text);
  Redescribe(app, "TEXT", say::help::kLoopText);
  AddOptions(app, options.live);
  AddNumber(app, "--press-n", options.press, 0.01, 20, 1, say::help::kLoopPress);
  AddOptions(app, options.style);
  AddOptions(app, options.layout);
  AddOptions(app, options.feel);
  BeginGroup(app, help_group::kHand);
  AddSeed(app, options.seed);
  AddOptions(app, options.output);
}

int Run(const LoopCommandOptions& options, Console& console) {
  LoopCommandOptions shown = options;
  shown.layout.centred = options.view.asked();  // as view has it
  CheckCamera(options.view, options.feel.model);
  const auto aims = AimsFor(shown.live.device, shown.view);
  const std::unique_ptr<ViewFeed> view = ViewFeed::Open(shown.view, aims, console);
  return RunLoop(shown, view.get(), aims, console);
}

int RunLoop(const LoopCommandOptions& options, ViewFeed* view,
            const std::shared_ptr<Mailbox<StylusAim>>& aims, Console& console) {
  SessionRequest request = RequestOf(options);
  request.aims = aims;
  LoopSession session(request, console);
  SayReplacements(session.text().set,
                  [&console](const std::string& line) { console.Remark(line); });
  const std::string why_not = session.loop().not_realtime();
  const bool is_felt = session.device().felt();
  if (is_felt && !why_not.empty()) console.Remark(say::NotRealtime(why_not));
  SayBeginning(session, console);
  Felt felt;
  DriveOptions drive;
  drive.seconds = options.live.seconds;
  drive.view = view;
  drive.sample = [&felt](const LoopSample& sample) { felt.Add(sample); };
  const bool spoken = Drive(session, drive, console);
  const bool for_nobody =
      options.view.window && view == nullptr && !spoken && !options.live.seconds;

  const LoopReport& report = session.loop().report();
  if (options.output.json) {
    Json json = LoopJson(session, report, why_not, felt);
    if (view != nullptr) json["view"] = ViewJson(*view);
    console.Json(Dump(json));
    RequireDevice(session);
    if (view != nullptr) RequireView(*view, options.live.device);
    if (for_nobody) throw LackError(say::NothingSeen());
    return exit_code::kGood;
  }
  console.Result(say::LoopOutcome(TimeOf(session, report)));
  if (is_felt) {
    console.Result(say::Touched(felt.Share(), felt.Mean(), felt.peak_force));
    console.Result(say::SafetyActed(report));
    console.Result(say::Lateness(report));
  } else {
    console.Result(say::Touched(felt.Share()));
  }
  if (view != nullptr) SayView(*view, options.view, console);
  RequireDevice(session);
  if (view != nullptr) RequireView(*view, options.live.device);
  if (for_nobody) throw LackError(say::NothingSeen());
  return exit_code::kGood;
}

}  // namespace moontrace

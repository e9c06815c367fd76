// The C interface to MuJoCo: traces by a simulated hand, and records of them.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "sim/library/call.h"
#include "sim/library/stepping/moontrace_mujoco.h"
#include "sim/library/stepping/scene_values.h"
#include "sim/setup/text_trial.h"
#include "sim/setup/trial_parameters.h"
#include "sim/trial/metrics_json.h"
#include "sim/trial/record.h"

using namespace moontrace;

namespace {

TrialSetup SetupOf(SceneState& state, const moontrace_trace_options& given) {
  RequireNumber(given.speed, "options.speed", 0);
  RequireNumber(given.press, "options.press", 0);
  FeelOptions feel;
  feel.scene = state.bound.scene().options();
  const auto press = given.press > 0 ? std::optional<double>(given.press) : std::nullopt;
  TrialSetup setup = TrialOf(state.text, state.page, feel, press, given.seed != 0 ? given.seed : 1);
  if (given.speed > 0) setup.plan.speed = given.speed;
  setup.field = state.field;
  setup.around = [&state](const std::function<void()>& work) { state.bound.Run(work); };
  return setup;
}

void Keep(const TickResult& felt, double time, TraceValue& trace) {
  trace.time.push_back(time);
  trace.depth.push_back(felt.depth);
  for (int i = 0; i < 3; ++i) {
    trace.tip.push_back(felt.tip_P[i]);
    trace.proxy.push_back(felt.proxy_P[i]);
    trace.force.push_back(felt.force_P[i]);
  }
}

std::unique_ptr<TraceValue> TraceOf(SceneState& state, const moontrace_trace_options& given) {
  auto trace = std::make_unique<TraceValue>();
  TrialSetup setup = SetupOf(state, given);
  setup.watch = [&trace](double time, const TickResult& felt, const GuidanceResult&, const Scene&) {
    Keep(felt, time, *trace);
  };
  std::optional<RecordRequest> request;
  if (given.record != nullptr) {
    if (!state.records) throw UsageError("a record needs the scene's options.model_path");
    const TextSetup& text = state.text;
    request.emplace();
    request->folder = given.record;
    request->also_csv = RequireFlag(given.csv, "options.csv");
    request->parameters_json = ParametersJson(
        {text.text, text.script_name, text.set.style, text.set.page, state.page, false}, setup);
    CheckRecordFolder(request->folder);
  }
  state.bound.Reset({0, 0, 0.02});  // where a scene that is loaded begins
  state.bound.RunWithout(
      [&] { trace->result = RunTrial(setup, state.bound.scene(), request ? &*request : nullptr); });
  trace->json = ResultText(trace->result);
  return trace;
}

moontrace_trace_facts FactsOf(const TraceValue& trace) {
  const TrialResult& result = trace.result;
  const TraceMetrics& total = result.score.total;
  moontrace_trace_facts given{};
  given.samples = trace.time.size();
  given.duration = result.duration;
  given.coverage = total.coverage;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const bool followed = !FollowedNothing(total);
  given.mean_error = followed ? total.mean_error : none;
  given.rms_error = followed ? total.rms_error : none;
  given.max_error = followed ? total.max_error : none;
  given.mean_force = total.mean_force;
  given.peak_force = total.peak_force;
  given.mean_speed = total.mean_speed;
  given.contact_share = total.contact_share;
  given.energy_out = result.energy_out;
  given.excursions = total.excursions;
  given.lifts = total.lifts;
  given.lifts_within_lines = result.lifts_within_lines;
  given.through = result.through;
  given.faults = result.faults;
  given.json = trace.json.c_str();
  return given;
}

/// Rows of `width` numbers.
void Copy(const std::vector<double>& from, std::size_t width, std::size_t first, std::size_t count,
          double* to) {
  if (to == nullptr) return;
  std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(width * first), width * count, to);
}

}  // namespace

int moontrace_trace_open(moontrace_scene* scene, mjModel_* m, mjData_* d,
                         const moontrace_trace_options* options, moontrace_trace** trace) {
  return Answer([&] {
    RequireNotNull(trace, "trace");
    const moontrace_trace_options given =
        options != nullptr ? Given(options, sizeof *options, "options") : moontrace_trace_options{};
    const InUse<SceneTable> value(scene, kSceneHandle);
    const Alone alone(*value->state);
    value->state->bound.Require(m, d);
    OpenHandle<TraceTable>(TraceOf(*value->state, given), trace);
  });
}

int moontrace_trace_describe(const moontrace_trace* trace, moontrace_trace_facts* facts) {
  return Answer([&] {
    const InUse<TraceTable> value(trace, kTraceHandle);
    Give(FactsOf(*value), sizeof *facts, "facts", facts);
  });
}

int moontrace_trace_read(const moontrace_trace* trace, const moontrace_trace_samples* samples) {
  return Answer([&] {
    const InUse<TraceTable> value(trace, kTraceHandle);
    const moontrace_trace_samples given = Given(samples, sizeof *samples, "samples");
    const std::size_t have = value->time.size();
    if (given.first > have || given.count > have - given.first) {
      throw UsageError(
          fmt::format("samples {} to {}, the trace has {}", given.first,
                      static_cast<double>(given.first) + static_cast<double>(given.count), have));
    }
    Copy(value->time, 1, given.first, given.count, given.time);
    Copy(value->tip, 3, given.first, given.count, given.tip);
    Copy(value->proxy, 3, given.first, given.count, given.proxy);
    Copy(value->force, 3, given.first, given.count, given.force);
    Copy(value->depth, 1, given.first, given.count, given.depth);
  });
}

int moontrace_trace_close(moontrace_trace* trace) {
  return Answer([&] { CloseHandle<TraceTable>(trace, kTraceHandle); });
}

#include "sim/app/commands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "sim/app/messages.h"
#include "sim/session/loop_messages.h"
#include "sim/session/view_messages.h"
#include "sim/session/view_trial.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/text_setup.h"
#include "sim/setup/trial_parameters.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/record.h"
#include "sim/trial/trial.h"
#include "textures/base/error.h"
#include "textures/fonts/fallback.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

/// The page of the record and its push, built again.
struct Rebuilt {
  std::shared_ptr<const TextureField> field;
  std::optional<GuidancePlan> push;
  std::shared_ptr<const ViewPage> seen;  ///< with `view`
  std::size_t letters = 0;               ///< of the page, without its running head
};
Rebuilt RebuiltFrom(const TrialParameters& parameters, const std::string& folder, bool view) {
  const bool alone = parameters.fallback_script.empty();
  Script script = FindScript(parameters.script, alone ? parameters.text : "");
  if (!parameters.fallback_script.empty())
    Borrow(script, FindScript(parameters.fallback_script), parameters.fallback_script);
  script = Reshaped(script, parameters.style.form);
  if (parameters.style.lines == LineDirection::kAlternate) AddGuides(script, parameters.style);
  const Typeset set = SetText(parameters.text, script, parameters.style, parameters.paper);
  if (parameters.page >= set.pages.size()) {
    throw InputError(say::BadParameters(folder, "page"));
  }
  const TextPage& page = set.pages[parameters.page];
  Rebuilt rebuilt;
  rebuilt.letters = static_cast<std::size_t>(
      std::count_if(page.glyphs.begin(), page.glyphs.end(),
                    [](const PlacedGlyph& glyph) { return glyph.kind != LineKind::kHead; }));
  rebuilt.field =
      std::make_shared<const TextureField>(PageField(page, script, set.style, parameters.blank));
  if (view) {
    rebuilt.seen = MakeViewPage(set, parameters.page, script, parameters.text, rebuilt.field,
                                parameters.blank, static_cast<std::uint32_t>(parameters.page));
  }
  if (parameters.guidance.on()) {
    rebuilt.push = PlanOf(parameters.guidance, IntendedStrokes(page, script, set.style));
  }
  return rebuilt;
}

Json ResultOf(const Record& record) {
  const Json result = Json::parse(record.result_json, nullptr, false);
  return result.is_object() ? result : Json::object();
}

/// A number of the record's results, in its unit there; none: it has none, or null.
std::optional<double> NumberOf(const Json& result, const char* key) {
  const auto found = result.find(key);
  if (found == result.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

/// A count, of a record that may say anything.
std::size_t CountOf(const Json& result, const char* key) {
  const double count = NumberOf(result, key).value_or(0);
  return count >= 0 && count < 1e15 ? static_cast<std::size_t>(count) : 0;
}

/// What people are told of the record's own results, as TotalJson wrote them.
TrialResult Told(const Json& result) {
  const auto number = [&result](const char* key) { return NumberOf(result, key).value_or(0); };
  TrialResult told;
  TraceMetrics& total = told.score.total;
  total.coverage = number("coverage");
  total.mean_error = 1e-3 * number("mean_error_mm");
  total.max_error = 1e-3 * number("max_error_mm");
  total.excursions = CountOf(result, "excursions");
  total.contact_share = number("contact_share");
  total.mean_force = number("mean_force_n");
  total.peak_force = number("peak_force_n");
  told.score.letters_per_second = number("letters_per_second");
  told.duration = number("duration_s");
  told.force_bound =
      NumberOf(result, "force_bound_n").value_or(std::numeric_limits<double>::infinity());
  told.force_per_acceleration = number("force_bound_per_m_per_s2_n");
  told.carried_press = number("carried_press_n");
  told.through = CountOf(result, "through");
  const auto by_readings = NumberOf(result, "energy_out_by_readings_uj");
  told.energy_out = 1e-6 * by_readings.value_or(number("energy_out_uj"));
  if (by_readings) told.true_energy_out = 1e-6 * number("energy_out_uj");
  told.mean_guidance = number("mean_guidance_n");
  told.guidance_work = 1e-3 * number("guidance_work_mj");
  return told;
}

/// In the sentences of `trace`; names with values stand in --json.
void SayResult(const Json& result, const TrialParameters& parameters, std::size_t letters,
               Console& console) {
  if (result.empty()) return;  // it was cut off before its end
  const TrialResult told = Told(result);
  const TraceMetrics& total = told.score.total;
  const bool blank = parameters.blank;
  if (NeverTouched(total)) {
    console.Result(say::NeverTouched(told.duration));
  } else {
    console.Result(say::TraceOutcome(told, letters, blank));
    if (NumberOf(result, "mean_error_mm")) {
      console.Result(say::MeanError(total, parameters.style, blank));
      console.Result(say::WorstError(total));
      console.Result(say::LeftGroove(total, parameters.style, blank));
    } else {
      console.Result(say::FollowedNothing());
    }
  }
  console.Result(say::Force(total));
  if (parameters.guidance.on()) {
    console.Result(say::Guided(parameters.guidance.mode, parameters.guidance.help,
                               told.mean_guidance, told.guidance_work));
  }
  if (std::isfinite(told.force_bound)) console.Result(say::ForceBound(told));
  console.Result(told.through > 0 ? say::Through(told) : say::CarriedPress(told.carried_press));
  console.Result(say::Energy(told));
  console.Result(say::RecordedTime(told.duration, told.score.letters_per_second));
}

}  // namespace

void AddOptions(CLI::App& app, ReplayOptions& options) {
  AddPath(app, "FOLDER", "FOLDER", options.folder, say::help::kFolder);
  AddFlag(app, "--check", options.check, say::help::kCheck);
  AddOptions(app, options.view);
  AddOptions(app, options.output);
}

int Run(const ReplayOptions& options, Console& console) {
  if (options.folder.empty()) throw UsageError(say::NoFolder());
  CheckTogether(options.view);
  const Record record = ReadRecord(options.folder, options.check);
  const TrialParameters parameters = ReadParameters(record.head.parameters_json, options.folder);
  const Rebuilt page = RebuiltFrom(parameters, options.folder, options.view.asked());
  if (page.field->Hash() != record.head.field_hash) {
    throw InputError(say::OtherField(options.folder));
  }
  const std::unique_ptr<ViewFeed> feed = ViewFeed::OpenOfTrial(options.view, console);
  std::optional<TrialView> view;
  TickWatch watch;
  const std::string model = options.folder + "/model.xml";
  const auto others =
      OtherLabels(Scene::FromXml(record.model_xml, model, record.options), model, console);
  if (feed) {
    view.emplace(*feed, console);
    const bool shipped = record.model_xml == Scene::Load("", SceneOptions()).model_xml();
    if (!shipped) view->ShowModel(others);
    view->Begin(page.seen, {parameters.text, parameters.style.size, {}, {}});
    watch = [&view](double time, const TickResult& felt, const GuidanceResult& push,
                    const Scene& scene) { view->Look(time, felt, push, scene); };
  }
  const ReplayResult replay =
      Replay(record, *page.field, page.push ? &*page.push : nullptr, watch, others);
  // An altered record is bad input, whatever the replay gives: bit-equal to what was altered is no
  // success, and not every column decides what is computed.
  if (!record.altered.empty()) throw InputError(say::Altered(record.altered, replay));
  const bool equal = replay.first_difference >= replay.ticks;
  if (options.output.json) {
    Json json;
    json["text"] = parameters.text;
    json["bit_equal"] = equal;
    json["ticks"] = replay.ticks;
    if (!equal) json["first_difference"] = replay.first_difference;
    if (!equal) json["column"] = replay.column;
    json["total"] = ResultOf(record);
    if (feed) json["view"] = ViewJson(*feed);
    console.Json(Dump(json));
  } else {
    console.Result(equal
                       ? say::ReplayEqual(replay.ticks)
                       : say::ReplayDiffers(replay.first_difference, replay.ticks, replay.column));
    console.Result(say::ReplayWhat(parameters.text, parameters.style.size, parameters.blank));
    if (!options.check) SayResult(ResultOf(record), parameters, page.letters, console);
    if (feed) SayView(*feed, options.view, console);
  }
  if (feed) RequireView(*feed, {});
  return options.check && !equal ? exit_code::kFailed : exit_code::kGood;
}

}  // namespace moontrace

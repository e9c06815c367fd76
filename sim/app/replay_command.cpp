#include "sim/app/commands.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "sim/app/messages.h"
#include "sim/session/view_messages.h"
#include "sim/session/view_trial.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
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

/// The record's own results, one "name: value" line each.
void SayResult(const Record& record, Console& console) {
  const Json result = ResultOf(record);
  for (const auto& [name, value] : result.items()) {
    console.Result(say::NamedValue(name, value.dump()));
  }
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
  if (feed) {
    view.emplace(*feed, console);
    view->Begin(page.seen, {parameters.text, parameters.style.size, {}, {}});
    watch = [&view](double time, const TickResult& felt, const GuidanceResult& push) {
      view->Look(time, felt, push);
    };
  }
  const ReplayResult replay = Replay(record, *page.field, page.push ? &*page.push : nullptr, watch);
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
    if (!options.check) SayResult(record, console);
    if (feed) SayView(*feed, options.view, console);
  }
  if (feed) RequireView(*feed, {});
  return options.check && !equal ? exit_code::kFailed : exit_code::kGood;
}

}  // namespace moontrace

#include "sim/app/commands.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "devices/catalogue/catalogue.h"
#include "lessons/guide/guidance.h"
#include "sim/app/messages.h"
#include "sim/app/trace_picture.h"
#include "sim/app/trace_report.h"
#include "sim/picture/picture_file.h"
#include "sim/session/device_choice.h"
#include "sim/session/loop_messages.h"
#include "sim/session/view_messages.h"
#include "sim/session/view_trial.h"
#include "sim/setup/cli_app.h"
#include "sim/setup/help.h"
#include "sim/setup/model_messages.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/text_setup.h"
#include "sim/setup/text_trial.h"
#include "sim/setup/trial_parameters.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/record.h"
#include "sim/trial/trial.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr double kUsualHelp = 6;  ///< as FadeSettings::start

void AddOptions(CLI::App& app, GuideOptions& options) {
  AddValue(
      app, "--guide", "MODE",
      [&options](const std::string& given) {
        options.mode = GuidanceModeOf(given);
        if (!options.mode) throw UsageError(say::NotAChoice("--guide", given, kGuidanceModes));
      },
      say::help::kGuide);
  AddNumber(app, "--help-level", options.help, 0, kMostHelp, 1, say::help::kHelpLevel);
}

/// The push that was asked for, from the shipped table. Throws UsageError for a help level where
/// nothing guides.
TrialGuidance GuidanceOf(const GuideOptions& options) {
  if (options.help && !options.mode) throw UsageError(say::NeedsOther("--help-level", "--guide"));
  const GuidanceMode mode = options.mode.value_or(GuidanceMode::kOff);
  if (mode == GuidanceMode::kOff) return {};
  return GuidanceAt(mode, options.help.value_or(kUsualHelp));
}

/// A profile that a hand can feel a page on.
DeviceProfile PushingProfile(const std::string& name) {
  DeviceProfile profile = FindProfile(name, ProfilesFolder());
  if (!profile.limits.pushes.x || !profile.limits.pushes.y) {
    throw InputError(say::ProfilePushesNothing(name));
  }
  return profile;
}

TrialSetup SetupOf(const TraceOptions& options, const Trace& trace, std::size_t page,
                   Console& console) {
  TrialSetup setup = TrialOf(trace.text, page, options.feel, options.press, options.seed);
  setup.blank = options.blank;
  setup.plan.speed = options.speed.value_or(setup.plan.speed);
  setup.guidance = GuidanceOf(options.guide);
  setup.device = trace.device;
  if (!options.picture.empty()) setup.path_spacing = trace.text.set.style.width / 20;
  setup.stop = console.stop();
  const auto pages = static_cast<double>(trace.text.set.pages.size());
  setup.alive = [&console, page, pages](double done) {
    console.Alive((static_cast<double>(page) + done) / pages);
  };
  return setup;
}

/// The page's trial is seen while it runs.
void Watch(TrialSetup& setup, TrialView& view, const Trace& trace, std::size_t page) {
  const Typeset& set = trace.text.set;
  const std::string& text = trace.text.text;
  setup.field = std::make_shared<const TextureField>(
      PageField(*setup.page, *setup.script, setup.style, setup.blank));
  view.Begin(MakeViewPage(set, page, *setup.script, text, setup.field, setup.blank,
                          static_cast<std::uint32_t>(page)),
             {text, setup.style.size, say::PanelPage(page, set.pages.size()), {}});
  setup.watch = [&view](double time, const TickResult& felt, const GuidanceResult& push,
                        const Scene& scene) { view.Look(time, felt, push, scene); };
}

/// DIR as it is for a single page, otherwise DIR-1, DIR-2 ...
std::string RecordFolder(const TraceOptions& options, std::size_t page, std::size_t pages) {
  return pages == 1 ? options.record : options.record + "-" + std::to_string(page + 1);
}

/// Of all pages, before the first is traced.
void CheckRecords(const TraceOptions& options, std::size_t pages) {
  if (options.record.empty()) return;
  for (std::size_t page = 0; page < pages; ++page) {
    CheckRecordFolder(RecordFolder(options, page, pages));
  }
}

/// `view`, `pictures`: null without.
void TracePage(const TraceOptions& options, std::size_t page, TrialView* view,
               PagePictures* pictures, Console& console, Trace& trace) {
  const std::size_t pages = trace.text.set.pages.size();
  TrialSetup setup = SetupOf(options, trace, page, console);
  if (view != nullptr) Watch(setup, *view, trace, page);
  RecordRequest request;
  if (!options.record.empty()) {
    request.folder = RecordFolder(options, page, pages);
    request.also_csv = options.csv;
    request.parameters_json =
        ParametersJson({trace.text.text, trace.text.script_name, trace.text.set.style,
                        trace.text.set.page, page, options.blank},
                       setup);
  }
  TrialResult result = RunTrial(setup, options.record.empty() ? nullptr : &request);
  if (page == 0) {
    for (const std::string& remark : result.remarks) console.Remark(remark);
  }
  if (!options.record.empty()) trace.records.push_back(request.folder);
  if (pictures != nullptr) {
    pictures->Add(TracePicture(*setup.page, trace.text.script, setup.style, options.blank,
                               TextOf(trace.text, page), result));
    result.path.clear();
    result.path.shrink_to_fit();
  }
  trace.pages.push_back(std::move(result));
}

/// `--render direct` is done as asked, with a warning where the hand cannot hold it quiet.
void WarnOfDirect(const TraceOptions& options, const Trace& trace, Console& console) {
  if (options.feel.scene.rendering != Rendering::kDirect) return;
  const TextureField field = PageField(trace.text.set.pages.front(), trace.text.script,
                                       trace.text.set.style, options.blank);
  const TrialSetup setup = SetupOf(options, trace, 0, console);
  const auto buzz = BuzzOfDirect(setup.scene, field, setup.hand, setup.plan.press);
  if (buzz) console.Remark(say::DirectWillBuzz(*buzz));
}

}  // namespace

void AddOptions(CLI::App& app, TraceOptions& options) {
  AddOptions(app, options.text);
  AddOptions(app, options.style);
  AddOptions(app, options.layout);
  AddOptions(app, options.feel);
  BeginGroup(app, help_group::kHand);
  AddNumber(app, "--press-n", options.press, 0.01, 20, 1, say::help::kPress);
  AddNumber(app, "--speed-mm-s", options.speed, 0.1, 1000, 1e-3, say::help::kSpeed);
  AddOptions(app, options.guide);
  AddSeed(app, options.seed, &options.seed_given);
  AddPath(app, "--device-profile", "NAME", options.device_profile, say::help::kDeviceProfile);
  AddFlag(app, "--blank", options.blank, say::help::kBlank);
  BeginGroup(app, help_group::kResults);
  AddPath(app, "--record", "DIR", options.record, say::help::kRecord);
  AddFlag(app, "--csv", options.csv, say::help::kCsv);
  AddPicture(app, options.picture, say::help::kPicture);
  AddOptions(app, options.view);
  AddCamera(app, options.view);
  AddOptions(app, options.live);
  AddOptions(app, options.output);
}

namespace {

void RefuseDeviceOptions(const TraceOptions& options) {
  const std::pair<bool, const char*> given[] = {{options.live.seconds.has_value(), "--seconds"},
                                                {options.live.rate.has_value(), "--rate-hz"},
                                                {options.live.scale.has_value(), "--scale"},
                                                {options.live.hold_to_feel, "--hold-to-feel"}};
  for (const auto& option : given) {
    if (option.first) throw UsageError(say::OnlyWithDevice(option.second));
  }
}

}  // namespace

namespace {

struct Traced {
  Trace trace;
  TrialResult all;
};

/// A text on its pages, on one label where a model was named.
Traced TraceText(const TraceOptions& options, ViewFeed* feed, Console& console) {
  Traced traced;
  Trace& trace = traced.trace;
  trace.text =
      SetUpText({options.text, options.style, options.layout, options.feel, "trace"}, console);
  trace.blank = options.blank;
  trace.guidance = GuidanceOf(options.guide);
  if (!options.device_profile.empty()) trace.device = PushingProfile(options.device_profile);
  SayReplacements(trace.text.set, [&console](const std::string& line) { console.Remark(line); });
  CheckRecords(options, trace.text.set.pages.size());
  WarnOfDirect(options, trace, console);
  std::optional<TrialView> view;
  if (feed != nullptr) view.emplace(*feed, console);
  if (view && !options.feel.model.empty()) view->ShowModel(trace.text.others);
  std::optional<PagePictures> pictures;
  if (!options.picture.empty()) pictures.emplace(options.picture, trace.text.set.pages.size());
  for (std::size_t page = 0; page < trace.text.set.pages.size(); ++page) {
    TracePage(options, page, view ? &*view : nullptr, pictures ? &*pictures : nullptr, console,
              trace);
  }
  if (pictures) trace.pictures = pictures->Finish();
  const TypeStyle& style = trace.text.set.style;
  const bool ridges =
      style.relief == Relief::kEmbossed || (trace.text.set.structure.headings > 0 &&
                                            style.structure.heading_relief == Relief::kEmbossed);
  if (ridges && !options.blank) console.Remark(say::RidgesPushAside());
  traced.all = Merged(trace.pages);
  return traced;
}

Json JsonOf(const Traced& traced, const TraceOptions& options) {
  Json json = TraceJson(traced.trace, options.feel.scene, traced.all);
  json["seed"] = options.seed;
  if (!options.feel.label.empty()) json["label"] = options.feel.label;
  return json;
}

/// The same for one of several labels: pictures and records are told apart by its number.
TraceOptions OnOneLabel(const TraceOptions& options, const std::string& name, std::size_t number) {
  TraceOptions one = options;
  one.feel.label = name;
  ChooseLabel(one.feel);
  const std::string mark = "-label" + std::to_string(number + 1);
  if (!one.record.empty()) one.record += mark;
  const std::size_t dot = one.picture.rfind('.');
  if (!one.picture.empty()) one.picture.insert(std::min(dot, one.picture.size()), mark);
  return one;
}

/// One label after another; each is told by itself.
int TraceAllLabels(const TraceOptions& options, Console& console) {
  if (options.feel.model.empty()) throw UsageError(say::LabelNeedsModel());
  const std::unique_ptr<ViewFeed> feed = ViewFeed::OpenOfTrial(options.view, console);
  Json labels = Json::array();
  std::vector<TrialResult> results;
  for (const std::string& name : LabelNames(options.feel)) {
    const TraceOptions one = OnOneLabel(options, name, results.size());
    const Traced traced = TraceText(one, feed.get(), console);
    results.push_back(traced.all);
    if (options.output.json) {
      labels.push_back(JsonOf(traced, one));
    } else {
      console.Result(say::OfLabel(name, traced.trace.text.text));
      SayTrace(traced.trace, traced.all, say::Time(traced.all), console);
    }
  }
  if (results.empty()) throw InputError(say::NoLabelHasText(options.feel.model));
  const TrialResult all = Merged(results);
  if (options.output.json) {
    Json json = {{"labels", labels}};
    if (feed) json["view"] = ViewJson(*feed);
    console.Json(Dump(json));
  } else if (feed) {
    SayView(*feed, options.view, console);
  }
  if (all.faults > 0) throw WorkFailed(say::Faults(all));
  if (feed) RequireView(*feed, options.live.device);
  return exit_code::kGood;
}

/// A text on one label, or on the shipped page.
int TraceOneLabel(const TraceOptions& options, Console& console) {
  const std::unique_ptr<ViewFeed> feed = ViewFeed::OpenOfTrial(options.view, console);
  const Traced traced = TraceText(options, feed.get(), console);
  if (options.feel.scene.friction > 0.1) {
    console.Remark(say::FrictionHampers(options.feel.scene.friction));
  }
  const TrialResult& all = traced.all;
  if (options.output.json) {
    Json json = JsonOf(traced, options);
    if (feed) json["view"] = ViewJson(*feed);
    console.Json(Dump(json));
  } else {
    SayTrace(traced.trace, all, say::Time(all), console);
    if (feed) SayView(*feed, options.view, console);
    const bool kept = feed || !options.picture.empty() || !options.record.empty();
    if (!kept) console.Result(say::TraceNext());
  }
  if (all.faults > 0) throw WorkFailed(say::Faults(all));
  if (feed) RequireView(*feed, options.live.device);
  return exit_code::kGood;
}

}  // namespace

int Run(const TraceOptions& options, Console& console) {
  if (options.csv && options.record.empty()) {
    throw UsageError(say::NeedsOther("--csv", "--record"));
  }
  if (!options.picture.empty()) CheckPicturePath(options.picture);
  CheckCamera(options.view, options.feel.model);
  CheckTogether(options.view);
  const bool simulated = IsSimulated(options.live.device);
  if (simulated) {
    RefuseDeviceOptions(options);
    GuidanceOf(options.guide);  // refuses what does not go together, before any work
    if (options.feel.label == "all") return TraceAllLabels(options, console);
  }
  TraceOptions chosen = options;
  ChooseLabel(chosen.feel);
  return simulated ? TraceOneLabel(chosen, console) : TraceWithDevice(chosen, console);
}

}  // namespace moontrace

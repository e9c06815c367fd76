#include "sim/app/commands.h"

#include <nlohmann/json.hpp>

#include "sim/app/messages.h"
#include "sim/physics/page_field.h"
#include "sim/picture/picture_file.h"
#include "sim/session/loop_messages.h"
#include "sim/session/view_feed.h"
#include "sim/session/view_messages.h"
#include "sim/session/view_panels.h"
#include "sim/session/view_trial.h"
#include "sim/setup/help.h"
#include "sim/setup/text_trial.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
#include "textures/base/output_file.h"

namespace moontrace {

namespace {

constexpr double kMomentEvery = 0.004;  ///< of the tip's path in a picture [s]

void CheckPicture(const ViewCommandOptions& options) {
  if (!options.picture.ends_with(".png")) {
    throw UsageError(say::NotAPng("--picture", options.picture));
  }
  if (!options.view.frames.empty()) throw UsageError(say::OnlyInView("--picture"));
  if (!IsSimulated(options.live.device)) throw UsageError(say::PictureIsSimulated());
  const std::pair<bool, const char*> given[] = {{options.live.rate.has_value(), "--rate-hz"},
                                                {options.live.scale.has_value(), "--scale"},
                                                {options.live.hold_to_feel, "--hold-to-feel"}};
  for (const auto& option : given) {
    if (option.first) throw UsageError(say::OnlyWithDevice(option.second));
  }
  CheckPicturePath(options.picture);
}

/// What the simulated stylus does on the first page within `seconds`, in its own time.
std::vector<ViewMoment> Traced(const ViewCommandOptions& options, const TextSetup& text,
                               double seconds, Console& console) {
  TrialSetup setup = TrialOf(text, 0, options.feel, options.press, options.seed);
  setup.stop = console.stop();
  setup.longest = seconds;
  std::vector<ViewMoment> moments;
  double next = 0;
  setup.watch = [&](double time, const TickResult& felt, const GuidanceResult& push) {
    if (time < next - 0.5 * setup.scene.tick) return;  // times are rounded
    next += kMomentEvery;
    moments.push_back(MomentOf(time, felt, push));
  };
  RunTrial(setup);
  return moments;
}

int DrawPicture(const ViewCommandOptions& given, Console& console) {
  ViewCommandOptions options = given;
  CheckPicture(options);
  ChooseLabel(options.feel);
  const TextSetup text = SetUpText(
      {options.text, options.style, options.layout, options.feel, "view", say::help::kDefaultText},
      console);
  SayReplacements(text.set, [&console](const std::string& line) { console.Remark(line); });
  std::vector<ViewMoment> moments;
  if (options.live.seconds) moments = Traced(options, text, *options.live.seconds, console);
  ViewerOptions look;
  look.high_contrast = options.view.contrast;
  look.large_text = options.view.large_text;
  const bool touching = !moments.empty() && moments.back().in_contact;
  auto field = std::make_shared<const TextureField>(
      PageField(text.set.pages.front(), text.script, text.set.style, false));
  const auto page = MakeViewPage(text.set, 0, text.script, text.text, std::move(field), false, 0);
  WriteViewPicture(options.picture, look, page, moments, LoopPanel(),
                   LoopPanelValues(text, {}, options.feel.scene.tilt, 0,
                                   moments.empty() ? "" : say::PanelState(false, touching)));
  if (options.output.json) {
    Json json = TypesetJson(text.set, text.script);
    json["picture"] = options.picture;
    json["moments"] = moments.size();
    console.Json(Dump(json));
    return exit_code::kGood;
  }
  console.Result(say::ViewPictureIn());
  console.Path(options.picture);
  return exit_code::kGood;
}

}  // namespace

void AddOptions(CLI::App& app, ViewCommandOptions& options) {
  AddLoopOptions(app, options);
  options.layout.centred = true;
  Redescribe(app, "--device", say::help::kViewDevice);
  BeginGroup(app, help_group::kView);
  AddPath(app, "--picture", "F.png", options.picture, say::help::kViewPicture);
  AddLookOptions(app, options.view);
}

int Run(const ViewCommandOptions& given, Console& console) {
  if (!given.picture.empty()) return DrawPicture(given, console);
  LoopCommandOptions options = given;
  options.view.window = options.view.frames.empty();
  auto aims = AimsFor(options.live.device, options.view);
  std::unique_ptr<ViewFeed> view;
  if (options.live.device.empty() && options.view.window) {
    aims = std::make_shared<Mailbox<StylusAim>>();
    try {
      view = ViewFeed::Open(options.view, aims, console);
      options.live.device = "mouse";
    } catch (const LackError& error) {
      aims.reset();
      console.Remark(say::ViewSays(error.what()));
    }
  } else {
    view = ViewFeed::Open(options.view, aims, console);
  }
  return RunLoop(options, view.get(), aims, console);
}

}  // namespace moontrace

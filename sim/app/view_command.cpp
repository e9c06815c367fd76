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

/// What a picture shows.
struct Shot {
  std::vector<ViewMoment> moments;
  std::shared_ptr<const ViewModel> model;  ///< null: none was named
};

/// What the simulated stylus does on the first page within `seconds`, in its own time.
Shot Traced(const ViewCommandOptions& options, const TextSetup& text, double seconds,
            Console& console) {
  TrialSetup setup = TrialOf(text, 0, options.feel, options.press, options.seed);
  setup.stop = console.stop();
  setup.longest = seconds;
  Shot shot;
  ScenePose pose;  // the last counts
  double next = 0;
  setup.watch = [&](double time, const TickResult& felt, const GuidanceResult& push,
                    const Scene& scene) {
    if (time < next - 0.5 * setup.scene.tick) return;  // times are rounded
    next += kMomentEvery;
    shot.moments.push_back(MomentOf(time, felt, push));
    if (options.feel.model.empty()) return;
    if (shot.model == nullptr) shot.model = MakeViewModel(scene, text.others, text.text);
    TakePose(scene, pose);
  };
  RunTrial(setup);
  if (shot.model != nullptr) {
    shot.moments.back().pose = std::make_shared<const ScenePose>(std::move(pose));
  }
  return shot;
}

/// As a model stands by itself.
Shot AtRest(const ViewCommandOptions& options, const TextSetup& text, const TextureField& field) {
  const std::string& model = options.feel.model;
  if (model.empty()) return {};
  Scene scene = Scene::Load(model, OnLabel(text, 0, options.feel.scene));
  scene.SetField(&field);
  for (const LaidLabel& other : text.others) scene.SetLabel(other);
  return {{}, MakeViewModel(scene, text.others, text.text)};
}

int DrawPicture(const ViewCommandOptions& given, Console& console) {
  ViewCommandOptions options = given;
  CheckPicture(options);
  ChooseLabel(options.feel);
  const TextSetup text = SetUpText(
      {options.text, options.style, options.layout, options.feel, "view", say::help::kDefaultText},
      console);
  SayReplacements(text.set, [&console](const std::string& line) { console.Remark(line); });
  auto field = std::make_shared<const TextureField>(
      PageField(text.set.pages.front(), text.script, text.set.style, false));
  const Shot shot = options.live.seconds ? Traced(options, text, *options.live.seconds, console)
                                         : AtRest(options, text, *field);
  const ViewerOptions look = ViewerOf(options.view);
  const bool touching = !shot.moments.empty() && shot.moments.back().in_contact;
  const auto page = MakeViewPage(text.set, 0, text.script, text.text, std::move(field), false, 0);
  // of a model that rests nothing is to be changed
  const bool panel = shot.model == nullptr || !shot.moments.empty();
  const auto values = LoopPanelValues(text, {}, options.feel.scene.tilt, 0,
                                      shot.moments.empty() ? "" : say::PanelState(false, touching));
  const std::vector<std::string> seen = WriteViewPicture(
      options.picture, look, page, shot.moments, panel ? LoopPanel() : std::vector<PanelControl>(),
      panel ? values : std::vector<PanelValue>(), shot.model);
  if (options.output.json) {
    Json json = TypesetJson(text.set, text.script);
    json["picture"] = options.picture;
    json["moments"] = shot.moments.size();
    if (!seen.empty()) json["seen"] = seen;
    console.Json(Dump(json));
    return exit_code::kGood;
  }
  console.Result(say::ViewPictureIn());
  console.Path(options.picture);
  for (const std::string& sentence : seen) console.Result(sentence);
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
  Redescribe(app, "--width-px", say::help::kViewPictureWidth);
  AddCamera(app, options.view);
}

int Run(const ViewCommandOptions& given, Console& console) {
  CheckCamera(given.view, given.feel.model);
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

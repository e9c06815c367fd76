#include "sim/trial/trial.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>

#include "devices/hand/simulated_stylus.h"
#include "lessons/guide/guidance_path.h"
#include "lessons/measure/link_meter.h"
#include "sim/physics/coupling.h"
#include "sim/physics/scene.h"
#include "sim/trial/hand_on_device.h"
#include "sim/trial/metrics_json.h"
#include "sim/trial/record.h"
#include "textures/base/resources.h"

namespace moontrace {

namespace {

/// What the hand is doing at a time, walking forward through the plan's spans.
class PhaseClock {
 public:
  explicit PhaseClock(const std::vector<Plan::Span>& spans) : spans_(spans) {}
  const Plan::Span& At(double time) {
    while (next_ + 1 < spans_.size() && time >= spans_[next_].end) ++next_;
    return spans_[next_];
  }

 private:
  const std::vector<Plan::Span>& spans_;
  std::size_t next_ = 0;
};

/// Keeps the tip's path at a spacing, and every change of phase or contact.
void Keep(std::vector<PathPoint>& path, const PathPoint& point, double spacing) {
  if (spacing <= 0) return;
  if (!path.empty()) {
    const PathPoint& last = path.back();
    const bool same = last.phase == point.phase && last.in_contact == point.in_contact;
    if (same && glm::distance(last.tip_P, point.tip_P) < spacing) return;
  }
  path.push_back(point);
}

std::unique_ptr<Recorder> StartRecorder(const RecordRequest* request, const TrialSetup& setup,
                                        const TextureField& field, const Scene& scene) {
  if (request == nullptr) return nullptr;
  RecordHead head;
  head.parameters_json = request->parameters_json;
  head.field_hash = field.Hash();
  head.seed = setup.seed;
  return std::make_unique<Recorder>(request->folder, head, scene);
}

/// A tip that is higher above the paper has lifted: no less than the hand's tremor.
constexpr double kLifted = 1e-4;  // [m]

/// Counts how often the tip leaves the page and comes back to it within one line of text: neither
/// in contact nor in a groove or a hair above it.
class LiftCounter {
 public:
  LiftCounter(const std::vector<IntendedStroke>& strokes, const TextPage& page) {
    for (const IntendedStroke& stroke : strokes) lines_.push_back(page.glyphs[stroke.glyph].line);
  }
  void Add(const Plan::Span& span, bool on_page) {
    if (on_page && span.phase != TracePhase::kAir) {
      const std::size_t line = lines_[span.stroke];
      if (!touching_ && touched_ && line == line_) ++lifts_;
      touched_ = true;
      line_ = line;
    }
    touching_ = on_page;
  }
  std::size_t lifts() const { return lifts_; }

 private:
  std::vector<std::size_t> lines_;  // by stroke
  bool touching_ = false, touched_ = false;
  std::size_t line_ = 0, lifts_ = 0;
};

/// The push of a trial, and how much it did.
class TrialPush {
 public:
  TrialPush(const TrialSetup& setup, const std::vector<IntendedStroke>& strokes) {
    if (setup.guidance.on()) push_.emplace(PlanOf(setup.guidance, strokes), setup.scene.tick);
  }
  GuidanceResult Add(const Scene& scene, TickResult& output) {
    ++ticks_;
    if (!push_) return {};
    // the force of the last tick stood while the tip came here
    work_ += glm::dot(force_P_, output.tip_P - tip_P_);
    const GuidanceResult push = push_->Add(scene.X_WP(), output);
    force_P_ = push.force_P;
    tip_P_ = output.tip_P;
    sum_ += glm::length(force_P_);
    return push;
  }
  void Report(TrialResult& result) const {
    result.mean_guidance = ticks_ > 0 ? sum_ / static_cast<double>(ticks_) : 0;
    result.guidance_work = work_;
  }

 private:
  std::optional<ScenePush> push_;
  glm::dvec3 force_P_{0, 0, 0}, tip_P_{0, 0, 0};
  std::size_t ticks_ = 0;
  double sum_ = 0, work_ = 0;  ///< [N], [J]
};

/// MuJoCo runs in `work`.
void Around(const TrialSetup& setup, const std::function<void()>& work) {
  setup.around ? setup.around(work) : work();
}

/// The loop: device, scene, push, device, score. Everything it needs exists before it starts.
void RunTicks(const TrialSetup& setup, const Plan& plan, Scene& scene, const TextureField& field,
              HandOnDevice& hand, TraceScorer& scorer, LinkMeter& links, LiftCounter lifts,
              TrialPush push, Recorder* recorder, TrialResult& result) {
  PhaseClock clock(plan.spans);
  const double duration = std::min(plan.duration, setup.longest);
  const auto ticks = static_cast<std::size_t>(std::ceil(duration / setup.scene.tick));
  bool through = false;
  const auto ticks_a_second = static_cast<std::size_t>(std::max(1.0, 1.0 / setup.scene.tick));
  TickResult output;
  std::size_t n = 0;
  for (; n < ticks && !hand.let_go(); ++n) {
    if (setup.stop != nullptr && setup.stop->load(std::memory_order_relaxed)) throw Interrupted();
    const DeviceState input = hand.Read(scene, n > 0 ? &output : nullptr, field);
    Around(setup, [&] { output = scene.Tick(input); });
    const GuidanceResult pushed = push.Add(scene, output);
    if (setup.watch) setup.watch(input.time, output, pushed, scene);
    hand.Write(output.force_W, output.stored);

    const Plan::Span& span = clock.At(input.time);
    TraceSample sample;
    sample.time = input.time;
    sample.tip_P = output.tip_P;
    sample.force_P =
        setup.device ? TurnFromWorld(scene.X_WP(), hand.Given(output.force_W)) : output.force_P;
    sample.in_contact = output.depth > 0;
    sample.phase = span.phase;
    sample.stroke = span.stroke;
    scorer.Add(sample);
    links.Add(sample);
    lifts.Add(span, sample.in_contact || (output.tip_P.z < kLifted && !output.through));
    Keep(result.path, {output.tip_P, span.phase, sample.in_contact}, setup.path_spacing);
    result.energy_out = std::max(result.energy_out, output.energy_out);
    if (output.fault) ++result.faults;
    if (output.held) ++result.held;
    if (output.through && !through) {
      if (result.through == 0) result.first_through = input.time;
      ++result.through;
    }
    through = output.through;
    if (recorder != nullptr) {
      const bool air = span.phase == TracePhase::kAir;
      recorder->Add({input, output, static_cast<double>(span.phase),
                     air ? -1.0 : static_cast<double>(span.stroke)});
    }
    if (setup.alive && n % ticks_a_second == 0) {
      setup.alive(static_cast<double>(n) / static_cast<double>(ticks));
    }
  }
  push.Report(result);
  if (setup.device && !setup.guidance.on()) result.true_energy_out = hand.energy_out();
  result.lifts_within_lines = lifts.lifts();
  result.ticks = n;
  result.duration = static_cast<double>(n) * setup.scene.tick;
  if (hand.let_go()) result.page_gone = result.duration;
}

}  // namespace

HandModel ShippedHand() { return LoadHand(ResourcePath("devices/hand.toml")); }

TrialGuidance GuidanceAt(GuidanceMode mode, double help) {
  TrialGuidance guidance;
  guidance.mode = mode;
  guidance.help = help;
  guidance.gains = GuidanceTable::Shipped().GainsOf(mode, help);
  return guidance;
}

GuidancePlan PlanOf(const TrialGuidance& guidance, const std::vector<IntendedStroke>& strokes) {
  return {guidance.mode, guidance.gains, MakeGuidancePath(strokes)};
}

TrialResult RunTrial(const TrialSetup& setup, const RecordRequest* record) {
  TrialSetup with_field = setup;
  if (setup.field == nullptr) {
    with_field.field = std::make_shared<const TextureField>(
        PageField(*setup.page, *setup.script, setup.style, setup.blank));
  }
  Scene scene = Scene::Load(setup.model_path, setup.scene);
  if (setup.device) scene.SetOptions(HeldOn(*setup.device, setup.scene, scene.proxy_mass()));
  return RunTrial(with_field, scene, record);
}

TrialResult RunTrial(const TrialSetup& setup, Scene& scene, const RecordRequest* record) {
  const TextureField& field = *setup.field;
  scene.SetField(&field);
  for (const LaidLabel& other : setup.others) scene.SetLabel(other);
  const std::vector<IntendedStroke> strokes =
      IntendedStrokes(*setup.page, *setup.script, setup.style);
  // a hand follows what hangs on a joint, not what falls
  const bool on_page = !scene.page_is_flat() || (scene.page_goes() && !scene.page_falls());
  const Pose X_WP = on_page ? Pose() : scene.X_WP();
  const auto links = LinksOf(*setup.page, *setup.script, setup.style);
  const Plan plan = MakePlan(strokes, WalksOf(strokes, *setup.page, *links), setup.plan, X_WP);
  HandOnDevice::Setup on_device{setup.hand, plan.path_W, setup.scene.tick, setup.seed};
  if (setup.device) on_device.profile = &*setup.device;
  on_device.press = setup.plan.press;
  on_device.on_page = on_page;
  HandOnDevice hand(on_device, X_WP);
  if (!plan.path_W.points.empty()) {
    Around(setup, [&] { scene.Reset(FromWorld(X_WP, plan.path_W.points.front().p_D)); });
  }

  TrialResult result;
  for (const IntendedStroke& stroke : strokes) result.stroke_length += LengthOf(stroke);
  result.lines = setup.page->lines;
  result.remarks = scene.remarks();
  result.force_bound = scene.force_bound();
  if (!scene.page_moves()) {
    result.force_per_acceleration = scene.force_bound({.acceleration = 1}) - result.force_bound;
  }
  result.carried_press = scene.carried_press();
  TraceScorer scorer(strokes, setup.page->glyphs.size());
  const std::unique_ptr<Recorder> recorder = StartRecorder(record, setup, field, scene);
  const auto start = std::chrono::steady_clock::now();
  LinkMeter link_meter(strokes, *links);
  RunTicks(setup, plan, scene, field, hand, scorer, link_meter, LiftCounter(strokes, *setup.page),
           TrialPush(setup, strokes), recorder.get(), result);
  result.score = scorer.Finish();
  if (setup.style.links.reach != LinkReach::kNone) result.links_left = link_meter.left();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.real_time_factor = result.duration / std::max(elapsed.count(), 1e-9);
  if (recorder != nullptr) {
    for (const Excursion& left : result.score.left_at) {
      recorder->AddEvent(left.time, "excursion", "stroke " + std::to_string(left.stroke));
    }
    recorder->Finish(ResultText(result), record->also_csv);
  }
  return result;
}

DirectBound BoundOfDirect(const TextureField& field, const Surface& surface, double press,
                          const DeviceLimits& limits, double tick) {
  const double s = field.greatest_slope();
  DirectBound bound;
  bound.felt = surface.stiffness * s * s + press * field.greatest_curvature();
  const double acts_after = tick * (1.0 + 2.0 * limits.late_ticks);
  bound.held = 2.0 * limits.damping / acts_after;
  return bound;
}

std::optional<DirectBound> BuzzOfDirect(const SceneOptions& scene, const TextureField& field,
                                        const HandModel& hand, double press) {
  if (scene.rendering != Rendering::kDirect) return std::nullopt;
  const DeviceLimits limits =
      MakeSimulatedStylus(hand, {{HandPoint{}}}, scene.tick, /*seed=*/0)->Limits();
  const DirectBound bound = BoundOfDirect(field, scene.surface, press, limits, scene.tick);
  return bound.Holds() ? std::nullopt : std::optional(bound);
}

}  // namespace moontrace

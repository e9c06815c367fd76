#include "sim/study/simulated_learner.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lessons/measure/trial_meter.h"
#include "sim/reader/line_explorer.h"
#include "sim/reading/reading_setup.h"
#include "sim/trial/plan.h"
#include "textures/base/random.h"

namespace moontrace {
namespace {

/// Reads a plan at ascending times.
class PlanClock {
 public:
  explicit PlanClock(const Plan& plan) : plan_(plan) {}
  void To(double time) {
    const auto& points = plan_.path_W.points;
    while (next_ + 1 < points.size() && points[next_].time <= time) ++next_;
    while (span_ + 1 < plan_.spans.size() && time >= plan_.spans[span_].end) ++span_;
    const HandPoint& a = points[next_ > 0 ? next_ - 1 : 0];
    const HandPoint& b = points[next_];
    const double share = b.time > a.time ? (time - a.time) / (b.time - a.time) : 1;
    p_W_ = a.p_D + std::clamp(share, 0.0, 1.0) * (b.p_D - a.p_D);
    travel_W_ = b.p_D - a.p_D;
  }
  const Plan::Span& span() const { return plan_.spans[span_]; }
  glm::dvec3 p_W() const { return p_W_; }
  glm::dvec3 travel_W() const { return travel_W_; }  ///< direction of travel, zero at rest

 private:
  const Plan& plan_;
  std::size_t next_ = 0, span_ = 0;
  glm::dvec3 p_W_{0, 0, 0}, travel_W_{0, 0, 0};
};

/// How much of an error of aim the tip followed: 1 where it followed all of it. Only what lies
/// across the path counts, since a hand lags along it.
class FeltError {
 public:
  void Add(glm::dvec2 off, glm::dvec2 error, glm::dvec2 travel) {
    const double length = glm::length(travel);
    if (length > 1e-9) {
      const glm::dvec2 across(-travel.y / length, travel.x / length);
      along_ += glm::dot(off, across) * glm::dot(error, across);
      whole_ += glm::dot(error, across) * glm::dot(error, across);
    } else {
      along_ += glm::dot(off, error);
      whole_ += glm::dot(error, error);
    }
  }
  double Share() const { return whole_ > 0 ? along_ / whole_ : 0; }

 private:
  double along_ = 0, whole_ = 0;
};

}  // namespace

/// The error of aim over one page.
struct SimulatedLearner::Aim {
  AimError general, own, restless;
  double general_share = 0;
  glm::dvec2 middle_P{0, 0};
  double reach = 1;      ///< of the box [m]
  double amplitude = 0;  ///< of a beginner [m]

  glm::dvec2 Beginner(glm::dvec2 p_P) const {
    const glm::dvec2 u = (p_P - middle_P) / reach;
    return amplitude * (general_share * general.At(u) + (1 - general_share) * own.At(u));
  }
  glm::dvec2 Restless(glm::dvec2 p_P) const {
    return amplitude * restless.At((p_P - middle_P) / reach);
  }
};

SimulatedLearner::SimulatedLearner(const LearnerModel& model, const HandModel& hand,
                                   std::uint64_t seed, const DeviceProfile* device)
    : model_(model),
      hand_(hand, SceneOptions{}, device),
      stiffness_(hand.stiffness),
      shapes_(model.recognition),
      seed_(seed) {}

const TwoRateMemory* SimulatedLearner::Find(const std::string& item) const {
  const auto memory = by_item_.find(item);
  return memory == by_item_.end() ? nullptr : &memory->second;
}

double SimulatedLearner::AimErrorShare(const std::string& item, bool guided) const {
  const TwoRateMemory* own = Find(item);
  const double general = general_.total(), special = own == nullptr ? 0 : own->total();
  const double share = model_.tracing.general_share;
  const double learnt = share * general + (1 - share) * special;
  return 1 - (guided ? 1 : 1 - model_.tracing.dependence) * learnt;
}

TracedItem SimulatedLearner::Trace(const std::string& item, const ItemPage& page,
                                   const GuidancePlan* push) {
  const TracingSkill& skill = model_.tracing;
  const std::uint64_t seed = SeedOf(seed_, "work" + std::to_string(++works_));
  Aim aim{AimError(seed_, "general"), AimError(seed_, "item " + item), AimError(seed, "restless")};
  aim.general_share = skill.general_share;
  aim.middle_P = (page.box_P.min + page.box_P.max) / 2.0;
  aim.reach = std::max(page.box_P.max.x - page.box_P.min.x, page.box_P.max.y - page.box_P.min.y);
  aim.amplitude = std::min(skill.deviation, skill.deviation_share * page.style.size);

  PlanOptions options;
  options.speed = skill.speed;
  options.press = skill.press;
  const Pose X_WP = hand_.X_WP();
  const Plan plan = MakeOraclePlan(page.strokes, options, X_WP);
  const double share = AimErrorShare(item, push != nullptr);
  FeltHand::Work work{&page.field, plan.path_W, push, seed};
  for (HandPoint& point : work.path.points) {
    const glm::dvec2 p_P(FromWorld(X_WP, point.p_D));
    const glm::dvec2 off = share * aim.Beginner(p_P) + skill.restless_share * aim.Restless(p_P);
    point.p_D += TurnToWorld(X_WP, {off, 0});
  }

  TrialMeter meter(page.strokes, page.page.glyphs.size(), hand_.tick());
  PlanClock clock(plan);
  FeltError felt;
  hand_.Do(work, [&](const HandTick& now) {
    clock.To(now.time);
    const Plan::Span& span = clock.span();
    meter.Add({now.time, now.tip_P, now.force_P, now.in_contact, span.phase, span.stroke},
              now.guidance_P);
    if (span.phase != TracePhase::kStroke) return;
    const glm::dvec2 p_P(FromWorld(X_WP, clock.p_W()));
    // The force of a flank that the tip leans on shows the error as well; a push from elsewhere
    // hides it.
    const glm::dvec2 flank(now.force_P - now.guidance_P);
    const glm::dvec2 off = glm::dvec2(now.tip_P) - p_P - skill.flank_share / stiffness_ * flank;
    felt.Add(off, aim.Beginner(p_P), glm::dvec2(TurnFromWorld(X_WP, clock.travel_W())));
  });
  TracedItem result;
  meter.Fill(result.measured);
  const bool blank = !(page.field.greatest_displacement() > 0);
  result.felt_error = blank ? 0 : felt.Share();
  Learn(item, result.felt_error);
  return result;
}

void SimulatedLearner::Learn(const std::string& item, double felt_error) {
  for (int i = 0; i < model_.tracing.lessons_a_trial; ++i) {
    general_ = AfterTrial(model_.memory, general_, felt_error);
    TwoRateMemory& own = by_item_[item];
    own = AfterTrial(model_.memory, own, felt_error);
  }
}

void SimulatedLearner::Relive(const std::string& item, double felt_error) {
  ++works_;
  Learn(item, felt_error);
}

FeltShape SimulatedLearner::Feel(const ItemPage& page) {
  constexpr double kLongest = 600;   // of one exploration [s]
  constexpr std::size_t kEvery = 3;  // ticks
  const Exploration& how = model_.exploration;
  Random random(SeedOf(seed_, "work" + std::to_string(++works_)));
  LedHandSetup setup;
  setup.field = &page.field;
  setup.hand = hand_.model();
  setup.hand.press = how.press;
  setup.device = hand_.device();
  setup.senses.unsure = how.unsure;
  setup.hand_seed = random.Bits();
  const double size = page.style.size;
  const double right = 2 * random.Uniform() - 1, up = 2 * random.Uniform() - 1;
  setup.start_P =
      glm::dvec2(page.box_P.min.x, page.box_P.max.y) + how.put_share * size * glm::dvec2(right, up);
  setup.knowledge = ToldOf(setup, page.style);
  setup.knowledge.space = page.space;
  LedHand hand(setup);

  LineExploration line;
  line.size = size;
  line.height = page.box_P.max.y - page.box_P.min.y;
  line.margin = how.margin_share * size;
  line.spacing = how.spacing_share * size;
  line.speed = how.speed * std::pow(size / how.at_size, how.speed_power);
  LineExplorer explorer(hand.knowledge(), line, hand.tick());
  FeltLine felt;
  const auto most = static_cast<std::size_t>(kLongest / hand.tick());
  std::size_t n = 0;
  for (; n < most && !explorer.done(); ++n) {
    hand.Lead(explorer.Step(hand.Feel()));
    if (n % kEvery == 0 && explorer.feels()) {
      felt.samples.push_back({explorer.place(), explorer.depth()});
    }
  }
  explored_ += static_cast<double>(n) * hand.tick();
  felt.bottom = explorer.bottom();
  felt.top = explorer.top();
  return ShapeOf(felt, model_.feeling);
}

void SimulatedLearner::Wait(double days) {
  day_ += days;
  general_ = AfterDays(model_.memory, general_, days);
  for (auto& item : by_item_) item.second = AfterDays(model_.memory, item.second, days);
}

}  // namespace moontrace

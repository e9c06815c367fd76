#include "sim/study/exploration.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace moontrace {
namespace {

constexpr double kDown = 0.15;    // coming down and lifting [s]
constexpr double kSettle = 0.05;  // with the press on [s]
constexpr double kStep = 0.005;   // between points [s]

class Sweeper {
 public:
  Sweeper(const Pose& X_WP, double speed, const Exploration& how, glm::dvec3 begin_P)
      : X_WP_(X_WP), speed_(speed), how_(how), p_P_(begin_P) {
    path_.press_direction_D = TurnToWorld(X_WP, {0, 0, -1});
    Add(0);
  }
  void Wait(double duration, double press) {
    time_ += duration;
    Add(press);
  }
  void Straight(glm::dvec3 to_P, double duration) {
    p_P_ = to_P;
    Wait(duration, 0);
  }
  /// From rest to rest. A tip that turns at once would be pulled aside by its own mass, as by a
  /// flank.
  void SweepTo(glm::dvec2 to_P) {
    const glm::dvec2 from_P(p_P_);
    const double length = glm::distance(from_P, to_P);
    if (!(length > 0)) return;
    const double a = how_.acceleration;
    const double v = std::min(speed_, std::sqrt(a * length));
    const double rise = v / a, duration = length / v + rise;
    const double begin = time_;
    const int count = static_cast<int>(std::ceil(duration / kStep));
    for (int i = 1; i <= count; ++i) {
      const double t = duration * i / count, left = duration - t;
      const double s = t < rise      ? a * t * t / 2
                       : left < rise ? length - a * left * left / 2
                                     : v * (t - rise / 2);
      time_ = begin + t;
      p_P_ = {i == count ? to_P : from_P + s / length * (to_P - from_P), 0};
      Add(how_.press);
    }
  }
  HandPath Finish() { return std::move(path_); }
  glm::dvec3 p_P() const { return p_P_; }

 private:
  void Add(double press) { path_.points.push_back({time_, ToWorld(X_WP_, p_P_), press}); }

  Pose X_WP_;
  double speed_;
  Exploration how_;
  HandPath path_;
  glm::dvec3 p_P_;
  double time_ = 0;
};

}  // namespace

HandPath ExplorationPath(const Box& box_P, double size, const Exploration& how, const Pose& X_WP) {
  const double speed = how.speed * std::pow(size / how.at_size, how.speed_power);
  const double spacing = how.spacing_share * size;
  const glm::dvec2 low = box_P.min, high = box_P.max;
  Sweeper sweeper(X_WP, speed, how, {low, how.height});
  sweeper.Straight({low, 0}, kDown);
  sweeper.Wait(kSettle, how.press);
  const int columns = std::max(2, static_cast<int>(std::ceil((high.x - low.x) / spacing)));
  const int rows = std::max(2, static_cast<int>(std::ceil((high.y - low.y) / spacing)));
  bool up = true;
  for (int i = 0; i <= columns; ++i, up = !up) {
    const double x = low.x + (high.x - low.x) * i / columns;
    sweeper.SweepTo({x, sweeper.p_P().y});
    sweeper.SweepTo({x, up ? high.y : low.y});
  }
  const double from = sweeper.p_P().y, to = low.y + high.y - from;
  bool left = true;
  for (int i = 0; i <= rows; ++i, left = !left) {
    const double y = from + (to - from) * i / rows;
    sweeper.SweepTo({sweeper.p_P().x, y});
    sweeper.SweepTo({left ? low.x : high.x, y});
  }
  sweeper.Wait(kStep, 0);
  sweeper.Straight({glm::dvec2(sweeper.p_P()), how.height}, kDown);
  return sweeper.Finish();
}

}  // namespace moontrace

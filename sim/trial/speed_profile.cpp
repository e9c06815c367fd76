#include "sim/trial/speed_profile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "textures/base/overload.h"

namespace moontrace {
namespace {

constexpr double kAcceleration = 0.3;  // [m/s^2]
constexpr double kNodeSpacing = 5e-5;  // [m]
constexpr double kFineStep = 1e-3;     // of the averaging [s]
constexpr std::size_t kWindow = 60;    // fine steps

/// Speed and time at evenly spaced places along a run.
struct Nodes {
  double spacing = 0;         ///< [m]
  std::vector<double> speed;  ///< [m/s]
};

/// The greatest speed at each node by piece and curvature, the lower one at joints.
std::vector<double> SpeedLimits(const std::vector<Piece>& run, double speed, double spacing,
                                std::size_t count) {
  std::vector<double> limits(count, speed);
  double begin = 0;
  for (const Piece& piece : run) {
    const double end = begin + Length(piece);
    const auto slow_down = [&](const Arc& arc) {
      const double limit = std::min(speed, std::sqrt(kAcceleration * arc.radius));
      const auto first = static_cast<std::size_t>(std::floor(begin / spacing));
      const auto last = static_cast<std::size_t>(std::ceil(end / spacing));
      for (std::size_t i = first; i <= std::min(last, count - 1); ++i) {
        limits[i] = std::min(limits[i], limit);
      }
    };
    std::visit(Overload{[](const Line&) {}, slow_down}, piece);
    begin = end;
  }
  return limits;
}

/// The fastest motion within the limits that starts and ends at rest.
Nodes FastestWithin(const std::vector<Piece>& run, double length, double speed) {
  const auto pieces = static_cast<std::size_t>(std::ceil(length / kNodeSpacing));
  const std::size_t count = std::max<std::size_t>(pieces, 2) + 1;
  Nodes nodes;
  nodes.spacing = length / static_cast<double>(count - 1);
  nodes.speed = SpeedLimits(run, speed, nodes.spacing, count);
  nodes.speed.front() = nodes.speed.back() = 0;
  const double gain = 2 * kAcceleration * nodes.spacing;
  const auto reach = [&](double& to, double from) {
    to = std::min(to, std::sqrt(from * from + gain));
  };
  for (std::size_t i = 1; i < count; ++i) reach(nodes.speed[i], nodes.speed[i - 1]);
  for (std::size_t i = count - 1; i > 0; --i) reach(nodes.speed[i - 1], nodes.speed[i]);
  return nodes;
}

/// Arc length at every fine step until the end is reached.
std::vector<double> Timed(const Nodes& nodes) {
  std::vector<double> arc_lengths;
  double time = 0;  // at the node
  for (std::size_t i = 0; i + 1 < nodes.speed.size(); ++i) {
    const double v = nodes.speed[i], mean = (v + nodes.speed[i + 1]) / 2;
    const double duration = nodes.spacing / mean;
    const double acceleration = (nodes.speed[i + 1] - v) / duration;
    for (double t = static_cast<double>(arc_lengths.size()) * kFineStep; t < time + duration;
         t = static_cast<double>(arc_lengths.size()) * kFineStep) {
      const double since = t - time;
      arc_lengths.push_back(nodes.spacing * static_cast<double>(i) +
                            since * (v + acceleration * since / 2));
    }
    time += duration;
  }
  return arc_lengths;
}

}  // namespace

std::vector<double> TimeRun(const std::vector<Piece>& run, double speed, double step) {
  const double length = Length(run);
  if (!(length > 0)) return {0.0};
  const std::vector<double> arc_lengths = Timed(FastestWithin(run, length, speed));
  // The mean over the window up to each step: at rest before the first, at the end after the last.
  const std::size_t stride = static_cast<std::size_t>(std::max(1L, std::lround(step / kFineStep)));
  std::vector<double> reached;
  double sum = 0;
  for (std::size_t i = 0; i < arc_lengths.size() + kWindow; ++i) {
    if (i % stride == 0) reached.push_back(sum / kWindow);
    sum += i < arc_lengths.size() ? arc_lengths[i] : length;
    if (i >= kWindow) sum -= i - kWindow < arc_lengths.size() ? arc_lengths[i - kWindow] : length;
  }
  reached.front() = 0;
  reached.push_back(length);
  return reached;
}

}  // namespace moontrace

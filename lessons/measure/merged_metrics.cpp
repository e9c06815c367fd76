#include "lessons/measure/merged_metrics.h"

#include <algorithm>
#include <cmath>

namespace moontrace {
namespace {

void AddGreatest(TraceMetrics& all, const TraceMetrics& page) {
  for (double TraceMetrics::*field :
       {&TraceMetrics::max_error, &TraceMetrics::peak_force, &TraceMetrics::peak_normal_force,
        &TraceMetrics::entry_error}) {
    all.*field = std::max(all.*field, page.*field);
  }
  all.shape.frechet = std::max(all.shape.frechet, page.shape.frechet);
  all.shape.hausdorff = std::max(all.shape.hausdorff, page.shape.hausdorff);
}

void AddSums(TraceMetrics& all, const TraceMetrics& page) {
  for (std::size_t TraceMetrics::*field : {&TraceMetrics::excursions, &TraceMetrics::entries,
                                           &TraceMetrics::lifts, &TraceMetrics::pauses}) {
    all.*field += page.*field;
  }
  for (double TraceMetrics::*field :
       {&TraceMetrics::duration, &TraceMetrics::time_outside, &TraceMetrics::pause_time}) {
    all.*field += page.*field;
  }
  all.smoothness.peaks += page.smoothness.peaks;
}

/// Mean of a page's value, weighed.
template <typename Value, typename Weight>
double Mean(const std::vector<PageMetrics>& pages, Value value, Weight weight, double none = 0) {
  double sum = 0, weights = 0;
  for (const PageMetrics& page : pages) {
    sum += weight(page) * value(page.total);
    weights += weight(page);
  }
  return weights > 0 ? sum / weights : none;
}

}  // namespace

TraceMetrics MergedMetrics(const std::vector<PageMetrics>& pages) {
  using M = const TraceMetrics&;
  const auto length = [](const PageMetrics& page) { return page.stroke_length; };
  const auto time = [](const PageMetrics& page) { return page.total.duration; };
  const auto contact = [](const PageMetrics& page) {
    return page.total.duration * page.total.contact_share;
  };
  // Pages on which nothing was followed have neither errors nor a speed.
  const auto followed = [](const PageMetrics& page) {
    return FollowedNothing(page.total) ? 0 : page.stroke_length;
  };
  const auto moving = [&contact](const PageMetrics& page) {
    return FollowedNothing(page.total) ? 0 : contact(page);
  };
  // Pages without a movement that was long enough have no smoothness.
  const auto smooth = [](const PageMetrics& page) {
    return page.total.smoothness.normalised_jerk > 0 ? page.total.duration : 0;
  };
  TraceMetrics all;
  for (const PageMetrics& page : pages) {
    AddSums(all, page.total);
    AddGreatest(all, page.total);
  }
  all.coverage = Mean(
      pages, [](M m) { return m.coverage; }, length);
  all.mean_error = Mean(
      pages, [](M m) { return m.mean_error; }, followed);
  all.rms_error = std::sqrt(Mean(
      pages, [](M m) { return m.rms_error * m.rms_error; }, followed));
  all.bias = Mean(
      pages, [](M m) { return m.bias; }, followed);
  all.direction = Mean(
      pages, [](M m) { return m.direction; }, followed);
  all.order = Mean(
      pages, [](M m) { return m.order; }, followed, 1);
  all.shape.warped = Mean(
      pages, [](M m) { return m.shape.warped; }, followed);
  all.mean_force = Mean(
      pages, [](M m) { return m.mean_force; }, contact);
  all.mean_normal_force = Mean(
      pages, [](M m) { return m.mean_normal_force; }, contact);
  all.contact_share = Mean(
      pages, [](M m) { return m.contact_share; }, time);
  all.mean_speed = Mean(
      pages, [](M m) { return m.mean_speed; }, moving);
  all.smoothness.normalised_jerk = Mean(
      pages, [](M m) { return m.smoothness.normalised_jerk; }, smooth);
  all.smoothness.log_jerk = Mean(
      pages, [](M m) { return m.smoothness.log_jerk; }, smooth);
  all.smoothness.spectral_arc = Mean(
      pages, [](M m) { return m.smoothness.spectral_arc; }, smooth);
  return all;
}

}  // namespace moontrace

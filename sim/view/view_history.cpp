#include "sim/view/view_history.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace moontrace {

namespace {

constexpr double kKeptPath = 20, kKeptPoints = 10;  // [s]
constexpr std::size_t kMostPath = 1500;
constexpr double kLate = 0.5;        // of a snapshot that comes after newer samples [s]
constexpr double kBin = 0.02;        // of a plotted point [s]
constexpr double kLookEvery = 4e-3;  // between searches for the nearest stroke [s]
constexpr double kReach = 1.5e-3;    // beyond a groove's width [m]
constexpr double kPathStep = 0.15;   // of a groove's width
constexpr double kPathLeap = 3;      // widths that no hand goes between two instants
constexpr double kMillimetres = 1e3;

}  // namespace

void ViewHistory::Show(std::shared_ptr<const ViewPage> page) {
  page_ = std::move(page);
  path_.clear();
  broken_ = true;
  stroke_.reset();
  looked_at_ = -1;
  candidates_.clear();
  if (!page_) return;
  candidates_.reserve(page_->strokes.size());
  for (const IntendedStroke& stroke : page_->strokes) {
    Box box;
    for (const Piece& piece : stroke.spine_P) Include(box, BoundsOf(piece));
    candidates_.push_back({Grown(box, stroke.width + kReach), &stroke.spine_P});
  }
}

double ViewHistory::DistanceFrom(glm::dvec2 tip_P) {
  double nearest = std::numeric_limits<double>::infinity();
  stroke_.reset();
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (!Contains(candidates_[i].reach_P, tip_P)) continue;
    for (const Piece& piece : *candidates_[i].spine_P) {
      const double distance = DistanceTo(piece, tip_P);
      if (distance >= nearest) continue;
      nearest = distance;
      stroke_ = i;
    }
  }
  return nearest;
}

void ViewHistory::Add(ViewMoment moment) {
  if (newest_ && moment.time < newest_->time - kLate) {
    points_.clear();
    path_.clear();
    broken_ = true;
    looked_at_ = -1;
  } else if (newest_) {
    moment.time = std::max(moment.time, newest_->time);
  }
  newest_ = moment;
  const bool here = page_ && moment.present && moment.page == page_->number;
  if (!here) {
    broken_ = true;
    stroke_.reset();
  } else if (looked_at_ < 0 || moment.time - looked_at_ >= kLookEvery) {
    looked_at_ = moment.time;
    distance_ = DistanceFrom(glm::dvec2(moment.tip_P));
  }
  const double error = here && moment.in_contact ? distance_ : -1;
  AddPoint(moment, error);
  if (here) AddPath(moment, error);
}

void ViewHistory::AddPoint(const ViewMoment& moment, double error) {
  if (points_.empty() || moment.time - points_.back().time >= kBin) {
    points_.push_back({moment.time});
    while (points_.front().time < moment.time - kKeptPoints) points_.pop_front();
  }
  Point& point = points_.back();
  point.force = std::max(point.force, moment.present ? glm::length(moment.force_P) : 0.0);
  if (std::isfinite(error) && error >= 0) point.error = std::max(point.error, kMillimetres * error);
  point.lateness_us = std::max(point.lateness_us, moment.lateness_us);
  point.heat = std::max(point.heat, 100 * moment.heat);
}

void ViewHistory::AddPath(const ViewMoment& moment, double error) {
  while (!path_.empty() &&
         (path_.front().time < moment.time - kKeptPath || path_.size() >= kMostPath)) {
    path_.pop_front();
  }
  if (error < 0) {
    broken_ = true;
    return;
  }
  if (!broken_ && !path_.empty()) {
    const double step = glm::distance(path_.back().point.p_P, moment.tip_P);
    if (step < kPathStep * page_->width) return;
    broken_ = step > kPathLeap * page_->width;
  }
  const double half = 0.5 * (page_->width > 0 ? page_->width : 1e-3);
  path_.push_back({moment.time, {moment.tip_P, std::min(error / half, 1.0), broken_}});
  broken_ = false;
}

std::vector<ViewMarks::PathPoint> ViewHistory::Path() const {
  std::vector<ViewMarks::PathPoint> path;
  path.reserve(path_.size());
  for (const TimedPoint& kept : path_) path.push_back(kept.point);
  return path;
}

}  // namespace moontrace

#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "sim/page_view/page_renderer.h"
#include "sim/page_view/view_page.h"

namespace moontrace {

/// What the hand did lately: the tip's path on the page, what is plotted, and which stroke
/// the tip is at. Bounded: 20 s of path, 10 s of plots.
class ViewHistory {
 public:
  /// A new page: the path of the old one is forgotten.
  void Show(std::shared_ptr<const ViewPage> page);
  /// In order of time; one that is late by up to half a second is taken as of now, a time that goes
  /// back farther begins anew.
  void Add(ViewMoment moment);

  const std::optional<ViewMoment>& newest() const { return newest_; }
  /// The path on the page shown, `off` as ViewMarks has it.
  std::vector<ViewMarks::PathPoint> Path() const;
  /// The page's stroke nearest to the tip, within 1.5 mm and a groove's width; none without a tip.
  std::optional<std::size_t> stroke() const { return stroke_; }

  /// The greatest of each 20 ms; `error` is below 0 while the tip touches nothing.
  struct Point {
    double time = 0;         ///< [s]
    double force = 0;        ///< [N]
    double error = -1;       ///< of the tip from the nearest stroke's centre line [mm]
    double lateness_us = 0;  ///< [us]
    double heat = 0;         ///< [%]
  };
  const std::deque<Point>& points() const { return points_; }

 private:
  struct Candidate {
    Box reach_P;  ///< where it can be the nearest
    const std::vector<Piece>* spine_P = nullptr;
  };
  struct TimedPoint {
    double time = 0;
    ViewMarks::PathPoint point;
  };
  double DistanceFrom(glm::dvec2 tip_P);
  void AddPoint(const ViewMoment& moment, double error);
  void AddPath(const ViewMoment& moment, double error);

  std::shared_ptr<const ViewPage> page_;
  std::vector<Candidate> candidates_;  // by stroke
  std::optional<ViewMoment> newest_;
  std::optional<std::size_t> stroke_;
  std::deque<TimedPoint> path_;
  std::deque<Point> points_;
  bool broken_ = true;  // the path's next point begins a line
  double looked_at_ = -1;
  double distance_ = 0;
};

}  // namespace moontrace

#include "lessons/measure/link_meter.h"

#include <algorithm>
#include <limits>

namespace moontrace {

namespace {

constexpr double kReach = 0.5;        // [w], beyond which a groove counts as left
constexpr double kReachInFill = 1.5;  // a filled area has no wall within

}  // namespace

LinkMeter::LinkMeter(const std::vector<IntendedStroke>& strokes, const GrooveLinks& links)
    : strokes_(strokes), links_(links), is_left_(links.links.size(), false) {
  double width = 0;
  for (const IntendedStroke& stroke : strokes) {
    width = std::max(width, stroke.width);
    const double share = stroke.kind == StrokeKind::kFill ? kReachInFill : kReach;
    grooves_.push_back({stroke.spine_P, std::max(share * stroke.width, stroke.dot_radius)});
  }
  for (const GrooveLink& link : links.links) {
    grooves_.push_back({SpineOf(links, link), kReach * width});
  }
}

double LinkMeter::BeyondReach(std::size_t groove, glm::dvec2 p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Piece& piece : grooves_[groove].spine_P) {
    nearest = std::min(nearest, DistanceTo(piece, p));
  }
  return nearest - grooves_[groove].reach;
}

void LinkMeter::Choose(std::size_t from, std::size_t to) {
  passage_ = {from, to, {}, {}};
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const std::size_t glyph = strokes_[i].glyph;
    if (glyph == from || glyph == to) passage_.grooves.push_back(i);
  }
  for (std::size_t i = 0; i < links_.links.size(); ++i) {
    const GrooveLink& link = links_.links[i];
    const bool joins = link.from == from && link.to == to;
    const bool within = link.from == link.to && (link.from == from || link.from == to);
    if (joins) passage_.links.push_back(i);
    if (joins || within) passage_.grooves.push_back(strokes_.size() + i);
  }
}

void LinkMeter::Add(const TraceSample& sample) {
  if (sample.phase != TracePhase::kTravel) {
    chosen_ = false;
    any_ = any_ || sample.phase == TracePhase::kStroke;
    if (sample.phase == TracePhase::kStroke) last_ = sample.stroke;
    return;
  }
  if (!any_ || sample.stroke == last_) return;
  if (!chosen_) Choose(strokes_[last_].glyph, strokes_[sample.stroke].glyph);
  chosen_ = true;
  if (!sample.in_contact || passage_.links.empty()) return;
  const glm::dvec2 p(sample.tip_P);
  for (const std::size_t groove : passage_.grooves) {
    if (BeyondReach(groove, p) <= 0) return;
  }
  const auto nearer = [&](std::size_t a, std::size_t b) {
    return BeyondReach(strokes_.size() + a, p) < BeyondReach(strokes_.size() + b, p);
  };
  const std::size_t link = *std::min_element(passage_.links.begin(), passage_.links.end(), nearer);
  if (is_left_[link]) return;
  is_left_[link] = true;
  left_.push_back({p, sample.time, sample.stroke});
}

}  // namespace moontrace

#pragma once

#include <cstddef>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "lessons/measure/scoring.h"
#include "textures/relief/groove_links.h"

namespace moontrace {

/// Finds the groove links that a tip left on its paths from stroke to stroke (kTravel): there, in
/// contact, it was more than half the letters' groove away (as for TraceMetrics::excursions) from
/// every link and stroke of the two letters, and outside their dots. A path within one letter that
/// has no link there is not looked at. Letters and their errors are the scorer's.
class LinkMeter {
 public:
  LinkMeter(const std::vector<IntendedStroke>& strokes, const GrooveLinks& links);
  /// In time order; what is not kTravel gives the letter from which a path comes.
  void Add(const TraceSample& sample);
  /// One for each link that was left: where it first was.
  const std::vector<Excursion>& left() const { return left_; }

 private:
  /// The grooves that may be followed from one letter to another, or within one letter.
  struct Passage {
    std::size_t from = 0, to = 0;
    std::vector<std::size_t> links;    ///< from the one to the other
    std::vector<std::size_t> grooves;  ///< those, and strokes and links within the two
  };
  struct Groove {
    std::vector<Piece> spine_P;  ///< [m]
    double reach = 0;            ///< farther away it is left [m]
  };
  double BeyondReach(std::size_t groove, glm::dvec2 p) const;
  void Choose(std::size_t from, std::size_t to);

  std::vector<IntendedStroke> strokes_;
  GrooveLinks links_;
  std::vector<Groove> grooves_;  ///< strokes, then links
  Passage passage_;              ///< that the tip is in now
  bool chosen_ = false, any_ = false;
  std::size_t last_ = 0;  ///< stroke that was followed last
  std::vector<bool> is_left_;
  std::vector<Excursion> left_;
};

}  // namespace moontrace

#pragma once

#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "lessons/measure/scoring.h"
#include "lessons/measure/spine.h"

namespace moontrace {

/// Finds which stroke a person's hand means, for which there is no plan: the one nearest to the
/// tip, if it is no more than `reach` away. For scoring a person's own trace.
///
/// In the air, and farther from every stroke, the hand is between strokes (kAir). Coming into
/// contact is an entry for the first 50 ms; from then on it follows. A stroke that is followed is
/// kept while another is no nearer by a quarter of the groove's width, so that joints do not make
/// it flicker.
class NearestStroke {
 public:
  NearestStroke(const std::vector<IntendedStroke>& strokes, double reach);
  /// Sets phase and stroke of a sample. In time order.
  void Assign(TraceSample& sample);

 private:
  struct Candidate {
    Spine spine;
    double width = 0;
  };
  std::vector<Candidate> candidates_;
  double reach_ = 0;  ///< [m]
  bool touching_ = false;
  double touched_at_ = 0;  ///< [s]
  std::size_t stroke_ = 0;
  bool has_stroke_ = false;
};

}  // namespace moontrace

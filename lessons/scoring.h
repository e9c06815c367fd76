#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "textures/element.h"
#include "textures/script.h"
#include "textures/typeset.h"

namespace moontrace {

/// A stroke that a tip is meant to follow, on the page: what tracing is measured against.
struct IntendedStroke {
  StrokeKind kind = StrokeKind::kStroke;
  std::vector<Piece> spine_P;  ///< centre line [m]; of a fill its centre arc; of a dot the circle's
                               ///< centre, as a Line of length zero
  double width = 0;            ///< of the groove [m]
  std::size_t glyph = 0;       ///< index into the page's glyphs
};

/// The strokes of a page in writing order.
std::vector<IntendedStroke> IntendedStrokes(const TextPage& page, const Script& script,
                                            const TypeStyle& style);

/// Centre arc of a filled outline of two long pieces (a crescent): through both tips and the middle
/// between the two sides. A circle's centre arc is its centre.
std::vector<Piece> CentreArc(const std::vector<Piece>& outline);

enum class TracePhase { kAir, kEntry, kStroke, kLift };

/// One tick as scoring sees it.
struct TraceSample {
  double time = 0;              ///< [s]
  glm::dvec3 tip_P{0, 0, 0};    ///< of the tip, never of the proxy [m]
  glm::dvec3 force_P{0, 0, 0};  ///< on the tip [N]
  bool in_contact = false;
  TracePhase phase = TracePhase::kAir;
  std::size_t stroke = 0;  ///< index of the intended stroke, valid unless kAir
};

/// Metrics of training-and-ux.md 1.5 of one letter or of all.
struct TraceMetrics {
  double coverage = 0;    ///< share of the length within w/4 of a sample; a dot counts one width
  double mean_error = 0;  ///< [m], resampled by arc length of the tip's way
  double rms_error = 0;   ///< [m]
  double max_error = 0;   ///< [m]
  std::size_t excursions = 0;  ///< left beyond w/2, came back within w/4
  double duration = 0;         ///< [s]
  double mean_force = 0;       ///< in contact [N]
  double peak_force = 0;       ///< [N]
  std::size_t entries = 0;     ///< landings, apart
  std::size_t lifts = 0;       ///< contact lost within a stroke and regained
  double entry_error = 0;      ///< greatest distance from the stroke's start at a landing [m]
};
/// Where a sample left the groove: for pictures and words.
struct Excursion {
  glm::dvec2 p_P{0, 0};
  double time = 0;
  std::size_t stroke = 0;
};
struct TraceScore {
  std::vector<TraceMetrics> letters;  ///< one per glyph of the page
  TraceMetrics total;
  std::vector<Excursion> left_at;
};

/// Takes samples one by one in time order, so that nothing long need be kept. Add does not allocate
/// between strokes' ends; Finish may.
class TraceScorer {
 public:
  TraceScorer(std::vector<IntendedStroke> strokes, std::size_t glyph_count);
  void Add(const TraceSample& sample);
  TraceScore Finish();

 private:
  struct Progress;
  std::vector<IntendedStroke> strokes_;
  std::vector<Progress> progress_;
  std::size_t glyph_count_ = 0;

 public:
  ~TraceScorer();
  TraceScorer(TraceScorer&&) noexcept;
};

}  // namespace moontrace

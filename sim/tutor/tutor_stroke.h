#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace moontrace {

/// The path of a hand with its times, ready for MakeRecordedPath (lessons/guide/guidance.h).
struct RecordedStroke {
  std::vector<double> times;       ///< from 0, strictly rising [s]
  std::vector<glm::dvec3> tips_P;  ///< [m]
};

/// Takes the tutor's own stroke from the device, sample by sample, off the tick. Memory is bounded:
/// what comes after `longest` seconds is not kept.
class StrokeRecorder {
 public:
  explicit StrokeRecorder(double longest = 60);
  /// In time order; samples that are not finite or go back in time are left out. `time` [s].
  void Add(double time, glm::dvec3 tip_P, bool in_contact);
  /// The path from the first touch to the last: what comes before and after is left out, lifts
  /// shorter than 0.15 s are bridged, longer ones are kept as they are. Points that lie within
  /// 0.02 mm of the path between their neighbours, in place and in time, are dropped. None if the
  /// page was touched for less than 0.1 s, or the tip went less than 1 mm.
  std::optional<RecordedStroke> Stroke() const;
  /// The bound on time was reached.
  bool full() const { return full_; }

 private:
  struct Sample {
    double time = 0;
    glm::dvec3 tip_P{0, 0, 0};
    bool in_contact = false;
  };
  double longest_;
  bool full_ = false;
  std::vector<Sample> samples_;
};

/// Where the recorded hand was at a time [s], held to the ends.
glm::dvec3 TipAt(const RecordedStroke& stroke, double time);

}  // namespace moontrace

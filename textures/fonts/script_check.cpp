#include "textures/fonts/script_check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "textures/base/overload.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

using Kind = ScriptFinding::Kind;

constexpr double kMeeting = 0.01;                 ///< strokes this near meet [em]
constexpr double kSmooth = std::numbers::pi / 6;  ///< greatest turn of a stroke that goes on [rad]
constexpr double kStep = 0.01;                    ///< between samples [em]
constexpr double kMostSamples = 2000;             ///< of a glyph
constexpr std::size_t kMostPieces = 1000;         ///< whose ends are all samples
constexpr double kLeastOverlap = 0.05;            ///< shorter ones are meetings [em]
constexpr double kParallel = 0.966;               ///< cosine of 15 degrees
constexpr double kLeastBend = std::numbers::pi / 2 - 1e-6;  ///< [rad]
constexpr char32_t kFirstIdeograph = 0x2E80;

struct Sample {
  glm::dvec2 p{0, 0};
  glm::dvec2 direction{1, 0};
  double at = 0;  ///< arc length from the stroke's start [em]
};

/// `every`: also both ends of each piece, however short it is.
std::vector<Sample> SamplesOf(const Stroke& stroke, double step, bool every) {
  std::vector<Sample> samples;
  double at = 0;
  for (const Piece& piece : stroke.pieces) {
    const double length = Length(piece);
    const int count = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int i = 0; i <= count; ++i) {
      const double s = length * i / count;
      if (!every && !samples.empty() && at + s < samples.back().at + step) continue;
      samples.push_back({PointAt(piece, s), TangentAt(piece, s), at + s});
    }
    at += length;
  }
  if (!every) {
    const Piece& last = stroke.pieces.back();
    samples.push_back({EndOf(last), TangentAt(last, Length(last)), at});
  }
  return samples;
}

double Turn(glm::dvec2 u, glm::dvec2 v) {
  return std::abs(std::atan2(u.x * v.y - u.y * v.x, glm::dot(u, v)));
}

/// Smallest distance from `p` to a sample of `others` that counts, and which.
struct Nearest {
  double distance = 1e300;
  std::size_t index = 0;
};

class GlyphChecker {
 public:
  GlyphChecker(const Glyph& glyph, std::size_t index, const CheckSize& size,
               std::vector<ScriptFinding>& findings)
      : glyph_(glyph), index_(index), size_(size), findings_(findings) {
    double total = 0;
    std::size_t pieces = 0;
    for (std::size_t i = 0; i < Count(); ++i) {
      total += Length(glyph.strokes[i].pieces);
      pieces += glyph.strokes[i].pieces.size();
    }
    const double step = std::max(kStep, total / kMostSamples);
    for (std::size_t i = 0; i < Count(); ++i) {
      const Stroke& stroke = glyph.strokes[i];
      const bool every = pieces <= kMostPieces;
      samples_.push_back(IsLine(stroke) ? SamplesOf(stroke, step, every) : std::vector<Sample>());
      boxes_.emplace_back();
      for (const Sample& sample : samples_.back()) Include(boxes_.back(), sample.p);
    }
  }

  void Check() {
    const std::u32string name = ToCodePoints(glyph_.name);
    const bool by_rule = name.size() == 1 && name[0] >= kFirstIdeograph;
    for (std::size_t i = 0; i < Count(); ++i) {
      CheckBends(i);
      CheckItself(i);
      for (std::size_t j = i + 1; j < Count(); ++j) {
        if (!by_rule) CheckEnds(i, j);
        CheckPair(i, j);
      }
    }
    const std::size_t strokes = glyph_.strokes.size();
    if (strokes > Count()) Add(Kind::kTooMany, 0, 0, static_cast<double>(strokes));
  }

 private:
  /// Of the strokes that are looked at.
  std::size_t Count() const { return std::min(glyph_.strokes.size(), kMostCheckedStrokes); }

  static bool IsLine(const Stroke& stroke) {
    return stroke.kind == StrokeKind::kStroke && !stroke.pieces.empty();
  }

  void Add(Kind kind, std::size_t stroke, std::size_t other, double figure, double needed = 0) {
    findings_.push_back({kind, index_, stroke, other, figure, needed});
  }

  bool IsRing(std::size_t i) const {
    return glm::length(samples_[i].front().p - samples_[i].back().p) <= kMeeting;
  }

  /// At most one finding for two strokes whose ends meet.
  void CheckEnds(std::size_t i, std::size_t j) {
    if (samples_[i].empty() || samples_[j].empty() || IsRing(i) || IsRing(j)) return;
    const Sample &start_i = samples_[i].front(), &end_i = samples_[i].back();
    const Sample &start_j = samples_[j].front(), &end_j = samples_[j].back();
    const auto meet = [](const Sample& a, const Sample& b) {
      return glm::length(a.p - b.p) <= kMeeting;
    };
    const bool follows = j == i + 1;
    if (meet(end_i, start_j)) {
      const double turn = Turn(end_i.direction, start_j.direction);
      if (turn <= kSmooth) return Add(Kind::kSplit, i, j, turn);
      if (follows) return Add(Kind::kLift, i, j, turn);
    }
    if (meet(end_j, start_i)) {
      const double turn = Turn(end_j.direction, start_i.direction);
      if (turn <= kSmooth) return Add(Kind::kSplit, j, i, turn);
    }
    if (meet(end_i, end_j)) {
      const double turn = Turn(end_i.direction, -end_j.direction);
      if (turn <= kSmooth || follows) return Add(Kind::kReversed, i, j, turn);
    }
    if (meet(start_i, start_j)) {
      const double turn = Turn(-start_i.direction, start_j.direction);
      if (turn <= kSmooth) return Add(Kind::kReversed, i, j, turn);
    }
  }

  void CheckBends(std::size_t i) {
    if (!IsLine(glyph_.strokes[i])) return;
    const double needed = std::max(size_.groove, size_.probe_diameter) / 2;
    double bend = 0, least = 1e300;
    const auto end_run = [&] {
      if (std::abs(bend) >= kLeastBend) Add(Kind::kTightBend, i, i, least, needed);
      bend = 0;
      least = 1e300;
    };
    for (const Piece& piece : glyph_.strokes[i].pieces) {
      const auto on_line = [&end_run](const Line&) { end_run(); };
      const auto on_arc = [&](const Arc& arc) {
        const double radius = arc.radius * size_.size;
        const bool tight = radius < needed * (1 - 1e-9);
        if (!tight || bend * arc.sweep < 0) end_run();
        if (!tight) return;
        bend += arc.sweep;
        least = std::min(least, radius);
      };
      std::visit(Overload{on_line, on_arc}, piece);
    }
    end_run();
  }

  double NeededSpacing() const { return (size_.groove + size_.probe_diameter) / size_.size; }

  /// What comes within the other's groove has joined it [em].
  double Meeting() const { return std::max(kMeeting, size_.groove / 2 / size_.size); }

  /// Arc length along stroke i between two of its samples; on a ring the shorter of the two.
  double ArcLength(std::size_t i, const Sample& a, const Sample& b) const {
    const double length = std::abs(a.at - b.at);
    return IsRing(i) ? std::min(length, samples_[i].back().at - length) : length;
  }

  /// Which sample is nearest, and how near the stroke itself is: distances to samples would waver
  /// and show gaps where strokes meet at a narrow angle. `apart` keeps a stroke's neighbourhood
  /// out.
  Nearest NearestIn(std::size_t j, const Sample& to, bool itself, double apart) const {
    Nearest nearest;
    const std::vector<Sample>& samples = samples_[j];
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (itself && ArcLength(j, samples[k], to) < apart) continue;
      const double distance = glm::length(samples[k].p - to.p);
      if (distance < nearest.distance) nearest = {distance, k};
    }
    if (nearest.distance > 1e200) return nearest;
    for (std::size_t k = nearest.index > 0 ? nearest.index - 1 : 0;
         k <= nearest.index && k + 1 < samples.size(); ++k) {
      if (itself &&
          std::min(ArcLength(j, samples[k], to), ArcLength(j, samples[k + 1], to)) < apart)
        continue;
      const Line chord{samples[k].p, samples[k + 1].p};
      nearest.distance = std::min(nearest.distance, DistanceTo(Piece(chord), to.p));
    }
    return nearest;
  }

  /// Length over which `one` runs within the meeting distance along `other`, and the least distance
  /// at which it passes beyond that. `apart`: arc length that keeps a stroke's neighbourhood out.
  void CheckAlong(std::size_t i, std::size_t j, double apart) {
    const std::vector<Sample>&one = samples_[i], &other = samples_[j];
    const bool itself = i == j;
    std::vector<Nearest> nearest;
    nearest.reserve(one.size());
    for (const Sample& sample : one) {
      nearest.push_back(NearestIn(j, sample, itself, apart));
    }
    const double meeting = Meeting();
    double overlap = 0, narrow = 1e300;
    for (std::size_t k = 0; k < one.size(); ++k) {
      const Nearest& at = nearest[k];
      if (at.distance > 1e200) continue;
      const Sample& beside = other[at.index];
      const double stretch = k > 0 ? one[k].at - one[k - 1].at : 0;
      if (at.distance <= meeting) {
        const bool along = std::abs(glm::dot(one[k].direction, beside.direction)) >= kParallel;
        const double beyond = std::abs(glm::dot(one[k].p - beside.p, beside.direction));
        if (along && beyond <= kStep) overlap += stretch;  // not where the other has ended
        continue;
      }
      const bool least = (k == 0 || nearest[k - 1].distance >= at.distance) &&
                         (k + 1 == one.size() || nearest[k + 1].distance >= at.distance);
      // At the edge of the neighbourhood the distance just grows with the arc length: no gap.
      const bool at_edge = itself && ArcLength(i, beside, one[k]) < 1.1 * apart + 2 * kStep;
      if (least && !at_edge) narrow = std::min(narrow, at.distance);
    }
    if (itself) overlap /= 2;  // counted once from either side
    if (overlap > kLeastOverlap + meeting) Add(Kind::kOverlap, i, j, overlap * size_.size);
    if (narrow < NeededSpacing() * (1 - 1e-9)) {
      Add(Kind::kNarrowGap, i, j, narrow * size_.size - size_.groove, size_.probe_diameter);
    }
  }

  void CheckItself(std::size_t i) {
    if (samples_[i].empty()) return;
    // Half a circle as wide as is needed is this long: what is nearer along the stroke is no gap.
    // The two ends of a ring touch, as at a meeting.
    CheckAlong(i, i, std::max(0.1, std::numbers::pi / 2 * NeededSpacing()));
  }

  void CheckPair(std::size_t i, std::size_t j) {
    if (samples_[i].empty() || samples_[j].empty()) return;
    // Boxes further apart than any finding reaches: most pairs of a large character.
    if (!Overlap(Grown(boxes_[i], std::max(NeededSpacing(), Meeting())), boxes_[j])) return;
    CheckAlong(i, j, -1);
  }

  const Glyph& glyph_;
  std::size_t index_;
  const CheckSize& size_;
  std::vector<ScriptFinding>& findings_;
  std::vector<std::vector<Sample>> samples_;  ///< by stroke; empty for dots and fills
  std::vector<Box> boxes_;                    ///< of the samples
};

}  // namespace

std::vector<ScriptFinding> CheckGlyph(const Script& script, std::size_t glyph,
                                      const CheckSize& size) {
  std::vector<ScriptFinding> findings;
  GlyphChecker(script.glyphs[glyph], glyph, size, findings).Check();
  return findings;
}

bool IsOutlineFont(const Script& script) {
  std::size_t outlines = 0;
  for (const Glyph& glyph : script.glyphs) {
    const bool filled =
        std::all_of(glyph.strokes.begin(), glyph.strokes.end(),
                    [](const Stroke& stroke) { return stroke.kind == StrokeKind::kFill; });
    outlines += filled ? 1U : 0U;
  }
  return 2 * outlines > script.glyphs.size();
}

}  // namespace moontrace

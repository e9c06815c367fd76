// How the hatching reader moves: it looks for lines, goes up and down over them, and feels.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "sim/reader/hatch_reader.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20. In em unless said.
constexpr double kGivesUp = 300;       ///< after so long without a sign or a line [s]
constexpr double kGivesUpFirst = 600;  ///< the same of the first line, gone over twice as high [s]
constexpr double kPerSecond = 14;      ///< widths of a ridge, over which it goes
constexpr double kColumn = 0.11;       ///< from one way across a line to the next
constexpr double kLean = 3;            ///< how far aside a way ends from where it begins [columns]
constexpr double kLinkedLean = 1;      ///< the same of linked letters
// Over how long it finds how far it strays aside [s]. A tip that dots turn away seems to stray.
constexpr double kLearn = 0.05, kDotLearn = 0.25;
constexpr double kSample = 0.25;    ///< from one felt place to the next, in widths
constexpr double kInk = 0.2;        ///< share of a ridge's height
constexpr double kInkTime = 0.004;  ///< [s]
constexpr double kFlat = 0.1;       ///< more is not flat paper
constexpr double kSlope = 0.2;      ///< more is a slope
constexpr double kDotSlope = 0.15;  ///< the same of raised dots, round which the tip slides
constexpr double kAbove = 0.8;      ///< where its hand was put the search begins; not on a face
constexpr double kAcrossRows = 3;   ///< the length of ways that look for a line
constexpr double kDeepest = 4;      ///< the next line lies no deeper
constexpr double kThinks = 0.3;     ///< after so much more was felt
constexpr int kMostRestarts = 2;    ///< of the search for the first line
constexpr double kInside = 0.002;   ///< of a face's edges the hand stays [m]

bool AllDots(const SignShapes& shapes) {
  for (std::size_t sign = 0; sign < shapes.size(); ++sign) {
    if (!shapes.IsDots(sign)) return false;
  }
  return true;
}

}  // namespace

HatchReader::HatchReader(const ReaderKnowledge& knowledge, double tick)
    : knowledge_(knowledge),
      belief_(*knowledge.shapes, knowledge.width, knowledge.space),
      dots_(AllDots(*knowledge.shapes)),
      hand_(knowledge, kPerSecond * knowledge.width, dots_ ? kDotLearn : kLearn, tick),
      size_(knowledge.greatest_size) {}

ReaderActivity HatchReader::activity() const {
  if (done()) return ReaderActivity::kDone;
  if (!hand_.sweeps()) return ReaderActivity::kFlying;
  return OnLine() ? ReaderActivity::kHatching : ReaderActivity::kSearching;
}

ReaderAction HatchReader::Step(const ReaderInput& input) {
  tick_ = input.time - now_;
  now_ = input.time;
  hand_.Add(input);
  if (errand_ == Errand::kDoubts) news_ = now_;  // that way has an end
  if (now_ - news_ > (line_starts_.empty() ? kGivesUpFirst : kGivesUp) && !done()) {
    if (!line_.empty()) LineDone();
    phase_ = Phase::kDone;
  }
  switch (phase_) {
    case Phase::kStart:
      start_ = glm::dvec2(hand_.felt().tip);
      SearchFirstLine(start_.y + (knowledge_.face ? 0 : kAbove * knowledge_.least_size));
      phase_ = Phase::kReads;
      action_ = hand_.Move({});
      break;
    case Phase::kReads:
      action_ = hand_.sweeps() ? Sweep() : hand_.Move({});
      break;
    case Phase::kDone:
      action_ = hand_.Lifted();
      break;
  }
  if (knowledge_.face && action_.press > 0) {
    action_.aim = {knowledge_.face->Held(glm::dvec2(action_.aim), kInside), action_.aim.z};
  }
  return action_;
}

/// Lifts the hand, and goes along a way from its first point.
void HatchReader::SweepFrom(std::vector<glm::dvec2> way, Errand errand) {
  errand_ = errand;
  inked_for_ = 0;
  hand_.Go(std::move(way));
}

/// Looks for a line's ink, or feels the line.
ReaderAction HatchReader::Sweep() {
  const Felt& felt = hand_.calm();
  inked_for_ = felt.touching && felt.depth > kInk ? inked_for_ + tick_ : 0;
  if (OnLine()) {
    Feel(felt);
  } else if (inked_for_ > kInkTime) {
    BeginLine(felt.place);
  }
  if (!hand_.sweeps() || done()) return action_;
  const ReaderAction moved = hand_.Move([this] {
    if (errand_ != Errand::kLine) return;
    for (const glm::dvec2 point : NextColumn()) hand_.GoOnTo(point);
  });
  if (!hand_.ended()) return moved;
  if (errand_ == Errand::kDoubts) {
    ReadAgain();
    LineDone();
  } else if (line_starts_.empty() && ++restarts_ <= kMostRestarts) {
    SearchFirstLine(start_.y - restarts_ * kRow * knowledge_.least_size / (kMostRestarts + 1));
  } else {
    phase_ = Phase::kDone;
  }
  return action_;
}

double HatchReader::ColumnWidth() const {
  return (dots_ ? kDotColumn : kColumn) *
         (line_starts_.empty() && !framed_ ? knowledge_.least_size : size_);
}

double HatchReader::Lean() const {
  if (dots_) return 0;
  return (knowledge_.link_depth > 0 ? kLinkedLean : kLean) * ColumnWidth();
}

/// To the end of this column, upwards or downwards in turn, and aside to where the next one begins.
/// They lean to the right by more than their distance, all alike: an upright stroke, which could
/// lie between two upright ones, is crossed by several of them. Dots are met by upright ones as
/// well.
std::vector<glm::dvec2> HatchReader::NextColumn() {
  const double lean = upwards_ ? Lean() : 0, end = upwards_ ? high_ : low_;
  const double from = column_ + lean;
  column_ += ColumnWidth();
  upwards_ = !upwards_;
  return {FromEm(hatch_, {from, end}), FromEm(hatch_, {column_ + lean, end})};
}

/// From where the hand was put to and fro, downwards.
void HatchReader::SearchFirstLine(double top) {
  constexpr int kRows = 90;
  const double a = knowledge_.least_size;
  std::vector<glm::dvec2> way;
  way.reserve(kRows);
  for (int i = 0; i < kRows; ++i) {
    way.emplace_back(start_.x + a * (i % 2 == 0 ? -0.5 : kAcrossRows), top - kRow * a * i);
  }
  SweepFrom(std::move(way), Errand::kFirstLine);
}

/// To and fro below the last line, over its first signs.
void HatchReader::SearchNextLine(double down) {
  std::vector<glm::dvec2> way;
  const SignPlace& last = line_starts_.back();
  const double left = Margin() - kBefore;
  bool right = true;
  for (double y = down; y < kDeepest; y += kRow, right = !right) {
    way.push_back(FromEm(last, {right ? left : kAcrossRows, -y}));
    way.push_back(FromEm(last, {right ? kAcrossRows : left, -y}));
  }
  SweepFrom(std::move(way), Errand::kNextLine);
}

/// Ink was met: it belongs to some sign near the beginning of a line, at any height of it.
void HatchReader::BeginLine(glm::dvec2 ink) {
  met_ = ink;
  const double height = belief_.bounds().max.y - belief_.bounds().min.y;
  SignPlace frame{ink, 1, turn_};
  const double low = -(height + kEdge) * size_;
  if (line_starts_.empty()) {
    // met from above, near its upper edge
    frame.origin.x = std::min(start_.x - 0.7 * size_, ink.x - size_);
    HatchLine(frame, low, 0.6 * size_);
  } else {
    const SignPlace& last = line_starts_.back();
    const double room = ToEm(last, ink).y - belief_.bounds().min.y + 0.1;
    frame.origin = FromEm(last, {Margin() - kBefore, ToEm(last, ink).y});
    HatchLine(frame, low, std::min(0.6 * height, std::max(kEdge, -room)) * size_);
  }
}

/// Goes over a line from its left. `frame` in metres.
void HatchReader::HatchLine(const SignPlace& frame, double low, double high) {
  expected_ = false;
  hatch_ = frame;
  low_ = low;
  high_ = high;
  first_token_ = tokens_.size();
  setting_at_begin_ = setting_;
  column_ = 0;
  upwards_ = false;
  points_.clear();
  line_.clear();
  framed_ = inked_ = false;
  thought_at_ = waits_ = 0;
  SweepFrom(NextColumn(), Errand::kLine);
}

/// A line at the pitch of those before.
void HatchReader::HatchExpectedLine() {
  const SignPlace& last = line_starts_.back();
  const double lines = static_cast<double>(line_starts_.size()) - 1;
  const double pitch = ToEm(last, line_starts_.front().origin).y / lines;
  SignPlace frame{FromEm(last, {Margin() - kBefore, -pitch}), size_, turn_};
  met_ = FromEm(frame, {0, 0.5 * (belief_.bounds().min.y + belief_.bounds().max.y)});
  frame.size = 1;
  HatchLine(frame, (belief_.bounds().min.y - kEdgeUnsure) * size_,
            (belief_.bounds().max.y + kEdgeUnsure) * size_);
  expected_ = true;
}

/// Where lines begin at the left, from the last one [em].
double HatchReader::Margin() const {
  double left = 0;
  for (const SignPlace& start : line_starts_) {
    left = std::min(left, ToEm(line_starts_.back(), start.origin).x);
  }
  return left;
}

/// How far along the line everything was felt [m].
double HatchReader::FeltTo() const {
  if (errand_ == Errand::kDoubts) return ToEm(hatch_, felt_to_).x;
  return ToEm(hatch_, hand_.felt().place).x - ColumnWidth() - Lean();
}

void HatchReader::Feel(const Felt& felt) {
  if (!felt.touching || !hand_.level_known()) return;
  const bool far =
      points_.empty() || glm::distance(sampled_, felt.place) > kSample * knowledge_.width;
  if (!far) return;
  sampled_ = felt.place;
  HatchPoint point;
  point.p = point.felt = felt.place;
  point.depth = felt.depth;
  point.ink = felt.depth > (dots_ && knowledge_.raised ? kDotSlope : kSlope);
  const double push = glm::length(felt.wall);
  if (point.ink && push > 0) {
    // a ridge pushes the tip away from its middle, a groove towards it
    const double off = 0.5 * knowledge_.width * std::max(0.0, 1 - felt.depth) / push;
    point.p += (knowledge_.raised ? -off : off) * felt.wall;
  }
  if (point.ink || felt.depth < kFlat) points_.push_back(point);
  if (errand_ == Errand::kDoubts) return;
  const double x = ToEm(hatch_, felt.place).x;
  if (felt.depth > kInk && inked_for_ > kInkTime) {
    if (!inked_) ink_from_ = ink_to_ = x;
    inked_ = true;
    ink_to_ = std::max(ink_to_, x);
  }
  if (FeltTo() - thought_at_ > kThinks * size_) Think();
}

}  // namespace moontrace

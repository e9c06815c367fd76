// How a reader finds its way along a line, from sign to sign, through gaps and past guide lines.
#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/reader/guide_line.h"
#include "sim/reader/reader.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20; in em.
constexpr double kBandLow = 0.14, kBandHigh = 0.62;  ///< of the weave over a line
constexpr double kWeave = 0.145;                     ///< half its period
constexpr double kDotWithin = 0.35;                  ///< dots at a sign's left edge are met by then
constexpr double kGapFrom = -0.15;                   ///< a dot may stick out at a sign's left edge
constexpr double kGapStep = 0.12;
constexpr double kLowEdge = 0.05, kHighEdge = 0.91;  ///< where marks and bars are
constexpr double kEdge = 0.12;                       ///< swept to either side of an edge
constexpr double kRoomForASign = 0.75;               ///< without a groove
constexpr int kMostFar = 2;                          ///< far_ at most

}  // namespace

/// Where the next sign of the line begins if no space comes before it, as the line runs.
SignPlace Reader::Expected() const {
  const SignGuess& last = line_.back().guess;
  SignPlace place = last.place;
  place.size = size_;
  place.turn = turn_;
  // the line's height by its newest signs, so that their errors do not add up
  double mean = 0, weight = 0;
  for (std::size_t i = 0; i < line_.size() && i < 6; ++i) {
    const SignGuess& read = line_[line_.size() - 1 - i].guess;
    if (read.sign == SignGuess::kUnknown) continue;
    const double share = std::pow(0.7, i);
    mean += share * ToEm(place, read.place.origin).y;
    weight += share;
  }
  if (weight > 0) mean /= weight;
  place.origin = AtAhead(place, WayBehind(line_.back()), mean);
  return place;
}

/// From a sign's strokes to its end [em].
double Reader::GapOf(std::size_t sign) const {
  return knowledge_.shapes->Advance(sign) - knowledge_.shapes->Bounds(sign).max.x;
}

/// From its left edge to the end of its strokes [em].
double Reader::WidthOf(const SignGuess& guess) const {
  return guess.sign == SignGuess::kUnknown ? kBeyond : knowledge_.shapes->Bounds(guess.sign).max.x;
}

/// From the left edge of what was read to where the next begins, as the line runs [em].
double Reader::WayBehind(const SignRead& read) const {
  const std::size_t sign = read.guess.sign;
  if (read.guide) return guide_gap_ + gap_bias_;
  if (sign == SignGuess::kUnknown) return leftwards_ ? 0 : kBeyond;
  return (leftwards_ ? GapOf(sign) : knowledge_.shapes->Advance(sign)) + gap_bias_;
}

double Reader::Ahead(const SignPlace& from, glm::dvec2 p) const {
  const double x = ToEm(from, p).x;
  return leftwards_ ? -x : x;
}

glm::dvec2 Reader::AtAhead(const SignPlace& from, double ahead, double y) const {
  return FromEm(from, {leftwards_ ? -ahead : ahead, y});
}

/// To the right, as lines are turned [m].
double Reader::Along(glm::dvec2 p) const { return std::cos(turn_) * p.x + std::sin(turn_) * p.y; }

/// A way that crosses every sign of a line, between two distances from where the next one is
/// expected [em].
std::vector<glm::dvec2> Reader::Weave(double from, double to) const {
  return WeaveFrom(Expected(), from, to);
}

std::vector<glm::dvec2> Reader::WeaveFrom(const SignPlace& place, double from, double to) const {
  std::vector<glm::dvec2> way;
  bool high = random_phase_;
  for (double x = from; x < to + kWeave; x += kWeave, high = !high) {
    way.push_back(AtAhead(place, x, high ? kBandHigh : kBandLow));
  }
  return way;
}

/// The next sign; after something unknown, beyond all that was felt of it.
void Reader::SearchNext() {
  gap_to_ = kGapFrom;
  far_ = 0;
  if (unknowns_ > 0) return SearchBeyond(unknown_);
  SweepAlong(Weave(-kBefore, knowledge_.space + kBeyond), Errand::kNextSign);
}

void Reader::SearchBeyond(const std::vector<FeltPoint>& grooves) {
  double beyond = -kBefore;
  const SignPlace next = Expected();
  for (const FeltPoint& groove : grooves) beyond = std::max(beyond, Ahead(next, groove.p) + 0.15);
  evidence_.grooves.clear();
  evidence_.flats.clear();
  crossings_ = 0;
  SweepAlong(Weave(beyond, beyond + knowledge_.space + kBeyond + kBefore), Errand::kNextSign);
}

/// The weave passes above bars on the base line and beside dots: where it met nothing for so long
/// that a sign has room, it looks along both edges of the line, between two distances from where
/// the next sign is expected, or from the first one, where it looks for what stands before it [em].
void Reader::LookThroughGap(double from, double to, AfterGap after) {
  SignPlace place = Expected();
  if (after == AfterGap::kLineBegin) place.origin = line_.front().guess.place.origin;
  std::vector<glm::dvec2> way;
  bool high = false;
  for (double x = from; x < to; x += kGapStep, high = !high) {
    way.push_back(AtAhead(place, x, high ? kLowEdge + kEdge : kLowEdge - kEdge));
  }
  const std::size_t turn = way.size();
  for (double x = to; x > from - kGapStep; x -= kGapStep, high = !high) {
    way.push_back(AtAhead(place, x, high ? kHighEdge + kEdge : kHighEdge - kEdge));
  }
  SweepAlong(std::move(way), errand_);
  in_gap_ = true;
  after_gap_ = after;
  gap_to_ = to;
  gap_turn_ = turn;
}

/// Whether this is the sign at which the gap ends, which may lean over it: the rest is looked
/// through then, before what it met.
bool Reader::MetGapsEnd(glm::dvec2 entry) {
  const SignPlace place = Expected();
  const double x = Ahead(place, entry);
  if (after_gap_ != AfterGap::kNextSign || x < gap_to_ - kBefore) return false;
  std::size_t rest = std::max(next_, gap_turn_);
  while (rest < way_.size() && Ahead(place, way_[rest]) > x - kBefore) ++rest;
  if (rest + 1 >= way_.size()) {
    LeaveGap();
    return true;
  }
  const auto left = static_cast<std::ptrdiff_t>(rest);
  SweepAlong({way_.begin() + left, way_.end()}, errand_);
  in_gap_ = true;
  gap_turn_ = 0;
  return true;
}

/// Whether the weave went by room for a sign before it met this; then that is looked through first.
bool Reader::LeftAGap(glm::dvec2 entry) {
  const double x = Ahead(Expected(), entry);
  if (x - std::max(gap_to_, 0.0) < kRoomForASign) return false;
  LookThroughGap(gap_to_, x - kBefore, AfterGap::kNextSign);
  return true;
}

/// Behind a line's last sign, where one of dots and bars may stand after a space; unless it has
/// looked so far already, before something that it met there and that was no sign.
void Reader::LookThroughLineEnd() {
  const double to = (far_ + 1) * knowledge_.space + kDotWithin;
  if (gap_to_ < to) return LookThroughGap(gap_to_, to, AfterGap::kLineEnd);
  after_gap_ = AfterGap::kLineEnd;
  LeaveGap();
}

/// Whether the line may go on behind two spaces, or three. It looks where most words would have
/// room, or once one such gap was met wherever lines go so far; in the first line, of which no
/// margin is known, and behind two spaces where only a guide ends a line.
bool Reader::MayGoOn() const {
  constexpr double kWord = 5;  // [em]
  if (far_ == kMostFar) return false;
  if (line_starts_.empty()) return true;
  if (guided_) return far_ == 0;
  const double there = (far_ + 2) * knowledge_.space + (widest_gap_ > far_ ? 0 : kWord);
  return Along(AtAhead(Expected(), there, 0)) < farthest_;
}

void Reader::LeaveGap() {
  switch (after_gap_) {
    case AfterGap::kNextSign:
      SweepAlong(Weave(gap_to_ - 0.05, gap_to_ + knowledge_.space + kBeyond), Errand::kNextSign);
      return;
    case AfterGap::kLineEnd:
      if (MayGoOn()) {
        ++far_;
        const double from = far_ * knowledge_.space + kBeyond;
        SweepAlong(Weave(from, from + knowledge_.space), Errand::kNextSign);
        return;
      }
      LeaveLine();
      return;
    case AfterGap::kLineBegin:
      BeginLine();
      return;
  }
}

/// Whether signs stand left of the line's first; of the page's first line, as far as from where the
/// hand was put: words may stand several spaces apart.
void Reader::SearchLineStart() {
  constexpr double kPutWithin = 0.5;  // [em]
  const SignPlace first{line_.front().guess.place.origin, size_, turn_};
  double back = kLookBack;
  if (line_starts_.empty()) back = std::max(back, kPutWithin - ToEm(first, start_).x);
  SweepAlong(WeaveFrom(first, -back, -kBefore - kWeave), Errand::kLineStart);
}

void Reader::LookThroughLineBegin() { LookThroughGap(-kLookBack, -kBefore, AfterGap::kLineBegin); }

std::vector<ReadToken> Reader::Pending() const {
  std::vector<ReadToken> tokens;
  std::optional<double> expected;  // where the next sign begins, as the line runs
  for (const SignRead& read : line_) {
    if (read.guide) continue;
    const SignPlace here{line_.front().guess.place.origin, size_, turn_};
    const double x = Ahead(here, read.guess.place.origin);
    const double begins = leftwards_ ? x - WidthOf(read.guess) : x;
    if (expected && begins - *expected > 0.6 * knowledge_.space) {
      tokens.push_back({ReadToken::Kind::kSpace, 0, 1, read.time, read.guess.place});
    }
    const bool known = read.guess.sign != SignGuess::kUnknown;
    tokens.push_back({known ? ReadToken::Kind::kSign : ReadToken::Kind::kUnknown,
                      known ? knowledge_.shapes->GlyphOf(read.guess.sign) : 0,
                      read.guess.probability, read.time, read.guess.place});
    expected = x + WayBehind(read);
  }
  return tokens;
}

/// A guide line ends its line of text and leads to where the next one begins, which runs the other
/// way.
bool Reader::TakeGuide() {
  constexpr double kMiddle = 0.5, kWithin = 0.3;  // of a line, where guides begin and end
  if (errand_ != Errand::kNextSign || line_.empty()) return false;
  const SignPlace here = Expected();
  const std::optional<GuideLine> guide = FitGuide(evidence_.grooves, here);
  if (!guide) return false;
  if (std::abs(ToEm(here, guide->lower).y - kMiddle) < kWithin && line_.back().guide) {
    const std::vector<FeltPoint> felt = evidence_.grooves;  // the one that led here
    SearchBeyond(felt);
    return true;
  }
  if (std::abs(ToEm(here, guide->upper).y - kMiddle) > kWithin) return false;
  if (guide->bulges_right == leftwards_) return false;
  for (const SignRead& read : line_) {
    if (read.guess.sign != SignGuess::kUnknown) guide_gap_ = GapOf(read.guess.sign);
  }
  EndLine();
  guided_ = true;
  leftwards_ = guide->bulges_right;
  SignRead led;
  led.guide = true;
  led.guess.place = {guide->lower, size_, turn_};
  led.guess.place.origin = FromEm(led.guess.place, {0, -kMiddle});
  line_.push_back(led);
  line_size_new_ = false;
  ForgetSign();
  unknowns_ = 0;
  SearchNext();
  return true;
}

}  // namespace moontrace

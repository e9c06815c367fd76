// How a reader finds its way over a page: from sign to sign and from line to line.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "sim/reader/reader.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20; in em unless said.
constexpr double kWide = 0.6;       ///< beyond a space, where one more may be
constexpr double kTellsSize = 0.6;  ///< a smaller sign says little of the size
constexpr double kSameSign = 0.4;   ///< nearer signs are one
constexpr int kNoMoreSkips = 1000;
constexpr double kTurnSpread = 0.03;  ///< of lines, before they are felt [rad]
constexpr double kSoonMet = 0.35;     ///< below where it could begin, of a line without more space
constexpr double kLeftOfLine = -0.2, kRightOfFirst = 1.6;  ///< between them signs begin and are
constexpr double kInBars = 0.25;     ///< right of where any bar begins, a hyphen's middle
constexpr double kTopOfBars = 0.75;  ///< so low that a hand that lands there meets no sign above
constexpr double kDown = 0.2;        ///< each sweep between them; less than a dot's height
constexpr double kSameLine = 0.5;    ///< nearer to a line it is the same
constexpr double kTooNear = 0.95;    ///< lines run into each other
constexpr int kMostSkips = 5;        ///< of what is the line above again, or no line
constexpr double kLowered = 0.1;     ///< it is looked for so much lower then
constexpr double kLower = 0.3;       ///< below a line another begins at least so much lower
constexpr int kMostRounds = 3;       ///< of lines that do not: it goes round in what it has read
constexpr double kDeepest = 4.0;     ///< the next line lies no deeper

double Across(const SignPlace& from, glm::dvec2 p) { return ToEm(from, p).y; }

}  // namespace

PlacePrior Reader::PriorNow() const {
  PlacePrior prior;
  prior.sizes = sizes_;
  prior.size_logs = size_logs_;
  prior.other_sizes = OtherSizes();
  prior.turns = {turn_};
  prior.whole = signs_ == 0 && legs_ > 1;
  if (signs_ < 4) {
    const double spread = signs_ == 0 ? 1.3 * kTurnSpread : 0.7 * kTurnSpread;
    prior.turns = {turn_ - spread, turn_, turn_ + spread};
  }
  if (!line_.empty() && errand_ == Errand::kNextSign) {
    const SignPlace next = Expected();
    prior.leftwards = leftwards_;
    const double spaces = std::floor((Ahead(next, entry_) - kWide) / knowledge_.space);
    const bool far = spaces >= 1;
    const double from = far ? spaces * knowledge_.space : 0;
    prior.origins = {AtAhead(next, from, 0), AtAhead(next, from + knowledge_.space, 0)};
    prior.along = signs_ < 4 ? 0.15 : 0.08;
    prior.across = signs_ < 4 ? 0.10 : 0.04;
    if (line_.back().guide) prior.along = 0.3;
    if (far) prior.along = 0.5;
    if (unknowns_ > 0) {  // it may have lost its place
      prior.along = 0.5;
      prior.across = 0.15;
    }
    if (line_.back().guide) prior.across = 0.15;
    prior.along = std::hypot(prior.along, knowledge_.unsure / size_);
    prior.across = std::hypot(prior.across, knowledge_.unsure / size_);
  } else if (!line_.empty()) {
    const SignPlace& first = line_.front().guess.place;
    const double back = std::abs(ToEm(first, entry_).x);
    prior.origins = {first.origin};
    prior.along = std::max(2.0, back);
    // farther back a turn that is hardly known carries the line up or down
    const double turned = signs_ < 4 ? 0.5 * kTurnSpread * std::max(0.0, back - kLookBack) : 0;
    prior.across = std::hypot(0.10, turned);
  } else if (line_starts_.size() > 1) {
    const glm::dvec2 pitch = (line_starts_.back().origin - line_starts_.front().origin) /
                             static_cast<double>(line_starts_.size() - 1);
    prior.origins = {line_starts_.back().origin + pitch};
    prior.along = 2;
    prior.across = 1;
  }
  return prior;
}

/// A sign's size by how far apart its grooves were felt, which a fit takes for too large: ends that
/// were not felt cost it nothing. Where walls alone tell of grooves, what was felt reaches too far
/// or not far enough, and the fit is better. None of a small sign.
std::optional<double> Reader::FeltSize(const SignGuess& read) const {
  constexpr double kWander = 0.6;  // of an unsure place, over a sign
  Box felt;
  const EmFrame frame(read.place);
  for (const FeltPoint& groove : evidence_.grooves) {
    if (!groove.crossed) Include(felt, frame.To(groove.p));
  }
  const Box& box = knowledge_.shapes->Bounds(read.sign);
  const glm::dvec2 extent = felt.max - felt.min, true_extent = box.max - box.min;
  double share = 0;
  for (int i = 0; i < 2; ++i) {
    if (true_extent[i] > kTellsSize) share = std::max(share, extent[i] / true_extent[i]);
  }
  if (share <= 0) return std::nullopt;
  if (!knowledge_.feels_height) return read.place.size;
  const double size = share * read.place.size - kWander * knowledge_.unsure;
  // within what it was told: a very unsure hand feels signs of no size at all
  return std::clamp(size, knowledge_.least_size,
                    std::max(1.0, knowledge_.heading_scale) * knowledge_.greatest_size);
}

/// A little above the middle of what the first signs say, some of which were not felt to their
/// ends; the more of them, the less it looks aside.
void Reader::LearnSize(double size) {
  constexpr std::size_t kCounted = 30;
  constexpr double kRank = 0.6;
  size_logs_.clear();
  if (knowledge_.least_size == knowledge_.greatest_size) return;
  if (felt_sizes_.size() < kCounted) felt_sizes_.push_back(size);
  std::vector<double> sorted = felt_sizes_;
  std::sort(sorted.begin(), sorted.end());
  size_ = sorted[static_cast<std::size_t>(kRank * static_cast<double>(sorted.size()))];
  constexpr double kSpreads[] = {0.15, 0.09, 0.06};
  const double spread = felt_sizes_.size() <= 3 ? kSpreads[felt_sizes_.size() - 1] : 0.025;
  sizes_.clear();
  for (double off = -spread; off < 1.01 * spread; off += std::max(0.025, spread / 3)) {
    sizes_.push_back((1 + off) * size_);
  }
}

/// Whether the groove that was met may lie deeper than a next line's top: headings have more space
/// before and behind them than other lines.
bool Reader::BelowASpace() const {
  if (line_starts_.size() < 2) return true;
  const SignPlace& above = line_starts_.back();
  return -ToEm(above, entry_).y > LeastPitch() / above.size - 1 + kSoonMet;
}

/// A line's first sign may be a heading's, or that of other lines behind one; if it is, the second
/// one may tell that it was not.
std::vector<double> Reader::OtherSizes() const {
  std::vector<double> sizes;
  if (knowledge_.heading_scale == 1 || line_starts_.empty() || line_.size() > 1) return sizes;
  if (line_.empty() ? !BelowASpace() : !line_size_new_) return sizes;
  for (const double scale : {knowledge_.heading_scale, 1 / knowledge_.heading_scale}) {
    for (const double size : sizes_) sizes.push_back(scale * size);
  }
  return sizes;
}

/// From a heading's size to that of other lines, or back, if that is nearer to a sign's.
void Reader::LearnLineSize(double size) {
  const bool first = line_.size() == 1;
  if (knowledge_.heading_scale == 1 || line_starts_.empty()) return;
  if (!first && (line_.size() > 2 || !line_size_new_)) return;
  double nearest = 1;
  for (const double scale : {knowledge_.heading_scale, 1 / knowledge_.heading_scale}) {
    const double off = std::abs(std::log(size / (scale * size_)));
    if (off < std::abs(std::log(size / (nearest * size_)))) nearest = scale;
  }
  line_size_new_ = first && nearest != 1;
  size_ *= nearest;
  for (double& one : sizes_) one *= nearest;
  for (double& one : felt_sizes_) one *= nearest;
}

/// From one sign of a line to another [m].
void Reader::LearnTurn(glm::dvec2 way) {
  across_ += way.x * way.y;
  along_ += way.x * way.x;
  // as sure of it before as a few signs would make it
  const double spread = 0.03 * size_ / kTurnSpread;
  turn_ = across_ / (along_ + spread * spread);
}

/// What the newest sign says of size, turn and gaps.
void Reader::LearnFrame() {
  const SignGuess& read = line_.back().guess;
  if (read.sign == SignGuess::kUnknown) return;
  ++signs_;
  widest_gap_ = std::max(widest_gap_, far_);
  LearnLineSize(read.place.size);
  if (const std::optional<double> size = FeltSize(read)) LearnSize(*size);
  if (line_.size() < 2 || line_[line_.size() - 2].guide) return;
  const SignGuess& before = line_[line_.size() - 2].guess;
  LearnTurn(read.place.origin - before.place.origin);
  if (before.sign == SignGuess::kUnknown) return;
  const SignGuess& left = leftwards_ ? read : before;
  const SignGuess& right = leftwards_ ? before : read;
  double gap = ToEm(left.place, right.place.origin).x - knowledge_.shapes->Advance(left.sign);
  if (leftwards_) gap += GapOf(left.sign) - GapOf(right.sign);
  const double bias = gap > 0.7 * knowledge_.space ? gap - knowledge_.space : gap;
  if (std::abs(bias) > 0.3) return;
  ++gaps_;
  gap_bias_ += (bias - gap_bias_) / std::min(gaps_ + 2, 12);
}

void Reader::Accept() {
  SignRead read;
  read.guess = belief_.front();
  read.guess.probability = Sureness();
  if (read.guess.sign == SignGuess::kUnknown) {
    read.guess.place = {FeltBox().min, size_, turn_};
    if (errand_ == Errand::kLineStart) {  // on the base line, where it was felt
      const SignPlace& first = line_.front().guess.place;
      read.guess.place.origin = FromEm(first, {ToEm(first, FeltBox().min).x, 0});
    } else if (!line_.empty()) {
      read.guess.place = Expected();
      if (leftwards_) read.guess.place.origin = AtAhead(read.guess.place, kBeyond, 0);
    }
  }
  read.time = news_ = now_;
  if (errand_ == Errand::kNextLine && IsInLastLine(read.guess.place)) return SearchNextLine();
  if (errand_ == Errand::kNextLine && IsTooNear(read.guess.place)) {
    return SearchNextLine(std::min(kDeepest, kLowered - Across(line_starts_.back(), entry_)));
  }
  if (errand_ == Errand::kNextLine) {
    const std::optional<double> skipped = SkippedLine(read.guess.place);
    if (skipped && LookForSkipped(*skipped)) return;
  }
  bool again = false;
  if (errand_ == Errand::kLineStart) {
    const SignPlace& first = line_.front().guess.place;
    again = ToEm(first, read.guess.place.origin).x > -kSameSign;
    if (!again) {
      if (read.guess.sign != SignGuess::kUnknown) LearnTurn(first.origin - read.guess.place.origin);
      line_.insert(line_.begin(), read);
    }
  } else {
    const bool known = read.guess.sign != SignGuess::kUnknown;
    if (known && unknowns_ > 0 && !line_.empty() && ShareOf(read.guess, unknown_) > 0.5) {
      line_.pop_back();  // it was this sign, felt badly
    }
    line_.push_back(read);
    LearnFrame();
  }
  unknown_ = evidence_.grooves;
  ForgetSign();
  random_phase_ = random_.Uniform() < 0.5;
  unknowns_ = read.guess.sign == SignGuess::kUnknown ? unknowns_ + 1 : 0;
  if (StartAnew()) return;
  const bool at_start = errand_ == Errand::kNextLine && IsAtMargin(read.guess.place);
  if (errand_ == Errand::kNextSign || at_start) {
    SearchNext();
  } else if (again) {
    BeginLine();
  } else {
    SearchLineStart();
  }
}

/// Whether what was taken for the next line's is the last line's, whose height it tells then: that
/// of its first sign may have been wrong.
bool Reader::IsInLastLine(const SignPlace& place) {
  SignPlace& last = line_starts_.back();
  const double off = Across(last, place.origin);
  if (std::abs(off) > kSameLine || skips_ >= kMostSkips) return false;
  ++skips_;
  last.origin = FromEm(last, {0, off - kLowered});
  ForgetSign();
  return true;
}

/// Whether what was taken for the next line's runs into the last one, as no two lines do where the
/// size is known: then it is part of a sign further down.
bool Reader::IsTooNear(const SignPlace& place) {
  constexpr std::size_t kKnown = 4;  // signs
  // of a heading's letters an em is larger than of the line below it
  const double too_near = kTooNear / std::max(1.0, knowledge_.heading_scale);
  const double off = Across(line_starts_.back(), place.origin);
  if (off > -kSameLine || off < -too_near || skips_ >= kMostSkips) return false;
  if (felt_sizes_.size() < kKnown) return false;
  ++skips_;
  ForgetSign();
  return true;
}

/// The least distance between two lines so far [m]; infinite where there was only one.
double Reader::LeastPitch() const {
  double pitch = INFINITY;
  for (std::size_t i = 1; i < line_starts_.size(); ++i) {
    const SignPlace& start = line_starts_[i];
    const double down = Across(start, line_starts_[i - 1].origin);
    if (down > kLower) pitch = std::min(pitch, down * start.size);
  }
  return pitch;
}

/// How far below the last line one is expected that was skipped before this; none if none has room.
/// Where there was only one line, the next may be the second or the third.
std::optional<double> Reader::SkippedLine(const SignPlace& place) const {
  constexpr double kRoom = 1.5;      // pitches
  constexpr double kTwoLines = 2.4;  // of a single pitch few pages have so much [em]
  const double down = Across(place, line_starts_.back().origin) * place.size;
  const double pitch = LeastPitch();
  if (std::isfinite(pitch)) return down > kRoom * pitch ? std::optional(pitch) : std::nullopt;
  return down > kTwoLines * size_ ? std::optional(0.5 * down) : std::nullopt;
}

/// The search for the next line goes over its first signs only, and may slip through between them:
/// where a line is expected it looks once more, from where lines begin and farther along.
bool Reader::LookForSkipped(double pitch) {
  constexpr double kFar = 6;
  if (skipped_ != Skipped::kUnknown || !std::isfinite(pitch)) return false;
  skipped_ = Skipped::kLooking;
  ForgetSign();
  SignPlace expected = line_starts_.back();
  double margin = 0;
  for (const SignPlace& start : line_starts_) {
    margin = std::min(margin, ToEm(expected, start.origin).x);
  }
  expected.origin = FromEm(expected, {margin, -pitch / expected.size});
  SweepAlong(WeaveFrom(expected, -kBefore, kFar), Errand::kNextLine);
  return true;
}

/// Whether a line's sign stands where the leftmost lines so far began, of which there must be two:
/// a single one may have been set in or out.
bool Reader::IsAtMargin(const SignPlace& place) const {
  constexpr double kNear = 0.3;  // [em]; no sign and its gap are so narrow
  double margin = INFINITY;
  for (const SignPlace& start : line_starts_)
    margin = std::min(margin, ToEm(place, start.origin).x);
  const auto is_near = [&](const SignPlace& start) {
    return ToEm(place, start.origin).x < margin + kNear;
  };
  return std::count_if(line_starts_.begin(), line_starts_.end(), is_near) > 1 && margin > -kNear;
}

/// From the line's first sign on; what it met further right before may have gaps.
void Reader::BeginLine() {
  line_.erase(line_.begin() + 1, line_.end());
  evidence_.flats.clear();
  SearchNext();
}

/// From where the hand was put to and fro, some signs' width and downwards; where nothing was met
/// so, a wider way, since the line may be set in.
void Reader::SearchFirstLine() {
  constexpr double kFar = 4, kFarther = 12;
  const double above = knowledge_.face ? 0 : kAboveHand;
  const double a = knowledge_.least_size;
  std::vector<glm::dvec2> way;
  constexpr int kTurns = 64;
  way.reserve(kTurns);
  for (int i = 0; i < kTurns; ++i) {
    way.push_back(start_ +
                  a * glm::dvec2(i % 2 == 0 ? -0.5 : (wider_ ? kFarther : kFar), above - 0.2 * i));
  }
  SweepAlong(std::move(way), Errand::kFirstLine);
}

void Reader::SearchNextLine(double from) {
  const SignPlace above = line_starts_.back();
  // To and fro over its first sign or two, slanting, so that bars are met as well. A short one that
  // all these pass above and below lies across a way straight down; where the pitch is known
  // LookForSkipped finds it.
  std::vector<glm::dvec2> way;
  if (straight_) {
    way = {FromEm(above, {kInBars, -kTopOfBars}), FromEm(above, {kInBars, -kTopOfNext - kDeepest})};
    return SweepAlong(std::move(way), Errand::kNextLine);
  }
  double x = kLeftOfLine;
  for (double y = -from; y > -kTopOfNext - kDeepest; y -= kDown) {
    way.push_back(FromEm(above, {x, y}));
    x = x == kLeftOfLine ? kRightOfFirst : kLeftOfLine;
  }
  SweepAlong(std::move(way), Errand::kNextLine);
}

void Reader::Missed() {
  if (in_gap_) return LeaveGap();
  switch (errand_) {
    case Errand::kFirstLine:
    case Errand::kNextLine:
      if (skipped_ == Skipped::kLooking) {  // none was skipped
        skipped_ = Skipped::kNone;
        return SearchNextLine();
      }
      if (first_skipped_ && skips_ < kNoMoreSkips) {  // there was nothing but that
        skips_ = kNoMoreSkips;
        return SweepAcross(*first_skipped_);
      }
      if (skips_ == kNoMoreSkips) {  // nor there
        ++skips_;
        errand_ == Errand::kFirstLine ? SearchFirstLine() : SearchNextLine();
        return;
      }
      if (errand_ == Errand::kFirstLine && !std::exchange(wider_, true)) return SearchFirstLine();
      if (errand_ == Errand::kNextLine && LookForSkipped(LeastPitch())) return;
      if (errand_ == Errand::kNextLine && line_starts_.size() == 1 &&
          !std::exchange(straight_, true)) {
        return SearchNextLine();
      }
      if (top_) return BeginAtTop();  // nothing is below
      phase_ = Phase::kDone;
      return;
    case Errand::kLineStart:
      LookThroughLineBegin();
      return;
    case Errand::kNextSign:
      LookThroughLineEnd();
      return;
  }
}

/// Where the line's first sign stands, at the middle height of all its signs: one of dots may be
/// taken to stand too high. Of one that runs to the left, below the start of the line above.
SignPlace Reader::StartOfLine() const {
  const bool led = line_.front().guide && line_.size() > 1;
  SignPlace start = line_[led ? 1 : 0].guess.place;
  start.size = size_;
  start.turn = turn_;
  std::vector<double> heights;
  for (const SignRead& read : line_) {
    if (read.guess.sign == SignGuess::kUnknown) continue;
    heights.push_back(Across(start, read.guess.place.origin));
  }
  if (heights.empty()) heights.push_back(0);
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  const double x = leftwards_ ? ToEm(start, line_starts_.back().origin).x : 0;
  start.origin = FromEm(start, {x, *middle});
  return start;
}

void Reader::LeaveLine() {
  if (top_) return BeginAtTop();
  EndLine();
  if (rounds_ < kMostRounds) return SearchNextLine();
  phase_ = Phase::kDone;
}

void Reader::EndLine() {
  news_ = now_;
  const std::vector<ReadToken> line = Pending();
  if (!line.empty()) {
    tokens_.insert(tokens_.end(), line.begin(), line.end());
    tokens_.push_back({ReadToken::Kind::kLineEnd, 0, 1, now_, line_.back().guess.place});
    const SignPlace start = StartOfLine();
    const bool lower =
        std::all_of(line_starts_.begin(), line_starts_.end(),
                    [&](const SignPlace& one) { return Across(one, start.origin) < -kLower; });
    line_starts_.push_back(start);
    rounds_ = lower ? 0 : rounds_ + 1;
  }
  farthest_ = std::max(farthest_, Along(Expected().origin));
  line_.clear();
  leftwards_ = straight_ = false;
  far_ = 0;
  skips_ = 0;
  first_skipped_.reset();
  skipped_ = Skipped::kUnknown;
  evidence_.flats.clear();
}

}  // namespace moontrace

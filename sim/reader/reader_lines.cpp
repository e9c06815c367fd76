// How a reader finds its way over a page: from sign to sign and from line to line.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "sim/reader/reader.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20; in em unless said.
constexpr double kBandLow = 0.14, kBandHigh = 0.62;  ///< of the weave over a line
constexpr double kWeave = 0.145;                     ///< half its period
constexpr double kBefore = 0.25;                     ///< it begins so far left of what is expected
constexpr double kBeyond = 1.15;     ///< a sign begins at its left edge plus this at most
constexpr double kLookBack = 3.2;    ///< left of a line's first sign another may lie so far off
constexpr double kDotWithin = 0.35;  ///< dots at a sign's left edge are met by then
constexpr double kGapFrom = -0.15;   ///< a dot may stick out at a sign's left edge
constexpr double kGapStep = 0.12;
constexpr double kLowEdge = 0.05, kHighEdge = 0.91;  ///< where marks and bars are
constexpr double kEdge = 0.12;                       ///< swept to either side of an edge
constexpr double kRoomForASign = 0.75;               ///< without a groove
constexpr double kTellsSize = 0.6;                   ///< a smaller sign says little of the size
constexpr double kSameSign = 0.4;                    ///< nearer signs are one
constexpr int kMostRestarts = 3;
constexpr int kNoMoreSkips = 1000;
constexpr double kTurnSpread = 0.03;  ///< of lines, before they are felt [rad]
/// Below a base line the next line's signs begin there, however far apart the lines before were:
/// behind a paragraph's space or a heading they are nearer again.
constexpr double kTopOfNext = 0.45;
constexpr double kSoonMet = 0.35;  ///< below where it could begin, of a line without more space
constexpr double kLeftOfLine = -0.2, kRightOfFirst = 1.6;  ///< between them signs begin and are
constexpr double kDown = 0.2;     ///< each sweep between them; less than a dot's height
constexpr int kMostSkips = 5;     ///< of what is the line above again
constexpr double kLowered = 0.1;  ///< it is looked for so much lower then
constexpr double kLower = 0.3;    ///< below a line another begins at least so much lower
constexpr int kMostRounds = 3;    ///< of lines that do not: it goes round in what it has read
constexpr double kDeepest = 4.0;  ///< the next line lies no deeper

double Across(const SignPlace& from, glm::dvec2 p) { return ToEm(from, p).y; }

}  // namespace

/// Where the next sign of the line begins if no space comes before it.
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
    mean += share * Across(place, read.place.origin);
    weight += share;
  }
  if (weight > 0) mean /= weight;
  const double advance = last.sign == SignGuess::kUnknown
                             ? kBeyond
                             : knowledge_.shapes->Advance(last.sign) + gap_bias_;
  place.origin = FromEm(place, {advance, mean});
  return place;
}

PlacePrior Reader::PriorNow() const {
  PlacePrior prior;
  prior.sizes = sizes_;
  prior.size_logs = size_logs_;
  prior.other_sizes = OtherSizes();
  prior.turns = {turn_};
  if (signs_ < 4) {
    const double spread = signs_ == 0 ? 1.3 * kTurnSpread : 0.7 * kTurnSpread;
    prior.turns = {turn_ - spread, turn_, turn_ + spread};
  }
  if (!line_.empty() && errand_ == Errand::kNextSign) {
    const SignPlace next = Expected();
    prior.origins = {next.origin, FromEm(next, {knowledge_.space, 0})};
    prior.along = signs_ < 4 ? 0.15 : 0.08;
    prior.across = signs_ < 4 ? 0.10 : 0.04;
    if (unknowns_ > 0) {  // it may have lost its place
      prior.along = 0.5;
      prior.across = 0.15;
    }
    prior.along = std::hypot(prior.along, knowledge_.unsure / size_);
    prior.across = std::hypot(prior.across, knowledge_.unsure / size_);
  } else if (!line_.empty()) {
    prior.origins = {line_.front().guess.place.origin};
    prior.along = 2;
    prior.across = 0.10;
  } else if (line_starts_.size() > 1) {
    const glm::dvec2 pitch = (line_starts_.back().origin - line_starts_.front().origin) /
                             static_cast<double>(line_starts_.size() - 1);
    prior.origins = {line_starts_.back().origin + pitch};
    prior.along = 2;
    prior.across = 1;
  }
  return prior;
}

/// The middle of what the first signs say; the more of them, the less it looks aside.
void Reader::LearnSize(double size) {
  constexpr std::size_t kCounted = 15;
  size_logs_.clear();
  if (knowledge_.least_size == knowledge_.greatest_size) return;
  if (felt_sizes_.size() < kCounted) felt_sizes_.push_back(size);
  std::vector<double> sorted = felt_sizes_;
  std::sort(sorted.begin(), sorted.end());
  size_ = 0.5 * (sorted[sorted.size() / 2] + sorted[(sorted.size() - 1) / 2]);
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
  LearnLineSize(read.place.size);
  const glm::dvec2 extent = (FeltBox().max - FeltBox().min) / read.place.size;
  if (std::max(extent.x, extent.y) > kTellsSize) LearnSize(read.place.size);
  if (line_.size() < 2) return;
  const SignGuess& before = line_[line_.size() - 2].guess;
  LearnTurn(read.place.origin - before.place.origin);
  if (before.sign == SignGuess::kUnknown) return;
  const double gap =
      ToEm(before.place, read.place.origin).x - knowledge_.shapes->Advance(before.sign);
  const double bias = gap > 0.7 * knowledge_.space ? gap - knowledge_.space : gap;
  if (std::abs(bias) > 0.3) return;
  ++gaps_;
  gap_bias_ += (bias - gap_bias_) / std::min(gaps_ + 2, 12);
}

/// A way that crosses every sign of a line, between two distances from where the next one is
/// expected [em].
std::vector<glm::dvec2> Reader::Weave(double from, double to) const {
  return WeaveFrom(Expected(), from, to);
}

std::vector<glm::dvec2> Reader::WeaveFrom(const SignPlace& place, double from, double to) const {
  std::vector<glm::dvec2> way;
  bool high = random_phase_;
  for (double x = from; x < to + kWeave; x += kWeave, high = !high) {
    way.push_back(FromEm(place, {x, high ? kBandHigh : kBandLow}));
  }
  return way;
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
    }
  }
  read.time = news_ = now_;
  if (errand_ == Errand::kNextLine && IsInLastLine(read.guess.place)) return SearchNextLine();
  if (errand_ == Errand::kNextLine && SkippedALine(read.guess.place) && LookForSkipped()) return;
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
  evidence_.grooves.clear();
  evidence_.flats.clear();
  crossings_ = tries_ = circles_ = 0;
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
  constexpr double kSameLine = 0.5;  // [em]
  SignPlace& last = line_starts_.back();
  const double off = Across(last, place.origin);
  if (std::abs(off) > kSameLine || skips_ >= kMostSkips) return false;
  ++skips_;
  last.origin = FromEm(last, {0, off - kLowered});
  evidence_.grooves.clear();
  evidence_.flats.clear();
  crossings_ = tries_ = circles_ = 0;
  return true;
}

/// The least distance between two lines so far [m]; infinite where there was only one.
double Reader::LeastPitch() const {
  double pitch = INFINITY;
  for (std::size_t i = 1; i < line_starts_.size(); ++i) {
    pitch = std::min(pitch, glm::distance(line_starts_[i].origin, line_starts_[i - 1].origin));
  }
  return pitch;
}

/// Whether a line has room between the last one and this.
bool Reader::SkippedALine(const SignPlace& place) const {
  constexpr double kRoom = 1.5;  // pitches
  return Across(place, line_starts_.back().origin) * place.size > kRoom * LeastPitch();
}

/// The search for the next line goes over its first signs only, and may slip through between them:
/// where a line is expected it looks once more, farther along.
bool Reader::LookForSkipped() {
  constexpr double kFar = 4;
  const double pitch = LeastPitch();
  if (skipped_ != Skipped::kUnknown || !std::isfinite(pitch)) return false;
  skipped_ = Skipped::kLooking;
  evidence_.grooves.clear();
  evidence_.flats.clear();
  crossings_ = tries_ = circles_ = 0;
  SignPlace expected = line_starts_.back();
  expected.origin = FromEm(expected, {0, -pitch / expected.size});
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

/// From where the hand was put to and fro, a line's width and downwards.
void Reader::SearchFirstLine() {
  const double a = knowledge_.least_size;
  std::vector<glm::dvec2> way;
  constexpr int kTurns = 60;
  way.reserve(kTurns);
  for (int i = 0; i < kTurns; ++i) {
    way.push_back(start_ + a * glm::dvec2(i % 2 == 0 ? -0.5 : 4.0, -0.2 * i));
  }
  SweepAlong(std::move(way), Errand::kFirstLine);
}

/// What it took for signs leads nowhere: it begins the page again, a little lower.
bool Reader::StartAnew() {
  if (unknowns_ < 2 || signs_ > 3 || !line_starts_.empty() || restarts_ >= kMostRestarts) {
    return false;
  }
  ++restarts_;
  start_.y -= (0.1 + 0.2 * random_.Uniform()) * knowledge_.least_size;
  line_.clear();
  signs_ = unknowns_ = 0;
  skips_ = 0;
  felt_sizes_.clear();
  size_logs_.clear();
  gaps_ = 0;
  gap_bias_ = turn_ = across_ = along_ = 0;
  sizes_ = AllSizes(knowledge_);
  size_ = std::sqrt(knowledge_.least_size * knowledge_.greatest_size);
  SearchFirstLine();
  return true;
}

/// The next sign; after something unknown, right of all that was felt of it.
void Reader::SearchNext() {
  gap_to_ = kGapFrom;
  if (unknowns_ > 0) return SearchBeyond(unknown_);
  SweepAlong(Weave(-kBefore, knowledge_.space + kBeyond), Errand::kNextSign);
}

void Reader::SearchBeyond(const std::vector<FeltPoint>& grooves) {
  double right = -kBefore;
  const SignPlace next = Expected();
  for (const FeltPoint& groove : grooves) right = std::max(right, ToEm(next, groove.p).x + 0.15);
  evidence_.grooves.clear();
  evidence_.flats.clear();
  crossings_ = 0;
  SweepAlong(Weave(right, right + knowledge_.space + kBeyond + kBefore), Errand::kNextSign);
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
    way.push_back(FromEm(place, {x, high ? kLowEdge + kEdge : kLowEdge - kEdge}));
  }
  const std::size_t turn = way.size();
  for (double x = to; x > from - kGapStep; x -= kGapStep, high = !high) {
    way.push_back(FromEm(place, {x, high ? kHighEdge + kEdge : kHighEdge - kEdge}));
  }
  SweepAlong(std::move(way), errand_);
  in_gap_ = true;
  after_gap_ = after;
  gap_to_ = to;
  gap_turn_ = turn;
}

/// Whether this is the sign at which the gap ends, which may lean over it: the rest is looked
/// through then, left of what it met.
bool Reader::MetGapsEnd(glm::dvec2 entry) {
  const SignPlace place = Expected();
  const double x = ToEm(place, entry).x;
  if (after_gap_ != AfterGap::kNextSign || x < gap_to_ - kBefore) return false;
  std::size_t rest = std::max(next_, gap_turn_);
  while (rest < way_.size() && ToEm(place, way_[rest]).x > x - kBefore) ++rest;
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
  const double x = ToEm(Expected(), entry).x;
  if (x - std::max(gap_to_, 0.0) < kRoomForASign) return false;
  LookThroughGap(gap_to_, x - kBefore, AfterGap::kNextSign);
  return true;
}

void Reader::LeaveGap() {
  switch (after_gap_) {
    case AfterGap::kNextSign:
      SweepAlong(Weave(gap_to_ - 0.05, gap_to_ + knowledge_.space + kBeyond), Errand::kNextSign);
      return;
    case AfterGap::kLineEnd:
      EndLine();
      if (rounds_ < kMostRounds) return SearchNextLine();
      phase_ = Phase::kDone;
      return;
    case AfterGap::kLineBegin:
      BeginLine();
      return;
  }
}

/// Whether signs stand left of the line's first.
void Reader::SearchLineStart() {
  const SignPlace first{line_.front().guess.place.origin, size_, turn_};
  SweepAlong(WeaveFrom(first, -kLookBack, -kBefore - kWeave), Errand::kLineStart);
}

void Reader::SearchNextLine() {
  const SignPlace above = line_starts_.back();
  // to and fro over its first sign or two, slanting, so that bars are met as well
  std::vector<glm::dvec2> way;
  double x = kLeftOfLine;
  for (double y = -kTopOfNext; y > -kTopOfNext - kDeepest; y -= kDown) {
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
      if (skips_ > 0 && skips_ < kNoMoreSkips) {  // there was nothing but that
        skips_ = kNoMoreSkips;
        return SweepAcross(first_skipped_);
      }
      if (skips_ == kNoMoreSkips) {  // nor there
        ++skips_;
        errand_ == Errand::kFirstLine ? SearchFirstLine() : SearchNextLine();
        return;
      }
      if (errand_ == Errand::kNextLine && LookForSkipped()) return;
      phase_ = Phase::kDone;
      return;
    case Errand::kLineStart: {
      LookThroughGap(-kLookBack, -kBefore, AfterGap::kLineBegin);
      return;
    }
    case Errand::kNextSign:
      LookThroughGap(gap_to_, gap_to_ + knowledge_.space + kDotWithin - kGapFrom,
                     AfterGap::kLineEnd);
      return;
  }
}

/// Where the line's first sign stands, at the middle height of all its signs: one of dots may be
/// taken to stand too high.
SignPlace Reader::StartOfLine() const {
  SignPlace start = line_.front().guess.place;
  start.size = size_;
  start.turn = turn_;
  std::vector<double> heights;
  for (const SignRead& read : line_) {
    if (read.guess.sign == SignGuess::kUnknown) continue;
    heights.push_back(Across(start, read.guess.place.origin));
  }
  if (heights.empty()) return start;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  start.origin = FromEm(start, {0, *middle});
  return start;
}

std::vector<ReadToken> Reader::Pending() const {
  std::vector<ReadToken> tokens;
  std::optional<double> expected;
  for (const SignRead& read : line_) {
    const SignPlace here{line_.front().guess.place.origin, size_, turn_};
    const double x = ToEm(here, read.guess.place.origin).x;
    if (expected && x - *expected > 0.6 * knowledge_.space) {
      tokens.push_back({ReadToken::Kind::kSpace, 0, 1, read.time, read.guess.place});
    }
    const bool known = read.guess.sign != SignGuess::kUnknown;
    tokens.push_back({known ? ReadToken::Kind::kSign : ReadToken::Kind::kUnknown,
                      known ? knowledge_.shapes->GlyphOf(read.guess.sign) : 0,
                      read.guess.probability, read.time, read.guess.place});
    expected = x + (known ? knowledge_.shapes->Advance(read.guess.sign) + gap_bias_ : kBeyond);
  }
  return tokens;
}

void Reader::EndLine() {
  news_ = now_;
  const std::vector<ReadToken> line = Pending();
  tokens_.insert(tokens_.end(), line.begin(), line.end());
  tokens_.push_back({ReadToken::Kind::kLineEnd, 0, 1, now_, line_.back().guess.place});
  line_starts_.push_back(StartOfLine());
  const std::size_t lines = line_starts_.size();
  const bool lower =
      lines < 2 || Across(line_starts_[lines - 2], line_starts_.back().origin) < -kLower;
  rounds_ = lower ? 0 : rounds_ + 1;
  line_.clear();
  skips_ = 0;
  skipped_ = Skipped::kUnknown;
  evidence_.flats.clear();
}

}  // namespace moontrace

#include "sim/reader/hatch_reader.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "sim/reader/link_ink.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20. In em unless said.
constexpr double kGivesUp = 300;       ///< after so long without a sign or a line [s]
constexpr double kGivesUpFirst = 600;  ///< the same of the first line, gone over twice as high [s]
constexpr double kPerSecond = 14;      ///< widths of a ridge, over which it goes
constexpr double kColumn = 0.11;       ///< from one way across a line to the next
constexpr double kDotColumn = 0.08;    ///< the same where all signs are of dots
constexpr double kLean = 3;            ///< how far aside a way ends from where it begins [columns]
constexpr double kLinkedLean = 1;      ///< the same of linked letters
// Over how long it finds how far it strays aside [s]. A tip that dots turn away seems to stray.
constexpr double kLearn = 0.05, kDotLearn = 0.25;
constexpr double kSample = 0.25;     ///< from one felt place to the next, in widths
constexpr double kInk = 0.2;         ///< share of a ridge's height
constexpr double kInkTime = 0.004;   ///< [s]
constexpr double kFlat = 0.1;        ///< more is not flat paper
constexpr double kSlope = 0.2;       ///< more is a slope
constexpr double kDotSlope = 0.15;   ///< the same of raised dots, round which the tip slides
constexpr double kEdge = 0.2;        ///< beyond a line's ink it is hatched
constexpr double kEdgeUnsure = 0.3;  ///< the same of a line that is only expected
constexpr double kBefore = 0.5;      ///< left of where lines began
constexpr double kRow = 0.13;        ///< between ways that look for a line; less than a dot
constexpr double kAbove = 0.8;       ///< where its hand was put the search begins; not on a face
constexpr double kAcrossRows = 3;    ///< their length
constexpr double kDeepest = 4;       ///< the next line lies no deeper
constexpr double kToFrame = 10;      ///< so much of a line tells size and turn
constexpr double kToLine = 8;        ///< or height alone; the beginning may lack lower dots
constexpr double kLookAhead = 1.6;   ///< behind a sign that is decided
constexpr double kThinks = 0.3;      ///< after so much more was felt
constexpr double kBeginsLeft = 0.9;  ///< of its ink a sign begins at most
constexpr double kBeginsRight = 0.2;
constexpr double kUnknownSlack = 0.45;  ///< behind what is no sign
constexpr double kUnknownClaims = 0.6;  ///< share of ink that it accounts for
constexpr double kMetBeyond = 0.1;      ///< a line's ink, where it was met
constexpr double kSure = 0.98;          ///< of a sign that it does not go back to
constexpr double kAround = 0.2;         ///< a sign it goes over again
constexpr int kMostRestarts = 2;        ///< of the search for the first line
constexpr double kInside = 0.002;       ///< of a face's edges the hand stays [m]
constexpr double kLeastFit = 20;        ///< nats, else what was felt is no line
constexpr double kGreatestTurn = 3 * kDegree;

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
  lie_at_begin_ = lie_;
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

/// What the line says so far.
void HatchReader::Think() {
  thought_at_ = FeltTo();
  const double to_end = (belief_.widest() + knowledge_.space + 0.6) * size_;
  const bool ended = FeltTo() - (inked_ ? ink_to_ : 0) > to_end + (inked_ ? 0 : kBefore * size_);
  if (!inked_ && ended) {
    if (line_starts_.empty()) return SearchFirstLine(hatch_.origin.y - kRow * size_);
    return SearchNextLine(0.25 - belief_.bounds().min.y);
  }
  if (!inked_) return;
  if (knowledge_.link_depth > 0) MarkLinks(points_, knowledge_.width, knowledge_.link_depth);
  const double enough = line_starts_.empty() ? kToFrame * knowledge_.least_size : kToLine * size_;
  if (!framed_ && (ended || FeltTo() - ink_from_ > enough) && !FindFrame()) {
    if (line_starts_.empty()) return SearchFirstLine(met_.y - kRow * size_);
    phase_ = Phase::kDone;
    return;
  }
  if (!framed_) return;
  if (ended && line_starts_.empty()) LookAgain();
  while (ReadOn(ended)) {
  }
  if (ended && !GoBackToDoubts()) LineDone();
}

/// Over the signs of the line that are not sure, from side to side: ways up and down meet an
/// upright ridge but here and there, where it may be a dot, and pass beside dots. False if all are
/// sure. Linked letters were not read better by it, and a hand unsure of its place reads worse.
bool HatchReader::GoBackToDoubts() {
  if (knowledge_.link_depth > 0 || knowledge_.unsure > 0) return false;
  const Box& ink = belief_.bounds();
  const double row = dots_ ? kDotColumn : kRow;
  std::vector<glm::dvec2> way;
  for (const SignGuess& read : line_) {
    if (read.probability > kSure) continue;
    const bool known = read.sign != SignGuess::kUnknown;
    const double right = (known ? knowledge_.shapes->Advance(read.sign) : 1) + kAround;
    bool to_right = true;
    for (double y = ink.max.y; y > ink.min.y - row; y -= row, to_right = !to_right) {
      way.push_back(FromEm(read.place, {to_right ? -kAround : right, y}));
      way.push_back(FromEm(read.place, {to_right ? right : -kAround, y}));
    }
  }
  if (way.empty()) return false;
  felt_to_ = FromEm(hatch_, {FeltTo(), 0});
  SweepFrom(std::move(way), Errand::kDoubts);
  return true;
}

/// The line, with what was felt on going back.
void HatchReader::ReadAgain() {
  SetFrame(line_frame_);
  lie_ = lie_at_begin_;
  line_.clear();
  tokens_.resize(first_token_);
  while (ReadOn(true)) {
  }
}

LinePrior HatchReader::PriorNow() const {
  LinePrior prior;
  prior.next = frame_;
  prior.gap = lie_.gap_bias;
  prior.unsure = knowledge_.unsure;
  prior.anywhere = line_.empty();
  if (prior.anywhere) {
    prior.before = kBeginsLeft;
    prior.behind = kBeginsRight;
  } else if (line_.back().sign == SignGuess::kUnknown) {
    // how wide that was is not known
    prior.anywhere = true;
    prior.before = prior.behind = kUnknownSlack;
    prior.claimed = kUnknownClaims;
  } else {
    prior.claimed = 1;
    prior.left = line_.back().sign;
  }
  prior.links = links_.get();
  prior.felt_to = ToEm(frame_, FromEm(hatch_, {FeltTo(), 0})).x;
  return prior;
}

FrameRange HatchReader::RangeNow() {
  FrameRange range;
  range.met = met_;
  range.felt_to = FromEm(hatch_, {FeltTo(), 0});
  range.unsure = knowledge_.unsure;
  range.before = kBeginsLeft;
  range.behind = kBeginsRight;
  if (knowledge_.links && line_starts_.empty()) {
    range.links = [this](double size) { return LinksOf(size); };
  }
  return range;
}

/// Found anew where letters are of another size: what lies along a link changes by less than it is
/// wide.
std::shared_ptr<const LinkShapes> HatchReader::LinksOf(double size) {
  constexpr double kEqual = 0.01;
  if (links_ == nullptr || std::abs(size - links_size_) > kEqual * size) {
    links_ = knowledge_.links(size);
    links_size_ = size;
  }
  return links_;
}

/// Where the line's base lies, and on the first line how large its letters are and how they lie.
bool HatchReader::FindFrame() {
  FrameRange range = RangeNow();
  const Box& ink = belief_.bounds();
  const double middle = 0.5 * (ink.min.y + ink.max.y);
  range.from = expected_ ? middle - kEdgeUnsure : ink.min.y - kMetBeyond;
  range.to = expected_ ? middle + kEdgeUnsure : ink.max.y + kMetBeyond;
  range.sizes = {size_};
  range.turns = {turn_};
  if (line_starts_.empty()) {
    const double ratio = knowledge_.greatest_size / knowledge_.least_size;
    const int count = std::max(1, static_cast<int>(std::lround(std::log(ratio) / 0.04)));
    range.sizes.clear();
    for (int i = 0; i <= count; ++i) {
      range.sizes.push_back(knowledge_.least_size * std::pow(ratio, 1.0 * i / count));
    }
    range.turns = {-0.67 * kGreatestTurn, 0, 0.67 * kGreatestTurn};
  }
  const FrameFit found = FitFrame(belief_, points_, range);
  if (found.log_likelihood < kLeastFit) return false;
  framed_ = true;
  SetFrame(found.frame);
  return true;
}

void HatchReader::SetFrame(const SignPlace& frame) {
  frame_ = line_frame_ = frame;
  size_ = frame.size;
  turn_ = frame.turn;
  if (knowledge_.links) LinksOf(size_);
}

/// All of the first line tells more of its frame than its beginning did: a turn of a degree shows
/// at its end. By that it is made out again.
void HatchReader::LookAgain() {
  const FrameFit found = RefineFrame(belief_, points_, RangeNow(), line_frame_);
  if (found.log_likelihood < kLeastFit) return;
  SetFrame(found.frame);
  lie_ = lie_at_begin_ = {};
  line_.clear();
  tokens_.clear();
}

/// Decides on the next sign if enough of the line was felt behind it.
bool HatchReader::ReadOn(bool line_ended) {
  const LinePrior prior = PriorNow();
  const double ahead = belief_.widest() + kLookAhead;
  if (!line_ended && prior.felt_to < ahead + waits_) return false;
  const NextOnLine next = belief_.Next(points_, prior);
  if (next.end) return false;
  const double space = next.space ? knowledge_.space : 0;
  if (!line_ended && prior.felt_to < ahead + space) {
    waits_ = space;
    return false;
  }
  waits_ = 0;
  Take(next);
  return true;
}

void HatchReader::Take(const NextOnLine& next) {
  news_ = now_;
  if (next.space) tokens_.push_back({ReadToken::Kind::kSpace, 0, 1, now_, {}});
  ReadToken token;
  token.time = now_;
  token.probability = next.sign.probability;
  token.place = next.sign.place;
  const bool known = next.sign.sign != SignGuess::kUnknown;
  token.kind = known ? ReadToken::Kind::kSign : ReadToken::Kind::kUnknown;
  if (known) token.glyph = knowledge_.shapes->GlyphOf(next.sign.sign);
  tokens_.push_back(token);
  newest_ = {next.sign};
  LearnFrame(next.sign);
}

/// Height, turn and gaps, and from there where the next sign is expected.
void HatchReader::LearnFrame(const SignGuess& read) {
  constexpr double kHeightShare = 0.3;  // of a sign's own height
  constexpr double kTurnSpread = 0.01;  // before it is felt [rad]
  const bool known = read.sign != SignGuess::kUnknown;
  const double off = known ? ToEm(frame_, read.place.origin).y : 0;
  if (known && !line_.empty() && line_.back().sign != SignGuess::kUnknown) {
    const SignGuess& before = line_.back();
    const glm::dvec2 way = ToEm(before.place, read.place.origin);
    const double gap = way.x - knowledge_.shapes->Advance(before.sign);
    const double bias = gap > 0.7 * knowledge_.space ? gap - knowledge_.space : gap;
    if (std::abs(bias) < 0.3) {
      ++lie_.gaps;
      lie_.gap_bias += (bias - lie_.gap_bias) / std::min(lie_.gaps + 3, 20);
    }
  }
  line_.push_back(read);
  if (line_.size() > 3 && known) {
    const glm::dvec2 way = read.place.origin - line_.front().place.origin;
    lie_.across += way.x * (way.y - turn_ * way.x);
    lie_.along += way.x * way.x;
    const double few = 0.05 * size_ / kTurnSpread;
    const double turned = lie_.across / (lie_.along + few * few);
    turn_ += 0.2 * turned;
  }
  frame_ = read.place;
  frame_.size = size_;
  frame_.turn = turn_;
  const double advance = known ? knowledge_.shapes->Advance(read.sign) + lie_.gap_bias : 0.6;
  frame_.origin = FromEm(frame_, {advance, known ? (kHeightShare - 1) * off : 0});
  // the columns follow
  SignPlace hatch = frame_;
  hatch.size = 1;
  const double at = ToEm(hatch, FromEm(hatch_, {column_, 0})).x;
  const double ink = ToEm(hatch, FromEm(hatch_, {ink_to_, 0})).x;
  const double thought = ToEm(hatch, FromEm(hatch_, {thought_at_, 0})).x;
  hatch_ = hatch;
  column_ = at;
  ink_to_ = ink;
  thought_at_ = thought;
  low_ = (belief_.bounds().min.y - kEdge) * size_;
  high_ = (belief_.bounds().max.y + kEdge) * size_;
}

void HatchReader::LineDone() {
  news_ = now_;
  tokens_.push_back({ReadToken::Kind::kLineEnd, 0, 1, now_, {}});
  if (!line_.empty()) {
    SignPlace start = line_.front().place;
    start.turn = turn_;
    line_starts_.push_back(start);
  }
  if (line_starts_.empty()) {
    phase_ = Phase::kDone;
    return;
  }
  if (line_starts_.size() > 1) return HatchExpectedLine();
  SearchNextLine(0.25 - belief_.bounds().min.y);
}

}  // namespace moontrace

// What the hatching reader makes of what it felt: where a line lies, its signs, and which of them
// it goes over again.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "sim/reader/hatch_reader.h"
#include "sim/reader/link_ink.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20. In em unless said.
constexpr double kToFrame = 10;      ///< so much of a line tells size and turn
constexpr double kToLine = 8;        ///< or height alone; the beginning may lack lower dots
constexpr double kLookAhead = 1.6;   ///< behind a sign that is decided
constexpr double kBeginsLeft = 0.9;  ///< of its ink a sign begins at most
constexpr double kBeginsRight = 0.2;
constexpr double kUnknownSlack = 0.45;  ///< behind what is no sign
constexpr double kUnknownClaims = 0.6;  ///< share of ink that it accounts for
constexpr double kMetBeyond = 0.1;      ///< a line's ink, where it was met
constexpr double kSure = 0.98;          ///< of a sign that it does not go back to
constexpr double kAround = 0.2;         ///< a sign it goes over again
constexpr double kLeastFit = 20;        ///< nats, else what was felt is no line
constexpr double kGreatestTurn = 3 * kDegree;

}  // namespace

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
  setting_ = setting_at_begin_;
  line_.clear();
  tokens_.resize(first_token_);
  while (ReadOn(true)) {
  }
}

LinePrior HatchReader::PriorNow() const {
  LinePrior prior;
  prior.next = frame_;
  prior.gap = setting_.gap_bias;
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
  setting_ = setting_at_begin_ = {};
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
      ++setting_.gaps;
      setting_.gap_bias += (bias - setting_.gap_bias) / std::min(setting_.gaps + 3, 20);
    }
  }
  line_.push_back(read);
  if (line_.size() > 3 && known) {
    const glm::dvec2 way = read.place.origin - line_.front().place.origin;
    setting_.across += way.x * (way.y - turn_ * way.x);
    setting_.along += way.x * way.x;
    const double few = 0.05 * size_ / kTurnSpread;
    const double turned = setting_.across / (setting_.along + few * few);
    turn_ += 0.2 * turned;
  }
  frame_ = read.place;
  frame_.size = size_;
  frame_.turn = turn_;
  const double advance = known ? knowledge_.shapes->Advance(read.sign) + setting_.gap_bias : 0.6;
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

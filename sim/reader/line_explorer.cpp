#include "sim/reader/line_explorer.h"

#include <algorithm>
#include <cmath>

namespace moontrace {
namespace {

// Ours. In sizes unless said.
constexpr double kLearn = 0.25;   // over which it finds how far it strays aside [s]
constexpr double kInk = 0.3;      // share of a groove's depth
constexpr double kBehind = 0.75;  // behind a sign it goes on with columns: dots may follow
constexpr double kBeyond = 1.3;   // the next sign begins at most so much behind a space
constexpr double kBefore = 0.3;   // left of a sign found there it goes on with columns
constexpr double kNothing = 2.5;  // so much blank paper at a line's beginning holds nothing
constexpr double kSlant = 0.3;    // from one slanting way that looks for further signs to the next

}  // namespace

LineExplorer::LineExplorer(const ReaderKnowledge& knowledge, const LineExploration& how,
                           double tick)
    : how_(how),
      space_(knowledge.space * how.size),
      groove_depth_(knowledge.depth),
      hand_(knowledge, how.speed, kLearn, tick) {}

double LineExplorer::depth() const {
  const Felt& felt = hand_.calm();
  return felt.touching ? felt.depth : std::max(0.0, hand_.level() - felt.tip.z) / groove_depth_;
}

ReaderAction LineExplorer::Step(const ReaderInput& input) {
  hand_.Add(input);
  if (stage_ == Stage::kStart) Begin();
  if (done()) return hand_.Lifted();
  if (feels()) Notice();
  const ReaderAction action = hand_.Move([this] {
    if (stage_ == Stage::kColumns && ColumnsGoOn()) NextColumn();
  });
  if (hand_.ended()) GoOn();
  return action;
}

void LineExplorer::Begin() {
  stage_ = Stage::kColumns;
  const glm::dvec2 corner(hand_.felt().tip);
  left_ = x_ = corner.x - how_.margin;
  top_ = corner.y + how_.margin;
  bottom_ = y_ = corner.y - how_.height - how_.margin;
  ink_to_ = corner.x;
  lowest_ = top_;
  highest_ = bottom_;
  hand_.Go({{left_, top_}, {left_, bottom_}});
}

void LineExplorer::Notice() {
  if (depth() < kInk) return;
  inked_ = true;
  if (stage_ == Stage::kLook && place().x > x_) found_ = std::min(found_, place().x);
  ink_to_ = std::max(ink_to_, place().x);
  lowest_ = std::min(lowest_, place().y);
  highest_ = std::max(highest_, place().y);
}

bool LineExplorer::ColumnsGoOn() const {
  return x_ < ink_to_ + (inked_ ? kBehind : kNothing) * how_.size;
}

void LineExplorer::NextColumn() {
  x_ += how_.spacing;
  hand_.GoOnTo({x_, y_});
  y_ = y_ > bottom_ ? bottom_ : top_;
  hand_.GoOnTo({x_, y_});
}

/// All is felt that lies on the way so far.
void LineExplorer::GoOn() {
  if (stage_ == Stage::kRows) {
    stage_ = Stage::kDone;
  } else if (ColumnsGoOn()) {
    if (stage_ == Stage::kLook) x_ = std::max(x_, found_ - kBefore * how_.size);
    stage_ = Stage::kColumns;
    NextColumn();
  } else if (inked_ && stage_ == Stage::kColumns) {
    LookBeyond();
  } else {
    GoBackInRows();
  }
}

/// To the right, over the widest gap between two signs, up and down, which meets level strokes, and
/// straight back along the middle, which meets upright ones.
void LineExplorer::LookBeyond() {
  stage_ = Stage::kLook;
  const double far = found_ = ink_to_ + space_ + kBeyond * how_.size;
  bool down = y_ > bottom_;
  for (double x = x_; x < far; down = !down) {
    x += kSlant * how_.size;
    hand_.GoOnTo({x, down ? bottom_ : top_});
  }
  const double middle = (bottom_ + top_) / 2;
  hand_.GoOnTo({far, middle});
  hand_.GoOnTo({x_, middle});
}

/// Over what was felt; where nothing was, over all: a thin upright stroke may lie between columns.
void LineExplorer::GoBackInRows() {
  stage_ = Stage::kRows;
  const double right = inked_ ? ink_to_ + how_.margin : x_;
  const double top = inked_ ? std::min(top_, highest_ + how_.margin) : top_;
  const double bottom = inked_ ? std::max(bottom_, lowest_ - how_.margin) : bottom_;
  bool leftwards = true;
  for (double y = top; y > bottom; y -= how_.spacing) {
    hand_.GoOnTo({leftwards ? right : left_, y});
    hand_.GoOnTo({leftwards ? left_ : right, y});
    leftwards = !leftwards;
  }
}

}  // namespace moontrace

#pragma once

#include "sim/reader/hatching_hand.h"

namespace moontrace {

/// How a line is explored by one who knows no signs.
struct LineExploration {
  double size = 0;     ///< of the letters, which it was told [m]
  double height = 0;   ///< of lines of any signs, downwards from where the hand is put [m]
  double margin = 0;   ///< beyond that, and left of where the hand is put [m]
  double spacing = 0;  ///< between sweeps [m]
  double speed = 0;    ///< over the paper [m/s]
};

/// Feels a line of signs all over, whatever they are, and names none: up and down along the line,
/// a little further to the right each time, until nothing more comes; then from side to side, back
/// over all of it. Where the signs stop it looks whether others follow beyond a space. What was
/// felt is for its owner to gather. Its way grows as it goes: not for the haptic thread.
class LineExplorer {
 public:
  /// The hand will be put on the upper left corner of the line. `tick` [s].
  LineExplorer(const ReaderKnowledge& knowledge, const LineExploration& how, double tick);

  /// What the hand is to do next.
  ReaderAction Step(const ReaderInput& input);
  bool done() const { return stage_ == Stage::kDone; }
  /// The hand is on its way over the paper, whose level it knows.
  bool feels() const { return !done() && hand_.sweeps() && hand_.level_known(); }
  /// Where the tip is felt to be then, in the hand's frame [m].
  glm::dvec2 place() const { return hand_.calm().place; }
  /// Between these heights it means to stay [m].
  double bottom() const { return bottom_; }
  double top() const { return top_; }
  /// How deep in a groove, share of its depth: also of a tip that falls into one, so fast that it
  /// touches nothing just now.
  double depth() const;

 private:
  enum class Stage { kStart, kColumns, kLook, kRows, kDone };
  void Begin();
  void Notice();
  bool ColumnsGoOn() const;
  void NextColumn();
  void GoOn();
  void LookBeyond();
  void GoBackInRows();

  LineExploration how_;
  double space_ = 0;         ///< [m]
  double groove_depth_ = 0;  ///< [m]
  HatchingHand hand_;
  Stage stage_ = Stage::kStart;
  double left_ = 0, top_ = 0, bottom_ = 0;  ///< of what is explored [m]
  double x_ = 0, y_ = 0;                    ///< where the columns end so far [m]
  double found_ = 0;                        ///< where signs go on beyond a space [m]
  bool inked_ = false;
  double ink_to_ = 0, lowest_ = 0, highest_ = 0;  ///< of what was felt in the paper [m]
};

}  // namespace moontrace

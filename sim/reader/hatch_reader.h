#pragma once

#include <vector>

#include "sim/reader/hatching_hand.h"
#include "sim/reader/line_belief.h"
#include "sim/reader/line_frame.h"
#include "sim/reader/page_reader.h"
#include "sim/reader/touch_sense.h"

namespace moontrace {

/// Reads what cannot be followed, ridges, dots and linked letters: it goes up and down over each
/// line, a little further to the right each time, and makes out the signs from where it felt the
/// paper high or low; over signs that are not sure it goes again, from side to side. Looks for the
/// first line from where its hand is put, tells size, turn and height from that line's beginning,
/// goes on line by line, and ends where no further line comes. Its hand must feel its height.
class HatchReader final : public PageReader {
 public:
  /// `tick` [s]. The shapes have dots of Braille by their middles.
  HatchReader(const ReaderKnowledge& knowledge, double tick);

  ReaderAction Step(const ReaderInput& input) override;
  bool done() const override { return phase_ == Phase::kDone; }
  std::vector<ReadToken> tokens() const override { return tokens_; }
  std::vector<ReadToken> Pending() const override { return {}; }
  std::vector<SignGuess> belief() const override { return newest_; }
  ReaderActivity activity() const override;

 private:
  enum class Phase { kStart, kReads, kDone };
  enum class Errand { kFirstLine, kNextLine, kLine, kDoubts };

  // Shared by how it moves and how it reads; ours, chosen on seeds 1 to 20. In em.
  static constexpr double kDotColumn = 0.08;  ///< the same where all signs are of dots
  static constexpr double kEdge = 0.2;        ///< beyond a line's ink it is hatched
  static constexpr double kEdgeUnsure = 0.3;  ///< the same of a line that is only expected
  static constexpr double kBefore = 0.5;      ///< left of where lines began
  static constexpr double kRow = 0.13;  ///< between ways that look for a line; less than a dot

  /// What the signs of lines have told of how they follow each other.
  struct Setting {
    double gap_bias = 0;           ///< between signs, beyond the script's own [em]
    int gaps = 0;                  ///< seen
    double across = 0, along = 0;  ///< tangent sums for the turn [m^2]
  };
  /// It feels a line's signs.
  bool OnLine() const { return errand_ == Errand::kLine || errand_ == Errand::kDoubts; }
  ReaderAction Sweep();
  void SweepFrom(std::vector<glm::dvec2> way, Errand errand);
  std::vector<glm::dvec2> NextColumn();
  void Feel(const Felt& felt);
  void SearchFirstLine(double top);
  void SearchNextLine(double down);
  void BeginLine(glm::dvec2 ink);
  void HatchLine(const SignPlace& frame, double low, double high);
  void HatchExpectedLine();
  double Margin() const;
  double ColumnWidth() const;
  double Lean() const;
  double FeltTo() const;
  void Think();
  FrameRange RangeNow();
  std::shared_ptr<const LinkShapes> LinksOf(double size);
  bool FindFrame();
  void SetFrame(const SignPlace& frame);
  void LookAgain();
  LinePrior PriorNow() const;
  bool ReadOn(bool line_ended);
  bool GoBackToDoubts();
  void ReadAgain();
  void Take(const NextOnLine& next);
  void LearnFrame(const SignGuess& read);
  void LineDone();

  ReaderKnowledge knowledge_;
  std::shared_ptr<const LinkShapes> links_;  ///< once the size is known, if there are any
  double links_size_ = 0;                    ///< [m]
  LineBelief belief_;
  bool dots_;  ///< and nothing else in the script
  HatchingHand hand_;
  double tick_ = 0;  ///< since the one before [s]
  ReaderAction action_;
  Phase phase_ = Phase::kStart;
  Errand errand_ = Errand::kFirstLine;
  double now_ = 0;
  double news_ = 0;  ///< when it last found a sign or a line's end [s]
  glm::dvec2 start_{0, 0};
  int restarts_ = 0;
  double inked_for_ = 0;  ///< [s]
  // a line
  SignPlace frame_;            ///< where the next sign is expected, once the line is known
  bool framed_ = false;        ///< it is
  SignPlace line_frame_;       ///< of the line's beginning, then
  bool expected_ = false;      ///< the line lies at the pitch of those before
  double low_ = 0, high_ = 0;  ///< edges of what is hatched, from `frame_`'s base line [m]
  double column_ = 0;          ///< of the newest way, from the line's left [m]
  bool upwards_ = false;       ///< goes the next column
  SignPlace hatch_;            ///< what columns are measured from
  std::vector<HatchPoint> points_;
  glm::dvec2 sampled_{0, 0};          ///< where the newest of them was felt [m]
  glm::dvec2 met_{0, 0};              ///< a place of the line, between its edges [m]
  double ink_from_ = 0, ink_to_ = 0;  ///< of the line, from `hatch_` [m]
  bool inked_ = false;
  double thought_at_ = 0;        ///< how far was felt then [m]
  std::size_t first_token_ = 0;  ///< of the line
  glm::dvec2 felt_to_{0, 0};     ///< so far all was felt when it went back to signs [m]
  double waits_ = 0;             ///< for so much more of the line, behind a space [em]
  std::vector<SignGuess> line_;
  std::vector<SignGuess> newest_;  ///< the sign read last
  // the page
  double size_ = 0, turn_ = 0;
  Setting setting_;           ///< so far
  Setting setting_at_begin_;  ///< where the line began
  std::vector<SignPlace> line_starts_;
  std::vector<ReadToken> tokens_;
};

}  // namespace moontrace

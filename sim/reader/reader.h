#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "sim/reader/groove_follower.h"
#include "sim/reader/page_reader.h"
#include "sim/reader/reader_knowledge.h"
#include "sim/reader/sign_belief.h"
#include "sim/reader/touch_sense.h"
#include "textures/base/random.h"

namespace moontrace {

/// Reads grooves by following them. It looks for the first line from where its hand is put, finds
/// that line's first sign, follows the grooves of each sign, feels again where two signs are still
/// likely, goes on line by line, and ends by itself where no further line comes.
class Reader final : public PageReader {
 public:
  /// `tick` [s].
  Reader(const ReaderKnowledge& knowledge, double tick, std::uint64_t seed);

  ReaderAction Step(const ReaderInput& input) override;
  bool done() const override { return phase_ == Phase::kDone; }
  std::vector<ReadToken> tokens() const override { return tokens_; }
  std::vector<ReadToken> Pending() const override;
  std::vector<SignGuess> belief() const override { return belief_; }
  ReaderActivity activity() const override;

 private:
  enum class Phase { kStart, kFly, kSweep, kSettle, kFollow, kDone };
  enum class Errand { kFirstLine, kLineStart, kNextSign, kNextLine };
  /// What goes on once a gap has been looked through for dots and bars.
  enum class AfterGap { kNextSign, kLineEnd, kLineBegin };
  /// Where the next sign is looked for, from where it is expected: it begins there and so much
  /// further at most [em]. Ours, chosen on seeds 1 to 20.
  static constexpr double kBefore = 0.25, kBeyond = 1.15;
  /// Below a base line the next line's signs begin there, however far apart the lines before were:
  /// behind a paragraph's space or a heading they are nearer again [em].
  static constexpr double kTopOfNext = 0.45;
  /// The first line is looked for from so far above where the hand was put, which may be too low;
  /// not on an object, whose face ends there. In the least size [em].
  static constexpr double kAboveHand = 0.8;
  /// Left of a line's first sign another may lie so far off [em].
  static constexpr double kLookBack = 3.2;
  struct SignRead {
    SignGuess guess;
    double time = 0;
    bool guide = false;  ///< no sign: the guide line that leads here from the line above
  };

  /// Within what it was told, some 4 percent apart [m].
  static std::vector<double> AllSizes(const ReaderKnowledge& knowledge);
  bool StartAnew();
  bool MayHaveWrongSize() const;
  bool SizesAgree() const;
  void BeginAtTop();
  void ForgetPage();
  void ForgetSize();
  void ForgetSign();
  ReaderAction Act(const Felt& felt);
  void FlyTo(glm::dvec2 to, Phase then);
  std::vector<glm::dvec2> WithinFace(std::vector<glm::dvec2> way) const;
  double LongestOn(const ReaderFace& face) const;
  bool Falls(const Felt& felt) const;
  void ComeBack();
  ReaderAction Fly(const Felt& felt);
  void SweepAlong(std::vector<glm::dvec2> way, Errand errand);
  ReaderAction Sweep(const Felt& felt);
  void Caught(const Felt& felt);
  void Missed();
  ReaderAction Settle(const Felt& felt);
  ReaderAction Follow(const Felt& felt);
  double LiftedHeight() const;
  void EndLeg();
  void TrySides();
  void TakeGrooves();
  void TakePath();
  void Think();
  double Sureness() const;
  bool MeanTheSame(const SignGuess& a, const SignGuess& b) const;
  double ShareOf(const SignGuess& guess, const std::vector<FeltPoint>& grooves) const;
  bool IsLastAgain() const;
  bool TakeGuide();
  /// The point of a sign that is farthest from all that was felt.
  struct Unfelt {
    double room = 0;  ///< [em]
    SignPoint point;
  };
  Unfelt FarthestUnfelt(const SignGuess& guess) const;
  bool KnowsTheRest();
  bool TurnBack();
  double ReachAcross() const;
  bool CrossUnfelt(const SignGuess& guess);
  Box FeltBox() const;
  bool FeltASpot(double widths) const;
  bool GoRound();
  bool SkipFirst();
  void WeighSizes();
  void SweepAcross(const Box& box);
  bool CrossBetween(const SignGuess& best, const SignGuess& other);
  void Accept();
  void SearchFirstLine();
  void SearchNext();
  void SearchBeyond(const std::vector<FeltPoint>& grooves);
  void LookThroughGap(double from, double to, AfterGap after);
  void LeaveGap();
  bool MetGapsEnd(glm::dvec2 entry);
  bool LeftAGap(glm::dvec2 entry);
  void SearchLineStart();
  bool IsInLastLine(const SignPlace& place);
  bool IsTooNear(const SignPlace& place);
  SignPlace StartOfLine() const;
  double LeastPitch() const;
  std::optional<double> SkippedLine(const SignPlace& place) const;
  bool LookForSkipped(double pitch);
  bool IsAtMargin(const SignPlace& place) const;
  void BeginLine();
  void SearchNextLine(double from = kTopOfNext);
  void EndLine();
  void LeaveLine();
  PlacePrior PriorNow() const;
  void LearnFrame();
  std::optional<double> FeltSize(const SignGuess& read) const;
  void LearnSize(double size);
  std::vector<double> OtherSizes() const;
  bool BelowASpace() const;
  void LearnLineSize(double size);
  void LearnTurn(glm::dvec2 way);
  SignPlace Expected() const;
  double GapOf(std::size_t sign) const;
  double WidthOf(const SignGuess& guess) const;
  double WayBehind(const SignRead& read) const;
  /// From a place along the line as it runs, and back [em].
  double Ahead(const SignPlace& from, glm::dvec2 p) const;
  glm::dvec2 AtAhead(const SignPlace& from, double ahead, double y) const;
  double Along(glm::dvec2 p) const;
  bool MayGoOn() const;
  void LookThroughLineEnd();
  void LookThroughLineBegin();
  std::vector<glm::dvec2> Weave(double from, double to) const;
  std::vector<glm::dvec2> WeaveFrom(const SignPlace& place, double from, double to) const;

  ReaderKnowledge knowledge_;
  Random random_{0};
  bool random_phase_ = false;  ///< of the next weave: begins high
  TouchSense sense_;
  AimDrift drift_;
  GrooveFollower follower_;
  ReaderAction action_;
  Phase phase_ = Phase::kStart;
  double now_ = 0, since_ = 0;
  double starts_ = 0;      ///< to sweep: the landing has come to rest [s]
  double feels_from_ = 0;  ///< what is felt before comes from before the last landing [s]
  double news_ = 0;        ///< when it last found a sign or the end of a line [s]

  // flying
  Phase then_ = Phase::kSweep;
  glm::dvec2 fly_from_{0, 0}, fly_to_{0, 0};
  double rise_ = 0;  ///< before it moves aside [s]
  // sweeping
  Errand errand_ = Errand::kFirstLine;
  bool in_gap_ = false;  ///< looks through a gap
  AfterGap after_gap_ = AfterGap::kNextSign;
  double gap_to_ = 0;         ///< where the gap ends [em]
  std::size_t gap_turn_ = 0;  ///< of its way, where the upper edge begins
  bool crossing_ = false;     ///< sweeps across a place that tells two signs apart
  bool circling_ = false;     ///< sweeps round a spot
  std::vector<glm::dvec2> way_;
  std::size_t next_ = 0;
  glm::dvec2 aim_{0, 0};
  glm::dvec2 last_flat_{0, 0};
  double caught_for_ = 0;
  glm::dvec2 sweep_direction_{1, 0};
  double waited_ = 0;  ///< at the end of a way [s]
  // a sign
  SignEvidence evidence_;
  std::vector<SignGuess> belief_;
  glm::dvec2 entry_{0, 0};
  std::vector<FeltPoint> first_leg_;  ///< grooves of a leg that is felt again
  int legs_ = 0;                      ///< followed from `entry_`
  glm::dvec2 leg_end_{0, 0};          ///< of the newest leg
  glm::dvec2 first_direction_{1, 0};  ///< of the newest leg
  int crossings_ = 0, tries_ = 0, circles_ = 0;
  // the page
  glm::dvec2 start_{0, 0};         ///< where the hand was put [m]
  double put_ = 0;                 ///< and how high [m]
  int falls_ = 0;                  ///< off its face, on this way
  glm::dvec2 carried_{0, 0};       ///< where that carried it last [m]
  std::optional<glm::dvec2> top_;  ///< where to begin again once the second line has told the size
  std::vector<ReadToken> read_above_;  ///< before it looked there, kept until it has
  bool looked_below_ = false;          ///< it was looked for there
  int restarts_ = 0, skips_ = 0;
  int rounds_ = 0;                    ///< lines in a row that began no lower than all before
  bool wider_ = false;                ///< looks for the first line in a wider way
  bool straight_ = false;             ///< looks for the next line straight down
  std::optional<Box> first_skipped_;  ///< round the first sign that was left for later
  std::size_t unknowns_ = 0;          ///< signs in a row
  std::vector<FeltPoint> unknown_;    ///< what was felt of the last sign
  std::vector<SignRead> line_;        ///< as it runs
  bool leftwards_ = false;            ///< the line runs so
  int far_ = 0;                  ///< spaces beyond one, behind which it looks for its next sign
  double farthest_ = -HUGE_VAL;  ///< to the right, where a line has ended [m]
  bool guided_ = false;          ///< lines end in guides
  int widest_gap_ = 0;           ///< most spaces beyond one between two signs so far
  double guide_gap_ = 0;         ///< between guides and signs [em]
  double size_ = 0;
  std::vector<double> sizes_;       ///< that are tried [m]
  std::vector<double> size_logs_;   ///< PlacePrior::size_logs, before the first sign is read
  std::vector<double> felt_sizes_;  ///< of the first signs [m]
  double turn_ = 0;
  double across_ = 0, along_ = 0;  ///< tangent sums for the turn [m^2]
  double gap_bias_ = 0;            ///< of gaps between signs from the script's [em]
  int gaps_ = 0;
  std::size_t signs_ = 0;  ///< read so far
  /// Whether a line was skipped between the last one and the next.
  enum class Skipped { kUnknown, kLooking, kNone } skipped_ = Skipped::kUnknown;
  bool line_size_new_ = false;  ///< the line's first sign was of another size than the line above
  std::vector<SignPlace> line_starts_;
  std::vector<ReadToken> tokens_;
};

}  // namespace moontrace

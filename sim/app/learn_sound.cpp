#include "sim/app/learn_sound.h"

#include <algorithm>
#include <limits>

namespace moontrace {

PathSound SoundOf(const std::vector<IntendedStroke>& strokes, glm::dvec2 tip_P, bool in_contact) {
  PathSound sound;
  Box box;
  double least = std::numeric_limits<double>::infinity(), width = 1;
  for (const IntendedStroke& stroke : strokes) {
    for (const Piece& piece : stroke.spine_P) {
      Include(box, BoundsOf(piece));
      const double distance = DistanceTo(piece, tip_P);
      if (distance < least) {
        least = distance;
        width = stroke.width;
      }
    }
  }
  if (!(box.min.x <= box.max.x)) return sound;  // nothing is there
  const auto share = [](double at, double low, double high) {
    return high - low > 1e-6 ? std::clamp((at - low) / (high - low), 0.0, 1.0) : 0.5;
  };
  sound.in_contact = in_contact;
  sound.x = share(tip_P.x, box.min.x, box.max.x);
  sound.y = share(tip_P.y, box.min.y, box.max.y);
  sound.off_line = std::clamp((least - 0.5 * width) / width, 0.0, 1.0);
  return sound;
}

void PathListener::Hear(const LearnSession& session) {
  const LoopSnapshot& now = session.newest();
  const LearnStage& stage = session.stage();
  const bool heard =
      !session.stopped() && stage.shown().told && now.page == stage.session().number();
  const bool touching = heard && now.depth > 0;
  const PathSound sound = SoundOf(stage.trace().strokes(), now.tip_P, touching);
  sound_.Follow(sound);
  if (touching != touching_) {
    sound_.Play(touching ? Earcon::kStrokeStart : Earcon::kStrokeEnd);
    off_ = false;
  } else if (touching && !off_ && sound.off_line >= 0.5) {
    off_ = true;
    sound_.Play(Earcon::kOffLine);
  } else if (touching && off_ && sound.off_line <= 0) {
    off_ = false;
    sound_.Play(Earcon::kBackOn);
  }
  touching_ = touching;
}

}  // namespace moontrace

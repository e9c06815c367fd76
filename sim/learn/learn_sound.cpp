#include "sim/learn/learn_sound.h"

#include <algorithm>
#include <limits>

#include "sim/audio/sound_messages.h"
#include "sim/learn/learn_stage.h"
#include "sim/learn/learn_teller.h"

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

void PathListener::Hear() {
  const LoopSnapshot& now = running_.poll().newest();
  const bool heard =
      !running_.stopped() && stage_.shown().told && now.page == stage_.session().felt().number;
  const bool touching = heard && now.depth > 0;
  const PathSound sound = SoundOf(stage_.trace().strokes(), now.tip_P, touching);
  sound_.Follow(sound);
  const FeltPage& page = stage_.session().felt();
  const PassedEnd end = PassedEndOf(page.set(), page.text->script, page.text->set.style, now.tip_P);
  const auto happened = events_.Take({now.time, touching, sound.off_line, end});
  if (!happened) return;
  sound_.Play(*happened);
  const std::string line = say::OnThePath(*happened);
  if (!line.empty()) teller_.Happening(Priority::kNotification, line);
}

}  // namespace moontrace

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/loop/loop_types.h"
#include "sim/session/loop_session.h"
#include "sim/session/place_walk.h"

namespace moontrace {

/// Leads from label to label of a model that a session lets be felt, and knows which object the tip
/// touches. One thread.
class LabelWalk {
 public:
  /// `session` must outlive this.
  explicit LabelWalk(LoopSession& session) : session_(session) {}

  /// All labels, each in a line of its own.
  std::vector<std::string> List() const;
  /// Goes to the label behind the present one, in the model's order, and round. What is said at
  /// once: why not. Empty: the way is said by Arrived.
  std::string Next();
  /// Goes to the label of that name, or that has this text; capitals do not count. `part`: a piece
  /// of either will do. As Next; none: no label is meant.
  std::optional<std::string> Find(std::string_view wanted, bool part);
  /// Back to the label before the last one that was gone to. As Next; none: there is none.
  std::optional<std::string> Return();
  /// Once, as soon as the label is under the tip's words; then what leads there. `source`: 0.
  std::optional<PlaceWalk::Arrival> Arrived(const LoopSnapshot& now);
  /// Whether the way that was told last can be pushed along by now: the tip is not behind the face.
  bool IsFree(const LoopSnapshot& now) const;

  /// The object that is touched, in words; empty: none, or there is only one.
  std::string Touched(const LoopSnapshot& now) const;
  /// The same once the tip has come to another one, and stays there.
  std::string TouchedAnew(const LoopSnapshot& now);
  /// A button, or what gives way like one, has come to its end: that it is pressed, once each time;
  /// else empty.
  std::string PressedAnew(const LoopSnapshot& now);

 private:
  std::string GoTo(std::size_t number);
  std::string NameOfGeom(int geom) const;

  LoopSession& session_;
  std::vector<std::size_t> before_;  ///< labels, newest last
  bool going_ = false;               ///< the way has not been told
  int told_ = -1;                    ///< geom
  int geom_ = -1;                    ///< that is touched ...
  double since_ = 0;                 ///< ... since then [s]
  bool pressed_ = false;             ///< it has given way to its end, and not come back
};

}  // namespace moontrace

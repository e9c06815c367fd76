#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/core/profile.h"
#include "devices/hand/hand.h"
#include "devices/hand/led_stylus.h"
#include "sim/physics/label_place.h"
#include "sim/physics/scene.h"
#include "sim/physics/scene_options.h"
#include "sim/reader/page_reader.h"
#include "sim/reading/reading_score.h"
#include "sim/trial/trial_result.h"
#include "textures/base/random.h"
#include "textures/field/field.h"
#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// The senses of a hand.
struct Senses {
  double delay = 0.120;  ///< by which force and place are felt late [s]
  double unsure = 0;     ///< rms error of the place, along and across the paper (UnsurePlace) [m]
};

/// One tick of a reading, for who looks on.
struct ReadingTick {
  double time;               ///< [s]
  const ReaderInput& input;  ///< what the reader was given
  const PageReader& reader;
  const TickResult& felt;  ///< what it was not given
  const Scene& scene;
};

/// Everything that decides one reading of one page.
struct ReadingSetup {
  const TextPage* page = nullptr;       ///< must outlive the run; the reader never sees it
  const TextureField* field = nullptr;  ///< of that page, or of another paper; must outlive the run
  std::string model_path;               ///< MJCF; empty = the shipped page
  std::vector<LaidLabel> others;        ///< labels of the model beside the page
  SceneOptions scene;
  HandModel hand;
  bool press_given = true;  ///< else of an object at most Scene::groove_press
  Muscle muscle;
  Senses senses;
  /// What the hand is on; none: a tip that is read exactly, in every tick. Must measure and push
  /// along the paper (CanBeReadOn); without a height the reader goes by walls alone.
  std::optional<DeviceProfile> device;
  /// On a device its stiffness is what the page is felt through there, whatever stands here.
  ReaderKnowledge knowledge;
  double page_turn = 0;           ///< of the sheet under the hand, counter-clockwise [rad]
  glm::dvec2 start_P{0, 0};       ///< where the hand is put [m]
  std::uint64_t hand_seed = 1;    ///< of tremor and drift
  std::uint64_t reader_seed = 1;  ///< of what the reader does by chance
  double path_spacing = 0;        ///< of the path kept for a picture [m]; 0: none
  double longest = 14400;         ///< a reader that has not ended by then is stopped [s]
  const std::atomic<bool>* stop = nullptr;  ///< looked at every tick; set: Interrupted is thrown
  /// Called in each tick, after the reader. None: costs nothing.
  std::function<void(const ReadingTick& tick)> watch;
  std::function<void()> alive;  ///< called each simulated second
};

struct ReadingResult {
  std::vector<ReadToken> tokens;                    ///< places in the page's frame
  bool ended = false;                               ///< by itself
  std::size_t through = 0;                          ///< how often the paper gave way under the tip
  double duration = 0;                              ///< simulated [s]
  std::array<double, kReaderActivities> seconds{};  ///< of it, by ReaderActivity
  double real_time_factor = 0;                      ///< the only value that varies
  std::vector<PathPoint> path;  ///< kTravel where it searches, kStroke where it follows
};

/// Reader, hand and scene, tick by tick: the hand's place goes to the scene, the scene's force one
/// tick late to the hand, both late to the reader, whose will moves the hand. On a device scene and
/// reader get the place by its readings, in its steps, and the hand feels after its delay
/// (HandOnDevice). Throws InputError as
/// Scene::Load, Interrupted.
ReadingResult RunReading(const ReadingSetup& setup);

/// What the page holds, as it should be read: signs by their number among the script's glyphs, a
/// form of a sign as that sign itself.
std::vector<int> MarksOf(const TextPage& page, const Script& script);
/// The same of what was read.
std::vector<int> MarksOf(const std::vector<ReadToken>& tokens, const Script& script);

/// How wrongly a hand knows where it is: an error that wanders smoothly over some 1.5 s, apart from
/// where the hand truly is. Two equal lags in a row make it of white noise, so that it has a speed
/// but no jitter; its correlation over a time t is (1 + t / lag) exp(-t / lag), whose integral, 1.5
/// s, is two lags.
class UnsurePlace {
 public:
  static constexpr double kLag = 0.75;  ///< each [s]

  /// `rms` on each axis [m]; 0: none. `tick` [s].
  UnsurePlace(double rms, double tick, std::uint64_t seed);

  /// The error of the next tick [m].
  glm::dvec2 Next() noexcept;

 private:
  double share_ = 0, kick_ = 0;  ///< of the way in a tick; of the noise [m]
  Random random_;
  glm::dvec2 inner_{0, 0}, error_{0, 0};  ///< [m]
};

}  // namespace moontrace

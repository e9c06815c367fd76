// Real hands start, stop and turn, and encoders answer in steps: the bound of the force holds with
// what they add, on every shipped profile that pushes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <random>

#include "devices/catalogue/catalogue.h"
#include "devices/core/tip_estimate.h"
#include "sim/loop/device_feel.h"
#include "sim/loop/pressing.h"
#include "tests/sim/scene_fixture.h"
#include "tests/source_path.h"
#include "tests/textures/sample_page.h"

namespace moontrace {
namespace {

constexpr double kTick = 0.001;       ///< [s]
constexpr double kAcceleration = 30;  ///< greatest [m/s^2]
constexpr double kSpeed = 0.3;        ///< greatest [m/s]
constexpr int kTicksPerStroke = 250;  ///< of which each chooses a new acceleration now and then

/// A tip that goes about a letter, from 3 mm above the paper to 6 mm below it, in jerks.
class JerkyHand {
 public:
  explicit JerkyHand(unsigned seed) : random_(seed) {}

  void Begin(glm::dvec3 p) {
    p_ = middle_ = p;
    v_ = glm::dvec3(0.0);
    left_ = 0;
  }
  glm::dvec3 Next() {
    if (left_-- <= 0) {
      left_ = static_cast<int>(1 + 40 * Share());
      const glm::dvec3 direction(Signed(), Signed(), Signed());
      a_ = kAcceleration * Share() * direction / std::max(1e-3, glm::length(direction));
    }
    glm::dvec3 a = a_;
    // brakes as hard as it may where it is too fast or too far away
    if (glm::length(v_) > 0.8 * kSpeed) a = -kAcceleration * glm::normalize(v_);
    const glm::dvec3 away = p_ - middle_;
    if (glm::length(away / glm::dvec3(6e-3, 6e-3, 4e-3)) > 1) {
      a = -kAcceleration * glm::normalize(away + 0.02 * v_);
    }
    v_ += kTick * a;
    p_ += kTick * v_;
    return p_;
  }

 private:
  double Share() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  double Signed() { return 2 * Share() - 1; }
  std::mt19937 random_;
  glm::dvec3 middle_{0, 0, 0}, p_{0, 0, 0}, v_{0, 0, 0}, a_{0, 0, 0};
  int left_ = 0;
};

glm::dvec3 InSteps(glm::dvec3 p, double step) { return step > 0 ? step * glm::round(p / step) : p; }

/// Greatest force on the pushed axes over `strokes` random strokes [N].
double GreatestForce(Scene& scene, const DeviceProfile& profile, const SamplePage& page,
                     const TextureField& field, int strokes, unsigned seed) {
  const auto& glyphs = page.typeset.pages.front().glyphs;
  JerkyHand hand(seed);
  double greatest = 0;
  for (int stroke = 0; stroke < strokes; ++stroke) {
    const glm::dvec2 at = glyphs[static_cast<std::size_t>(stroke) % glyphs.size()].origin_P +
                          0.4 * page.typeset.style.size;
    hand.Begin({at, stroke % 3 == 0 ? -0.003 : -0.001});
    TipEstimate tip(glm::dvec3(profile.position_step));
    TickResult felt;
    for (int i = 0; i < kTicksPerStroke; ++i) {
      tip.Advance(kTick, true, InSteps(hand.Next(), profile.position_step));
      DeviceState reading = TipAt(tip.p());
      reading.v_D = tip.v();
      reading.velocity_known = true;
      if (!profile.limits.measures.z) {
        reading.p_D.z = reading.v_D.z = 0;
        reading =
            Pressed(reading, scene.X_WP(), i > 0 ? &felt : nullptr, 1.0, scene.options(), field);
      }
      if (i == 0) scene.Restart();
      felt = scene.Tick(reading);
      if (felt.fault) return INFINITY;
      const glm::dvec3 pushed = felt.force_P * glm::dvec3(profile.limits.pushes);
      greatest = std::max(greatest, glm::length(pushed));
    }
  }
  return greatest;
}

void HoldsFor(int strokes) {
  int profiles = 0;
  for (const DeviceProfile& profile : LoadProfiles(SourcePath("devices/profiles"))) {
    if (!glm::any(profile.limits.pushes)) continue;
    ++profiles;
    for (const double friction : {0.0, 0.1}) {
      for (const double size : {0.006, 0.02}) {
        const SamplePage page = MakePage("moon hazel", size, Relief::kEngraved);
        const TextureField field(page.texture);
        SceneOptions asked;
        asked.friction = friction;
        const SceneOptions options = HeldBy(LimitsOf(profile, kTick), asked, 0.05);
        Scene scene = Scene::Load("", options);
        scene.SetField(&field);
        const double bound = scene.force_bound({.acceleration = kAcceleration,
                                                .position_step = profile.position_step,
                                                .pushes_height = profile.limits.pushes.z});
        const double force = GreatestForce(scene, profile, page, field, strokes / 4, 17);
        EXPECT_LE(force, bound) << profile.name << " " << friction << " " << size;
        EXPECT_GT(force, 0.15 * bound) << profile.name;  // the bound is no wild guess
        std::printf("%s, friction %.1f, %.0f mm: %.2f of at most %.2f N\n", profile.name.c_str(),
                    friction, 1000 * size, force, bound);
      }
    }
  }
  EXPECT_GE(profiles, 7);
}

TEST(UnevenHand, StaysUnderTheBoundOnEveryProfile) { HoldsFor(40); }
TEST(SlowUnevenHand, StaysUnderTheBoundOnEveryProfile) { HoldsFor(4000); }

}  // namespace
}  // namespace moontrace

// The proxy is never left behind: over every glyph, direction, speed and friction the force on the
// device stays under the analytic bound (sim/physics/coupling.h), which is printed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "sim/physics/coupling.h"
#include "sim/physics/scene.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

/// Greatest force on a device that goes evenly across a glyph, held 6 mm below the paper.
double GreatestForce(Scene& scene, const Box& box, int direction, double speed) {
  const double angle = direction * std::numbers::pi / 4 + 0.1;
  const glm::dvec3 along(std::cos(angle), std::sin(angle), 0.0);
  const glm::dvec3 middle(0.5 * (box.min + box.max), -6e-3);
  const double reach = 0.6 * glm::length(box.max - box.min);
  scene.Reset(middle - reach * along);
  double greatest = 0;
  const int ticks = static_cast<int>(2 * reach / (speed * 1e-3));
  for (int i = 0; i < ticks; ++i) {
    DeviceState input;
    input.p_D = ToWorld(scene.X_WP(), middle + (i * 1e-3 * speed - reach) * along);
    input.v_D = TurnToWorld(scene.X_WP(), speed * along);
    input.velocity_known = true;
    const TickResult result = scene.Tick(input);
    if (result.fault) return INFINITY;
    greatest = std::max(greatest, glm::length(result.force_P));
  }
  return greatest;
}

class SlowNeverLeftBehind : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Frictions, SlowNeverLeftBehind, ::testing::Values(0.0, 0.15, 0.3));

TEST_P(SlowNeverLeftBehind, OverEveryGlyphDirectionAndSpeed) {
  const Script script = FindScript("moon");
  SceneOptions options;
  options.friction = GetParam();
  double greatest = 0, bound = 0;
  for (const double size : {0.020, 0.006}) {
    const TypeStyle style = DefaultStyle(size, Relief::kEngraved, script);
    for (const Glyph& glyph : script.glyphs) {
      Texture texture;
      texture.layers.push_back({Finish(BuildGlyph(glyph, style)), Relief::kEngraved});
      const TextureField field(texture);
      Scene scene = Scene::Load("", options);
      scene.SetField(&field);
      bound = ForceBound(options, scene.proxy_mass(), {}, scene.substeps());
      for (int direction = 0; direction < 8; ++direction) {
        for (const double speed : {0.005, 0.020, 0.050, 0.100, 0.200}) {
          const double force =
              GreatestForce(scene, texture.layers.front().group->bounds, direction, speed);
          ASSERT_LE(force, bound) << glyph.name << " direction " << direction << " at " << speed;
          greatest = std::max(greatest, force);
        }
      }
    }
  }
  std::printf("friction %.2f: greatest force %.2f N, bound %.2f N\n", GetParam(), greatest, bound);
  EXPECT_GT(greatest, 0.5 * bound);  // the bound is no wild guess
}

}  // namespace
}  // namespace moontrace

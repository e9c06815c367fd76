#include "sim/physics/coupling.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>

#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

TEST(Coupling, PullsByStretchAndItsRate) {
  const Coupling coupling{1000, 10};
  EXPECT_EQ(coupling.Pull({0.001, 0, -0.002}, {0, 0.1, 0}), glm::dvec3(1, 1, -2));
  EXPECT_EQ(coupling.Pull({0, 0, 0}, {0, 0, 0}), glm::dvec3(0, 0, 0));
}

TEST(Coupling, HoldsTheWorkThatItsSpringTook) {
  // the midpoint rule is exact for a linear force
  const Coupling coupling{1000, 0};
  const glm::dvec3 end{0.003, -0.001, 0.002};
  EXPECT_NEAR(coupling.Energy(end), glm::dot(coupling.Pull(0.5 * end, {0, 0, 0}), end), 1e-15);
}

constexpr double kPi = std::numbers::pi;

/// Integral of |h| for h(t) = e^(-a t) (A cos w t + C sin w t), the impulse response of
/// (B s + K) / (m s^2 + B s + K): each half swing holds e^(-a pi/w) times the one before.
double ContinuousNorm(double K, double B, double m) {
  const double a = B / (2 * m);
  const double w = std::sqrt(K / m - a * a);
  const double A = B / m;
  const double C = (K / m - a * A) / w;
  const auto primitive = [&](double t) {
    const double s = std::sin(w * t);
    const double c = std::cos(w * t);
    return std::exp(-a * t) * (A * (w * s - a * c) + C * (-a * s - w * c)) / (a * a + w * w);
  };
  double zero = std::atan2(-A, C) / w;
  if (zero < 0) zero += kPi / w;
  const double first = std::abs(primitive(zero) - primitive(0));
  const double swing = std::abs(primitive(zero + kPi / w) - primitive(zero));
  return first + swing / (1 - std::exp(-a * kPi / w));
}

TEST(CouplingNorm, TendsToTheClosedFormForSmallSteps) {
  // the recursion is of first order in the step: ten times smaller, ten times nearer
  for (const double B : {1.0, 5.0, 10.0}) {
    const double exact = ContinuousNorm(1000, B, 0.05);
    const double coarse = std::abs(CouplingNorm(1000, B, 0.05, 1e-4) - exact);
    const double fine = std::abs(CouplingNorm(1000, B, 0.05, 1e-5) - exact);
    EXPECT_LT(fine, 1e-2 * exact) << B;
    EXPECT_LT(fine, 0.2 * coarse) << B;
  }
}

TEST(CouplingNorm, IsOfPureSpringsTheCothOfTheSwing) {
  // With little damping B s is small beside K, and the integral of |h| is that of the spring alone,
  // coth(pi zeta / (2 sqrt(1 - zeta^2))).
  const double K = 1000, m = 0.05, zeta = 0.01;
  const double B = 2 * zeta * std::sqrt(K * m);
  const double coth = 1 / std::tanh(kPi * zeta / (2 * std::sqrt(1 - zeta * zeta)));
  EXPECT_NEAR(CouplingNorm(K, B, m, 1e-5), coth, 0.01 * coth);
}

TEST(CouplingNorm, IsInfiniteWithoutDampingAndForAnUnstableStep) {
  EXPECT_TRUE(std::isinf(CouplingNorm(1000, 0, 0.05, 0.001)));
  EXPECT_TRUE(std::isinf(CouplingNorm(1e6, 10, 0.05, 0.001)));
}

TEST(CouplingNorm, IsReachedByTheWorstPageForceAndExceededByNone) {
  const double K = 1000, B = 10, m = 0.05, h = 0.001;
  const auto run = [&](const std::function<double(int)>& page) {
    double e = 0, w = 0, greatest = 0;
    for (int n = 0; n < 400; ++n) {
      const double f = K * e + B * w;
      greatest = std::max(greatest, std::abs(f));
      w -= h / m * (f + page(n));
      e += h * w;
    }
    return greatest;
  };
  // the pulse response, from the same difference equation written for e alone:
  // e'' = (2 - h^2 K/m - h B/m) e' - (1 - h B/m) e
  std::vector<double> g;
  double e0 = 0, e1 = -h * h / m;
  for (int n = 0; n < 400; ++n) {
    g.push_back(K * e1 + B * (e1 - e0) / h);
    const double e2 = (2 - h * h * K / m - h * B / m) * e1 - (1 - h * B / m) * e0;
    e0 = e1;
    e1 = e2;
  }
  const double norm = CouplingNorm(K, B, m, h);
  const auto worst = [&](int n) {
    return g[static_cast<std::size_t>(398 - std::min(n, 398))] < 0 ? -1.0 : 1.0;
  };
  EXPECT_NEAR(run(worst), norm, 1e-6 * norm);
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    EXPECT_LE(run([&](int) { return random() % 2 == 0 ? 1.0 : -1.0; }), norm);
  }
}

TEST(ForceBound, OfThePapersLawCountsFrictionAndAcceleration) {
  SceneOptions options;
  options.friction = 0.3;
  options.surface = {1000, 3, ForceLaw::kPaper};
  const double norm = CouplingNorm(1000, 10, 0.05, 0.001);
  EXPECT_NEAR(ForceBound(options, 0.05), norm * 3 * std::sqrt(1.09), 1e-12);
  EXPECT_NEAR(ForceBound(options, 0.05, {.acceleration = 4}) - ForceBound(options, 0.05),
              norm * 0.2, 1e-12);
  options.rendering = Rendering::kDirect;
  EXPECT_NEAR(ForceBound(options, 0.05, {.acceleration = 4}), 3 * std::sqrt(1.09), 1e-12);
}

TEST(ForceBound, OfTheDefaultLawIsThatOfItsTwoDirections) {
  SceneOptions options;
  options.surface = {1000, 4, ForceLaw::kPotential};
  const double n = CouplingNorm(1000, 10, 0.05, 0.001);
  const double both = std::hypot(n * 2.2, (n + 1) / 2 * 3.34);
  EXPECT_NEAR(ForceBound(options, 0.05), both, 1e-12);
  EXPECT_NEAR(ForceBound(options, 0.05, {.pushes_height = false}), n * 2.2, 1e-12);
  options.friction = 0.1;
  EXPECT_NEAR(ForceBound(options, 0.05), both + n * 0.4, 1e-12);
}

// Steps of the readings: every sequence of errors within half a step, and the velocity that is
// found from differences of such readings, on a linear page with none of its own force.
TEST(ForceBound, CountsTheStepsOfTheReadings) {
  const double K = 1000, B = 10, m = 0.05, h = 0.001, q = 64e-6;
  SceneOptions options;
  const double steps = ForceBound(options, m, {.position_step = q}) - ForceBound(options, m);
  std::mt19937 random(4);
  double greatest = 0;
  for (int trial = 0; trial < 200; ++trial) {
    double x = 0, v = 0, last = 0;
    for (int i = 0; i < 300; ++i) {
      // the worst kinds of noise: every tick, or in beats near the coupling's own frequency
      const bool up = trial % 2 == 0 ? random() % 2 == 0 : (i / (1 + trial / 4)) % 2 == 0;
      const double tip = up ? q / 2 : -q / 2;
      const double pull = K * (tip - x) + B * ((tip - last) / h - v);
      last = tip;
      greatest = std::max(greatest, std::abs(pull));
      v += h / m * pull;
      x += h * v;
    }
  }
  EXPECT_LT(greatest, steps);
  EXPECT_GT(greatest, 0.1 * steps);  // these readings are used as they come
}

/// A corner, a crossing, a ring and a dot.
TextureField GlyphLike() {
  return FieldOf({{Line{{-0.006, -0.006}, {0.0, 0.006}}, kGroove},
                  {Line{{0.0, 0.006}, {0.006, -0.006}}, kGroove},
                  {Line{{-0.006, 0.0}, {0.006, 0.0}}, kGroove},
                  {Arc{{0.0, 0.0}, 0.004, 0.0, 2 * kPi}, kGroove},
                  {Dot{{0.0, 0.006}}, kGroove}});
}

/// Greatest force of a device that goes evenly over the glyph, whatever pushes back.
double GreatestForce(Scene& scene, double depth, double angle, double speed, double offset) {
  scene.Reset({0, 0, 0.01});
  const glm::dvec3 along{std::cos(angle), std::sin(angle), 0};
  const glm::dvec3 across{-along.y, along.x, 0};
  const double length = 0.016;
  double greatest = 0;
  const int ticks = static_cast<int>(length / (speed * 0.001));
  for (int i = 0; i < ticks; ++i) {
    DeviceState input =
        TipAt((i * 0.001 * speed - length / 2) * along + offset * across - glm::dvec3(0, 0, depth));
    input.v_D = speed * along;
    input.velocity_known = true;
    const TickResult result = scene.Tick(input);
    EXPECT_FALSE(result.fault);
    greatest = std::max(greatest, glm::length(result.force_W));
  }
  return greatest;
}

TEST(ForceBound, IsNeverExceededBySlidingOverAGlyph) {
  const TextureField field = GlyphLike();
  for (const double friction : {0.0, 0.3}) {
    SceneOptions options;
    options.friction = friction;
    Scene scene = Scene::Load("", options);
    scene.SetField(&field);
    const double bound = ForceBound(options, scene.proxy_mass(), {}, scene.substeps());
    double greatest = 0;
    for (const double depth : {0.001, 0.0075}) {
      for (int direction = 0; direction < 8; ++direction) {
        for (const double speed : {0.005, 0.05, 0.2}) {
          const double f = GreatestForce(scene, depth, direction * kPi / 4, speed, 0.0007);
          EXPECT_LE(f, bound) << depth << " " << direction << " " << speed;
          greatest = std::max(greatest, f);
        }
      }
    }
    // the bound is no wild guess; friction is counted as if it pulled along with the page's force
    EXPECT_GT(greatest, (friction > 0 ? 0.6 : 0.7) * bound);
  }
}

}  // namespace
}  // namespace moontrace

#include "sim/scene/coupling.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

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

}  // namespace
}  // namespace moontrace

#include "textures/base/finite.h"

#include <gtest/gtest.h>

#include <limits>

namespace moontrace {
namespace {

TEST(FiniteVector, HasNoPartThatIsNot) {
  EXPECT_TRUE(IsFinite({0.0, -1e308, 1e-320}));
  for (int part = 0; part < 3; ++part) {
    for (const double other :
         {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::quiet_NaN()}) {
      glm::dvec3 v(1.0, 2.0, 3.0);
      v[part] = other;
      EXPECT_FALSE(IsFinite(v)) << part << " " << other;
    }
  }
}

}  // namespace
}  // namespace moontrace

#include "sim/reader/reader_knowledge.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace moontrace {
namespace {

// Off the edge that is nearest, at right angles to it, however the face lies turned.
TEST(ReaderFace, OutwardLeadsOverTheNearestEdge) {
  ReaderFace face;
  face.middle = {0.01, -0.02};
  face.half = {0.03, 0.01};
  const auto expect = [&](glm::dvec2 own, glm::dvec2 out) {
    const glm::dvec2 found = face.ToOwn(face.middle + face.Outward(face.FromOwn(own)));
    EXPECT_LT(glm::distance(found, out), 1e-12) << own.x << " " << own.y;
  };
  for (const double turn : {0.0, 0.7, -2.0}) {
    face.turn = turn;
    expect({0.028, 0.001}, {1, 0});
    expect({-0.031, 0.002}, {-1, 0});  // a little beyond it
    expect({0.01, 0.008}, {0, 1});
    expect({-0.02, -0.009}, {0, -1});
  }
}

}  // namespace
}  // namespace moontrace

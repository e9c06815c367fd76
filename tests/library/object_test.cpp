// Pages on solids by the C interface, against the rooms that they are made of.
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <vector>

#include "tests/library/library_fixture.h"
#include "textures/fonts/script_library.h"
#include "textures/objects/solid_contact.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

moontrace_shape ShapeOf(const char* kind, double first, double second = 0, double third = 0) {
  auto shape = Sized<moontrace_shape>();
  shape.kind = kind;
  shape.half[0] = first;
  shape.half[1] = second;
  shape.half[2] = third;
  return shape;
}

struct OpenObject {
  OpenObject(const moontrace_page* page, const moontrace_shape& shape) {
    EXPECT_EQ(moontrace_object_open(page, &shape, &object), MOONTRACE_DONE) << moontrace_message();
  }
  ~OpenObject() { moontrace_object_close(object); }
  OpenObject(const OpenObject&) = delete;
  OpenObject& operator=(const OpenObject&) = delete;
  moontrace_object* object = nullptr;
};

void ExpectRefused(const moontrace_page* page, const moontrace_shape& shape, int code,
                   const char* words) {
  moontrace_object* object = nullptr;
  EXPECT_EQ(moontrace_object_open(page, &shape, &object), code) << words;
  EXPECT_NE(std::string(moontrace_message()).find(words), std::string::npos) << moontrace_message();
  EXPECT_EQ(object, nullptr);
}

TEST(LibraryObject, OnAPlaneIsThePageItself) {
  const OpenPage open("moon");
  moontrace_shape shape = ShapeOf("plane", 0, 0);
  shape.corner = 1;
  shape.u = -0.1;
  shape.v = -0.15;
  const OpenObject plane(open.page, shape);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> x(0.010, 0.070), y(0.265, 0.290), z(-0.001, 0.0002);
  int felt = 0;
  for (int i = 0; i < 5000; ++i) {
    const double at[3] = {x(random), y(random), z(random)};
    double of_page[3], of_object[5], place[3];
    ASSERT_EQ(moontrace_object_place(plane.object, at[0], at[1], at[2], place), MOONTRACE_DONE);
    EXPECT_DOUBLE_EQ(place[0], at[0] - 0.1);
    EXPECT_EQ(place[2], at[2]);
    ASSERT_EQ(moontrace_sample(open.page, at[0], at[1], of_page), MOONTRACE_DONE);
    ASSERT_EQ(moontrace_object_sample(plane.object, place[0], place[1], place[2], of_object),
              MOONTRACE_DONE);
    // places are off by rounding, at slopes of about 1
    EXPECT_NEAR(of_object[0], of_page[0], 1e-15);
    EXPECT_EQ(of_object[4], at[2]);
    double force[3], force_O[3];
    ASSERT_EQ(moontrace_force(open.page, nullptr, at[0], at[1], at[2], force), MOONTRACE_DONE);
    ASSERT_EQ(moontrace_object_force(plane.object, nullptr, place[0], place[1], place[2], force_O),
              MOONTRACE_DONE);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(force_O[k], force[k], 1e-6);
    felt += of_page[0] < 0 && force[2] > 0 ? 1 : 0;
  }
  EXPECT_GT(felt, 100);
}

/// Round the front of a mug, on its lid, on the left face of a box, on a ball, an egg, a handle.
TEST(LibraryObject, IsThatOfTheRoomsToTheLastBit) {
  const OpenPage open("it");
  const Script script = FindScript("moon");
  const TypeStyle style = DefaultStyle(script.size, Relief::kEngraved, script);
  const Typeset set = SetText("it", script, style, FindPage("a4"));
  const Texture texture = BuildTexture(set.pages.front(), script, style);
  const TextureField field(texture);
  const Box text_P = texture.layers.front().group->bounds;
  struct Case {
    moontrace_shape shape;
    Solid solid;
    Face face;
  };
  moontrace_shape lid = ShapeOf("cylinder", 0.04, 0.05), left = ShapeOf("box", 0.05, 0.06, 0.07);
  lid.face = "top";
  left.face = "left";
  left.turn = 0.3;
  left.u = 0.004;
  const Case cases[] = {
      {ShapeOf("cylinder", 0.04, 0.05), {SolidKind::kCylinder, {0.04, 0.05, 0}}, Face::kRound},
      {lid, {SolidKind::kCylinder, {0.04, 0.05, 0}}, Face::kTop},
      {left, {SolidKind::kBox, {0.05, 0.06, 0.07}}, Face::kLeft},
      {ShapeOf("sphere", 0.05), {SolidKind::kSphere, {0.05, 0, 0}}, Face::kRound},
      {ShapeOf("ellipsoid", 0.05, 0.06, 0.07),
       {SolidKind::kEllipsoid, {0.05, 0.06, 0.07}},
       Face::kRound},
      {ShapeOf("capsule", 0.03, 0.04), {SolidKind::kCapsule, {0.03, 0.04, 0}}, Face::kRound}};
  for (const Case& each : cases) {
    const OpenObject open_object(open.page, each.shape);
    const LabelPlace place{
        each.face, {each.shape.u, each.shape.v}, 0.5 * (text_P.min + text_P.max), each.shape.turn};
    LabelOnSolid label{LabelChart(each.solid, place), &field, 1};
    if (each.face == Face::kRound) {
      label.stretch = std::max(1.0, ScalesOf(label.chart, text_P).greatest);
    }
    const SurfaceLaw law = LawOn(each.solid, Surface(), {&label, 1});
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> x(text_P.min.x, text_P.max.x),
        y(text_P.min.y, text_P.max.y), z(-0.0012, 0.0002);
    std::vector<double> points, forces(3 * 1000), samples(5 * 1000);
    int felt = 0;
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 p_O = label.chart.ToObject({x(random), y(random), z(random)});
      const SolidContact expected = TouchSolid(law, each.solid, {&label, 1}, p_O);
      double sample[5], force[3];
      ASSERT_EQ(moontrace_object_sample(open_object.object, p_O.x, p_O.y, p_O.z, sample),
                MOONTRACE_DONE);
      EXPECT_EQ(sample[0], expected.displacement);
      EXPECT_EQ(sample[1], expected.gradient_O.x);
      EXPECT_EQ(sample[4], expected.nearest.height);
      ASSERT_EQ(moontrace_object_force(open_object.object, nullptr, p_O.x, p_O.y, p_O.z, force),
                MOONTRACE_DONE);
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(force[k], expected.force_O[k]);
        points.push_back(p_O[k]);
      }
      felt += expected.displacement < 0 ? 1 : 0;
    }
    EXPECT_GT(felt, 20) << each.shape.kind;

    // and all at once
    constexpr std::ptrdiff_t kThree = 3 * sizeof(double), kFive = 5 * sizeof(double);
    moontrace_forces many{sizeof many, 0,
                          1000,        points.data(),
                          kThree,      points.data() + 1,
                          kThree,      points.data() + 2,
                          kThree,      forces.data(),
                          kThree,      forces.data() + 1,
                          kThree,      forces.data() + 2,
                          kThree};
    ASSERT_EQ(moontrace_object_force_many(open_object.object, nullptr, &many), MOONTRACE_DONE);
    auto many_samples = Sized<moontrace_object_samples>();
    many_samples.count = 1000;
    many_samples.x = many.x;
    many_samples.y = many.y;
    many_samples.z = many.z;
    many_samples.x_step = many_samples.y_step = many_samples.z_step = kThree;
    many_samples.displacement = samples.data();
    many_samples.height = samples.data() + 4;
    many_samples.displacement_step = many_samples.height_step = kFive;
    ASSERT_EQ(moontrace_object_sample_many(open_object.object, &many_samples), MOONTRACE_DONE);
    for (std::size_t i = 0; i < 1000; ++i) {
      double sample[5], force[3];
      const double* p = points.data() + 3 * i;
      moontrace_object_sample(open_object.object, p[0], p[1], p[2], sample);
      moontrace_object_force(open_object.object, nullptr, p[0], p[1], p[2], force);
      ASSERT_EQ(samples[5 * i], sample[0]);
      ASSERT_EQ(samples[5 * i + 4], sample[4]);
      for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(forces[3 * i + k], force[k]);
    }
  }
}

TEST(LibraryObject, SaysHowThePageLies) {
  const OpenPage open("moon");
  const OpenObject ball(open.page, ShapeOf("sphere", 0.06));
  auto facts = Sized<moontrace_object_facts>();
  ASSERT_EQ(moontrace_object_describe(ball.object, &facts), MOONTRACE_DONE);
  EXPECT_STREQ(facts.face, "round");
  EXPECT_EQ(facts.greatest_depth, 0.03);  // half the radius
  EXPECT_GT(facts.text_width, 0.03);
  EXPECT_NEAR(facts.least_scale, 1, 0.02);
  EXPECT_GE(facts.greatest_scale, 1);
  const OpenObject plane(open.page, ShapeOf("plane", 0.1, 0.1));
  ASSERT_EQ(moontrace_object_describe(plane.object, &facts), MOONTRACE_DONE);
  EXPECT_STREQ(facts.face, "top");
  EXPECT_EQ(facts.greatest_scale, 1);
  EXPECT_TRUE(std::isinf(facts.greatest_depth));
}

TEST(LibraryObject, OutlivesItsPage) {
  OpenPage open("moon");
  const OpenObject plane(open.page, ShapeOf("plane", 0.1, 0.1));
  double before[5], after[5], place[3];
  ASSERT_EQ(moontrace_object_place(plane.object, 0.02, 0.275, 0, place), MOONTRACE_DONE);
  ASSERT_EQ(moontrace_object_sample(plane.object, place[0], place[1], 0, before), MOONTRACE_DONE);
  ASSERT_EQ(moontrace_page_close(open.page), MOONTRACE_DONE);
  open.page = nullptr;
  ASSERT_EQ(moontrace_object_sample(plane.object, place[0], place[1], 0, after), MOONTRACE_DONE);
  EXPECT_EQ(before[0], after[0]);
}

TEST(LibraryObject, ShapesThatCannotBeAreRefused) {
  const OpenPage open("moon");
  ExpectRefused(open.page, ShapeOf("cone", 1), MOONTRACE_BAD_INPUT, "shape.kind is one of");
  ExpectRefused(open.page, ShapeOf(nullptr, 1), MOONTRACE_BAD_CALL, "shape.kind is NULL");
  ExpectRefused(open.page, ShapeOf("box", 0.1, 0.1), MOONTRACE_BAD_CALL, "3 sizes above 0");
  ExpectRefused(open.page, ShapeOf("sphere", kNan), MOONTRACE_BAD_CALL, "shape.half");
  ExpectRefused(open.page, ShapeOf("sphere", -1), MOONTRACE_BAD_CALL, "shape.half");
  ExpectRefused(open.page, ShapeOf("sphere", 0), MOONTRACE_BAD_CALL, "give 1 size above 0 for");
  ExpectRefused(open.page, ShapeOf("box", 0.01, 0.01, 0.01), MOONTRACE_BAD_INPUT, "has no room");
  moontrace_shape shape = ShapeOf("sphere", 0.05);
  shape.face = "top";
  ExpectRefused(open.page, shape, MOONTRACE_BAD_INPUT, "has no face top");
  shape.face = "inside";
  ExpectRefused(open.page, shape, MOONTRACE_BAD_INPUT, "shape.face is one of");
  shape = ShapeOf("plane", 0.1, 0.1);
  shape.turn = kNan;
  ExpectRefused(open.page, shape, MOONTRACE_BAD_CALL, "shape.turn");
  shape.turn = 0;
  shape.size = 3;
  ExpectRefused(open.page, shape, MOONTRACE_BAD_CALL, "shape.size");
  ExpectRefused(nullptr, ShapeOf("plane", 0.1), MOONTRACE_BAD_CALL, "page is NULL");
}

/// At the bound all that is answered are numbers.
TEST(LibraryObject, SizesAndPlacesAreAtMostAThousandMetres) {
  const OpenPage open("moon");
  for (const char* kind : {"plane", "box", "cylinder", "sphere", "capsule", "ellipsoid"}) {
    for (const double size : {1000.001, 1e300}) {
      ExpectRefused(open.page, ShapeOf(kind, size, 0.1, 0.1), MOONTRACE_BAD_CALL,
                    "shape.half is above 1000 m");
      moontrace_shape far = ShapeOf(kind, 0.1, 0.2, 0.1);
      far.u = size;
      ExpectRefused(open.page, far, MOONTRACE_BAD_CALL, "shape.u is above 1000 m");
      far.u = 0;
      far.v = -size;
      ExpectRefused(open.page, far, MOONTRACE_BAD_CALL, "shape.v is below -1000");
    }
    const OpenObject largest(open.page, ShapeOf(kind, 1000, 1000, 1000));
    double place[3] = {kNan, kNan, kNan}, sample[5], force[3];
    ASSERT_EQ(moontrace_object_place(largest.object, 0.03, 0.27, -1e-4, place), MOONTRACE_DONE);
    ASSERT_EQ(moontrace_object_sample(largest.object, place[0], place[1], place[2], sample),
              MOONTRACE_DONE);
    ASSERT_EQ(moontrace_object_force(largest.object, nullptr, place[0], place[1], place[2], force),
              MOONTRACE_DONE);
    for (const double value : place) EXPECT_TRUE(std::isfinite(value)) << kind;
    for (const double value : sample) EXPECT_TRUE(std::isfinite(value)) << kind;
    for (const double value : force) EXPECT_TRUE(std::isfinite(value)) << kind;
  }
}

TEST(LibraryObject, PointsAndHandlesThatAreNoneAreRefused) {
  const OpenPage open("moon");
  const moontrace_shape shape = ShapeOf("plane", 0.1, 0.1);
  moontrace_object* object = nullptr;
  ASSERT_EQ(moontrace_object_open(open.page, &shape, &object), MOONTRACE_DONE);
  double five[5] = {9, 9, 9, 9, 9}, three[3];
  EXPECT_EQ(moontrace_object_sample(object, 0, kNan, 0, five), MOONTRACE_BAD_CALL);
  EXPECT_EQ(five[0] + five[4], 0);
  EXPECT_EQ(moontrace_object_force(object, nullptr, 0, 0, kNan, three), MOONTRACE_BAD_CALL);
  EXPECT_EQ(moontrace_object_place(object, kNan, 0, 0, three), MOONTRACE_BAD_CALL);
  EXPECT_EQ(moontrace_object_sample(object, 0, 0, 0, nullptr), MOONTRACE_BAD_CALL);
  EXPECT_EQ(moontrace_object_sample_many(object, nullptr), MOONTRACE_BAD_CALL);
  const double bad[2] = {0, kNan}, zero = 0;
  double heights[2] = {9, 9};
  auto samples = Sized<moontrace_object_samples>();
  samples.count = 2;
  samples.x = bad;
  samples.x_step = sizeof(double);
  samples.y = samples.z = &zero;
  samples.height = heights;
  samples.height_step = sizeof(double);
  EXPECT_EQ(moontrace_object_sample_many(object, &samples), MOONTRACE_BAD_CALL);
  EXPECT_STREQ(moontrace_message(), "point 1 is not finite");
  EXPECT_EQ(heights[1], 0);
  ASSERT_EQ(moontrace_object_close(object), MOONTRACE_DONE);
  EXPECT_EQ(moontrace_object_close(object), MOONTRACE_BAD_CALL);
  EXPECT_EQ(moontrace_object_sample(object, 0, 0, 0, five), MOONTRACE_BAD_CALL);
  EXPECT_EQ(moontrace_object_close(nullptr), MOONTRACE_DONE);
}

}  // namespace
}  // namespace moontrace

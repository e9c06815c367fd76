#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "tests/sim/loop_fixture.h"

namespace moontrace {
namespace {

// Top faces: of `table` at z = 0, of `shelf` at z = 0.05, 0.2 m to the right. `can`: a cylinder of
// 50 mm radius that lies along x behind them, its label on its upper side.
constexpr const char* kModel = R"(
<mujoco>
  <option gravity="0 0 0"/>
  <custom>
    <text name="moontrace:table" data="{text='O', middle_mm=[0,0]}"/>
    <text name="moontrace:shelf" data="{text='O', middle_mm=[0,0]}"/>
    <text name="moontrace:can" data="{text='O'}"/>
  </custom>
  <worldbody>
    <geom name="table" type="box" size="0.05 0.05 0.02" pos="0 0 -0.02"/>
    <geom name="shelf" type="box" size="0.05 0.05 0.02" pos="0.2 0 0.03"/>
    <geom name="can" type="cylinder" size="0.05 0.05" pos="0 0.3 0" euler="90 0 0"/>
  </worldbody>
</mujoco>)";
constexpr double kDeep = 0.001;  // page and coupling give 1000 N/m each: 0.5 N
constexpr int kSettled = 400;

class LoopLabels : public LoopTickTest {
 protected:
  void BeginOn(std::size_t label, ScriptedDevice::ReadFunction read,
               const DeviceLimits& limits = {}, const LoopOptions& options = {}) {
    SceneOptions on;
    on.label = label;
    tick_ =
        std::make_unique<LoopTick>(Scene::FromXml(kModel, "three", on), field_,
                                   std::make_unique<ScriptedDevice>(log_, std::move(read), limits),
                                   DevicePlace{}, options, mail_);
  }
  void GoTo(std::size_t label, const DevicePlace& place_P, std::optional<PageAnchor> anchor) {
    PostedPage posted;
    posted.ready = tick_->scene().MakeReady(label, &field_, {});
    posted.page = 5;
    posted.place_P = place_P;
    posted.anchor = anchor;
    mail_.wanted_page = &posted;
    for (int i = 0; i < 100 && mail_.done_page.load() == nullptr; ++i) Run(1);
    EXPECT_NE(mail_.done_page.exchange(nullptr), nullptr);
  }
};

// The world stays: the tip is where it was, told on the other page.
TEST_F(LoopLabels, AnotherLabelWithinReachIsThePageWhereItLies) {
  BeginOn(0, HoldAt({0.01, 0, -kDeep}));
  Run(kSettled);
  EXPECT_EQ(Newest().geom, mj_name2id(tick_->scene().model(), mjOBJ_GEOM, "table"));
  GoTo(1, {}, PageAnchor{});
  Run(kSettled);
  const LoopSnapshot now = Newest();
  EXPECT_EQ(now.page, 5U);
  // the shelf's page begins in its middle
  EXPECT_NEAR(glm::distance(now.tip_P, glm::dvec3(-0.19, 0, -0.05 - kDeep)), 0, 1e-12);
  EXPECT_FALSE(Told(LoopEventKind::kModelMoved));
  EXPECT_NEAR(log_.last().z, 0.5, 1e-3);  // the table is felt as before
  EXPECT_EQ(now.geom, mj_name2id(tick_->scene().model(), mjOBJ_GEOM, "table"));
}

TEST_F(LoopLabels, AModelIsMovedWhereItsLabelIsOutOfReach) {
  DeviceLimits limits;
  limits.workspace_D = glm::dvec3(0.1);
  BeginOn(0, HoldAt({0.01, 0, -kDeep}), limits);
  Run(kSettled);
  DevicePlace place;  // the device's middle over this point of the page
  place.origin_W = {0.02, 0.01, 0};
  GoTo(1, place, PageAnchor{});
  EXPECT_TRUE(Told(LoopEventKind::kModelMoved));
  EXPECT_EQ(log_.last(), glm::dvec3(0));
  Run(kSettled);
  // the hand was below the label's plane: it is in the air now, and feels nothing
  const glm::dvec3 tip_P = Newest().tip_P;
  EXPECT_NEAR(tip_P.x, 0.03, 1e-12);
  EXPECT_NEAR(tip_P.y, 0.01, 1e-12);
  EXPECT_NEAR(tip_P.z, 0.005, 1e-12);
  EXPECT_EQ(log_.last(), glm::dvec3(0));
}

// A device that is laid on the page has the cylinder unrolled under it: x is the way around.
TEST_F(LoopLabels, ADeviceOnTheRoundPageGoesRoundIt) {
  constexpr double kRadius = 0.05, kTurn = std::numbers::pi / 3;
  DeviceLimits limits;
  limits.pushes = glm::bvec3(true);
  LoopOptions options;
  options.on_page = true;
  for (const double turn : {0.0, kTurn, -kTurn}) {
    BeginOn(2, HoldAt({turn * kRadius, 0.01, -kDeep}), limits, options);
    Run(kSettled);
    const LoopSnapshot now = Newest();
    EXPECT_NEAR(glm::distance(now.tip_P, glm::dvec3(turn * kRadius, 0.01, -kDeep)), 0, 1e-12);
    EXPECT_NEAR(log_.last().x, 0, 1e-6) << turn;
    EXPECT_NEAR(log_.last().y, 0, 1e-6) << turn;
    EXPECT_NEAR(log_.last().z, 0.5, 1e-3) << turn;
    EXPECT_NEAR(glm::distance(now.force_P, log_.last()), 0, 1e-12);
    EXPECT_EQ(now.geom, mj_name2id(tick_->scene().model(), mjOBJ_GEOM, "can"));
  }
}

// A spring of 200 N/m, 4 mm of way, page and coupling 1000 N/m each: pressed d deep at first, the
// button yields by y with (d - y) 500 = 200 y.
TEST_F(LoopLabels, AButtonTellsHowFarItHasGivenWay) {
  constexpr const char* kButton = R"(
<mujoco>
  <option gravity="0 0 0"/>
  <custom><text name="moontrace:key" data="{text='O', middle_mm=[0,0]}"/></custom>
  <worldbody>
    <body>
      <joint type="slide" axis="0 0 1" limited="true" range="-0.004 0" stiffness="200" damping="4"/>
      <geom name="key" type="box" size="0.02 0.02 0.01" pos="0 0 -0.01" mass="0.1"/>
    </body>
  </worldbody>
</mujoco>)";
  for (const double deep : {0.0035, 0.0056}) {  // of the latter all
    tick_ =
        std::make_unique<LoopTick>(Scene::FromXml(kButton, "button", {}), field_,
                                   std::make_unique<ScriptedDevice>(log_, HoldAt({0, 0, -deep})),
                                   DevicePlace{}, LoopOptions(), mail_);
    Run(3 * kSettled);
    const LoopSnapshot now = Newest();
    EXPECT_EQ(now.geom, mj_name2id(tick_->scene().model(), mjOBJ_GEOM, "key"));
    EXPECT_NEAR(now.gives, deep * 500 / 700 / 0.004, 0.02) << deep;
  }
  EXPECT_EQ(tick_->scene().gives(-1), 0);
}

// From the flat page to the round one and back, by a device that is laid on them.
TEST_F(LoopLabels, ADeviceOnThePageIsLaidOnTheNextOne) {
  LoopOptions options;
  options.on_page = true;
  BeginOn(0, HoldAt({0.01, 0.02, -kDeep}), {}, options);
  Run(kSettled);
  for (const std::size_t label : {std::size_t{2}, std::size_t{1}}) {
    GoTo(label, {}, std::nullopt);
    Run(kSettled);
    EXPECT_NEAR(glm::distance(Newest().tip_P, glm::dvec3(0.01, 0.02, -kDeep)), 0, 1e-12);
    EXPECT_NEAR(log_.last().z, 0.5, 1e-3);
    GoTo(0, {}, PageAnchor{{0, 0}, {-0.03, 0.01}, 0});
    Run(kSettled);
    EXPECT_NEAR(glm::distance(Newest().tip_P, glm::dvec3(-0.03, 0.01, -kDeep)), 0, 1e-12);
  }
}

// A sheet that nothing holds falls from rest: at 9.81 m/s^2 it is faster than 1.5 m/s after 153 ms.
TEST_F(LoopLabels, AHandLetsGoOfAPageThatFlees) {
  constexpr const char* kSheet = R"(
<mujoco>
  <custom><text name="moontrace:sheet" data="{text='O', middle_mm=[0,0]}"/></custom>
  <worldbody>
    <body>
      <joint type="slide" axis="0 0 1"/>
      <geom name="sheet" type="box" size="0.05 0.05 0.01" pos="0 0 -0.01" mass="0.02"/>
    </body>
  </worldbody>
</mujoco>)";
  constexpr double kOver = 0.001;  // the sheet, which the hand does not touch
  LoopOptions options;
  options.on_page = true;
  tick_ = std::make_unique<LoopTick>(Scene::FromXml(kSheet, "sheet", {}), field_,
                                     std::make_unique<ScriptedDevice>(log_, HoldAt({0, 0, kOver})),
                                     DevicePlace{}, options, mail_);
  const auto height_W = [this] { return tick_->scene().X_WP().p.z; };
  while (ticks_ < 200 && !Told(LoopEventKind::kPageGone)) Run(1);
  EXPECT_NEAR(ticks_, 154, 2);
  LoopSnapshot now = Newest();
  EXPECT_TRUE(now.stopped);
  // the hand rests where it was, over a sheet that fell 1.5 mm in each tick since
  EXPECT_GT(now.tip_P.z, kOver + 0.0015);
  EXPECT_LT(now.tip_P.z, kOver + 2 * 0.0016);
  const double rests_W = now.tip_P.z + height_W();
  Run(100);
  now = Newest();
  EXPECT_NEAR(now.tip_P.z + height_W(), rests_W, 0.0015);  // how far it falls in a tick more
  EXPECT_EQ(log_.last(), glm::dvec3(0));
  EXPECT_FALSE(Told(LoopEventKind::kPageGone));  // once
  // a hand that goes on is back over the page, which still flees
  mail_.go_on = true;
  Run(2);
  EXPECT_NEAR(Newest().tip_P.z, kOver, 2 * 0.0026);  // it has fallen 0.2 m since
  Run(1);
  EXPECT_TRUE(Told(LoopEventKind::kPageGone));
  EXPECT_TRUE(Newest().stopped);
}

}  // namespace
}  // namespace moontrace

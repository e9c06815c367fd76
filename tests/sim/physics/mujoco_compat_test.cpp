#include "sim/physics/mujoco_compat.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace moontrace {
namespace {

/// A tip on three slides and a pendulum; `joint` are attributes of the pendulum's hinge.
ModelPtr Model(const std::string& flags, const std::string& joint, const std::string& more) {
  const std::string xml =
      "<mujoco><option timestep='0.001'><flag " + flags +
      "/></option><worldbody><body name='tip'><joint type='slide' axis='1 0 0'/><joint "
      "type='slide' axis='0 1 0'/><joint type='slide' axis='0 0 1'/><geom type='sphere' "
      "mass='0.05' size='0.001'/></body><body name='arm'><joint name='hinge' type='hinge' axis='0 "
      "1 0' " +
      joint +
      "/><geom name='arm' type='capsule' fromto='0 0 0 0.1 0 0' size='0.01'/></body></worldbody>" +
      more + "</mujoco>";
  std::string warning;
  return CompileMjcf(xml, "idle.xml", "idle.xml", warning);
}

int FlagsAfter(const std::string& flags, const std::string& joint, const std::string& more) {
  const ModelPtr m = Model(flags, joint, more);
  const int before = m->opt.disableflags;
  SkipIdleStages(*m);
  EXPECT_EQ(m->opt.disableflags & before, before);
  return m->opt.disableflags & ~before;
}

constexpr const char* kNoContact = "contact='disable'";

/// Everything that a hundred pushed steps leave behind.
std::vector<double> WayOf(const mjModel& m) {
  const DataPtr d = MakeData(m, "idle.xml");
  std::vector<double> state;
  for (int i = 0; i < 100; ++i) {
    mj_step1(&m, d.get());
    d->qfrc_applied[0] = 0.01 * i;
    d->qfrc_applied[3] = 0.02;
    mj_step2(&m, d.get());
    for (const double* values : {d->qpos, d->qvel, d->qacc, d->qacc_warmstart, d->qfrc_passive,
                                 d->qfrc_constraint, d->qfrc_bias}) {
      state.insert(state.end(), values, values + m.nv);
    }
    state.push_back(d->time);
  }
  return state;
}

TEST(SkipIdleStages, LeavesEveryBitOfAStepAsItWas) {
  const ModelPtr whole = Model(kNoContact, "", ""), skipping = Model(kNoContact, "", "");
  SkipIdleStages(*skipping);
  ASSERT_NE(skipping->opt.disableflags, whole->opt.disableflags);
  EXPECT_EQ(WayOf(*whole), WayOf(*skipping));
}

TEST(SkipIdleStages, KeepsConstraintsThatTheModelHas) {
  EXPECT_NE(FlagsAfter(kNoContact, "", "") & mjDSBL_CONSTRAINT, 0);
  EXPECT_EQ(FlagsAfter("contact='enable'", "", "") & mjDSBL_CONSTRAINT, 0);
  EXPECT_EQ(FlagsAfter(kNoContact, "limited='true' range='-1 1'", "") & mjDSBL_CONSTRAINT, 0);
  EXPECT_EQ(FlagsAfter(kNoContact, "frictionloss='0.1'", "") & mjDSBL_CONSTRAINT, 0);
  EXPECT_EQ(FlagsAfter(kNoContact, "", "<equality><joint joint1='hinge'/></equality>") &
                mjDSBL_CONSTRAINT,
            0);
}

TEST(SkipIdleStages, KeepsSensorsThatTheModelHas) {
  EXPECT_NE(FlagsAfter(kNoContact, "", "") & mjDSBL_SENSOR, 0);
  EXPECT_EQ(
      FlagsAfter(kNoContact, "", "<sensor><jointpos joint='hinge'/></sensor>") & mjDSBL_SENSOR, 0);
}

#if mjVERSION_HEADER < 230
TEST(SkipIdleStages, KeepsPassiveForcesThatTheModelHas) {
  EXPECT_NE(FlagsAfter(kNoContact, "", "") & mjDSBL_PASSIVE, 0);
  EXPECT_EQ(FlagsAfter(kNoContact, "damping='0.1'", "") & mjDSBL_PASSIVE, 0);
  EXPECT_EQ(FlagsAfter(kNoContact, "stiffness='1'", "") & mjDSBL_PASSIVE, 0);
  EXPECT_EQ(
      FlagsAfter(kNoContact, "", "<option density='1.2' viscosity='0.00002'/>") & mjDSBL_PASSIVE,
      0);
}
#endif

}  // namespace
}  // namespace moontrace

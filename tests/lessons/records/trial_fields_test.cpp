#include "lessons/records/trial_fields.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "tests/lessons/records_fixture.h"

namespace moontrace {
namespace {

TEST(TrialFields, CarryEveryMemberOver) {
  const Trial from = NumberedTrial(4);
  Trial to;
  std::set<std::string> names;
  for (const TrialField& field : TrialFields()) {
    EXPECT_NE(field.get(from), field.get(to)) << field.name << ": the test's trial has its default";
    EXPECT_TRUE(field.set(to, field.get(from))) << field.name;
    EXPECT_EQ(field.get(from), field.get(to)) << field.name;
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
  }
}

// A member that is added to Trial and not to the fields would be lost: this fails to compile then.
TEST(TrialFields, AreAsManyAsTheMembers) {
  const auto& [time, lesson, step, kind, item, size, guidance, help, probe, scaled, simulated,
               answer, right, latency, coverage, mean_error, rms_error, error_widths, wander_offs,
               duration, log_jerk, spectral_arc, mean_force, mean_guidance, guidance_work] =
      NumberedTrial(1);
  EXPECT_EQ(TrialFields().size(), 25U);
  EXPECT_EQ(time, NumberedTrial(1).time);
  EXPECT_EQ(guidance_work, NumberedTrial(1).guidance_work);
}

TEST(TrialFields, RefuseWhatAMemberCannotHold) {
  Trial trial;
  const auto refused = [&trial](const std::string& name, const TrialField::Value& value) {
    for (const TrialField& field : TrialFields()) {
      if (field.name == name) return !field.set(trial, value);
    }
    return false;
  };
  EXPECT_TRUE(refused("kind", std::string("trance")));
  EXPECT_TRUE(refused("guidance", std::string("")));
  EXPECT_TRUE(refused("kind", std::int64_t{1}));
  EXPECT_TRUE(refused("step", std::int64_t{-1}));
  EXPECT_TRUE(refused("help", std::int64_t{1} << 40));
  EXPECT_TRUE(refused("probe", std::int64_t{2}));
  EXPECT_TRUE(refused("size_m", std::string("1")));
  EXPECT_TRUE(refused("size_m", std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(refused("lesson", 1.0));
}

}  // namespace
}  // namespace moontrace

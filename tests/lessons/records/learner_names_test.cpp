#include "lessons/records/learner_names.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

std::vector<LearnerEntry> Known(const std::vector<std::string>& people) {
  std::vector<LearnerEntry> known{{"robot", 0, false, "", true}};
  for (const std::string& name : people) known.push_back({name, 0, false, "", false});
  return known;
}

TEST(LearnerNames, SimulatedLearnersAreNoPeople) {
  EXPECT_EQ(PeopleAmong(Known({"Ann", "Bob"})), (std::vector<std::string>{"Ann", "Bob"}));
}

TEST(LearnerNames, AreKnownButForCapitals) {
  EXPECT_EQ(KeptName("ANN", Known({"Ann", "Bob"})), "Ann");
  EXPECT_EQ(KeptName("zoe", Known({"Ann", "Bob"})), "zoe");
  EXPECT_EQ(KeptName("ROBOT", Known({"Ann"})), "ROBOT");  // who is new
}

TEST(LearnerNames, AreAsGivenWhereTwoPeopleDifferByCapitalsOnly) {
  EXPECT_EQ(KeptName("ann", Known({"Ann", "ann"})), "ann");
  EXPECT_EQ(KeptName("ANN", Known({"Ann", "ann"})), "ANN");
}

}  // namespace
}  // namespace moontrace

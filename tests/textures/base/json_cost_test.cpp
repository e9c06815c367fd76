#include "textures/base/json_cost.h"

#include <gtest/gtest.h>

#include <string>

namespace moontrace {
namespace {

TEST(JsonCost, CountsBracketsWithinBrackets) {
  EXPECT_EQ(CostOf("7").depth, 0U);
  EXPECT_EQ(CostOf("{}").depth, 1U);
  EXPECT_EQ(CostOf("[[1],{\"a\":[2]},3]").depth, 3U);
  EXPECT_EQ(CostOf(std::string(1000, '[')).depth, 1000U);
  EXPECT_EQ(CostOf("]]]}[").depth, 1U);  // no JSON, and no count below zero
}

TEST(JsonCost, CountsNoFewerValuesThanThereAre) {
  EXPECT_EQ(CostOf("7").values, 1U);
  EXPECT_GE(CostOf("[1,2,3]").values, 4U);
  EXPECT_LE(CostOf("[1,2,3]").values, 6U);
  // a list of n numbers costs n, one of n objects two each and a comma
  std::string numbers = "[0", objects = "[{}";
  for (int i = 1; i < 1000; ++i) {
    numbers += ",0";
    objects += ",{}";
  }
  EXPECT_NEAR(static_cast<double>(CostOf(numbers + "]").values), 1000, 3);
  EXPECT_NEAR(static_cast<double>(CostOf(objects + "]").values), 3000, 3);
}

TEST(JsonCost, TakesNothingWithinTexts) {
  EXPECT_EQ(CostOf(R"(["[[,:{","\"[[","\\"])").depth, 1U);
  EXPECT_EQ(CostOf(R"(["[[,:{","\"[[","\\"])").values, CostOf("[1,2,3]").values);
  EXPECT_EQ(CostOf(R"("\\[[")").depth, 0U);
  EXPECT_EQ(CostOf("\"[").depth, 0U);   // not closed
  EXPECT_EQ(CostOf("\"\\").depth, 0U);  // ends within an escape
}

}  // namespace
}  // namespace moontrace

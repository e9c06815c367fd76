#include "lessons/measure/covered_length.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace moontrace {
namespace {

TEST(CoveredLength, CountsNothingTwice) {
  CoveredLength covered(4);
  EXPECT_EQ(covered.Total(), 0);
  covered.Add(1, 3);
  covered.Add(2, 4);
  covered.Add(1.5, 2.5);
  covered.Add(1, 3);
  EXPECT_EQ(covered.Total(), 3);
}

TEST(CoveredLength, JoinsWhatANewIntervalBridges) {
  CoveredLength covered(4);
  covered.Add(6, 7);
  covered.Add(0, 1);
  covered.Add(2, 3);
  covered.Add(4, 5);
  EXPECT_EQ(covered.Total(), 4);
  covered.Add(0.5, 4.5);  // bridges the first three
  EXPECT_EQ(covered.Total(), 6);
  covered.Add(5, 6);  // touches both neighbours
  EXPECT_EQ(covered.Total(), 7);
}

TEST(CoveredLength, IgnoresIntervalsTurnedRound) {
  CoveredLength covered(4);
  covered.Add(2, 1);
  EXPECT_EQ(covered.Total(), 0);
}

// Against cells ticked one by one; all numbers are whole, so sums are exact.
TEST(CoveredLength, AgreesWithTickingCells) {
  std::uint32_t state = 1;
  const auto next = [&] { return (state = state * 1664525u + 1013904223u) >> 16; };
  for (int round = 0; round < 200; ++round) {
    CoveredLength covered(1);
    std::vector<bool> cells(1000, false);
    for (int i = 0; i < 30; ++i) {
      const unsigned begin = next() % 980, end = begin + next() % 20;
      covered.Add(begin, end);
      for (unsigned cell = begin; cell < end; ++cell) cells[cell] = true;
    }
    int ticked = 0;
    for (const bool cell : cells) ticked += cell ? 1 : 0;
    ASSERT_EQ(covered.Total(), ticked);
  }
}

}  // namespace
}  // namespace moontrace

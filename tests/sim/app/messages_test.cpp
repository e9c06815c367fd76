#include "sim/app/messages.h"
#include "sim/setup/setup_messages.h"
#include "sim/study/study_messages.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(Messages, NeverRoundCoverageUpToAWhole) {
  TrialResult result;
  result.score.total.coverage = 0.99996;
  EXPECT_EQ(say::TraceOutcome(result, 2, false), "Traced: 99.9 percent covered, 2 letters.");
  result.score.total.coverage = 1;
  EXPECT_EQ(say::TraceOutcome(result, 1, true), "Blank page: 100 percent covered, 1 letter.");
}

TEST(Messages, RoundTheForceBoundUp) {
  TrialResult result;
  result.force_bound = 4.341;
  EXPECT_EQ(say::ForceBound(result), "Force bound: 4.35 N for an evenly moving hand.");
  result.force_bound = 3;
  EXPECT_EQ(say::ForceBound(result), "Force bound: 3 N for an evenly moving hand.");
}

TEST(Messages, TellFiguresOfTheBenchWithoutExponents) {
  EXPECT_EQ(say::BenchLine(Shown("wall", 1.5e7, "N/m")), "wall: 15000000 N/m");
  EXPECT_EQ(say::BenchLine(AtLeast("wall", 24030.4, "N/m", 1e6)),
            "Missed: wall: 24030 N/m, at least 1000000.");
  EXPECT_EQ(say::BenchLine(AtMost("energy", 0.0123456, "mJ", 0.5)),
            "Holds: energy: 0.01235 mJ, at most 0.5.");
  EXPECT_EQ(say::BenchLine(AtMost("energy", 0.000012346, "mJ", 0.5)),
            "Holds: energy: below 0.0001 mJ, at most 0.5.");
  EXPECT_EQ(say::BenchLine(Shown("nothing", 0, "mJ")), "nothing: 0 mJ");
  EXPECT_EQ(say::OutOfRange("--seconds", "-1", 0.01, 1e6),
            "--seconds is -1: write a number from 0.01 to 1000000");
}

TEST(Messages, SayOfAStopAndOfAStudyWhatAnybodyUnderstands) {
  EXPECT_EQ(say::Stopped(), "Stopped, as you asked. No file is left half written.");
  EXPECT_NE(say::StudyProves().find("not how people learn"), std::string::npos);
}

TEST(Messages, CountInWords) {
  TraceMetrics total;
  EXPECT_EQ(say::LeftGroove(total, {}, false), "Left the groove: never.");
  EXPECT_EQ(say::LeftGroove(total, {}, true), "Left where a groove would be: never.");
  total.excursions = 1;
  EXPECT_EQ(say::LeftGroove(total, {}, false), "Left the groove: once.");
  total.excursions = 3;
  TypeStyle ridges;
  ridges.relief = Relief::kEmbossed;
  EXPECT_EQ(say::LeftGroove(total, ridges, false), "Left the ridge: 3 times.");
}

TEST(Messages, KeepForeignTextOnOneLine) {
  EXPECT_EQ(say::UnknownOption("--a\nb\x1b[1m", "page", "").find('\n'), std::string::npos);
  EXPECT_EQ(say::UnknownOption("--a\nb\x1b[1m", "page", "").find('\x1b'), std::string::npos);
  EXPECT_LT(say::NotANumber("--seed", std::string(5000, '9')).size(), 200U);
}

}  // namespace
}  // namespace moontrace

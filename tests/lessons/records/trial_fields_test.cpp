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

TEST(TrialsCsv, HasARowForEachTrialWithAllDigits) {
  Trial trial;
  trial.time = 1'699'963'200;  // noon of 2023-11-14, UTC
  trial.lesson = "1";
  trial.step = 1;
  trial.kind = StepKind::kRecognise;
  trial.item = "a,\"b";
  trial.size = 0.02;
  trial.answer = "x\ny";
  trial.latency = 0.1;
  const std::string csv = TrialsToCsv("bat", "small", {trial, Trial()});
  EXPECT_EQ(csv.substr(0, csv.find("\r\n")),
            "learner,course,time_unix_s,lesson,step,kind,item,size_m,guidance,help,probe,scaled,"
            "simulated,answer,right_answer,latency_s,coverage,mean_error_m,rms_error_m,"
            "error_widths,wander_offs,duration_s,log_jerk,spectral_arc,mean_force_N,"
            "mean_guidance_N,guidance_work_J");
  EXPECT_EQ(csv.substr(csv.find("\r\n") + 2),
            "bat,small,1699963200,1,1,recognise,\"a,\"\"b\",0.02,off,0,0,0,0,\"x\ny\",0,0.1,0,0,0,"
            "0,0,0,0,0,0,0,0\r\n");
}

// A spreadsheet runs a cell that begins so as a formula (OWASP, CSV injection).
TEST(TrialsCsv, HasNoTextThatASpreadsheetWouldRun) {
  Trial trial;
  trial.lesson = "1";
  trial.item = "-";
  trial.answer = "=cmd|' /C calc'!A0";
  trial.log_jerk = -5.25;
  std::string csv = TrialsToCsv("@bat", "+1", {trial});
  csv.erase(0, csv.find("\r\n") + 2);
  EXPECT_EQ(csv.substr(0, csv.find(",1,")), "'@bat,'+1,0");
  EXPECT_NE(csv.find(",'-,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",'=cmd|' /C calc'!A0,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",-5.25,"), std::string::npos) << csv;  // a number is none
  for (const std::string begin : {"\t=1", "\r=1"}) {
    trial.answer = begin;
    csv = TrialsToCsv("bat", "c", {trial});
    EXPECT_NE(csv.find("'" + begin), std::string::npos) << csv;
  }
  trial.answer = "=\"x\",1";
  EXPECT_NE(TrialsToCsv("bat", "c", {trial}).find(",\"'=\"\"x\"\",1\","), std::string::npos);
}

}  // namespace
}  // namespace moontrace

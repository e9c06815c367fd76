#include "lessons/records/records.h"
#include <pwd.h>
#include <unistd.h>

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lessons/records/trial_fields.h"
#include "tests/lessons/records_fixture.h"

namespace moontrace {
namespace {

void ExpectEqual(const Trial& a, const Trial& b) {
  for (const TrialField& field : TrialFields()) EXPECT_EQ(field.get(a), field.get(b)) << field.name;
}

unsigned RightsOf(const std::filesystem::path& path) {
  struct stat found {};
  EXPECT_EQ(stat(path.c_str(), &found), 0) << path;
  return found.st_mode & 0777U;
}

class RecordsFile : public RecordsTest {};

TEST_F(RecordsFile, GivesBackEveryMemberOfATrialToTheBit) {
  Records::Open(path_).AddLearner({"bat", 1'699'999'999, true, "2", true});
  Records::Open(path_).Add("bat", "learn-moon", NumberedTrial(3));
  const Records records = Records::OpenToRead(path_);
  const std::vector<Trial> trials = records.Trials("bat");
  ASSERT_EQ(trials.size(), 1U);
  ExpectEqual(trials[0], NumberedTrial(3));
  const LearnerEntry learner = records.Find("bat").value();
  EXPECT_EQ(learner.since, 1'699'999'999);
  EXPECT_TRUE(learner.keeps_tracks);
  EXPECT_EQ(learner.consent, "2");
  EXPECT_TRUE(learner.simulated);
}

// A board without a battery comes up in 1970: what was added later comes later, whatever the clock
// said.
TEST_F(RecordsFile, GivesTrialsAndEventsInTheOrderInWhichTheyWereAdded) {
  Records records = Records::Open(path_);
  records.AddLearner(Named("bat"));
  const Trial late = NumberedTrial(9);
  const Trial early = NumberedTrial(1);
  records.Add("bat", "a", late);
  records.Add("bat", "b", early);
  Trial third = late;
  third.item = "third";
  records.Add("bat", "a", third);
  records.AddEvent("bat", {7, "tutor", "size 20"});
  records.AddEvent("bat", {5, "break", ""});
  const std::vector<Trial> all = records.Trials("bat");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].time, late.time);
  EXPECT_EQ(all[1].time, early.time);
  EXPECT_EQ(all[2].item, "third");
  EXPECT_EQ(records.Trials("bat", "b").size(), 1U);
  EXPECT_EQ(records.Courses("bat"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(records.LastCourse("bat"), "a");
  const std::vector<RecordedEvent> events = records.Events("bat");
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].text, "size 20");
  EXPECT_EQ(events[1].kind, "break");
  // and so through an export
  records.Import(HistoryFromJson(
                     [&] {
                       std::string text = records.Export("bat");
                       return text.replace(text.find("bat"), 3, "owl");
                     }(),
                     "test"),
                 "test");
  const std::vector<Trial> again = records.Trials("owl");
  ASSERT_EQ(again.size(), 3U);
  EXPECT_EQ(again[1].time, early.time);
}

TEST_F(RecordsFile, KeepsLearnersApart) {
  Records records = Records::Open(path_);
  records.AddLearner(Named("owl"));
  records.AddLearner(Named("bat"));
  records.Add("owl", "c", NumberedTrial(1));
  EXPECT_EQ(records.Trials("owl").size(), 1U);
  EXPECT_TRUE(records.Trials("bat").empty());
  EXPECT_EQ(records.Learners().front().pseudonym, "bat");
  EXPECT_FALSE(records.Find("cat"));
}

TEST_F(RecordsFile, IsTheOwnersAlone) {
  path_ = (folder_ / "data" / "moontrace" / "records.sqlite").string();
  Records::Open(path_).AddLearner(Named("bat"));
  EXPECT_EQ(RightsOf(path_), 0600U);
  EXPECT_EQ(RightsOf(folder_ / "data"), 0700U);
  EXPECT_EQ(RightsOf(folder_ / "data" / "moontrace"), 0700U);
  chmod(path_.c_str(), 0644);
  Records::Open(path_);
  EXPECT_EQ(RightsOf(path_), 0600U);
}

TEST_F(RecordsFile, LeavesNothingButTheLockBesideIt) {
  Records::Open(path_).AddLearner(Named("bat"));
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"records.sqlite", "records.sqlite-lock"}));
}

TEST_F(RecordsFile, KeepsATrialWhoseNumbersAreNotFiniteOrWhoseAnswerIsNoText) {
  Records records = Records::Open(path_);
  records.AddLearner(Named("bat"));
  Trial trial = NumberedTrial(1);
  trial.log_jerk = std::numeric_limits<double>::quiet_NaN();
  trial.latency = std::numeric_limits<double>::infinity();
  trial.answer =
      "a\xff"
      "b";
  records.Add("bat", "c", trial);
  const Trial kept = records.Trials("bat").at(0);
  EXPECT_EQ(kept.log_jerk, 0);
  EXPECT_EQ(kept.latency, 0);
  EXPECT_EQ(kept.answer, "a?b");
}

TEST_F(RecordsFile, TakesNamesAsTheyAreWritten) {
  Records records = Records::Open(path_);
  const std::string quote = "Robert'); DROP TABLE learner;--";
  records.AddLearner(Named(quote));
  records.Add(quote, "c", NumberedTrial(1));
  EXPECT_EQ(records.Trials(quote).size(), 1U);
  EXPECT_EQ(records.Learners().size(), 1U);
}

TEST_F(RecordsFile, RefusesWhatIsNoPseudonym) {
  Records records = Records::Open(path_);
  const auto refusal = [&](const std::string& name) {
    return RefusalOf<InputError>([&] { records.AddLearner(Named(name)); });
  };
  for (const std::string& name :
       {std::string(), std::string("  "), std::string("a/b"), std::string("a\\b"),
        std::string("a\nb"), std::string("a\x1b"), std::string("a\xc2\x9b"), std::string("a\xff"),
        std::string(61, 'a')}) {
    EXPECT_NE(refusal(name).find("choose a name of 1 to 60"), std::string::npos);
  }
  std::string longest;
  for (int i = 0; i < 60; ++i) longest += "ü";
  records.AddLearner(Named(longest));
  EXPECT_NE(refusal(longest).find("already"), std::string::npos);
}

TEST_F(RecordsFile, RefusesALearnerItDoesNotHold) {
  Records records = Records::Open(path_);
  const auto refusal = [](const auto& work) { return RefusalOf<InputError>(work); };
  EXPECT_NE(refusal([&] { records.Add("bat", "c", {}); }).find("no learner \"bat\""),
            std::string::npos);
  refusal([&] { records.AddEvent("bat", {}); });
  refusal([&] { records.Trials("bat"); });
  refusal([&] { records.Events("bat"); });
  refusal([&] { records.Courses("bat"); });
  refusal([&] { records.SetConsent("bat", true, "1"); });
  refusal([&] { records.Export("bat"); });
  refusal([&] { records.Erase("bat"); });
}

TEST_F(RecordsFile, CanBeReadWhileAnotherWrites) {
  Records writing = Records::Open(path_);
  writing.AddLearner(Named("bat"));
  const Records reading = Records::OpenToRead(path_);
  writing.Add("bat", "c", NumberedTrial(1));
  EXPECT_EQ(reading.Trials("bat").size(), 1U);
}

TEST(RecordsPath, FollowsTheUsersDataFolder) {
  const char* old = std::getenv("XDG_DATA_HOME");
  const std::string before = old == nullptr ? "" : old;
  setenv("XDG_DATA_HOME", "/data", 1);
  EXPECT_EQ(Records::DefaultPath(), "/data/moontrace/records.sqlite");
  unsetenv("XDG_DATA_HOME");
  const char* old_home = std::getenv("HOME");
  const std::string home = old_home == nullptr ? "" : old_home;
  setenv("HOME", "/home/owl", 1);
  EXPECT_EQ(Records::DefaultPath(), "/home/owl/.local/share/moontrace/records.sqlite");
  unsetenv("HOME");  // it went to the root folder
  if (const passwd* account = getpwuid(getuid())) {
    EXPECT_EQ(Records::DefaultPath(),
              std::string(account->pw_dir) + "/.local/share/moontrace/records.sqlite");
  }
  if (old_home != nullptr) setenv("HOME", home.c_str(), 1);
  if (old != nullptr) setenv("XDG_DATA_HOME", before.c_str(), 1);
}

}  // namespace
}  // namespace moontrace

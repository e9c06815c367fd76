#include "lessons/records/records_schema.h"

#include <algorithm>

#include "lessons/records/database.h"
#include "lessons/records/trial_fields.h"
#include "tests/lessons/records_fixture.h"

namespace moontrace {
namespace {

/// Records as version 1 wrote them, with a learner of each kind. Never to be changed: it stands for
/// the files that people have.
constexpr const char* kVersionOne = R"(
  CREATE TABLE learner (id INTEGER PRIMARY KEY, pseudonym TEXT NOT NULL UNIQUE,
    since INTEGER NOT NULL, keeps_tracks INTEGER NOT NULL, consent TEXT NOT NULL);
  CREATE TABLE trial (id INTEGER PRIMARY KEY,
    learner INTEGER NOT NULL REFERENCES learner(id) ON DELETE CASCADE, course TEXT NOT NULL,
    time_unix_s INTEGER NOT NULL, lesson TEXT NOT NULL, step INTEGER NOT NULL, kind TEXT NOT NULL,
    item TEXT NOT NULL, size_m REAL NOT NULL, guidance TEXT NOT NULL, help INTEGER NOT NULL,
    probe INTEGER NOT NULL, scaled INTEGER NOT NULL, simulated INTEGER NOT NULL,
    answer TEXT NOT NULL, right_answer INTEGER NOT NULL, latency_s REAL NOT NULL,
    coverage REAL NOT NULL, mean_error_m REAL NOT NULL, rms_error_m REAL NOT NULL,
    error_widths REAL NOT NULL, wander_offs INTEGER NOT NULL, duration_s REAL NOT NULL,
    log_jerk REAL NOT NULL, spectral_arc REAL NOT NULL, mean_force_N REAL NOT NULL,
    mean_guidance_N REAL NOT NULL, guidance_work_J REAL NOT NULL);
  CREATE INDEX trial_of_learner ON trial (learner, time_unix_s);
  CREATE TABLE track (trial INTEGER PRIMARY KEY REFERENCES trial(id) ON DELETE CASCADE,
    samples BLOB NOT NULL);
  CREATE TABLE event (id INTEGER PRIMARY KEY,
    learner INTEGER NOT NULL REFERENCES learner(id) ON DELETE CASCADE,
    time_unix_s INTEGER NOT NULL, kind TEXT NOT NULL, text TEXT NOT NULL);
  CREATE INDEX event_of_learner ON event (learner, time_unix_s);
  INSERT INTO learner VALUES (1, 'bat', 1600000000, 1, '1'), (2, 'robot', 1600000001, 0, '');
  INSERT INTO trial VALUES (1, 1, 'learn-moon', 1600000100, '01-line', 3, 'trace', 'l', 0.04,
    'attract', 6, 0, 0, 0, '', 1, 0, 0.95, 0.0005, 0.0006, 0.125, 2, 8.5, -7.5, -1.75, 0.5, 0.25,
    0.001);
  INSERT INTO trial VALUES (2, 2, 'learn-moon', 1600000200, '02-corner', 0, 'recognise', 'v', 0.02,
    'off', 0, 1, 0, 1, 'a', 0, 3.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  INSERT INTO track VALUES (1, x'000000000000f03f0000000000000040');
  INSERT INTO event VALUES (1, 1, 1600000150, 'tutor', 'size 40');
  PRAGMA application_id = 0x4d4f4f4e;
  PRAGMA user_version = 1;
)";

class RecordsSchema : public RecordsTest {
 protected:
  void SetUp() override {
    RecordsTest::SetUp();
    if (!IsSkipped()) Database(path_, true).Run(kVersionOne);
  }
};

void ExpectAllOfVersionOne(const Records& records) {
  const std::vector<LearnerEntry> learners = records.Learners();
  ASSERT_EQ(learners.size(), 2U);
  EXPECT_EQ(learners[0].pseudonym, "bat");
  EXPECT_EQ(learners[0].since, 1'600'000'000);
  EXPECT_TRUE(learners[0].keeps_tracks);
  EXPECT_EQ(learners[0].consent, "1");
  EXPECT_FALSE(learners[0].simulated);
  EXPECT_TRUE(learners[1].simulated);
  const Trial trial = records.Trials("bat", "learn-moon").at(0);
  EXPECT_EQ(trial.time, 1'600'000'100);
  EXPECT_EQ(trial.kind, StepKind::kTrace);
  EXPECT_EQ(trial.guidance, GuidanceMode::kAttract);
  EXPECT_EQ(trial.size, 0.04);
  EXPECT_EQ(trial.coverage, 0.95);
  EXPECT_EQ(trial.guidance_work, 0.001);
  EXPECT_EQ(records.Trials("robot").at(0).answer, "a");
  EXPECT_EQ(records.Events("bat").at(0).text, "size 40");
  EXPECT_NE(records.Export("bat").find("\"track\":[1.0,2.0]"), std::string::npos);
}

TEST_F(RecordsSchema, BringsVersionOneUpToDateWithAllItHolds) {
  Records records = Records::Open(path_);
  ExpectAllOfVersionOne(records);
  EXPECT_EQ(Database(path_, false).Number("PRAGMA user_version"), 4);
  records.AddLearner(Named("owl"));
  records.Add("owl", "c", NumberedTrial(1));
}

TEST_F(RecordsSchema, BringsVersionOneUpToDateForWhoeverOnlyReads) {
  ExpectAllOfVersionOne(Records::OpenToRead(path_));
  EXPECT_EQ(Database(path_, false).Number("PRAGMA user_version"), 4);
}

TEST_F(RecordsSchema, ChangesNothingWhereAStepFails) {
  // the second step fails in its last statement, after a column was added and filled
  Database(path_, true).Run("CREATE TABLE unfinished (x)");
  RefusalOf<InputError>([&] { Records::Open(path_); });
  const Database file(path_, false);
  EXPECT_EQ(file.Number("PRAGMA user_version"), 1);
  const std::vector<std::string> columns = file.Columns("learner");
  EXPECT_EQ(std::count(columns.begin(), columns.end(), "simulated"), 0);
}

TEST_F(RecordsSchema, HasAColumnForEveryMemberOfATrialAndNoOther) {
  Records::Open(path_);
  std::vector<std::string> columns = Database(path_, false).Columns("trial");
  std::vector<std::string> wanted{"id", "learner", "course"};
  for (const TrialField& field : TrialFields()) wanted.emplace_back(field.name);
  std::sort(columns.begin(), columns.end());
  std::sort(wanted.begin(), wanted.end());
  EXPECT_EQ(columns, wanted);
}

}  // namespace
}  // namespace moontrace

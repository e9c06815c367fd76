// Of an erased learner, and of tracks without consent, no byte is left in any file.
#include <cstring>

#include "lessons/records/database.h"
#include "tests/lessons/records_fixture.h"

namespace moontrace {
namespace {

/// Words and numbers that occur nowhere else.
constexpr const char* kPseudonym = "Zwergfledermaus";
constexpr const char* kAnswer = "qqAnswerqq";
constexpr const char* kEvent = "qqEventqq";
constexpr const char* kConsent = "qqConsentqq";
constexpr double kSample = 1234.56789;
constexpr double kCoverage = 0.123456789;

/// As SQLite writes it: high byte first.
std::string AsColumn(double value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  return {std::make_reverse_iterator(bytes + sizeof value), std::make_reverse_iterator(bytes)};
}

std::string AsTrack(double value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  return {bytes, sizeof value};
}

class RecordsErase : public RecordsTest {
 protected:
  /// Rows of two learners by turns, so that they lie on the same pages, some of them long.
  void Fill(Records& records) {
    LearnerEntry learner = Named(kPseudonym);
    learner.keeps_tracks = true;
    learner.consent = kConsent;
    records.AddLearner(learner);
    records.AddLearner(Named("bat"));
    for (int i = 0; i < 16; ++i) {
      records.Add("bat", "learn-moon", NumberedTrial(i));
      Trial trial = NumberedTrial(i);
      trial.answer = kAnswer + std::string(static_cast<std::size_t>(i) * 40, '.');
      trial.coverage = kCoverage;
      records.Add(kPseudonym, "learn-moon", trial, {kSample, static_cast<double>(i), kSample});
      if (i % 8 == 0) {
        records.AddEvent(kPseudonym, {trial.time, "tutor", kEvent + std::string(5000, '.')});
      }
    }
  }

  const std::vector<std::string> traces_{kPseudonym,          kAnswer,         kEvent, kConsent,
                                         AsColumn(kCoverage), AsTrack(kSample)};
};

TEST_F(RecordsErase, LeavesNoByteOfTheLearner) {
  Records records = Records::Open(path_);
  Fill(records);
  for (const std::string& trace : traces_) EXPECT_TRUE(AnyFileHolds(trace)) << trace;
  const std::string other = records.Export("bat");
  records.Erase(kPseudonym);
  // while the file is still open, and after
  for (const std::string& trace : traces_) EXPECT_FALSE(AnyFileHolds(trace)) << trace;
  EXPECT_EQ(records.Export("bat"), other);
  EXPECT_FALSE(records.Find(kPseudonym));
  { const Records done = std::move(records); }
  for (const std::string& trace : traces_) EXPECT_FALSE(AnyFileHolds(trace)) << trace;
  EXPECT_EQ(Records::OpenToRead(path_).Learners().size(), 1U);
}

TEST_F(RecordsErase, LeavesNoByteOfAnOnlyLearner) {
  Records records = Records::Open(path_);
  LearnerEntry learner = Named(kPseudonym);
  learner.consent = kConsent;
  records.AddLearner(learner);
  records.Erase(kPseudonym);
  for (const std::string& trace : traces_) EXPECT_FALSE(AnyFileHolds(trace)) << trace;
  EXPECT_TRUE(records.Learners().empty());
}

// As after a kill between the two halves of Erase.
TEST_F(RecordsErase, IsFinishedAtTheNextStart) {
  {
    Records records = Records::Open(path_);
    Fill(records);
  }
  Database(path_, true)
      .Run(
          "BEGIN; DELETE FROM learner WHERE pseudonym <> 'bat';"
          "INSERT INTO unfinished VALUES ('scrub'); COMMIT");
  Records::Open(path_);
  for (const std::string& trace : traces_) EXPECT_FALSE(AnyFileHolds(trace)) << trace;
  EXPECT_EQ(Database(path_, false).Number("SELECT count(*) FROM unfinished"), 0);
}

TEST_F(RecordsErase, TakesTracksAwayWithTheConsent) {
  Records records = Records::Open(path_);
  Fill(records);
  records.SetConsent(kPseudonym, false, "");
  EXPECT_FALSE(AnyFileHolds(AsTrack(kSample)));
  EXPECT_FALSE(AnyFileHolds(kConsent));
  EXPECT_EQ(records.Trials(kPseudonym).size(), 16U);
  EXPECT_FALSE(records.Find(kPseudonym)->keeps_tracks);
}

TEST_F(RecordsErase, HasNothingToTakeWhereNoConsentWasGiven) {
  Records records = Records::Open(path_);
  records.AddLearner(Named("bat"));
  records.Add("bat", "c", NumberedTrial(1), {kSample, kSample});
  EXPECT_FALSE(AnyFileHolds(AsTrack(kSample)));
  records.SetConsent("bat", true, "1");
  records.Add("bat", "c", NumberedTrial(2), {kSample, kSample});
  EXPECT_TRUE(AnyFileHolds(AsTrack(kSample)));
}

}  // namespace
}  // namespace moontrace

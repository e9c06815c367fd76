// A program that writes records is killed at random instants by a signal that cannot be caught.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "lessons/records/database.h"
#include "tests/lessons/records_fixture.h"
#include "tests/signal_child.h"

namespace moontrace {
namespace {

/// The learner's first trial has this number, the next ones count on.
void AddForEver(const std::string& path, int first, int out) {
  Records records = Records::Open(path);
  for (int number = first;; ++number) {
    records.Add("bat", "learn-moon", NumberedTrial(number), {1.0 * number, 2, 3});
    if (write(out, &number, sizeof number) != sizeof number) _exit(1);
  }
}

class RecordsKilled : public RecordsTest {
 protected:
  /// Runs `work` in a process of its own, kills that after a random while from its first word on,
  /// and returns the last number it wrote; -1: none.
  template <typename Work>
  int KillAtRandom(const Work& work) {
    int ends[2] = {};
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      try {
        work(ends[1]);
      } catch (const std::exception&) {
      }
      _exit(1);
    }
    close(ends[1]);
    int number = -1;
    int last = -1;
    if (read(ends[0], &number, sizeof number) == sizeof number) last = number;
    // The instant is meant to be any: several of the work's turns.
    std::this_thread::sleep_for(
        std::chrono::microseconds(std::uniform_int_distribution<int>(0, 40'000)(random_)));
    EXPECT_EQ(SignalChild(child, SIGKILL), 0);
    while (read(ends[0], &number, sizeof number) == sizeof number) last = number;
    close(ends[0]);
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
        << "ended by itself: " << status;
    return last;
  }

  void ExpectSound() {
    Statement check = Database(path_, false).Prepare("PRAGMA integrity_check");
    ASSERT_TRUE(check.Step());
    EXPECT_EQ(check.Text(0), "ok");
  }

  void AddKilled(int times) {
    LearnerEntry learner = Named("bat");
    learner.keeps_tracks = true;
    Records::Open(path_).AddLearner(learner);
    int told = 0;
    int kept = 0;
    for (int i = 0; i < times; ++i) {
      const int last = KillAtRandom([&](int out) { AddForEver(path_, kept, out); });
      ASSERT_GE(last, kept);
      told = last + 1;
      const std::vector<Trial> trials = Records::OpenToRead(path_).Trials("bat");
      // every one that was told, perhaps the one that was being added, no half of any
      ASSERT_GE(trials.size(), static_cast<std::size_t>(told));
      ASSERT_LE(trials.size(), static_cast<std::size_t>(told) + 1);
      for (std::size_t k = 0; k < trials.size(); ++k) {
        ASSERT_EQ(trials[k].wander_offs, static_cast<std::int64_t>(k));
      }
      kept = static_cast<int>(trials.size());
      EXPECT_EQ(Database(path_, false).Number("SELECT count(*) FROM track"), kept);
      ExpectSound();
    }
  }

  void EraseKilled(int times) {
    for (int i = 0; i < times; ++i) {
      {
        Records records = Records::Open(path_);
        if (!records.Find("owl")) records.AddLearner(Named("owl"));
        if (!records.Find("Zwergfledermaus")) records.AddLearner(Named("Zwergfledermaus"));
        records.Add("Zwergfledermaus", "c", NumberedTrial(1));
        records.Add("owl", "c", NumberedTrial(1));
      }
      const std::size_t before = Records::OpenToRead(path_).Trials("Zwergfledermaus").size();
      const int last = KillAtRandom([&](int out) {
        Records records = Records::Open(path_);
        int number = 0;
        if (write(out, &number, sizeof number) != sizeof number) _exit(1);
        records.Erase("Zwergfledermaus");
        number = 1;
        if (write(out, &number, sizeof number) != sizeof number) _exit(1);
        pause();
      });
      if (last == 1) {
        EXPECT_FALSE(AnyFileHolds("Zwergfledermaus"));
      }
      const Records records = Records::Open(path_);
      EXPECT_EQ(records.Trials("owl").size(), static_cast<std::size_t>(i) + 1);
      if (records.Find("Zwergfledermaus")) {
        EXPECT_EQ(records.Trials("Zwergfledermaus").size(), before);
        EXPECT_EQ(last, 0);
      } else {
        EXPECT_FALSE(AnyFileHolds("Zwergfledermaus"));
      }
      ExpectSound();
    }
  }

  std::mt19937 random_{20261121};
};

TEST_F(RecordsKilled, AtRandomInstantsKeepEveryTrialThatWasTold) { AddKilled(20); }
TEST_F(RecordsKilled, WhileErasingHoldTheWholeLearnerOrNoByteOfHim) { EraseKilled(10); }

class SlowRecordsKilled : public RecordsKilled {};
TEST_F(SlowRecordsKilled, AtTwoHundredInstantsKeepEveryTrialThatWasTold) { AddKilled(200); }
TEST_F(SlowRecordsKilled, WhileErasingHoldTheWholeLearnerOrNoByteOfHim) { EraseKilled(200); }

}  // namespace
}  // namespace moontrace

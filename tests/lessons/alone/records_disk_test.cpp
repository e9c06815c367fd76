// Records when the power is cut at any moment, and when any one call to the system fails.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <random>

#include "lessons/records/database.h"
#include "lessons/records/learner_history.h"
#include "tests/lessons/records_fixture.h"
#include "tests/watched_disk.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;
using test::DiskState;
using test::WatchedDisk;

constexpr const char* kErased = "Zwergfledermaus";

/// All that records hold, as text.
std::string AllOf(const Records& records) {
  std::string all;
  for (const LearnerEntry& learner : records.Learners()) all += records.Export(learner.pseudonym);
  return all;
}

LearnerEntry WithTracks(const std::string& pseudonym) {
  LearnerEntry learner = Named(pseudonym);
  learner.keeps_tracks = true;
  learner.consent = "1";
  return learner;
}

std::vector<double> Track(int number, std::size_t size) {
  return std::vector<double>(size, 1.5 * number);
}

LearnerHistory Imported() {
  LearnerHistory history;
  history.learner = WithTracks("owl");
  for (int i = 0; i < 6; ++i) {
    history.trials.push_back({"learn-moon", NumberedTrial(i), Track(i, 12)});
  }
  history.events.push_back({7, "tutor", "size 20"});
  return history;
}

/// One piece of work that is told as done.
struct Work {
  const char* name;
  std::function<void(Records&)> run;
};

/// What learning, tutoring and the records command do, one after the other.
std::vector<Work> AllWork() {
  std::vector<Work> all;
  all.push_back({"a new learner", [](Records& r) { r.AddLearner(WithTracks("bat")); }});
  all.push_back({"one to be erased", [](Records& r) { r.AddLearner(WithTracks(kErased)); }});
  for (int i = 0; i < 6; ++i) {
    all.push_back({"a trial", [i](Records& r) {
                     const std::size_t size = i == 4 ? 3000 : 40;  // one over several pages
                     r.Add(i % 2 == 0 ? "bat" : kErased, "learn-moon", NumberedTrial(i),
                           Track(i, size));
                   }});
  }
  all.push_back({"an event", [](Records& r) { r.AddEvent("bat", {5, "break", "tea"}); }});
  all.push_back({"an import", [](Records& r) { r.Import(Imported(), "owl.json"); }});
  all.push_back({"an erasure", [](Records& r) { r.Erase(kErased); }});
  all.push_back({"consent taken back", [](Records& r) { r.SetConsent("owl", false, ""); }});
  all.push_back({"a trial", [](Records& r) { r.Add("bat", "learn-moon", NumberedTrial(9)); }});
  return all;
}

class RecordsDisk : public RecordsTest {
 protected:
  RecordsDisk() { fs::create_directories(work_); }

  const test::QuickFolder quick_;
  const std::string work_ = quick_.path() + "/work", after_ = quick_.path() + "/after";
  // in folders that are not there yet
  const std::string inside_ = "/data/moontrace/records.sqlite";
};

class RecordsPowerCut : public RecordsDisk {
 protected:
  /// Does all work on a disk that is watched.
  void Log(WatchedDisk& disk) {
    Records records = Records::Open(work_ + inside_);
    told_.push_back(AllOf(records));
    disk.Mark(0);
    for (const Work& work : AllWork()) {
      work.run(records);
      told_.push_back(AllOf(records));
      disk.Mark(static_cast<int>(told_.size()) - 1);
    }
  }

  void Cut(const WatchedDisk& disk, int cuts) {
    std::mt19937 random(20261123);
    for (int i = 0; i < cuts; ++i) {
      const std::size_t at = std::uniform_int_distribution<std::size_t>(0, disk.events())(random);
      const auto told = static_cast<std::size_t>(disk.MarkAt(at));
      WatchedDisk::Put(disk.After(at, random), after_);
      const std::string path = after_ + inside_;
      std::string found;
      ASSERT_NO_THROW(found = AllOf(Records::Open(path))) << "cut " << i << " at event " << at;
      const bool next = told + 1 < told_.size() && found == told_[told + 1];
      ASSERT_TRUE(found == told_[told] || next)
          << "cut " << i << " at event " << at << " of " << disk.events() << ": "
          << (told < AllWork().size() ? AllWork()[told].name : "the end") << " was to come next";
      if (found.find(kErased) == std::string::npos && told > 2) {
        EXPECT_FALSE(Holds(path, kErased)) << "cut " << i << " at event " << at;
      }
    }
  }

  static bool Holds(const std::string& path, const std::string& bytes) {
    std::ifstream file(path, std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    return all.find(bytes) != std::string::npos;
  }

  std::vector<std::string> told_;
};

// The apparatus itself: what is not synced can be lost, what is synced cannot.
TEST_F(RecordsPowerCut, LosesJustWhatWasNotSynced) {
  WatchedDisk disk(work_);
  const int file = open((work_ + "/a").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  ASSERT_EQ(write(file, "kept", 4), 4);
  ASSERT_EQ(fsync(file), 0);
  const int folder = open(work_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ASSERT_EQ(fsync(folder), 0);
  ASSERT_EQ(write(file, "lost", 4), 4);
  ASSERT_EQ(rename((work_ + "/a").c_str(), (work_ + "/b").c_str()), 0);
  close(file);
  close(folder);
  std::set<std::string> ways;
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const DiskState state = disk.After(disk.events(), random);
    const auto& [name, node] = *state.at(0).names.begin();
    EXPECT_EQ(state.at(0).names.size(), 1U);
    ways.insert(name + " " + state.at(node).bytes);
  }
  EXPECT_EQ(ways, (std::set<std::string>{"a kept", "a keptlost", "b kept", "b keptlost"}));
}

TEST_F(RecordsPowerCut, AtAnyMomentLosesNoFinishedWorkAndLeavesNoHalf) {
  WatchedDisk disk(work_);
  Log(disk);
  Cut(disk, 200);
}

class SlowRecordsPowerCut : public RecordsPowerCut {};
TEST_F(SlowRecordsPowerCut, AtAThousandMomentsLosesNoFinishedWorkAndLeavesNoHalf) {
  WatchedDisk disk(work_);
  Log(disk);
  Cut(disk, 1000);
}

class RecordsFault : public RecordsDisk {
 protected:
  /// Runs `work` on the records at `path` while one call fails; true: it was told as done.
  bool Run(const std::string& path, const Work& work, std::string& line) {
    try {
      Records records = Records::Open(path);
      work.run(records);
      return true;
    } catch (const LackError& error) {
      line = error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << "another kind of error: " << error.what();
    }
    return false;
  }

  void FailEach(const Work& work, const std::string& before_path, int error) {
    const std::string before = AllOf(Records::Open(before_path));
    std::string after;
    {
      fs::remove_all(after_);
      fs::create_directories(after_);
      fs::copy_file(before_path, after_ + "/r");
      Records records = Records::Open(after_ + "/r");
      work.run(records);
      after = AllOf(records);
    }
    for (int call = 1;; ++call) {
      fs::remove_all(work_);
      fs::create_directories(work_);
      const std::string path = work_ + "/r";
      fs::copy_file(before_path, path);
      std::string line, failed;
      bool done = false;
      {
        WatchedDisk disk(work_);
        disk.Fail(call, error);
        done = Run(path, work, line);
        if (!disk.failed()) break;
        failed = disk.failed_call();
      }
      const std::string where = std::string(work.name) + ", call " + std::to_string(call) + ", " +
                                failed + ", " + std::strerror(error) + ": " + line;
      const std::string found = AllOf(Records::Open(path));
      EXPECT_TRUE(found == after || (found == before && !done)) << where;
      if (!done) {
        EXPECT_EQ(line.find('\n'), std::string::npos) << where;
        EXPECT_EQ(line.find(path), 0U) << where;
      }
    }
  }

  std::string Prepared(const std::vector<Work>& all, std::size_t count) {
    const std::string path = quick_.path() + "/before.sqlite";
    fs::remove(path);
    Records records = Records::Open(path);
    for (std::size_t i = 0; i < count; ++i) all[i].run(records);
    return path;
  }
};

constexpr int kErrors[] = {ENOSPC, EIO, EINTR, EMFILE, 0};

TEST_F(RecordsFault, AtEachCallOfATrialAnImportAndAnErasureLosesNothing) {
  const std::vector<Work> all = AllWork();
  for (std::size_t i = 6; i < all.size(); ++i) {
    const std::string name = all[i].name;
    if (name != "a trial" && name != "an import" && name != "an erasure") continue;
    FailEach(all[i], Prepared(all, i), EIO);
  }
}

class SlowRecordsFault : public RecordsFault {};
TEST_F(SlowRecordsFault, AtEachCallOfAnyWorkLosesNothingAndSaysOneLine) {
  const std::vector<Work> all = AllWork();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string before = Prepared(all, i);
    for (const int error : kErrors) FailEach(all[i], before, error);
  }
}

TEST_F(RecordsFault, WhileTheyAreMadeLeavesNoneOrWholeOnes) {
  for (const int error : kErrors) {
    for (int call = 1;; ++call) {
      fs::remove_all(work_);
      fs::create_directories(work_);
      std::string line;
      {
        WatchedDisk disk(work_);
        disk.Fail(call, error);
        Run(work_ + inside_, {"making them", [](Records& r) { r.AddLearner(Named("bat")); }}, line);
        if (!disk.failed()) break;
      }
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      Records records = Records::Open(work_ + inside_);
      if (!records.Find("bat")) records.AddLearner(Named("bat"));
    }
  }
}

// As a lesson does: what was not kept is tried again.
TEST_F(RecordsFault, ATrialThatIsTriedAgainIsThereOnce) {
  for (const int error : kErrors) {
    for (int call = 1;; ++call) {
      fs::remove_all(work_);
      fs::create_directories(work_);
      WatchedDisk disk(work_);
      Records records = Records::Open(work_ + "/r");
      records.AddLearner(WithTracks("bat"));
      records.Add("bat", "c", NumberedTrial(1));
      std::string line;
      disk.Fail(call, error);
      try {
        records.Add("bat", "c", NumberedTrial(2), Track(2, 2000));
      } catch (const LackError& lack) {
        line = lack.what();
      }
      if (!disk.failed()) break;
      const std::string failed = disk.failed_call();
      if (!line.empty()) records.Add("bat", "c", NumberedTrial(2), Track(2, 2000));
      records.Add("bat", "c", NumberedTrial(3));
      const std::vector<Trial> trials = records.Trials("bat");
      ASSERT_EQ(trials.size(), 3U) << failed << " " << call << " " << std::strerror(error) << line;
      for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(trials[i].wander_offs, int(i) + 1);
    }
  }
}

}  // namespace
}  // namespace moontrace

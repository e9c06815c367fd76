// What the program writes besides the records (record folders, studies, reports, exports, pictures)
// when the power is cut at any moment, and when any one call to the system fails.
#include <cstring>
#include <functional>

#include "lessons/records/records.h"
#include "sim/study/study_files.h"
#include "tests/sim/cli_fixture.h"
#include "tests/sim/record_fixture.h"
#include "tests/watched_disk.h"
#include "textures/base/output_file.h"

namespace moontrace::test {
namespace {

namespace fs = std::filesystem;

constexpr int kErrors[] = {ENOSPC, EIO, EINTR, EMFILE, 0};

class Disk : public testing::Test {
 protected:
  Disk() { fs::create_directories(work_); }

  void Empty() const {
    fs::remove_all(work_);
    fs::create_directories(work_);
  }
  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(work_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  /// Puts a disk after each of so many cuts at `after_` and looks at it; `told` is the last mark.
  void Cut(const WatchedDisk& disk, int cuts, const std::function<void(int told)>& look) const {
    std::mt19937 random(20261123);
    for (int i = 0; i < cuts && !HasFailure(); ++i) {
      const std::size_t at = std::uniform_int_distribution<std::size_t>(0, disk.events())(random);
      WatchedDisk::Put(disk.After(at, random), after_);
      SCOPED_TRACE("cut " + std::to_string(i) + " at event " + std::to_string(at) + " of " +
                   std::to_string(disk.events()));
      ASSERT_NO_THROW(look(disk.MarkAt(at)));
    }
  }

  const QuickFolder quick_;
  const std::string work_ = quick_.path() + "/work", after_ = quick_.path() + "/after";
};

class PowerCut : public Disk {
 protected:
  void OutputFiles(int cuts) const;
  void RecordFolders(int cuts) const;
  void Studies(int cuts) const;
};

std::string Version(int number) {
  return std::string(70'000, static_cast<char>('a' + number)) + std::to_string(number);
}

/// A report, an export, a picture: written anew over what was there.
void PowerCut::OutputFiles(int cuts) const {
  WatchedDisk disk(work_);
  for (int number = 1; number <= 6; ++number) {
    MakeFolder(work_ + "/a/b");
    WriteWhole(work_ + "/a/b/report.html", Version(number));
    disk.Mark(number);
  }
  Cut(disk, cuts, [&](int told) {
    const std::string path = after_ + "/a/b/report.html";
    const std::string found = ReadBytes(path);
    EXPECT_TRUE((told == 0 && !fs::exists(path)) || (told > 0 && found == Version(told)) ||
                found == Version(told + 1))
        << "told: " << told << ", found " << found.size() << " bytes";
  });
}

void PowerCut::RecordFolders(int cuts) const {
  const TextureField field = GrooveField();
  Scene scene = SceneAtRest(field, RubbingOptions());
  const auto name = [](int number) { return "/trial-" + std::to_string(number); };
  constexpr int kTrials = 3;
  WatchedDisk disk(work_);
  for (int number = 1; number <= kTrials; ++number) {
    RecordTicks(work_ + name(number), field, scene, 0, 20, number == 2);
    disk.Mark(number);
  }
  int partial = 0;
  Cut(disk, cuts, [&](int told) {
    for (int number = 1; number <= kTrials; ++number) {
      const std::string folder = after_ + name(number);
      if (number > told && !fs::exists(folder)) continue;
      EXPECT_EQ(ReadRecord(folder).rows.size(), 20U);
    }
    // and what a cut leaves beside them is in nobody's way
    if (!fs::exists(after_ + name(told + 1) + ".partial")) return;
    ++partial;
    if (partial > 20 || fs::exists(after_ + name(told + 1))) return;
    RecordTicks(after_ + name(told + 1), field, scene, 0, 1);
  });
  EXPECT_GT(partial, 0);
}

/// The rows that are whole lines of a study's part files.
std::size_t RowsIn(const std::string& parts) {
  std::size_t rows = 0;
  for (const auto& entry : fs::directory_iterator(parts)) {
    if (entry.path().extension() != ".csv") continue;
    rows += ParseRows(ReadBytes(entry.path().string()), entry.path().string()).size();
  }
  return rows;
}

struct Begun {};

void PowerCut::Studies(int cuts) const {
  const StudyProtocol protocol = ParseStudy(R"(title = "Small"
learners = 1
letters = ["l"]
size_mm = 8.0
[trials]
training = 3
[[conditions]]
name = "full"
mode = "rail"
help = [10, 10]
[[conditions]]
name = "none"
)",
                                            "small.toml");
  StudyOutput output;
  output.path = work_ + "/study.csv";
  WatchedDisk disk(work_);
  std::size_t learners = 0;
  output.progress = [&](std::size_t done, std::size_t) {
    if (done > learners) disk.Mark(static_cast<int>(done));
    learners = done;
  };
  const std::string whole = StudyText(RunStudy(protocol, output));
  const int end = 3;
  disk.Mark(end);
  Cut(disk, cuts, [&](int told) {
    StudyOutput again;
    again.path = after_ + "/study.csv";
    if (fs::exists(again.path)) {
      EXPECT_EQ(ReadBytes(again.path), whole);
      EXPECT_EQ(StudyText(RunStudy(protocol, again)), whole);
      return;
    }
    EXPECT_LT(told, end);
    // it is taken up again by whoever goes on, no line lost or damaged
    again.begins = [] { throw Begun(); };
    EXPECT_THROW(RunStudy(protocol, again), Begun);
    EXPECT_GE(RowsIn(again.path + ".parts"), 3U * static_cast<std::size_t>(told));
  });
}

TEST_F(PowerCut, LeavesAnOutputFileWholeOldOrNew) { OutputFiles(100); }
TEST_F(PowerCut, LeavesRecordFoldersWholeOrNone) { RecordFolders(60); }
TEST_F(PowerCut, LosesNoFinishedTrialOfAStudy) { Studies(100); }

class SlowPowerCut : public PowerCut {};
TEST_F(SlowPowerCut, AtAThousandMomentsLeavesOutputFilesWhole) { OutputFiles(1000); }
TEST_F(SlowPowerCut, AtAThousandMomentsLeavesRecordFoldersWholeOrNone) { RecordFolders(1000); }
TEST_F(SlowPowerCut, AtAThousandMomentsLosesNoFinishedTrialOfAStudy) { Studies(1000); }

class IoFault : public Disk {
 protected:
  /// Runs a command line while each call in turn fails. Where it was told as done `name` must be
  /// whole, otherwise whole or as it was; beside it nothing may lie.
  void FailEach(const std::vector<std::string>& args, const std::string& name,
                const std::function<bool(const std::string& bytes)>& whole,
                const std::vector<int>& errors) const {
    for (const bool before : {false, true}) {
      for (const int error : errors) {
        for (int call = 1; FailOne(args, name, whole, error, call, before); ++call) {
        }
      }
    }
  }

  /// False: there is no such call.
  bool FailOne(const std::vector<std::string>& args, const std::string& name,
               const std::function<bool(const std::string& bytes)>& whole, int error, int call,
               bool before) const {
    Empty();
    if (before) WriteBytes(work_ + "/" + name, "old");
    Outcome outcome;
    std::string failed;
    {
      WatchedDisk disk(work_);
      disk.Fail(call, error);
      outcome = RunLine(args);
      if (!disk.failed()) return false;
      failed = disk.failed_call();
    }
    SCOPED_TRACE(args[0] + ", call " + std::to_string(call) + ", " + failed + ", " +
                 std::strerror(error) + (before ? ", over an old one: " : ": ") + outcome.err);
    const bool there = fs::exists(work_ + "/" + name);
    const std::string found = ReadBytes(work_ + "/" + name);
    const bool untouched = before ? found == "old" : !there;
    EXPECT_TRUE(outcome.code == 0 || outcome.code == 4) << outcome.code;
    EXPECT_TRUE(whole(found) || (outcome.code != 0 && untouched)) << found.size() << " bytes";
    if (outcome.code != 0) {
      EXPECT_EQ(Lines(outcome.err).size(), 1U);
    }
    const std::size_t files = there ? 1 : 0;
    if (failed != "unlink") {
      EXPECT_EQ(Names().size(), files);
    }
    return true;
  }

  /// A study, which is run again after each failure.
  void Study(const std::vector<int>& errors) const;
  /// Lessons of a simulated learner that is kept in records; every `stride`th call fails.
  void Learn(const std::vector<int>& errors, int stride) const;

  const std::vector<int> all_{std::begin(kErrors), std::end(kErrors)};
};

TEST_F(IoFault, AtEachCallLeavesAPictureWhole) {
  const std::vector<std::string> args{"page", "moon", "--picture"};
  ASSERT_EQ(RunLine(With(args, {work_ + "/p.svg"})).code, 0);
  const std::string svg = ReadBytes(work_ + "/p.svg");
  FailEach(
      With(args, {work_ + "/p.svg"}), "p.svg", [&](const auto& found) { return found == svg; },
      all_);
  const Outcome pdf = RunLine(With(args, {work_ + "/p.pdf"}));
  if (pdf.code != 0) return;  // built without cairo
  FailEach(With(args, {work_ + "/p.pdf"}), "p.pdf",
           [](const auto& found) {
             return found.rfind("%PDF-", 0) == 0 && found.find("%%EOF") != std::string::npos;
           },
           {ENOSPC, 0});
}

TEST_F(IoFault, AtEachCallLeavesAReportAndAnExportWhole) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  const std::string records = quick_.path() + "/records.sqlite";
  {
    Records made = Records::Open(records);
    LearnerEntry learner;
    learner.pseudonym = "bat";
    made.AddLearner(learner);
    Trial trial;
    trial.lesson = "04-itlo";
    trial.item = std::string("i");
    trial.time = 1'700'000'000;
    made.Add("bat", "learn-moon", trial);
  }
  const std::vector<std::vector<std::string>> lines{{"report", "bat", "--csv"},
                                                    {"report", "bat", "--html"},
                                                    {"records", "export", "bat", "--output"}};
  for (const std::vector<std::string>& line : lines) {
    const auto args = With(line, {work_ + "/f", "--records", records});
    Empty();
    ASSERT_EQ(RunLine(args).code, 0);
    const std::string expected = ReadBytes(work_ + "/f");
    ASSERT_FALSE(expected.empty());
    FailEach(
        args, "f", [&](const auto& found) { return found == expected; }, all_);
  }
}

TEST_F(IoFault, AtEachCallLeavesARecordFolderWholeOrNone) {
  const TextureField field = GrooveField();
  Scene scene = SceneAtRest(field, RubbingOptions());
  const std::string folder = work_ + "/trial";
  for (const int error : kErrors) {
    for (int call = 1;; ++call) {
      Empty();
      std::string line, failed;
      {
        WatchedDisk disk(work_);
        disk.Fail(call, error);
        line = LineOf<LackError>([&] { RecordTicks(folder, field, scene, 0, 5, true); });
        if (!disk.failed()) break;
        failed = disk.failed_call();
      }
      SCOPED_TRACE("call " + std::to_string(call) + ", " + failed + ", " + std::strerror(error) +
                   ": " + line);
      EXPECT_EQ(line.find('\n'), std::string::npos);
      if (fs::exists(folder)) {
        EXPECT_EQ(ReadRecord(folder).rows.size(), 5U);
      } else {
        EXPECT_NE(line, "");
      }
      EXPECT_LE(Names().size(), 1U);
      if (!fs::exists(folder)) RecordTicks(folder, field, scene, 0, 1);  // nothing is in the way
    }
  }
}

void IoFault::Study(const std::vector<int>& errors) const {
  const std::string protocol = quick_.path() + "/small.toml";
  WriteBytes(protocol, R"(title = "Small"
learners = 1
letters = ["l"]
size_mm = 8.0
[trials]
training = 2
[[conditions]]
name = "none"
)");
  const std::vector<std::string> args{"study",    protocol,           "--threads", "1",
                                      "--output", work_ + "/out.csv", "--quiet"};
  std::string whole;
  for (const int error : errors) {
    for (int call = 1;; ++call) {
      Empty();
      Outcome outcome;
      std::string failed;
      {
        WatchedDisk disk(work_);
        disk.Fail(call, error);
        outcome = RunLine(args);
        if (!disk.failed()) break;
        failed = disk.failed_call();
      }
      SCOPED_TRACE("call " + std::to_string(call) + ", " + failed + ": " + outcome.err);
      EXPECT_TRUE(outcome.code == 0 || outcome.code == 4) << outcome.code;
      if (outcome.code != 0) {
        EXPECT_EQ(Lines(outcome.err).size(), 1U);
      }
      ASSERT_EQ(RunLine(args).code, 0);  // it goes on
      const std::string found = ReadBytes(work_ + "/out.csv");
      if (whole.empty()) whole = found;
      EXPECT_EQ(found, whole);
    }
  }
}

TEST_F(IoFault, AtEachCallLosesNoFinishedTrialOfAStudy) { Study({EIO}); }

/// A course that a simulated learner goes through in some two dozen trials.
std::string SmallCourse(const std::string& folder) {
  fs::create_directories(folder);
  WriteBytes(folder + "/course.toml", R"(title = "Small"
language = "en"
script = "moon"
sizes_mm = [16, 10]
lessons = ["one"]
)");
  WriteBytes(folder + "/one.toml", R"(title = "I and L"
new = ["i", "l"]
[[steps]]
kind = "recognise"
)");
  return folder;
}

std::vector<std::string> ItemsIn(const std::string& records) {
  std::vector<std::string> items;
  if (!fs::exists(records)) return items;
  const Records found = Records::Open(records);
  if (!found.Find("simulated")) return items;
  for (const Trial& trial : found.Trials("simulated", "small")) {
    items.push_back(trial.item + " " + trial.answer);
  }
  return items;
}

void IoFault::Learn(const std::vector<int>& errors, int stride) const {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  const std::string path = work_ + "/records.sqlite";
  const std::vector<std::string> args{
      "learn", "--simulate", "--course", SmallCourse(quick_.path() + "/small"), "--records", path};
  Empty();
  ASSERT_EQ(RunLine(args).code, 0);
  const std::vector<std::string> whole = ItemsIn(path);
  ASSERT_GT(whole.size(), 10U);
  int first = 1;
  for (const int error : errors) {
    std::size_t kept = 0;
    for (int call = first++;; call += stride) {
      Empty();
      Outcome outcome;
      std::string failed;
      {
        WatchedDisk disk(work_);
        disk.Fail(call, error);
        outcome = RunLine(args);
        if (!disk.failed()) break;
        failed = disk.failed_call();
      }
      SCOPED_TRACE("call " + std::to_string(call) + ", " + failed + ", " + std::strerror(error) +
                   ": " + outcome.err);
      EXPECT_TRUE(outcome.code == 0 || outcome.code == 4) << outcome.code;
      // the first of them and no others; the later the fault, the more
      const std::vector<std::string> found = ItemsIn(path);
      ASSERT_LE(found.size(), whole.size());
      EXPECT_TRUE(std::equal(found.begin(), found.end(), whole.begin()));
      EXPECT_EQ(found.size() == whole.size() || outcome.code == 4, true) << found.size();
      EXPECT_GE(found.size(), outcome.code == 0 ? whole.size() : kept);
      if (outcome.code != 0) kept = found.size();
      const Outcome again = RunLine(args);  // nothing is in its way
      EXPECT_EQ(again.code, 0) << again.err;
    }
    EXPECT_GT(kept + static_cast<std::size_t>(stride), whole.size() / 2);
  }
}

TEST_F(IoFault, InALearnersLessonLosesNoFinishedTrial) { Learn({EIO}, 101); }

class SlowIoFault : public IoFault {};
TEST_F(SlowIoFault, OfAnyKindLosesNoFinishedTrialOfAStudy) { Study(all_); }
TEST_F(SlowIoFault, OfAnyKindInALearnersLessonsLosesNoFinishedTrial) { Learn(all_, 29); }

}  // namespace
}  // namespace moontrace::test

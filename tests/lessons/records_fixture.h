#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "lessons/records/records.h"
#include "textures/base/error.h"

namespace moontrace {

inline LearnerEntry Named(const std::string& pseudonym) {
  LearnerEntry learner;
  learner.pseudonym = pseudonym;
  return learner;
}

/// A trial whose every member differs from its default and from trials of other numbers.
inline Trial NumberedTrial(int number) {
  Trial trial;
  trial.time = 1'700'000'000 + number;
  trial.lesson = "04-jnz";
  trial.step = 2;
  trial.kind = StepKind::kRecognise;
  trial.item = "j\nn";
  trial.size = 0.012 + 1e-17 * number;
  trial.guidance = GuidanceMode::kBead;
  trial.help = 7;
  trial.probe = true;
  trial.scaled = true;
  trial.simulated = true;
  trial.answer = "nü\"";
  trial.right = true;
  trial.latency = 1.0 / 3;
  trial.coverage = 0.1 + number;
  trial.mean_error = 1e-4 / 3;
  trial.rms_error = 2e-4 / 3;
  trial.error_widths = 0.7 / 3;
  trial.wander_offs = number;
  trial.duration = 12.7;
  trial.log_jerk = -5.322;
  trial.spectral_arc = -1.4024;
  trial.mean_force = 0.3;
  trial.mean_guidance = 0.2;
  trial.guidance_work = -0.001;
  return trial;
}

/// A records file in an empty folder of the test's own, removed behind it.
class RecordsTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      Records::Open(path_);
    } catch (const LackError& error) {
      const std::string what = error.what();
      if (what.find("built without SQLite") != std::string::npos) GTEST_SKIP() << what;
      throw;
    }
    std::filesystem::remove(path_);
  }

  RecordsTest() {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("moontrace_") + info->test_suite_name() + "_" + info->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    path_ = (folder_ / "records.sqlite").string();
  }
  ~RecordsTest() override {
    std::error_code ignored;
    std::filesystem::permissions(folder_, std::filesystem::perms::owner_all, ignored);
    std::filesystem::remove_all(folder_);
  }

  /// Whether any file of the folder holds the bytes.
  bool AnyFileHolds(const std::string& bytes) const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string all{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
      if (all.find(bytes) != std::string::npos) return true;
    }
    return false;
  }

  std::filesystem::path folder_;
  std::string path_;
};

/// The one line by which `work` was refused with this kind of error.
template <typename Error, typename Work>
std::string RefusalOf(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    const std::string line = error.what();
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    return line;
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another error: " << error.what();
    return {};
  }
  ADD_FAILURE() << "not refused";
  return {};
}

}  // namespace moontrace

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/guidance_mode.h"
#include "sim/study/reading_sweep.h"

namespace moontrace {

/// How one group of learners is trained.
struct StudyCondition {
  std::string name;
  GuidanceMode mode = GuidanceMode::kOff;
  double help_first = 0, help_last = 0;  ///< 0-10, evenly from the first training trial to the last
  int probe_every = 0;                   ///< one unguided trial in so many; 0: none
};

/// Letters' sizes by staircases at the end of a learner's trials; see sim/study/size_threshold.h.
struct StudyStaircase {
  double start = 0.02, least = 0.003;  ///< [m]
  int down = 2, trials = 40, staircases = 2;
  int lessons = 2;  ///< times that each letter is taught, named and felt, before
};

/// Who is studied: learners who trace letters, or a reader that reads pages by touch.
enum class StudyKind { kTracing, kReading };

/// A study: the same phases for each condition. From a TOML file, `lessons/studies/guidance.toml`
/// shows all keys; of reading `lessons/studies/reading.toml`, where combinations are the conditions
/// and pages the learners.
struct StudyProtocol {
  std::string title, file, script = "moon";
  std::uint64_t digest = 0;  ///< of the file's bytes: which protocol a row was made by
  int learners = 20;         ///< of each condition
  std::uint64_t first_seed = 1;
  std::vector<std::string> letters;
  double size = 0.012;  ///< [m]
  double groove_depth_share = 1;
  std::optional<double> press;  ///< [N]; none: the learner's own
  std::string device;   ///< profile that the hand is on, a name or a file; empty: read exactly
  std::string learner;  ///< path of the learner's file; empty: the shipped one
  int pre_test = 0, training = 0, retention = 0, transfer = 0;  ///< trials
  std::vector<double> retention_days;
  std::vector<std::string> transfer_letters;
  std::optional<double> transfer_size;  ///< [m]
  std::vector<StudyCondition> conditions;
  std::optional<StudyStaircase> staircase;
  std::optional<ReadingSweep> reading;  ///< then nothing above from `script` on is asked

  StudyKind kind() const { return reading ? StudyKind::kReading : StudyKind::kTracing; }
};

/// Throws InputError: file:line:column, cause, cure with the nearest key; there is no such script,
/// or it does not set each letter as one sign.
StudyProtocol LoadStudy(const std::string& path);
/// The same without looking for the script.
StudyProtocol ParseStudy(std::string_view text, const std::string& name);

/// One trial that a learner is given.
struct StudyTrial {
  std::string phase;  ///< "pre-test", "training", "retention-0", "retention-7", "transfer-letters",
                      ///< "transfer-size"
  double day = 0;     ///< since the learner began [days]
  std::string letter;
  double size = 0;  ///< [m]
  GuidanceMode mode = GuidanceMode::kOff;
  double help = 0;
};

/// All trials of a learner of a condition, in order. Letters go in turn, which one first by the
/// seed.
std::vector<StudyTrial> TrialsOf(const StudyProtocol& protocol, const StudyCondition& condition,
                                 std::uint64_t seed);

}  // namespace moontrace

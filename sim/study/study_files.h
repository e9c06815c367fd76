#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "sim/study/study_protocol.h"
#include "sim/study/study_row.h"
#include "sim/study/study_run.h"

namespace moontrace {

/// Where a study's rows go.
struct StudyOutput {
  std::string path;           ///< CSV; while it grows, a folder "PATH.parts" lies beside it
  int shard = 1, shards = 1;  ///< of its learners, shard from 1
  int threads = 1;
  /// Called once the output is known to be writable and work begins; not if all is done already.
  std::function<void()> begins;
  std::function<void()> check;  ///< called by the caller's thread now and then; may throw to stop
  std::function<void(std::size_t done, std::size_t of)> progress;  ///< learners; may be empty
};

/// Runs what of a study is not yet done and gives all its rows, in the order of learners and
/// trials: the same bytes for any number of threads. Each finished trial is on disk as a whole line
/// before the next begins; a run that was ended at any moment goes on with the next trial. Throws
/// InputError (an output that was made by another protocol or is damaged), LackError (cannot be
/// written; another run writes it), and what `check` throws.
std::vector<StudyRow> RunStudy(const StudyProtocol& protocol, const StudyOutput& output);

/// Rows of several shards together, in the order of one run. Throws InputError: a file that cannot
/// be read, files of different studies, a learner in two of them or not finished.
std::vector<StudyRow> MergeStudies(const std::vector<std::string>& paths);

/// The bytes of a study's file.
std::string StudyText(const std::vector<StudyRow>& rows);

}  // namespace moontrace

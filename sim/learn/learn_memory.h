#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/progress/progress.h"
#include "lessons/records/records.h"

namespace moontrace {

/// What is remembered of one learner in one course: the records, or nothing where there are none.
class LearnMemory {
 public:
  /// Without records: all is forgotten at the end.
  LearnMemory() = default;
  /// `fresh`: the records do not have the learner yet; Admit comes before the first row.
  LearnMemory(Records records, LearnerEntry learner, std::string course, bool fresh);

  /// A fresh learner into the records, once the lesson can begin: a start that fails leaves nobody
  /// behind. Throws as Records::AddLearner.
  void Admit();

  /// Progress, computed anew from the rows.
  Progress Recall(const Course& course) const;
  std::size_t trials() const;  ///< of this course: rows with an item

  /// A row, on disk when this returns. Where that fails, it is held back and tried again with the
  /// next one, in order; then why, otherwise empty.
  std::string Keep(const Trial& trial, const std::vector<double>& track);
  /// The rest that was held back, once more. Number of rows that are not on disk.
  std::size_t KeepRest();
  void Note(std::int64_t time, const std::string& kind, const std::string& text);

  /// Outcomes only are to be said. What is kept of it and of a text is the newest note of its kind.
  bool brief() const { return brief_; }
  void SetBrief(std::int64_t time, bool brief);
  /// The learner's last own text; empty: none.
  const std::string& own_text() const { return own_text_; }
  void SetOwnText(std::int64_t time, const std::string& text);
  /// What is worked with from now on, by the name that `--device` takes.
  void SetDevice(std::int64_t time, const std::string& name);

  /// Whether the question about tracks has been answered.
  bool consent_asked() const { return !learner_.consent.empty(); }
  /// `version` of the question. Throws as Records::SetConsent.
  void SetConsent(bool keeps_tracks, const std::string& version);

  bool keeps_tracks() const { return records_ && learner_.keeps_tracks; }
  bool remembers() const { return records_.has_value(); }
  const std::string& name() const { return learner_.pseudonym; }
  std::size_t held_back() const { return held_back_.size(); }

 private:
  struct Row {
    Trial trial;
    std::vector<double> track;
  };
  void Flush();

  std::optional<Records> records_;
  LearnerEntry learner_;
  std::string course_;
  bool fresh_ = false;
  bool brief_ = false;
  std::string own_text_, device_;
  std::vector<Row> held_back_;
};

/// Devices that a learner worked with by these events, each once, that of the newest session last.
std::vector<std::string> DevicesOf(const std::vector<RecordedEvent>& events);

}  // namespace moontrace

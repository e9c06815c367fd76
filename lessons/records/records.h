#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lessons/course/trial.h"
#include "lessons/records/learner_history.h"
#include "lessons/records/readings.h"

namespace moontrace {

/// Learners' records in one SQLite file of the user's data folder. Nothing leaves the machine.
/// Every Add is one transaction, on disk when it returns: neither a process that is killed at any
/// instant nor a machine whose power is cut loses a finished trial. One thread at a time; a second
/// program is refused while one writes, by whatever name it knows the file.
///
/// Throws LackError: no SQLite in this build, no permission, read-only, disk full, used by another
/// program; InputError: no records file, of a newer version, damaged. Then nothing was changed.
class Records {
 public:
  /// False: built without SQLite; then nothing can be remembered.
  static bool Available();
  /// `$XDG_DATA_HOME/moontrace/records.sqlite`, else `~/.local/share/...`; `~` without HOME is the
  /// account's. Throws InputError: there is none.
  static std::string DefaultPath();
  /// Opens for writing; makes file (0600) and folder (0700) where there are none; an older version
  /// is brought up to date.
  static Records Open(const std::string& path);
  /// For reading only; throws InputError where there is no file.
  static Records OpenToRead(const std::string& path);

  std::vector<LearnerEntry> Learners() const;
  std::optional<LearnerEntry> Find(const std::string& pseudonym) const;
  /// Throws InputError for a pseudonym that is not 1 to 60 printable characters without slashes.
  void AddLearner(const LearnerEntry& learner);
  void SetConsent(const std::string& pseudonym, bool keeps_tracks, const std::string& consent);

  /// `track`: raw samples as a blob (record.h's columns); dropped where the learner has not
  /// consented. After an error the same trial may be added again: it is there once.
  void Add(const std::string& pseudonym, const std::string& course, const Trial& trial,
           const std::vector<double>& track = {});
  void AddEvent(const std::string& pseudonym, const RecordedEvent& event);
  /// In the order in which they were added, whatever the clock said.
  std::vector<Trial> Trials(const std::string& pseudonym, const std::string& course = {}) const;
  std::vector<std::string> Courses(const std::string& pseudonym) const;
  /// That of the trial added last; empty: there is none.
  std::string LastCourse(const std::string& pseudonym) const;
  std::vector<RecordedEvent> Events(const std::string& pseudonym) const;

  /// What a learner reads, the newest first.
  std::vector<ReadDocument> Readings(const std::string& pseudonym) const;
  /// Keeps a document and its place; on disk when it returns. Its id, by which it is kept anew.
  std::int64_t Keep(const std::string& pseudonym, const ReadDocument& reading);
  /// Deletes what is kept of a document, by its id, and every byte of it; false: there is none.
  bool Forget(const std::string& pseudonym, std::int64_t reading);

  /// All that is known of a learner as JSON text (UTF-8), which HistoryFromJson reads.
  std::string Export(const std::string& pseudonym) const;
  /// The part of it that researchers may see: no pseudonym, no words, no tracks; times count from
  /// the first trial. It lists the fields that it holds, and cannot be imported.
  std::string ExportAnonymous(const std::string& pseudonym) const;
  /// Adds a learner with a whole history. Throws InputError (`name`: where it comes from) where one
  /// of that pseudonym is here; then nothing is added.
  void Import(const LearnerHistory& history, const std::string& name);
  /// Removes every byte of a learner from the file, its journal and its free pages.
  void Erase(const std::string& pseudonym);

  Records(Records&&) noexcept;
  Records& operator=(Records&&) noexcept;
  ~Records();

 private:
  struct Impl;
  explicit Records(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace moontrace

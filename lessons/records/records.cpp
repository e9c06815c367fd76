#include "lessons/records/records.h"

#include <fmt/core.h>
#include <pwd.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "lessons/records/database.h"
#include "lessons/records/learner_history.h"
#include "lessons/records/records_file.h"
#include "lessons/records/records_schema.h"
#include "lessons/records/trial_fields.h"
#include "textures/base/error.h"
#include "textures/base/file_writing.h"
#include "textures/base/overload.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {

namespace {

constexpr std::int64_t kQuicklyRead = std::int64_t{64} << 20U;  // [bytes]

/// The home folder that the account has, whatever the environment says.
std::string AccountHome() {
  passwd entry{};
  passwd* found = nullptr;
  std::array<char, 16384> text{};  // far more than an entry takes
  getpwuid_r(getuid(), &entry, text.data(), text.size(), &found);
  if (found != nullptr && found->pw_dir != nullptr && *found->pw_dir == '/') return found->pw_dir;
  throw InputError("no home folder is known for the records; name their file by --records FILE");
}

/// Text as it can be exported: bytes that are no UTF-8 become "?".
std::string Clean(std::string text) {
  while (const std::optional<std::size_t> bad = FirstBadUtf8(text)) text[*bad] = '?';
  return text;
}

void BindField(Statement& statement, int index, const TrialField::Value& value) {
  std::visit(Overload{
                 [&](std::int64_t whole) { statement.Bind(index, whole); },
                 [&](double real) { statement.Bind(index, std::isfinite(real) ? real : 0); },
                 [&](const std::string& text) { statement.Bind(index, Clean(text)); },
             },
             value);
}

TrialField::Value FieldValue(const Statement& statement, int column, const TrialField& field) {
  switch (field.kind) {
    case TrialField::Kind::kReal:
      return statement.Real(column);
    case TrialField::Kind::kText:
      return statement.Text(column);
    case TrialField::Kind::kWhole:
    case TrialField::Kind::kFlag:
      break;
  }
  return statement.Integer(column);
}

}  // namespace

struct Records::Impl {
  /// A trial whose commit failed at its very end may be in the file all the same.
  struct Doubtful {
    std::int64_t learner = 0, row = 0;
    RecordedTrial trial;
  };

  std::string path;
  std::unique_ptr<WriterLock> lock;  // released after the file is closed
  Database file;
  std::optional<Doubtful> doubtful;

  Impl(const std::string& records, bool write)
      : path(records),
        lock(write ? std::make_unique<WriterLock>(records) : nullptr),
        file(records, write) {}

  std::int64_t IdOf(const std::string& pseudonym) const {
    Statement find = file.Prepare("SELECT id FROM learner WHERE pseudonym = ?");
    find.Bind(1, std::string_view(pseudonym));
    if (find.Step()) return find.Integer(0);
    throw InputError(
        fmt::format("{}: no learner \"{}\" in these records; list them", path, OneLine(pseudonym)));
  }

  std::int64_t Version() const { return file.Number("PRAGMA user_version"); }

  /// An empty file has neither mark nor tables.
  bool IsEmpty() const {
    return file.Number("PRAGMA application_id") == 0 && Version() == 0 &&
           file.Number("SELECT count(*) FROM sqlite_schema") == 0;
  }

  void RequireOurs() const {
    if (file.Number("PRAGMA application_id") != kRecordsApplication || Version() < 1) {
      throw InputError(path + ": not a records file; name another by --records");
    }
    if (Version() > RecordsVersion()) {
      throw InputError(
          fmt::format("{}: of a newer Moontrace (version {} of records, here {}); "
                      "update this program",
                      path, Version(), RecordsVersion()));
    }
    // a view in a table's place, a column with a rule of its own: no file of ours
    if (SchemaOf(file) != RecordsSchema(Version())) {
      throw InputError(path +
                       ": the records are damaged (their tables are others); put a copy in their "
                       "place, or import an export");
    }
    if (file.Bytes() <= kQuicklyRead) {
      file.Check();
    } else {  // raw tracks: these are found damaged when they are read
      for (const char* table : {"learner", "trial", "event"}) file.Check(table);
    }
  }

  /// Runs all schema steps that are missing, or none if one fails.
  void BringUpToDate() const {
    if (Version() == RecordsVersion()) return;
    Transaction transaction(file);
    for (std::int64_t done = Version(); done < RecordsVersion(); ++done) {
      file.Run(RecordsSteps()[static_cast<std::size_t>(done)]);
    }
    file.Run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}",
                         kRecordsApplication, RecordsVersion()));
    transaction.Commit();
  }

  /// What was deleted is already zeros; cells that were moved before leave copies in the gaps of
  /// pages, so the file is written anew. The file notes this, so that after a kill the next
  /// start does it.
  void Scrub() const {
    if (file.Number("SELECT count(*) FROM unfinished WHERE work = 'scrub'") == 0) return;
    file.Run("VACUUM");
    file.Run("DELETE FROM unfinished WHERE work = 'scrub'");
  }
  void MustScrub() const { file.Run("INSERT OR REPLACE INTO unfinished VALUES ('scrub')"); }

  std::int64_t AddLearner(const LearnerEntry& learner) const {
    file.Prepare(
            "INSERT INTO learner (pseudonym, since, keeps_tracks, consent, simulated) "
            "VALUES (?, ?, ?, ?, ?)")
        .Bind(1, std::string_view(learner.pseudonym))
        .Bind(2, learner.since)
        .Bind(3, std::int64_t{learner.keeps_tracks})
        .Bind(4, Clean(learner.consent))
        .Bind(5, std::int64_t{learner.simulated})
        .Step();
    return file.LastRow();
  }

  std::int64_t AddTrial(std::int64_t learner, const RecordedTrial& row) const {
    Statement insert = file.Prepare(InsertTrial());
    insert.Bind(1, learner).Bind(2, Clean(row.course));
    int index = 2;
    for (const TrialField& field : TrialFields()) BindField(insert, ++index, field.get(row.trial));
    insert.Step();
    const std::int64_t trial = file.LastRow();
    if (row.track.empty()) return trial;
    file.Prepare("INSERT INTO track SELECT ?, ? FROM learner WHERE id = ? AND keeps_tracks")
        .Bind(1, trial)
        .Bind(2, row.track)
        .Bind(3, learner)
        .Step();
    return trial;
  }

  /// Whether the trial is the one whose commit failed last, and is there nevertheless: SQLite says
  /// so, too, where all is written and only the folder could not be synced.
  bool IsThere(std::int64_t learner, const RecordedTrial& row) const {
    if (!doubtful || doubtful->learner != learner || doubtful->trial.course != row.course ||
        doubtful->trial.track != row.track) {
      return false;
    }
    for (const TrialField& field : TrialFields()) {
      if (field.get(doubtful->trial.trial) != field.get(row.trial)) return false;
    }
    Statement find = file.Prepare("SELECT 1 FROM trial WHERE id = ? AND learner = ?");
    find.Bind(1, doubtful->row).Bind(2, learner);
    return find.Step();
  }

  /// One that is tried again once more is added once only.
  void Add(std::int64_t learner, const RecordedTrial& row) {
    if (IsThere(learner, row)) {
      if (!SyncFolder(FolderOf(path))) {
        throw LackError(path + ": the records' folder cannot be synced; check the disk");
      }
      return doubtful.reset();
    }
    Transaction transaction(file);
    doubtful = Doubtful{learner, AddTrial(learner, row), row};
    transaction.Commit();
    doubtful.reset();
  }

  void AddEvent(std::int64_t learner, const RecordedEvent& event) const {
    file.Prepare("INSERT INTO event (learner, time_unix_s, kind, text) VALUES (?, ?, ?, ?)")
        .Bind(1, learner)
        .Bind(2, event.time)
        .Bind(3, Clean(event.kind))
        .Bind(4, Clean(event.text))
        .Step();
  }

  Statement TrialsOf(std::int64_t learner) const {
    Statement rows = file.Prepare(SelectTrials() + " WHERE learner = ? ORDER BY id");
    rows.Bind(1, learner);
    return rows;
  }

  Trial ReadTrial(const Statement& row) const {
    Trial trial;
    int column = 1;
    for (const TrialField& field : TrialFields()) {
      if (field.set(trial, FieldValue(row, ++column, field))) continue;
      throw InputError(
          fmt::format("{}: trial {}: \"{}\" is no {}; put a copy in place of these "
                      "records, or import an export",
                      path, row.Integer(0), OneLine(row.Text(column)), field.name));
    }
    return trial;
  }

  LearnerHistory HistoryOf(const Records& records, const std::string& pseudonym) const {
    LearnerHistory history;
    Statement rows = TrialsOf(IdOf(pseudonym));
    history.learner = *records.Find(pseudonym);
    while (rows.Step()) {
      Statement track = file.Prepare("SELECT samples FROM track WHERE trial = ?");
      track.Bind(1, rows.Integer(0));
      const bool kept = track.Step();
      history.trials.push_back(
          {rows.Text(1), ReadTrial(rows), kept ? track.Numbers(0) : std::vector<double>()});
    }
    history.events = records.Events(pseudonym);
    history.readings = records.Readings(pseudonym);
    return history;
  }
};

bool Records::Available() { return Database::Available(); }

std::string Records::DefaultPath() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  if (const std::string data = variable("XDG_DATA_HOME"); !data.empty()) {
    return data + "/moontrace/records.sqlite";
  }
  const std::string home = variable("HOME");
  return (home.empty() ? AccountHome() : home) + "/.local/share/moontrace/records.sqlite";
}

Records Records::Open(const std::string& path) {
  Database::RequireAvailable(path);
  RequireNoLink(path);
  MakeRecordsFile(path);
  auto impl = std::make_unique<Impl>(path, true);
  if (!impl->IsEmpty()) impl->RequireOurs();
  impl->BringUpToDate();
  impl->Scrub();
  MakePrivate(path);
  return Records(std::move(impl));
}

Records Records::OpenToRead(const std::string& path) {
  RequireNoLink(path);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw InputError(path + ": no records there yet; learn first or name another by --records");
  }
  auto impl = std::make_unique<Impl>(path, false);
  impl->RequireOurs();
  if (impl->Version() == RecordsVersion()) return Records(std::move(impl));
  impl.reset();
  Open(path);
  return Records(std::make_unique<Impl>(path, false));
}

std::vector<LearnerEntry> Records::Learners() const {
  std::vector<LearnerEntry> learners;
  Statement all = impl_->file.Prepare(
      "SELECT pseudonym, since, keeps_tracks, consent, simulated FROM learner ORDER BY pseudonym");
  while (all.Step()) {
    learners.push_back(
        {all.Text(0), all.Integer(1), all.Integer(2) != 0, all.Text(3), all.Integer(4) != 0});
  }
  return learners;
}

std::optional<LearnerEntry> Records::Find(const std::string& pseudonym) const {
  for (LearnerEntry& learner : Learners()) {
    if (learner.pseudonym == pseudonym) return std::move(learner);
  }
  return std::nullopt;
}

void Records::AddLearner(const LearnerEntry& learner) {
  RequirePseudonym(learner.pseudonym);
  if (Find(learner.pseudonym)) {
    throw InputError(fmt::format("{}: there is a learner \"{}\" already; choose another name",
                                 impl_->path, learner.pseudonym));
  }
  Transaction transaction(impl_->file);
  impl_->AddLearner(learner);
  transaction.Commit();
}

void Records::SetConsent(const std::string& pseudonym, bool keeps_tracks,
                         const std::string& consent) {
  const std::int64_t id = impl_->IdOf(pseudonym);
  Transaction transaction(impl_->file);
  impl_->file.Prepare("UPDATE learner SET keeps_tracks = ?, consent = ? WHERE id = ?")
      .Bind(1, std::int64_t{keeps_tracks})
      .Bind(2, Clean(consent))
      .Bind(3, id)
      .Step();
  if (!keeps_tracks) {
    impl_->file.Prepare("DELETE FROM track WHERE trial IN (SELECT id FROM trial WHERE learner = ?)")
        .Bind(1, id)
        .Step();
    impl_->MustScrub();
  }
  transaction.Commit();
  impl_->Scrub();
}

void Records::Add(const std::string& pseudonym, const std::string& course, const Trial& trial,
                  const std::vector<double>& track) {
  impl_->Add(impl_->IdOf(pseudonym), {course, trial, track});
}

void Records::AddEvent(const std::string& pseudonym, const RecordedEvent& event) {
  const std::int64_t id = impl_->IdOf(pseudonym);
  Transaction transaction(impl_->file);
  impl_->AddEvent(id, event);
  transaction.Commit();
}

std::vector<Trial> Records::Trials(const std::string& pseudonym, const std::string& course) const {
  std::vector<Trial> trials;
  Statement rows = impl_->TrialsOf(impl_->IdOf(pseudonym));
  while (rows.Step()) {
    if (course.empty() || rows.Text(1) == course) trials.push_back(impl_->ReadTrial(rows));
  }
  return trials;
}

std::vector<std::string> Records::Courses(const std::string& pseudonym) const {
  std::vector<std::string> courses;
  Statement rows = impl_->file.Prepare(
      "SELECT course FROM trial WHERE learner = ? GROUP BY course ORDER BY min(id)");
  rows.Bind(1, impl_->IdOf(pseudonym));
  while (rows.Step()) courses.push_back(rows.Text(0));
  return courses;
}

std::string Records::LastCourse(const std::string& pseudonym) const {
  Statement last =
      impl_->file.Prepare("SELECT course FROM trial WHERE learner = ? ORDER BY id DESC LIMIT 1");
  last.Bind(1, impl_->IdOf(pseudonym));
  return last.Step() ? last.Text(0) : std::string();
}

std::vector<RecordedEvent> Records::Events(const std::string& pseudonym) const {
  std::vector<RecordedEvent> events;
  Statement rows = impl_->file.Prepare(
      "SELECT time_unix_s, kind, text FROM event WHERE learner = ? ORDER BY id");
  rows.Bind(1, impl_->IdOf(pseudonym));
  while (rows.Step()) events.push_back({rows.Integer(0), rows.Text(1), rows.Text(2)});
  return events;
}

std::vector<ReadDocument> Records::Readings(const std::string& pseudonym) const {
  return ReadingsOf(impl_->file, impl_->IdOf(pseudonym));
}

std::int64_t Records::Keep(const std::string& pseudonym, const ReadDocument& reading) {
  const std::int64_t learner = impl_->IdOf(pseudonym);
  Transaction transaction(impl_->file);
  const std::int64_t id = KeepReading(impl_->file, learner, reading);
  transaction.Commit();
  return id;
}

bool Records::Forget(const std::string& pseudonym, std::int64_t reading) {
  const std::int64_t learner = impl_->IdOf(pseudonym);
  Transaction transaction(impl_->file);
  const bool there = DeleteReading(impl_->file, learner, reading);
  if (there) impl_->MustScrub();
  transaction.Commit();
  impl_->Scrub();
  return there;
}

std::string Records::Export(const std::string& pseudonym) const {
  return HistoryToJson(impl_->HistoryOf(*this, pseudonym));
}

std::string Records::ExportAnonymous(const std::string& pseudonym) const {
  return ResearchJson(impl_->HistoryOf(*this, pseudonym));
}

void Records::Import(const LearnerHistory& history, const std::string& name) {
  const std::string& pseudonym = history.learner.pseudonym;
  if (Find(pseudonym)) {
    throw InputError(
        fmt::format("{}: there is a learner \"{}\" already; erase that one first, or "
                    "import into other records",
                    name, pseudonym));
  }
  Transaction transaction(impl_->file);
  const std::int64_t id = impl_->AddLearner(history.learner);
  for (const RecordedTrial& trial : history.trials) impl_->AddTrial(id, trial);
  for (const RecordedEvent& event : history.events) impl_->AddEvent(id, event);
  for (ReadDocument reading : history.readings) {
    reading.id = 0;
    KeepReading(impl_->file, id, reading);
  }
  transaction.Commit();
}

void Records::Erase(const std::string& pseudonym) {
  const std::int64_t id = impl_->IdOf(pseudonym);
  Transaction transaction(impl_->file);
  impl_->file.Prepare("DELETE FROM learner WHERE id = ?").Bind(1, id).Step();
  impl_->MustScrub();
  transaction.Commit();
  impl_->Scrub();
}

Records::Records(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Records::Records(Records&&) noexcept = default;
Records& Records::operator=(Records&&) noexcept = default;
Records::~Records() = default;

}  // namespace moontrace

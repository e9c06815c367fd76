#include "lessons/records/records_schema.h"

#include <cctype>
#include <cstddef>
#include <string_view>

#include "lessons/records/database.h"
#include "lessons/records/trial_fields.h"

namespace moontrace {

namespace {

/// SQL with one blank between words and none elsewhere: the steps' layout is none of the file's.
std::string Squeezed(std::string_view sql) {
  const auto is_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  std::string squeezed;
  bool blank = false;
  for (const char c : sql) {
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      blank = true;
      continue;
    }
    if (blank && !squeezed.empty() && is_word(squeezed.back()) && is_word(c)) squeezed += ' ';
    blank = false;
    squeezed += c;
  }
  return squeezed;
}

}  // namespace

const std::vector<std::string>& RecordsSteps() {
  static const std::vector<std::string> steps{
      // 1
      R"(CREATE TABLE learner (
           id INTEGER PRIMARY KEY,
           pseudonym TEXT NOT NULL UNIQUE,
           since INTEGER NOT NULL,
           keeps_tracks INTEGER NOT NULL,
           consent TEXT NOT NULL);
         CREATE TABLE trial (
           id INTEGER PRIMARY KEY,
           learner INTEGER NOT NULL REFERENCES learner(id) ON DELETE CASCADE,
           course TEXT NOT NULL,
           time_unix_s INTEGER NOT NULL,
           lesson TEXT NOT NULL,
           step INTEGER NOT NULL,
           kind TEXT NOT NULL,
           item TEXT NOT NULL,
           size_m REAL NOT NULL,
           guidance TEXT NOT NULL,
           help INTEGER NOT NULL,
           probe INTEGER NOT NULL,
           scaled INTEGER NOT NULL,
           simulated INTEGER NOT NULL,
           answer TEXT NOT NULL,
           right_answer INTEGER NOT NULL,
           latency_s REAL NOT NULL,
           coverage REAL NOT NULL,
           mean_error_m REAL NOT NULL,
           rms_error_m REAL NOT NULL,
           error_widths REAL NOT NULL,
           wander_offs INTEGER NOT NULL,
           duration_s REAL NOT NULL,
           log_jerk REAL NOT NULL,
           spectral_arc REAL NOT NULL,
           mean_force_N REAL NOT NULL,
           mean_guidance_N REAL NOT NULL,
           guidance_work_J REAL NOT NULL);
         CREATE INDEX trial_of_learner ON trial (learner, time_unix_s);
         CREATE TABLE track (
           trial INTEGER PRIMARY KEY REFERENCES trial(id) ON DELETE CASCADE,
           samples BLOB NOT NULL);
         CREATE TABLE event (
           id INTEGER PRIMARY KEY,
           learner INTEGER NOT NULL REFERENCES learner(id) ON DELETE CASCADE,
           time_unix_s INTEGER NOT NULL,
           kind TEXT NOT NULL,
           text TEXT NOT NULL);
         CREATE INDEX event_of_learner ON event (learner, time_unix_s);)",
      // 2: a simulated learner is known as one before its first trial; work that must be finished
      // at the next start if the program was killed in the middle of it
      R"(ALTER TABLE learner ADD COLUMN simulated INTEGER NOT NULL DEFAULT 0;
         UPDATE learner SET simulated = 1
           WHERE id IN (SELECT learner FROM trial WHERE trial.simulated <> 0);
         CREATE TABLE unfinished (work TEXT PRIMARY KEY);)",
      // 3: what is read, and how far
      R"(CREATE TABLE reading (
           id INTEGER PRIMARY KEY,
           learner INTEGER NOT NULL REFERENCES learner(id) ON DELETE CASCADE,
           content TEXT NOT NULL,
           path TEXT NOT NULL,
           title TEXT NOT NULL,
           time_unix_s INTEGER NOT NULL,
           length INTEGER NOT NULL,
           letter INTEGER NOT NULL,
           before TEXT NOT NULL,
           behind TEXT NOT NULL,
           words TEXT NOT NULL);
         CREATE INDEX reading_of_learner ON reading (learner, time_unix_s);
         CREATE TABLE bookmark (
           id INTEGER PRIMARY KEY,
           reading INTEGER NOT NULL REFERENCES reading(id) ON DELETE CASCADE,
           name TEXT NOT NULL,
           letter INTEGER NOT NULL,
           before TEXT NOT NULL,
           behind TEXT NOT NULL,
           UNIQUE (reading, name));)",
      // 4: a text that was edited is told from another one of the same file
      R"(ALTER TABLE reading ADD COLUMN landmarks TEXT NOT NULL DEFAULT '';)",
  };
  return steps;
}

std::int64_t RecordsVersion() { return static_cast<std::int64_t>(RecordsSteps().size()); }

std::vector<std::string> SchemaOf(const Database& file) {
  std::vector<std::string> all;
  // what SQLite makes for itself, an index of UNIQUE say, has names that nobody else may give
  Statement rows = file.Prepare(
      "SELECT type, name, coalesce(sql, '') FROM sqlite_schema "
      "WHERE name NOT LIKE 'sqlite\\_%' ESCAPE '\\' ORDER BY name, type");
  while (rows.Step())
    all.push_back(rows.Text(0) + " " + rows.Text(1) + " " + Squeezed(rows.Text(2)));
  return all;
}

std::vector<std::string> RecordsSchema(std::int64_t version) {
  const Database made = Database::InMemory();
  for (std::int64_t step = 0; step < version; ++step) {
    made.Run(RecordsSteps()[static_cast<std::size_t>(step)]);
  }
  return SchemaOf(made);
}

std::string InsertTrial() {
  std::string names = "INSERT INTO trial (learner, course";
  std::string values = ") VALUES (?, ?";
  for (const TrialField& field : TrialFields()) {
    names.append(", ").append(field.name);
    values += ", ?";
  }
  return names + values + ")";
}

std::string SelectTrials() {
  std::string sql = "SELECT id, course";
  for (const TrialField& field : TrialFields()) sql.append(", ").append(field.name);
  return sql + " FROM trial";
}

}  // namespace moontrace

#include "lessons/records/readings.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "lessons/records/database.h"
#include "textures/base/utf8.h"

namespace moontrace {

std::string KeptReadText(const std::string& text) {
  std::string clean = text.substr(0, kLongestReadText);
  while (const std::optional<std::size_t> bad = FirstBadUtf8(clean)) clean[*bad] = '?';
  return clean;
}

namespace {

void BindPlace(Statement& statement, int index, const ReadPlace& place) {
  statement.Bind(index, place.letter)
      .Bind(index + 1, KeptReadText(place.before))
      .Bind(index + 2, KeptReadText(place.behind));
}

ReadPlace PlaceIn(const Statement& row, int column) {
  return {std::max<std::int64_t>(row.Integer(column), 0), row.Text(column + 1),
          row.Text(column + 2)};
}

std::vector<ReadMark> MarksOf(const Database& file, std::int64_t reading) {
  std::vector<ReadMark> marks;
  Statement rows = file.Prepare(
      "SELECT name, letter, before, behind FROM bookmark WHERE reading = ? ORDER BY id");
  rows.Bind(1, reading);
  while (rows.Step()) marks.push_back({rows.Text(0), PlaceIn(rows, 1)});
  return marks;
}

void KeepMarks(const Database& file, std::int64_t reading, const std::vector<ReadMark>& marks) {
  file.Prepare("DELETE FROM bookmark WHERE reading = ?").Bind(1, reading).Step();
  const std::size_t first = marks.size() - std::min(marks.size(), kMostReadMarks);
  for (std::size_t i = first; i < marks.size(); ++i) {
    Statement insert = file.Prepare(
        "INSERT OR REPLACE INTO bookmark (reading, name, letter, before, behind) "
        "VALUES (?, ?, ?, ?, ?)");
    insert.Bind(1, reading).Bind(2, KeptReadText(marks[i].name));
    BindPlace(insert, 3, marks[i].place);
    insert.Step();
  }
}

}  // namespace

std::vector<ReadDocument> ReadingsOf(const Database& file, std::int64_t learner) {
  std::vector<ReadDocument> readings;
  Statement rows = file.Prepare(
      "SELECT id, content, path, title, time_unix_s, length, letter, before, behind, words, "
      "landmarks FROM reading WHERE learner = ? ORDER BY time_unix_s DESC, id DESC");
  rows.Bind(1, learner);
  while (rows.Step()) {
    readings.push_back({rows.Integer(0), rows.Text(1), rows.Text(2), rows.Text(3), rows.Integer(4),
                        rows.Integer(5), PlaceIn(rows, 6), rows.Text(9),
                        MarksOf(file, rows.Integer(0)), rows.Text(10)});
  }
  return readings;
}

std::int64_t KeepReading(const Database& file, std::int64_t learner, const ReadDocument& reading) {
  const bool fresh = reading.id == 0;
  Statement keep =
      fresh ? file.Prepare(
                  "INSERT INTO reading (content, path, title, time_unix_s, length, letter, before, "
                  "behind, words, landmarks, learner) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
            : file.Prepare(
                  "UPDATE reading SET content = ?, path = ?, title = ?, time_unix_s = ?, "
                  "length = ?, letter = ?, before = ?, behind = ?, words = ?, "
                  "landmarks = ? "
                  "WHERE learner = ? AND id = ?");
  keep.Bind(1, KeptReadText(reading.content))
      .Bind(2, KeptReadText(reading.path))
      .Bind(3, KeptReadText(reading.title))
      .Bind(4, reading.time)
      .Bind(5, reading.length);
  BindPlace(keep, 6, reading.place);
  keep.Bind(9, KeptReadText(reading.where))
      .Bind(10, KeptReadText(reading.landmarks))
      .Bind(11, learner);
  if (!fresh) keep.Bind(12, reading.id);
  keep.Step();
  if (file.Number("SELECT changes()") == 0) return reading.id;  // no row of this learner
  const std::int64_t id = fresh ? file.LastRow() : reading.id;
  const bool same = fresh ? reading.marks.empty() : MarksOf(file, id) == reading.marks;
  if (!same) KeepMarks(file, id, reading.marks);
  return id;
}

bool DeleteReading(const Database& file, std::int64_t learner, std::int64_t id) {
  file.Prepare("DELETE FROM reading WHERE learner = ? AND id = ?")
      .Bind(1, learner)
      .Bind(2, id)
      .Step();
  return file.Number("SELECT changes()") > 0;  // its bookmarks go with it
}

}  // namespace moontrace

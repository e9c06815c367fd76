#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace moontrace {

class Database;

/// A letter of a document's text, with what stands around it, so that it is found again after the
/// text was changed.
struct ReadPlace {
  std::int64_t letter = 0;  ///< its byte in the text, from 0
  std::string before;       ///< the text up to it, at most 80 bytes
  std::string behind;       ///< the text from it on, at most 80 bytes
  bool operator==(const ReadPlace&) const = default;
};

struct ReadMark {
  std::string name;
  ReadPlace place;
  bool operator==(const ReadMark&) const = default;
};

/// A document that a learner reads, and how far.
struct ReadDocument {
  std::int64_t id = 0;      ///< of its row; 0: not kept yet
  std::string content;      ///< a digest of its text, by which it is known wherever it lies
  std::string path;         ///< where it lay last, absolute
  std::string title;        ///< as it was told
  std::int64_t time = 0;    ///< when it was read last, Unix time [s]
  std::int64_t length = 0;  ///< of the text [bytes]
  ReadPlace place;
  std::string where;            ///< the place in words, as it was told
  std::vector<ReadMark> marks;  ///< in the order in which they were set
  /// Pieces of the text, by which it is known again after an edit (document_places.h); empty: kept
  /// by an older version.
  std::string landmarks = {};
  bool operator==(const ReadDocument&) const = default;
};

/// Texts of a document's row that are longer are cut to so many bytes.
constexpr std::size_t kLongestReadText = 4000;
/// Bookmarks of a document [number]; of more the first are dropped.
constexpr std::size_t kMostReadMarks = 500;

/// A text as a row has it: cut, and bytes that are no UTF-8 become "?".
std::string KeptReadText(const std::string& text);

/// What a learner reads, the newest first. Throws as Database.
std::vector<ReadDocument> ReadingsOf(const Database& file, std::int64_t learner);

/// A new row, or the one of that id anew; its id. Within a transaction of the caller's.
std::int64_t KeepReading(const Database& file, std::int64_t learner, const ReadDocument& reading);

/// Deletes a learner's row with its bookmarks; false: there is none. Within a transaction of the
/// caller's.
bool DeleteReading(const Database& file, std::int64_t learner, std::int64_t id);

}  // namespace moontrace

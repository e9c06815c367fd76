#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/records/records.h"
#include "sim/console/console.h"

namespace moontrace {

/// How a document that is opened was found among those that were read.
enum class KnownBy : std::uint8_t {
  kNothing,  ///< it is read for the first time, or nothing is remembered
  kContent,  ///< the same text, at the same place
  kMoved,    ///< the same text, at another place
  kEdited    ///< much of the text, at the same place and of the same title
};

/// What is remembered of one learner's reading of one document. One thread.
class BookMemory {
 public:
  /// Remembers nothing.
  BookMemory() = default;
  /// `text`: the transcription. Places of an edited document are found again in it. A text that
  /// took another one's place is read for the first time, and what was kept of that one stays.
  BookMemory(Records records, std::string learner, std::string path, std::string title,
             std::string_view text);

  bool remembers() const { return records_.has_value(); }
  const std::string& learner() const { return learner_; }
  KnownBy known_by() const { return known_by_; }
  /// Where reading goes on; letter 0 of a new one.
  const ReadDocument& reading() const { return reading_; }
  /// Something else was read at the same place before.
  bool replaced() const { return replaced_; }
  /// The words at the place of an edited document are gone: reading goes on near where they stood.
  bool place_gone() const { return place_gone_; }
  /// Bookmarks of an edited document whose words are gone; they are no longer among the others.
  const std::vector<ReadMark>& lost_marks() const { return lost_marks_; }

  /// The place, on disk when this returns; why not, where that fails: then the next one is tried.
  std::string Keep(std::string_view text, std::size_t letter, const std::string& where);
  /// A text that lessons give the learner to read, by the word `my text`; why not, where it cannot
  /// be kept.
  std::string KeepOwnText(const std::string& text);
  /// A bookmark, which the next Keep keeps; one of that name moves. Without a name it is given one.
  /// Its name.
  std::string Mark(std::string_view text, std::size_t letter, std::string name);
  /// By its name, in whatever case; the newest for an empty one; null: there is none.
  const ReadMark* MarkNamed(std::string_view name) const;
  /// Forgets a bookmark, which the next Keep keeps; false: there is none of that name.
  bool ForgetMark(std::string_view name);

 private:
  void Recognise(std::string_view text, const std::string& path, const std::string& title);
  void FindAgain(std::string_view text);

  std::optional<Records> records_;
  std::string learner_;
  KnownBy known_by_ = KnownBy::kNothing;
  bool replaced_ = false, place_gone_ = false;
  std::vector<ReadMark> lost_marks_;
  ReadDocument reading_;
};

/// The records' learner who reads: the one that is named, who is new if nobody is called so, else
/// the only one. None: nobody is named, and there are none or several. Throws InputError: a
/// pseudonym that cannot be one; UsageError: a simulated learner.
std::optional<std::string> WhoReads(Records& records, const std::string& given, Console& console);

}  // namespace moontrace

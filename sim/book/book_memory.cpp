#include "sim/book/book_memory.h"

#include <algorithm>
#include <ctime>
#include <utility>

#include "lessons/documents/document_places.h"
#include "lessons/records/learner_names.h"
#include "sim/book/book_messages.h"
#include "textures/base/digest.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {

namespace {

ReadPlace ReadPlaceOf(std::string_view text, std::size_t letter) {
  Around around = AroundOf(text, letter);
  return {static_cast<std::int64_t>(letter), std::move(around.before), std::move(around.behind)};
}

std::size_t LetterOf(const ReadPlace& place) { return static_cast<std::size_t>(place.letter); }

std::size_t LengthOf(const ReadDocument& kept) {
  return static_cast<std::size_t>(std::max<std::int64_t>(kept.length, 0));
}

std::optional<std::size_t> PlaceAgain(std::string_view text, const ReadPlace& place,
                                      std::size_t length) {
  return FindAgain(text, {place.before, place.behind}, LetterOf(place), length);
}

/// Whether a text is what a kept one became by an edit: half of it stands there still. Of what an
/// older version kept there is its place alone, and the bookmarks.
bool IsEditOf(const ReadDocument& kept, std::string_view text) {
  constexpr double kHalf = 0.5;
  if (!kept.landmarks.empty()) return LandmarksIn(text, kept.landmarks) >= kHalf;
  const auto stands = [&](const ReadPlace& place) {
    return PlaceAgain(text, place, LengthOf(kept)).has_value();
  };
  const auto marks = std::count_if(kept.marks.begin(), kept.marks.end(),
                                   [&](const ReadMark& mark) { return stands(mark.place); });
  return stands(kept.place) && 2 * static_cast<std::size_t>(marks) >= kept.marks.size();
}

}  // namespace

BookMemory::BookMemory(Records records, std::string learner, std::string path, std::string title,
                       std::string_view text)
    : records_(std::move(records)), learner_(std::move(learner)) {
  path = KeptReadText(path);
  title = KeptReadText(title);
  Recognise(text, path, title);
  reading_.content = ToHex(DigestOf(text));
  reading_.length = static_cast<std::int64_t>(text.size());
  reading_.landmarks = LandmarksOf(text);
  reading_.path = std::move(path);
  reading_.title = std::move(title);
}

/// Of several the newest; the same text comes before the same path.
void BookMemory::Recognise(std::string_view text, const std::string& path,
                           const std::string& title) {
  const std::string content = ToHex(DigestOf(text));
  for (ReadDocument& kept : records_->Readings(learner_)) {
    if (kept.content == content && LengthOf(kept) == text.size()) {
      known_by_ = kept.path == path ? KnownBy::kContent : KnownBy::kMoved;
      reading_ = std::move(kept);
      replaced_ = false;
      return;
    }
    if (path.empty() || kept.path != path) continue;
    replaced_ = true;
    if (known_by_ == KnownBy::kNothing && kept.title == title && IsEditOf(kept, text)) {
      known_by_ = KnownBy::kEdited;
      reading_ = std::move(kept);
    }
  }
  if (known_by_ != KnownBy::kEdited) return;
  replaced_ = false;
  FindAgain(text);
}

void BookMemory::FindAgain(std::string_view text) {
  const std::size_t length = LengthOf(reading_);
  const auto letter = PlaceAgain(text, reading_.place, length);
  place_gone_ = !letter;
  reading_.place =
      ReadPlaceOf(text, letter.value_or(SameShare(text, LetterOf(reading_.place), length)));
  std::vector<ReadMark> marks;
  for (ReadMark& mark : reading_.marks) {
    if (const auto found = PlaceAgain(text, mark.place, length)) {
      marks.push_back({std::move(mark.name), ReadPlaceOf(text, *found)});
    } else {
      lost_marks_.push_back(std::move(mark));
    }
  }
  reading_.marks = std::move(marks);
}

std::string BookMemory::Keep(std::string_view text, std::size_t letter, const std::string& where) {
  if (!records_) return {};
  reading_.place = ReadPlaceOf(text, letter);
  reading_.where = where;
  reading_.time = static_cast<std::int64_t>(std::time(nullptr));
  try {
    reading_.id = records_->Keep(learner_, reading_);
    return {};
  } catch (const std::runtime_error& error) {  // an InputError or a LackError
    return error.what();
  }
}

std::string BookMemory::KeepOwnText(const std::string& text) {
  const auto now = static_cast<std::int64_t>(std::time(nullptr));
  try {
    records_->AddEvent(learner_, {now, std::string(kOwnTextEvent), text});
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::string BookMemory::Mark(std::string_view text, std::size_t letter, std::string name) {
  std::vector<ReadMark>& marks = reading_.marks;
  for (std::size_t number = 1; name.empty(); ++number) {
    if (MarkNamed(say::NameOfMark(number)) == nullptr) name = say::NameOfMark(number);
  }
  const std::string folded = CaseFolded(name);
  marks.erase(
      std::remove_if(marks.begin(), marks.end(),
                     [&folded](const ReadMark& mark) { return CaseFolded(mark.name) == folded; }),
      marks.end());
  marks.push_back({name, ReadPlaceOf(text, letter)});
  return name;
}

bool BookMemory::ForgetMark(std::string_view name) {
  const ReadMark* mark = name.empty() ? nullptr : MarkNamed(name);
  if (mark == nullptr) return false;
  reading_.marks.erase(reading_.marks.begin() + (mark - reading_.marks.data()));
  return true;
}

const ReadMark* BookMemory::MarkNamed(std::string_view name) const {
  const std::vector<ReadMark>& marks = reading_.marks;
  if (name.empty()) return marks.empty() ? nullptr : &marks.back();
  const std::string folded = CaseFolded(name);
  const auto found = std::find_if(marks.begin(), marks.end(), [&folded](const ReadMark& mark) {
    return CaseFolded(mark.name) == folded;
  });
  return found == marks.end() ? nullptr : &*found;
}

std::optional<std::string> WhoReads(Records& records, const std::string& given, Console& console) {
  const std::vector<LearnerEntry> known = records.Learners();
  if (given.empty()) {
    const std::vector<std::string> people = PeopleAmong(known);
    if (people.size() == 1) return people.front();
    return std::nullopt;
  }
  const std::string name = KeptName(given, known);
  for (const LearnerEntry& learner : known) {
    if (learner.pseudonym != name) continue;
    if (learner.simulated) throw UsageError(say::SimulatedReader(given));
    return name;
  }
  LearnerEntry learner;
  learner.pseudonym = given;
  learner.since = static_cast<std::int64_t>(std::time(nullptr));
  records.AddLearner(learner);
  console.Happening(say::NewReader(given));
  return given;
}

}  // namespace moontrace

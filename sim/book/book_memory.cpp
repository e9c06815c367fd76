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

}  // namespace

BookMemory::BookMemory(Records records, std::string learner, std::string path, std::string title,
                       std::string_view text)
    : records_(std::move(records)), learner_(std::move(learner)) {
  const std::string content = ToHex(DigestOf(text));
  const auto length = static_cast<std::int64_t>(text.size());
  for (ReadDocument& kept : records_->Readings(learner_)) {
    const bool same = kept.content == content && kept.length == length;
    if (!same && (path.empty() || kept.path != path)) continue;
    // of several the newest; the same text comes before the same path
    if (same || known_by_ == KnownBy::kNothing) reading_ = std::move(kept);
    known_by_ = same ? KnownBy::kContent : KnownBy::kPath;
    if (same) break;
  }
  if (known_by_ == KnownBy::kContent && reading_.path != path) known_by_ = KnownBy::kMoved;
  if (known_by_ == KnownBy::kPath) FindAgain(text);
  reading_.content = content;
  reading_.length = length;
  reading_.path = std::move(path);
  reading_.title = std::move(title);
}

void BookMemory::FindAgain(std::string_view text) {
  const auto length = static_cast<std::size_t>(std::max<std::int64_t>(reading_.length, 0));
  const auto again = [&](ReadPlace& place) {
    place = ReadPlaceOf(text, moontrace::FindAgain(text, {place.before, place.behind},
                                                   static_cast<std::size_t>(place.letter), length));
  };
  again(reading_.place);
  for (ReadMark& mark : reading_.marks) again(mark.place);
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

#include "sim/book/read_book.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "lessons/documents/document_places.h"
#include "lessons/documents/transcribe.h"
#include "lessons/records/learner_names.h"
#include "sim/book/book_memory.h"
#include "sim/book/book_messages.h"
#include "sim/book/book_tutor.h"
#include "sim/book/book_walk.h"
#include "sim/book/document_messages.h"
#include "sim/book/moon_lines.h"
#include "sim/book/read_list.h"
#include "sim/book/unset_words.h"
#include "sim/session/loop_messages.h"
#include "sim/session/loop_session.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

SessionRequest RequestOf(const ReadBookOptions& options, const std::string& file,
                         std::string text) {
  SessionRequest request;
  request.input_taken = file == "-";
  request.text.text.text = std::move(text);
  request.text.style = options.style;
  request.text.style.structure = true;
  request.text.layout = options.layout;
  request.text.command = "read";
  request.text.book = true;
  request.text.turn_mark = options.turns;
  request.live = options.live;
  request.press = options.press;
  request.seed = options.seed;
  return request;
}

/// Asked by touch, of several people. None: whoever was asked has left; empty: none of them.
std::optional<std::string> AskWho(const SessionRequest& like, const Records& records,
                                  LineReader& typed, Console& console) {
  std::vector<std::string> names = PeopleAmong(records.Learners());
  if (names.size() < 2) return std::string();
  names.emplace_back(say::NoneOfThem());
  const auto taken = ChooseByTouch(like, say::AskWhoReads(), names, typed, console);
  if (!taken) return std::nullopt;
  return *taken == say::NoneOfThem() ? std::string() : *taken;
}

/// What is remembered, and whether records that were to be used could not be.
struct Kept {
  std::optional<BookMemory> memory;  ///< none: whoever was asked for a name has left
  bool wrong = false, lacking = false;
};

Kept MemoryOf(const ReadBookOptions& options, const Book& book, const std::string& file,
              LineReader& typed, Console& console) {
  if (!Records::Available()) {
    console.Remark(say::ReadsWithoutRecords());
    return {BookMemory()};
  }
  if (!options.learner.empty()) RequirePseudonym(options.learner);
  try {
    Records records = Records::Open(options.records);
    std::optional<std::string> learner = WhoReads(records, options.learner, console);
    if (!learner && options.moon) {
      learner = AskWho(RequestOf(options, file, ""), records, typed, console);
      if (!learner) return {};
    }
    if (!learner || learner->empty()) {
      console.Remark(say::ReadsWithoutName());
      return {BookMemory()};
    }
    return {BookMemory(std::move(records), std::move(*learner), PathOfRead(file), book.title,
                       book.text.text)};
  } catch (const InputError& error) {
    console.Remark(say::PlaceNotKept(error.what()));
    return {BookMemory(), true, false};
  } catch (const LackError& error) {
    console.Remark(say::PlaceNotKept(error.what()));
    return {BookMemory(), false, true};
  }
}

/// What must be known before reading: of what was kept, and of what is felt.
std::vector<std::string> NewsOf(const BookMemory& memory, const LoopSession& session, bool known) {
  std::vector<std::string> news;
  if (memory.replaced()) news.push_back(say::BookReplaced());
  for (const ReadMark& mark : memory.lost_marks()) {
    news.push_back(say::MarkLost(mark.name, WordsOf(mark.place.before + mark.place.behind)));
  }
  if (known) news.push_back(say::LeftOutWordsAre(CountLeftOut(session.text())));
  return news;
}

/// What was left out of a document that is not known yet, and replaced in it.
void SayLeftOut(const Document& document, const LoopSession& session, Console& console) {
  for (const LeftOutCount& one : document.left_out) console.Result(say::LeftOutOf(one));
  SayReplacements(
      session.text().set, [&console](const std::string& line) { console.Remark(line); },
      kReplacementsSaid);
}

void SayEnd(BookWalk& walk, Console& console) {
  for (const std::string& line : walk.End()) console.Result(line);
}

}  // namespace

void ReadBook(const Document& document, const std::string& file, const ReadBookOptions& options,
              Console& console) {
  const Transcription text = Transcribe(document);
  const Book book{document, text, say::DocumentName(document, file)};
  LineReader typed(console.in());
  Kept kept = MemoryOf(options, book, file, typed, console);
  if (!kept.memory) return;
  BookMemory& memory = *kept.memory;
  LoopSession session(RequestOf(options, file, text.text), console);
  const std::size_t pages = session.text().set.pages.size();
  console.Result(say::DocumentSummary(document, file, &pages));
  const std::vector<std::string> news = NewsOf(memory, session, options.known);
  for (const std::string& line : news) console.Result(line);
  if (memory.known_by() != KnownBy::kContent) SayLeftOut(document, session, console);
  const std::string why_not = session.loop().not_realtime();
  if (session.device().felt() && !why_not.empty()) console.Remark(say::NotRealtime(why_not));
  SayBeginning(session, console);
  BookWalk walk(session, book, memory,
                {options.turns, options.alone, options.moon, options.known, news});
  std::optional<BookDesk> tutors;
  if (options.tutor)
    tutors.emplace(memory.remembers() ? memory.learner() : "reader", book.title, walk);
  DriveOptions drive;
  drive.seconds = options.live.seconds;
  drive.companion = &walk;
  drive.typed = &typed;
  drive.input_ends = !options.alone;
  if (tutors) drive.elsewhere = &*tutors;
  try {
    Drive(session, drive, console);
  } catch (const OutputLost&) {
    walk.End();
    throw;
  } catch (const Interrupted&) {
    SayEnd(walk, console);
    throw;
  }
  SayEnd(walk, console);
  RequireDevice(session);
  if (kept.wrong) throw InputError(say::PlaceLost());
  if (kept.lacking || walk.lost()) throw LackError(say::PlaceLost());
}

std::optional<ListedFile> ChooseReading(const ReadBookOptions& options, Console& console) {
  std::vector<ListedFile> files = FilesToReadOn(options.learner, options.records);
  if (files.empty()) {
    console.Result(say::NothingRead());
    TellInPlaceOfBook(say::NothingRead(), options, console);
    return std::nullopt;
  }
  const bool one_reader = std::all_of(files.begin(), files.end(), [&files](const ListedFile& one) {
    return one.learner == files.front().learner;
  });
  std::vector<std::string> answers;
  answers.reserve(files.size());
  for (const ListedFile& one : files) {
    const std::string whose = one_reader ? "" : one.learner;
    answers.push_back(say::NumberedTitle(answers.size() + 1, one.title, whose));
  }
  LineReader typed(console.in());
  const auto taken =
      ChooseByTouch(RequestOf(options, "", ""), say::AskWhichText(), answers, typed, console);
  if (!taken) return std::nullopt;
  const auto at = std::find(answers.begin(), answers.end(), *taken) - answers.begin();
  return std::move(files[static_cast<std::size_t>(at)]);
}

void TellInPlaceOfBook(const std::string& sentence, const ReadBookOptions& options,
                       Console& console) {
  try {
    LineReader typed(console.in());
    TellByTouch(RequestOf(options, "", ""), sentence, typed, console);
  } catch (const InputError&) {  // the sentence stands in the text face as well
  } catch (const LackError&) {
  }
}

}  // namespace moontrace

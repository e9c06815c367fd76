#include "sim/book/moon_lines.h"

#include <algorithm>
#include <array>
#include <utility>

#include "textures/base/utf8.h"

namespace moontrace {
namespace {

using Lines = std::vector<std::string>;

std::optional<std::string> Lay(const SessionRequest& like, const std::string& question,
                               const Lines& answers, LineReader& typed, Console& console) {
  SessionRequest request = like;
  std::string text = question;
  for (const std::string& answer : answers) text += "\n" + answer;
  request.text.text.text = std::move(text);
  request.text.style.structure = false;
  request.text.style.only.reset();
  request.text.book = request.text.turn_mark = false;
  LoopSession session(request, console);
  MoonLines lines(session, question, answers);
  DriveOptions drive;
  drive.seconds = like.live.seconds;
  drive.companion = &lines;
  drive.typed = &typed;
  Drive(session, drive, console);
  return lines.taken();
}

}  // namespace

std::optional<Lines> MoonLines::Obey(std::string_view line, const LoopSnapshot& /*now*/) {
  if (Take(std::string(line))) return Lines{};  // first: an answer may begin as a word's number
  const SaidLine said = ReadLine(line, WordPlace::kBook);
  constexpr std::array<std::string_view, 4> kDriven{"quit", "stop", "pause", "go"};
  const bool driven = said.word != nullptr &&
                      std::find(kDriven.begin(), kDriven.end(), said.word->word) != kDriven.end();
  if (driven) return std::nullopt;
  return Asked();
}

Lines MoonLines::Asked() const {
  Lines lines{question_};
  lines.insert(lines.end(), answers_.begin(), answers_.end());
  return lines;
}

Companion::Press MoonLines::Pressed(bool /*twice*/, const LoopEvent& event) {
  if (stopped_) {  // no answer is taken that is not felt
    session_.GoOn();
    return {true, ""};
  }
  const std::optional<TouchedLine> line = LineAt(session_.felt(), event.tip_P);
  // nobody chooses by a press what the hand has not read
  const bool read = line && line_.Is(line->number);
  if (!Take(read ? line->text : "") && !line) {
    const std::size_t next = session_.felt().index + 1;
    session_.TurnToStartOf(next < session_.text().set.pages.size() ? next : 0);
  }
  return {true, ""};
}

Lines MoonLines::Look(const LoopSnapshot& now) {
  stopped_ = now.stopped;
  if (!touched_ && now.depth > 0) {  // it begins under the tip
    touched_ = true;
    session_.TurnToStartOf(0);
  }
  if (now.page == session_.felt().number) line_.See(session_.felt(), now.tip_P, now.depth > 0);
  urgent_ = !std::exchange(told_, true);
  return urgent_ ? Asked() : Lines{};
}

/// False: that is no answer.
bool MoonLines::Take(const std::string& line) {
  const std::string folded = CaseFolded(line);
  const auto found =
      std::find_if(answers_.begin(), answers_.end(),
                   [&folded](const std::string& one) { return CaseFolded(one) == folded; });
  if (found != answers_.end()) taken_ = *found;
  ended_ = taken_.has_value() || answers_.empty();
  return ended_;
}

std::optional<std::string> ChooseByTouch(const SessionRequest& like, const std::string& question,
                                         const Lines& answers, LineReader& typed,
                                         Console& console) {
  return Lay(like, question, answers, typed, console);
}

void TellByTouch(const SessionRequest& like, const std::string& sentence, LineReader& typed,
                 Console& console) {
  Lay(like, sentence, {}, typed, console);
}

}  // namespace moontrace

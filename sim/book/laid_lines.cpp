#include "sim/book/laid_lines.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "textures/base/error.h"

namespace moontrace {
namespace {

/// A tip above this has left the line that it touched [m]; ours.
constexpr double kLifted = 0.005;
/// Across a narrow letter and beside it, where it is near still [em]; ours.
constexpr double kSlid = 0.4;

}  // namespace

std::optional<TouchedLine> LineAt(const FeltPage& felt, glm::dvec2 p_P) {
  const std::optional<NearLetter> near = LetterNear(felt, p_P);
  if (!near || !near->near) return std::nullopt;
  const std::size_t letter = LetterPlaceOf(felt, p_P)->source;
  const std::string& text = felt.text->text;
  const auto at = text.begin() + static_cast<std::ptrdiff_t>(std::min(letter, text.size()));
  const auto begin = std::find(std::make_reverse_iterator(at), text.rend(), '\n').base();
  return TouchedLine{std::string(begin, std::find(at, text.end(), '\n')),
                     static_cast<std::size_t>(std::count(text.begin(), at, '\n'))};
}

void FeltLine::See(const FeltPage& felt, glm::dvec2 p_P, bool touching) {
  if (!touching) return;
  const std::optional<TouchedLine> line = LineAt(felt, p_P);
  if (!line) return;
  if (line_ != line->number) {
    line_ = line->number;
    begin_ = p_P.x;
    slid_ = false;
  }
  slid_ = slid_ || std::abs(p_P.x - begin_) >= kSlid * felt.text->set.style.size;
}

bool LaidLines::Lay(std::vector<Line> lines, glm::dvec2 tip_P) {
  std::string text;
  for (const Line& line : lines) text += (text.empty() ? "" : "\n") + line.shown;
  TextRequest request = session_.request();
  request.text.text = text == "-" ? "- " : std::move(text);  // "-" is standard input
  request.style.structure = false;
  request.style.only.reset();
  request.book = request.turn_mark = false;
  std::optional<LoopSession::Laid> before = text_ ? text_ : session_.Lies();
  try {
    session_.LayLine(std::move(request));
  } catch (const InputError&) {
    return false;  // it was said
  }
  if (!text_) tip_P_ = tip_P;
  text_ = std::move(before);
  lines_ = std::move(lines);
  return true;
}

bool LaidLines::Clear() {
  if (!text_) return false;
  session_.LayAgain(*std::exchange(text_, std::nullopt), tip_P_);
  return true;
}

LaidLines::Press LaidLines::Pressed(bool twice, glm::dvec3 tip_P) {
  std::optional<TouchedLine> line;
  if (!twice && tip_P.z < kLifted) line = LineAt(session_.felt(), tip_P);
  const bool chosen = line && line->number < lines_.size() && !lines_[line->number].word.empty();
  const std::size_t next = session_.felt().index + 1;
  if (!twice && !chosen && next < session_.text().set.pages.size()) {
    session_.TurnToStartOf(next);
    return {true, ""};
  }
  Clear();
  return {false, chosen ? lines_[line->number].word : std::string()};
}

}  // namespace moontrace

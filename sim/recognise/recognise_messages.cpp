#include "sim/recognise/recognise_messages.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "sim/console/wording.h"
#include "sim/reading/read_text.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"

namespace moontrace::say {
namespace {

std::string MarkWord(int mark, const Script& script) {
  switch (mark) {
    case kSpaceMark:
      return "a space";
    case kLineEndMark:
      return "a line end";
    case kUnknownMark:
      return "unknown";
    default:
      return TextOfSign(static_cast<std::size_t>(mark), script);
  }
}

}  // namespace

std::string ReadingOutcome(const ReadingScore& score) {
  return fmt::format("{} of {} right; {} wrong, {} missed, {} extra. Spaces and line ends count.",
                     score.right, score.right + score.wrong + score.missed, score.wrong,
                     score.missed, score.extra);
}

std::string NothingRead(double seconds, std::size_t signs) {
  const std::string missed =
      signs > 0 ? fmt::format(" {} there.", Counted(signs, "sign lies", "signs lie")) : "";
  return fmt::format("Nothing was read: no sign felt in {} s.{}", Short(seconds, 1), missed);
}

std::string ReadingTime(const ReadingScore& score, double seconds, double real_time_factor) {
  return fmt::format("{} s a sign, {} s in all, simulated; {} times real time.",
                     Short(seconds / static_cast<double>(std::max<std::size_t>(1, score.signs)), 1),
                     Short(seconds, 0), Short(real_time_factor, 0));
}

std::string Confusions(const ReadingScore& score, const Script& script) {
  if (score.confusions.empty()) return {};
  std::vector<std::pair<std::size_t, std::pair<int, int>>> order;
  for (const auto& [pair, count] : score.confusions) order.emplace_back(count, pair);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  constexpr std::size_t kMost = 12;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < order.size() && i < kMost; ++i) {
    const auto& [count, pair] = order[i];
    std::string word =
        fmt::format("{} for {}", MarkWord(pair.second, script), MarkWord(pair.first, script));
    if (count > 1) word += fmt::format(" {}", Times(count));
    words.push_back(std::move(word));
  }
  if (order.size() > kMost) words.push_back(fmt::format("{} more", order.size() - kMost));
  return fmt::format("Read wrongly: {}.", Joined(words, ", "));
}

std::string AsRead() { return "As read, line by line:"; }

std::string Spoken(std::string_view read) {
  constexpr std::string_view kUnknown = "\xEF\xBF\xBD";
  std::string spoken;
  for (std::size_t from = 0; from < read.size();) {
    const std::size_t at = read.find(kUnknown, from);
    spoken += read.substr(from, at - from);
    if (at == std::string_view::npos) break;
    spoken += "(unknown)";
    from = at + kUnknown.size();
  }
  return spoken;
}

std::string InPrint() { return "In print, line by line:"; }

std::string ReadsWhereLettersAreFelt(std::string_view profile, bool followed) {
  return fmt::format(
      "device profile {}: recognise needs one that {}; name another", Quoted(profile),
      followed ? "measures and pushes x and y"
               : "measures z too for ridges, Braille and linked letters, which are not followed");
}

std::string ReaderPressedThrough(std::size_t page, std::size_t count) {
  return fmt::format("Page {}: the paper gave way under the tip {}; press less (--press-n).",
                     page + 1, Times(count));
}

std::string ReaderStopped(std::size_t page) {
  return fmt::format("Page {}: the reader found no end by itself and was stopped.", page + 1);
}

std::string ReaderMissesWideGaps() {
  return "The text has wide gaps: the reader may take one for the end of its line.";
}

std::string ReaderFollowsNoGuides() {
  return "The reader follows guide lines in grooves without links only: here it reads little.";
}

std::string ReaderKnowsLinksToTheRight() {
  return "The reader knows links of lines from left to right only: here it reads little.";
}

std::string Belief(std::string_view sign, double probability) {
  return fmt::format("{} {} %", sign.empty() ? "unknown" : sign, Short(100 * probability, 0));
}

std::string Doing(ReaderActivity activity) {
  switch (activity) {
    case ReaderActivity::kFlying:
      return "lifted";
    case ReaderActivity::kSearching:
      return "searches";
    case ReaderActivity::kCrossing:
      return "tells signs apart";
    case ReaderActivity::kSettling:
      return "goes back";
    case ReaderActivity::kFollowing:
      return "follows";
    case ReaderActivity::kTurning:
      return "looks for the rest";
    case ReaderActivity::kHatching:
      return "goes up and down";
    case ReaderActivity::kDone:
      return "has read it all";
  }
  return {};
}

std::string ReadingPictureTitle(const Script& script, const TypeStyle& style) {
  return fmt::format("{} of {} mm read by touch", OneLine(script.title, 60),
                     Short(kMillimetres * style.size, 2));
}

std::string ReadingPictureWords(std::string_view text, std::string_view read) {
  return fmt::format("Text: {}. Read: {}.", OneLine(Unbroken(text)),
                     read.empty() ? "nothing" : OneLine(Spoken(read)));
}

std::string ReadingPictureLegend(const TypeStyle& style, bool followed, bool blank) {
  const char* letters = style.relief == Relief::kEmbossed ? "ridge" : "groove";
  const std::string ground = blank ? fmt::format("Dashed grey: where each {} would be.", letters)
                                   : fmt::format("Grey band: the {}, {} mm wide.", letters,
                                                 Short(kMillimetres * style.width, 2));
  return fmt::format(
      "{} Orange line: the tip where it searches{}. Print: what was read, and how sure it is where "
      "that is below 99 percent.",
      ground, followed ? ". Blue line: where it follows a groove" : " and goes over a line");
}

}  // namespace moontrace::say

#include "lessons/documents/document_places.h"

#include <algorithm>
#include <array>

#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr std::size_t kSentence = 200;  // [bytes] to either side
constexpr std::size_t kDecent =
    40;  // bytes that must be the same where a place is found again; ours
constexpr std::size_t kLandmarks = 16, kLandmark = 32;  // number, and bytes of each; ours
constexpr char kBetweenLandmarks = '\x1e';              // ASCII's record separator

bool IsBlank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

/// Not within a character of several bytes.
bool BeginsCharacter(std::string_view text, std::size_t at) {
  return at >= text.size() || (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U;
}

/// Whether a sentence ends before `at`: a stop and a blank, or a paragraph's end.
bool EndsBefore(std::string_view text, std::size_t at) {
  if (at < 2 || at >= text.size()) return at == 0 || at >= text.size();
  if (text[at - 1] == '\n' && (text[at - 2] == '\n' || text[at - 2] == '\r')) return true;
  if (!IsBlank(text[at - 1])) return false;
  std::size_t stop = at - 1;
  while (stop > 0 && (IsBlank(text[stop]) || text[stop] == '"' || text[stop] == ')')) --stop;
  return std::string_view(".!?").find(text[stop]) != std::string_view::npos;
}

/// The place of `piece` that is nearest to `expected`; npos: there is none.
std::size_t NearestPlace(std::string_view text, std::string_view piece, std::size_t expected) {
  const std::size_t behind = text.find(piece, std::min(expected, text.size()));
  const std::size_t before = text.rfind(piece, expected);
  if (behind == std::string_view::npos || before == std::string_view::npos) {
    return std::min(behind, before);
  }
  return behind - expected < expected - before ? behind : before;
}

}  // namespace

std::size_t BlockAt(const Transcription& text, std::size_t byte) {
  const auto behind = std::upper_bound(text.begins.begin(), text.begins.end(), byte);
  return behind == text.begins.begin() ? 0
                                       : static_cast<std::size_t>(behind - text.begins.begin()) - 1;
}

std::vector<std::size_t> HeadingTrail(const Document& document, std::size_t block) {
  std::vector<std::size_t> trail;
  int level = 7;  // below all
  for (std::size_t i = std::min(block + 1, document.blocks.size()); i > 0 && level > 1; --i) {
    const Block& one = document.blocks[i - 1];
    if (one.kind != BlockKind::kHeading || one.level >= level) continue;
    trail.push_back(i - 1);
    level = one.level;
  }
  std::reverse(trail.begin(), trail.end());
  return trail;
}

const TranscribedPage* PrintPageAt(const Transcription& text, std::size_t byte) {
  const auto behind =
      std::upper_bound(text.pages.begin(), text.pages.end(), byte,
                       [](std::size_t at, const TranscribedPage& page) { return at < page.begin; });
  return behind == text.pages.begin() ? nullptr : &*std::prev(behind);
}

const TranscribedLink* LinkAt(const Transcription& text, std::size_t byte) {
  const auto behind =
      std::upper_bound(text.links.begin(), text.links.end(), byte,
                       [](std::size_t at, const TranscribedLink& link) { return at < link.begin; });
  if (behind == text.links.begin() || byte >= std::prev(behind)->end) return nullptr;
  return &*std::prev(behind);
}

std::string SentenceAt(std::string_view text, std::size_t byte) {
  byte = std::min(byte, text.size());
  std::size_t begin = byte, end = std::min(byte + 1, text.size());
  while (begin > 0 && byte - begin < kSentence && !EndsBefore(text, begin)) --begin;
  while (end < text.size() && end - byte < kSentence && !EndsBefore(text, end)) ++end;
  // a longer one is cut between words
  while (begin < byte && begin > 0 && !IsBlank(text[begin - 1])) ++begin;
  while (end < text.size() && end - byte < 2 * kSentence && !IsBlank(text[end - 1]) &&
         !IsBlank(text[end])) {
    ++end;
  }
  while (!BeginsCharacter(text, begin)) ++begin;
  while (!BeginsCharacter(text, end)) ++end;
  return WordsOf(text.substr(begin, end - begin));
}

std::string ReadAt(const Document& document, const Transcription& text, std::size_t byte) {
  const std::size_t block = BlockAt(text, byte);
  const BlockKind kind =
      block < document.blocks.size() ? document.blocks[block].kind : BlockKind::kParagraph;
  const bool own = kind == BlockKind::kList || kind == BlockKind::kListItem ||
                   kind == BlockKind::kTable || kind == BlockKind::kCell;
  if (!own || block >= text.begins.size()) return SentenceAt(text.text, byte);
  const std::size_t begin = std::min(text.begins[block], byte);
  const std::size_t next =
      block + 1 < text.begins.size() ? text.begins[block + 1] : text.text.size();
  return SentenceAt(std::string_view(text.text).substr(begin, next - begin), byte - begin);
}

std::string WordsOf(std::string_view piece) {
  std::string words;
  bool line_begins = true;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (line_begins) {
      const std::size_t mark = piece.find_first_not_of("#>", i);
      if (mark != std::string_view::npos && mark > i && piece[mark] == ' ') i = mark;
    }
    line_begins = piece[i] == '\n';
    const char next = i + 1 < piece.size() ? piece[i + 1] : ' ';
    if (piece[i] == '\\' && (next == '[' || next == '#' || next == '>')) continue;
    if (piece[i] == '[' && (i == 0 || piece[i - 1] != '\\')) {
      const std::size_t close = piece.find_first_of("[]", i + 1);
      if (close != std::string_view::npos && piece.substr(close, 2) == "](") continue;
    }
    if (piece.substr(i, 2) == "](") {
      const std::size_t end = piece.find(')', i);
      i = std::min(end, piece.size() - 1);
      continue;
    }
    if (!IsBlank(piece[i])) {
      words += piece[i];
    } else if (!words.empty() && words.back() != ' ') {
      words += ' ';
    }
  }
  while (!words.empty() && words.back() == ' ') words.pop_back();
  return words;
}

Around AroundOf(std::string_view text, std::size_t byte) {
  byte = std::min(byte, text.size());
  std::size_t begin = byte - std::min(byte, kAround), end = std::min(byte + kAround, text.size());
  while (!BeginsCharacter(text, begin)) ++begin;
  while (end > byte && !BeginsCharacter(text, end)) --end;
  return {std::string(text.substr(begin, byte - begin)),
          std::string(text.substr(byte, end - byte))};
}

std::size_t SameShare(std::string_view text, std::size_t byte, std::size_t length) {
  if (text.empty()) return 0;
  const double share = length == 0 ? 0 : static_cast<double>(byte) / static_cast<double>(length);
  std::size_t at =
      std::min(static_cast<std::size_t>(share * static_cast<double>(text.size())), text.size() - 1);
  while (at > 0 && !BeginsCharacter(text, at)) --at;
  return at;
}

std::optional<std::size_t> FindAgain(std::string_view text, const Around& around, std::size_t byte,
                                     std::size_t length) {
  const std::size_t all = around.before.size() + around.behind.size();
  if (text.empty() || all == 0) return std::nullopt;
  const std::size_t decent = std::min(kDecent, all);
  const std::size_t expected = SameShare(text, byte, length);
  const std::string_view before = around.before, behind = around.behind;
  const auto place = [&text, decent](std::string_view piece, std::size_t near) {
    return piece.size() < decent ? std::string_view::npos : NearestPlace(text, piece, near);
  };
  // less and less of both sides
  for (const std::size_t most : std::array<std::size_t, 3>{80, 40, 20}) {
    const std::size_t left = std::min(before.size(), most);
    const std::string both =
        std::string(before.substr(before.size() - left)).append(behind.substr(0, most));
    const std::size_t at = place(both, expected - std::min(expected, left));
    if (at != std::string_view::npos) return std::min(at + left, text.size() - 1);
  }
  // all of the side that is still to be read, then of the one that was read
  const std::size_t right = place(behind, expected);
  if (right != std::string_view::npos) return right;
  const std::size_t left = place(before, expected - std::min(expected, before.size()));
  if (left != std::string_view::npos) return std::min(left + before.size(), text.size() - 1);
  return std::nullopt;
}

std::string LandmarksOf(std::string_view text) {
  const std::size_t length = std::min(text.size(), kLandmark);
  std::string landmarks;
  for (std::size_t i = 0; i < kLandmarks; ++i) {
    std::size_t begin = (text.size() - length) / (2 * kLandmarks) * (2 * i + 1);
    std::size_t end = begin + length;
    while (begin < end && !BeginsCharacter(text, begin)) ++begin;
    while (end > begin && !BeginsCharacter(text, end)) --end;
    const std::string_view piece = text.substr(begin, end - begin);
    if (piece.empty() || piece.find(kBetweenLandmarks) != std::string_view::npos) continue;
    landmarks.append(piece) += kBetweenLandmarks;
  }
  return landmarks;
}

double LandmarksIn(std::string_view text, std::string_view landmarks) {
  std::size_t all = 0, found = 0;
  while (!landmarks.empty()) {
    const std::size_t end = std::min(landmarks.find(kBetweenLandmarks), landmarks.size());
    ++all;
    found += text.find(landmarks.substr(0, end)) != std::string_view::npos ? 1U : 0U;
    landmarks.remove_prefix(std::min(end + 1, landmarks.size()));
  }
  return all == 0 ? 0 : static_cast<double>(found) / static_cast<double>(all);
}

}  // namespace moontrace

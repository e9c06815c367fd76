#include <algorithm>
#include <cstddef>

#include "lessons/documents/encoding.h"

namespace moontrace {
namespace {

constexpr std::size_t kLookedAt = std::size_t{1} << 16U;

unsigned ByteAt(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

bool Between(unsigned byte, unsigned first, unsigned last) { return byte >= first && byte <= last; }

/// Shift-JIS (JIS X 0208): pairs of bytes with kana among them, and hardly a byte that is none.
bool IsShiftJis(std::string_view bytes) {
  std::size_t pairs = 0, kana = 0, bad = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const unsigned lead = ByteAt(bytes, i);
    if (lead < 0x80 || Between(lead, 0xA1, 0xDF)) continue;  // ASCII, half-width kana
    const unsigned trail = i + 1 < bytes.size() ? ByteAt(bytes, i + 1) : 0;
    const bool sound = (Between(lead, 0x81, 0x9F) || Between(lead, 0xE0, 0xFC)) &&
                       Between(trail, 0x40, 0xFC) && trail != 0x7F;
    if (!sound) {
      ++bad;
      continue;
    }
    ++pairs;
    kana += (lead == 0x82 && trail >= 0x9F) || (lead == 0x83 && trail <= 0x96) ? 1U : 0U;
    ++i;
  }
  return kana * 5 > pairs && bad * 50 < pairs;
}

/// Bytes of the six commonest letters of Russian, in small and in capitals: о е а и н т.
struct Cyrillic {
  std::string_view small, capital;
};
constexpr Cyrillic kKoi8{"\xCF\xC5\xC1\xC9\xCE\xD4", "\xEF\xE5\xE1\xE9\xEE\xF4"};
constexpr Cyrillic kWindows1251{"\xEE\xE5\xE0\xE8\xED\xF2", "\xCE\xC5\xC0\xC8\xCD\xD2"};

/// Commonest letters, a capital for half.
double Common(std::string_view bytes, const Cyrillic& letters) {
  const auto count = [bytes](std::string_view wanted) {
    return static_cast<double>(std::count_if(bytes.begin(), bytes.end(), [wanted](char c) {
      return wanted.find(c) != std::string_view::npos;
    }));
  };
  return count(letters.small) + count(letters.capital) / 2;
}

bool IsAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

const char* GuessedEncoding(std::string_view bytes) {
  bytes = bytes.substr(0, kLookedAt);
  if (IsShiftJis(bytes)) return "SHIFT_JIS";
  const auto high = std::count_if(bytes.begin(), bytes.end(),
                                  [](char c) { return static_cast<unsigned char>(c) >= 0xC0; });
  const auto ascii = std::count_if(bytes.begin(), bytes.end(), IsAsciiLetter);
  const double koi8 = Common(bytes, kKoi8), windows = Common(bytes, kWindows1251);
  // they make half of a Russian text; words of Latin letters have few letters above ASCII
  constexpr double kShare = 0.3;
  if (high > ascii && std::max(koi8, windows) > kShare * static_cast<double>(high)) {
    return koi8 > windows ? "KOI8-R" : "WINDOWS-1251";
  }
  return "Windows-1252";
}

}  // namespace moontrace

#include "lessons/documents/encoding.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>

#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

constexpr std::size_t kLookedAt = std::size_t{1} << 16U;
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
constexpr char32_t kReplacementCode = 0xFFFD;

enum class Order { kLittle, kBig };

/// Windows-1252's characters from 0x80 to 0x9F (WHATWG Encoding, index windows-1252); 0: none.
constexpr std::array<char32_t, 32> kWindows1252 = {
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

unsigned ByteAt(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

/// UTF-16 without a mark: text has mostly characters below U+0100, whose high byte is zero.
std::optional<Order> WideOrder(std::string_view bytes) {
  const std::size_t pairs = std::min(bytes.size(), kLookedAt) / 2;
  std::size_t even = 0, odd = 0;
  for (std::size_t i = 0; i < pairs; ++i) {
    even += bytes[2 * i] == 0 ? 1U : 0U;
    odd += bytes[2 * i + 1] == 0 ? 1U : 0U;
  }
  if (pairs == 0 || bytes.size() % 2 != 0) return std::nullopt;
  if (odd * 2 > pairs && even * 50 < pairs) return Order::kLittle;
  if (even * 2 > pairs && odd * 50 < pairs) return Order::kBig;
  return std::nullopt;
}

DecodedText FromUtf16(std::string_view bytes, Order order) {
  DecodedText decoded{{}, "UTF-16", bytes.size() % 2};
  decoded.text.reserve(bytes.size() / 2);
  const auto unit = [&](std::size_t i) {
    const unsigned first = ByteAt(bytes, 2 * i), second = ByteAt(bytes, 2 * i + 1);
    return static_cast<char32_t>(order == Order::kLittle ? first | second << 8U
                                                         : first << 8U | second);
  };
  const std::size_t units = bytes.size() / 2;
  for (std::size_t i = 0; i < units; ++i) {
    char32_t c = unit(i);
    const bool high = c >= 0xD800 && c < 0xDC00;
    if (high && i + 1 < units && (unit(i + 1) & 0xFC00U) == 0xDC00) {
      c = 0x10000 + ((c & 0x3FFU) << 10U) + (unit(++i) & 0x3FFU);
    } else if (c >= 0xD800 && c < 0xE000) {
      c = kReplacementCode;
      ++decoded.bad;
    }
    decoded.text += ToUtf8(c);
  }
  return decoded;
}

DecodedText FromWindows1252(std::string_view bytes) {
  DecodedText decoded{{}, "Windows-1252", 0};
  decoded.text.reserve(bytes.size() + bytes.size() / 8);
  for (const char byte : bytes) {
    const unsigned c = static_cast<unsigned char>(byte);
    if (c < 0x80) {
      decoded.text += byte;
    } else if (c >= 0xA0) {
      decoded.text += ToUtf8(c);
    } else if (kWindows1252[c - 0x80] != 0) {
      decoded.text += ToUtf8(kWindows1252[c - 0x80]);
    } else {
      decoded.text += kReplacement;
      ++decoded.bad;
    }
  }
  return decoded;
}

/// Broken places replaced; `wide` counts the characters of several bytes that are sound.
DecodedText FromUtf8(std::string_view bytes, std::size_t& wide) {
  DecodedText decoded{{}, "UTF-8", 0};
  decoded.text.reserve(bytes.size());
  bool broken = false;
  for (std::size_t at = 0; at < bytes.size();) {
    char32_t c = 0;
    const std::size_t length = Decode(bytes.substr(at, 4), c);
    if (length == 0) {
      if (!broken) {
        decoded.text += kReplacement;
        ++decoded.bad;
      }
      broken = true;
      ++at;
      continue;
    }
    broken = false;
    wide += length > 1 ? 1U : 0U;
    decoded.text.append(bytes.substr(at, length));
    at += length;
  }
  return decoded;
}

bool IsLabel(std::string_view label) {
  return !label.empty() && label.size() <= 40 &&
         std::all_of(label.begin(), label.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '-' || c == '_' || c == '.' || c == ':';
         });
}

/// By the C library; nothing for a label that it does not know.
std::optional<DecodedText> FromDeclared(std::string_view bytes, const std::string& label) {
  iconv_t convert = iconv_open("UTF-8", label.c_str());
  if (convert == reinterpret_cast<iconv_t>(-1)) return std::nullopt;  // NOLINT
  DecodedText decoded{{}, label, 0};
  std::string source(bytes);
  char* in = source.data();
  std::size_t left = source.size();
  std::array<char, 4096> block{};
  while (left > 0) {
    char* out = block.data();
    std::size_t room = block.size();
    const std::size_t result = iconv(convert, &in, &left, &out, &room);
    decoded.text.append(block.data(), block.size() - room);
    if (result != static_cast<std::size_t>(-1) || errno == E2BIG) continue;
    decoded.text += kReplacement;
    ++decoded.bad;
    if (errno == EINVAL || left == 0) break;  // it ends within a character
    ++in;
    --left;
  }
  iconv_close(convert);
  return decoded;
}

constexpr std::string_view kLittle32("\xFF\xFE\0\0", 4), kBig32("\0\0\xFE\xFF", 4);

DecodedText FromUtf32(std::string_view bytes, Order order) {
  DecodedText decoded{{}, "UTF-32", bytes.size() % 4 == 0 ? 0U : 1U};
  for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
    char32_t c = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      c = c << 8U | ByteAt(bytes, order == Order::kBig ? i + k : i + 3 - k);
    }
    if (c > 0x10FFFF || (c >= 0xD800 && c < 0xE000)) {
      c = kReplacementCode;
      ++decoded.bad;
    }
    decoded.text += ToUtf8(c);
  }
  return decoded;
}

DecodedText Guessed(std::string_view bytes) {
  const std::string label = GuessedEncoding(bytes);
  std::optional<DecodedText> decoded;
  if (label != "Windows-1252") decoded = FromDeclared(bytes, label);
  if (!decoded) decoded = FromWindows1252(bytes);
  decoded->guessed = true;
  return *decoded;
}

/// Labels that mean Windows-1252 on the web.
bool SaysLatin(const std::string& label) {
  static constexpr std::array<std::string_view, 7> kLabels = {
      "iso-8859-1", "latin1", "iso8859-1", "ascii", "us-ascii", "windows-1252", "cp1252"};
  return std::find(kLabels.begin(), kLabels.end(), label) != kLabels.end();
}

/// These, and those that add nothing to what is found here.
bool SaysNothing(const std::string& label) {
  return label == "utf-8" || label == "utf8" || label.rfind("utf-16", 0) == 0 || SaysLatin(label);
}

}  // namespace

DecodedText DecodeText(std::string_view bytes, std::string_view declared) {
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") bytes.remove_prefix(3);
  if (bytes.substr(0, 4) == kLittle32) return FromUtf32(bytes.substr(4), Order::kLittle);
  if (bytes.substr(0, 4) == kBig32) return FromUtf32(bytes.substr(4), Order::kBig);
  if (bytes.substr(0, 2) == "\xFF\xFE") return FromUtf16(bytes.substr(2), Order::kLittle);
  if (bytes.substr(0, 2) == "\xFE\xFF") return FromUtf16(bytes.substr(2), Order::kBig);
  if (const std::optional<Order> order = WideOrder(bytes)) return FromUtf16(bytes, *order);
  const std::string label = LowerCase(declared);
  const bool foreign = IsLabel(label) && !SaysNothing(label);
  const bool valid = !FirstBadUtf8(bytes);
  if (foreign && (!valid || label.rfind("iso-2022", 0) == 0)) {
    if (std::optional<DecodedText> decoded = FromDeclared(bytes, label)) return *decoded;
  }
  if (valid) return {std::string(bytes), "UTF-8", 0};
  std::size_t wide = 0;
  DecodedText decoded = FromUtf8(bytes, wide);
  // In Latin-1 hardly any two letters above ASCII follow each other as UTF-8 demands.
  if (wide > decoded.bad) return decoded;
  if (SaysLatin(label)) return FromWindows1252(bytes);
  return Guessed(bytes);
}

bool IsBinary(std::string_view bytes) {
  if (bytes.substr(0, 2) == "\xFF\xFE" || bytes.substr(0, 2) == "\xFE\xFF" ||
      bytes.substr(0, 4) == kBig32 || WideOrder(bytes)) {
    return false;
  }
  if (bytes.find('\0') != std::string_view::npos) return true;
  const std::string_view seen = bytes.substr(0, kLookedAt);
  const auto controls = std::count_if(seen.begin(), seen.end(), [](char c) {
    const bool blank = c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\x1b';
    return (c >= 0 && c < ' ' && !blank) || c == '\x7f';
  });
  return static_cast<std::size_t>(controls) * 10 > seen.size();
}

}  // namespace moontrace

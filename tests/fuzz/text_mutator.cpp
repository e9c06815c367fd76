// How libFuzzer changes what targets of text are given: number by number, word by word, line by
// line, and by whole bracketed, quoted and XML parts, from the input itself or from another one. So
// most of what it makes is still JSON, XML, TOML, a path or a row, and comes past the parser to the
// reader behind it. One change in five is libFuzzer's own, of bytes.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

enum class Kind { kNumber, kWord, kQuoted, kItem, kLine, kElement };
constexpr int kKinds = 6;

/// Part of a text, [begin, end).
struct Span {
  Kind kind = Kind::kWord;
  std::size_t begin = 0, end = 0;
};

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80) != 0;
}

/// Numbers and words, wherever they stand.
void FindTokens(std::string_view text, std::vector<Span>& spans) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = i;
    const bool sign = text[i] == '-' || text[i] == '+' || text[i] == '.';
    if (IsDigit(text[i]) || (sign && i + 1 < text.size() && IsDigit(text[i + 1]))) {
      for (++i; i < text.size() && (IsDigit(text[i]) || text[i] == '.' || text[i] == 'e'); ++i) {
      }
      spans.push_back({Kind::kNumber, begin, i});
    } else if (IsLetter(text[i])) {
      while (i < text.size() && (IsLetter(text[i]) || IsDigit(text[i]) || text[i] == '-')) ++i;
      spans.push_back({Kind::kWord, begin, i});
    } else {
      ++i;
    }
  }
}

void FindLines(std::string_view text, std::vector<Span>& spans) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    spans.push_back({Kind::kLine, begin, end});
    begin = end;
  }
}

/// Quoted texts without their quotes, and the items between brackets and commas.
void FindItems(std::string_view text, std::vector<Span>& spans) {
  std::vector<std::size_t> open;  // where an item begins, bracket in bracket
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = text.find(c, i + 1);
      if (end == std::string_view::npos) continue;
      spans.push_back({Kind::kQuoted, i + 1, end});
      i = end;
    } else if (c == '{' || c == '[' || c == '(') {
      open.push_back(i + 1);
    } else if (!open.empty() && (c == ',' || c == '}' || c == ']' || c == ')')) {
      if (i > open.back()) spans.push_back({Kind::kItem, open.back(), i});
      open.back() = i + 1;
      if (c != ',') open.pop_back();
    }
  }
}

/// XML's, from "<a" to "</a>" or "/>".
void FindElements(std::string_view text, std::vector<Span>& spans) {
  std::vector<std::size_t> open;
  for (std::size_t i = text.find('<'); i != std::string_view::npos; i = text.find('<', i + 1)) {
    const std::size_t end = text.find('>', i);
    if (end == std::string_view::npos) return;
    if (text[end - 1] == '/') {
      spans.push_back({Kind::kElement, i, end + 1});
    } else if (text[i + 1] == '/' && !open.empty()) {
      spans.push_back({Kind::kElement, open.back(), end + 1});
      open.pop_back();
    } else if (IsLetter(text[i + 1])) {
      open.push_back(i);
    }
  }
}

std::vector<Span> SpansOf(std::string_view text) {
  std::vector<Span> spans;
  FindTokens(text, spans);
  FindLines(text, spans);
  FindItems(text, spans);
  FindElements(text, spans);
  return spans;
}

class Mutator {
 public:
  Mutator(std::string text, unsigned seed) : text_(std::move(text)), draw_(seed) {
    spans_ = SpansOf(text_);
  }

  /// One change; what takes its place comes from `other`, which may be the text itself.
  std::string Changed(const std::string& other) {
    const std::vector<Span> same = Of(spans_, static_cast<Kind>(Below(kKinds)));
    if (same.empty()) return Bytes(0, text_.size());
    const Span span = same[Below(same.size())];
    switch (Below(6)) {
      case 0:
        return span.kind == Kind::kItem ? WithoutItem(span) : With(span, "");
      case 1:
        return Doubled(span);
      case 2:
        return span.kind == Kind::kNumber ? With(span, Number(span)) : Bytes(span.begin, span.end);
      default:
        break;
    }
    if (span.kind == Kind::kNumber && Below(2) == 0) return With(span, Number(span));
    const std::vector<Span> foreign = Of(SpansOf(other), span.kind);
    if (foreign.empty()) return Doubled(span);
    const Span from = foreign[Below(foreign.size())];
    return With(span, other.substr(from.begin, from.end - from.begin));
  }

  std::size_t Below(std::size_t count) { return draw_() % count; }
  /// Without a hint of where: libFuzzer's own change of some bytes of the text.
  std::string Bytes(std::size_t begin, std::size_t end) {
    std::string part = text_.substr(begin, end - begin);
    const std::size_t size = part.size();
    part.resize(2 * size + 8);
    part.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(part.data()), size, part.size()));
    return With({Kind::kWord, begin, end}, part);
  }

 private:
  static std::vector<Span> Of(const std::vector<Span>& spans, Kind kind) {
    std::vector<Span> of;
    std::copy_if(spans.begin(), spans.end(), std::back_inserter(of),
                 [kind](const Span& span) { return span.kind == kind; });
    return of;
  }
  std::string With(const Span& span, const std::string& part) const {
    return text_.substr(0, span.begin) + part + text_.substr(span.end);
  }
  /// One of the commas around it goes too.
  std::string WithoutItem(Span span) const {
    if (span.end < text_.size() && text_[span.end] == ',') {
      ++span.end;
    } else if (span.begin > 0 && text_[span.begin - 1] == ',') {
      --span.begin;
    }
    return With(span, "");
  }
  std::string Doubled(const Span& span) {
    const std::string part = text_.substr(span.begin, span.end - span.begin);
    std::string doubled = part;
    const bool often = Below(16) == 0;
    for (std::size_t i = 0, count = often ? 100 : 1; i < count; ++i) {
      doubled += (span.kind == Kind::kItem ? "," : span.kind == Kind::kWord ? " " : "") + part;
    }
    return With(span, doubled);
  }
  /// Those at which readers go wrong, and neighbours of the one that stands there.
  std::string Number(const Span& span) {
    static constexpr std::array<const char*, 28> kEdges = {
        "0",     "-0",    "1",      "-1",    "2",          "0.5",         "1e-9",
        "1e-20", "1e-99", "1e-320", "100",   "1000",       "65535",       "65536",
        "1e5",   "1e9",   "1e20",   "1e99",  "1.8e308",    "2147483647",  "2147483648",
        "nan",   "inf",   "-inf",   "1e999", "4294967296", "-2147483649", "18446744073709551616"};
    const std::string was = text_.substr(span.begin, span.end - span.begin);
    switch (Below(5)) {
      case 0:
        return "-" + was;
      case 1:
        return was + std::to_string(Below(10));
      case 2: {
        std::string digit = was;
        digit[Below(digit.size())] = static_cast<char>('0' + Below(10));
        return digit;
      }
      default:
        return kEdges[Below(kEdges.size())];
    }
  }

  std::string text_;
  std::minstd_rand draw_;
  std::vector<Span> spans_;
};

std::size_t Give(const std::string& text, std::uint8_t* out, std::size_t most) {
  const std::size_t size = std::min(text.size(), most);
  std::memcpy(out, text.data(), size);
  return size;
}

std::string TextOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  const std::string text = TextOf(data, size);
  Mutator mutator(text, seed);
  if (mutator.Below(5) == 0) return LLVMFuzzerMutate(data, size, most);
  return Give(mutator.Changed(text), data, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size,
                                                 const std::uint8_t* other, std::size_t other_size,
                                                 std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  Mutator mutator(TextOf(one, one_size), seed);
  return Give(mutator.Changed(TextOf(other, other_size)), out, most);
}

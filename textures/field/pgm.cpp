#include "textures/field/pgm.h"

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostBytes = 100'000'000;
constexpr std::uint32_t kMostSide = 4096, kMostGrey = 65535;

constexpr const char* kSmaller = "make the picture smaller";
constexpr const char* kWhiter = "raise the greatest value before the heights";

bool IsSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Walks through the bytes of a picture.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  [[noreturn]] void Fail(const std::string& problem) const {
    std::size_t line = 1;
    for (std::size_t i = 0; i < at_ && i < bytes_.size(); ++i) line += bytes_[i] == '\n' ? 1 : 0;
    throw InputError(fmt::format("{}:{}: {}", name_, line, problem));
  }

  /// The next number, behind spaces and comments, at most `most`; `cure` for one above.
  std::uint32_t Number(const char* what, std::uint32_t most, const char* cure) {
    SkipSpaces();
    if (at_ == bytes_.size()) {
      Fail(fmt::format("the picture ends before its {}: save it again", what));
    }
    std::uint32_t value = 0;
    const std::size_t begin = at_;
    for (; at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_) {
      value = 10 * value + static_cast<std::uint32_t>(bytes_[at_] - '0');
      if (value > most) Fail(fmt::format("{} above {}: {}", what, most, cure));
    }
    if (at_ == begin) Fail(fmt::format("{} is not a whole number: write one", what));
    return value;
  }

  /// One byte, the white space that ends a binary picture's head.
  void SkipOne() {
    if (at_ == bytes_.size() || !IsSpace(bytes_[at_]))
      Fail("no space between head and heights: write one");
    ++at_;
  }

  std::string_view Rest() const { return bytes_.substr(at_); }

 private:
  void SkipSpaces() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      } else if (IsSpace(bytes_[at_])) {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 2;  // behind the magic number
};

}  // namespace

SampledHeights ParsePgm(std::string_view bytes, const std::string& name) {
  const bool plain = bytes.substr(0, 2) == "P2", binary = bytes.substr(0, 2) == "P5";
  if (!plain && !binary) {
    throw InputError(name + ": not a PGM picture: give one that begins with P2 or P5");
  }
  Reader reader(bytes, name);
  const std::uint32_t columns = reader.Number("width", kMostSide, kSmaller);
  const std::uint32_t rows = reader.Number("height", kMostSide, kSmaller);
  const std::uint32_t white =
      reader.Number("greatest value", kMostGrey, "save it with 8 or 16 bits");
  if (columns < 2 || rows < 2) reader.Fail("a side of less than 2 samples: give more");
  if (white == 0) reader.Fail("a greatest value of 0: write 255, say");
  const std::size_t width = white > 255 ? 2 : 1;  // [bytes]
  std::size_t at = 0;
  std::string_view heights_bytes;
  if (binary) {
    reader.SkipOne();
    heights_bytes = reader.Rest();
    if (heights_bytes.size() < width * columns * rows) {
      reader.Fail(fmt::format("cut off: {} bytes of heights, {} x {} need {}: save it again",
                              heights_bytes.size(), columns, rows, width * columns * rows));
    }
  } else if (reader.Rest().size() / 2 + 1 < std::size_t{columns} * rows) {
    reader.Fail(
        fmt::format("cut off: too short for {} x {} heights: save it again", columns, rows));
  }
  const auto next = [&] {
    if (!binary) return reader.Number("height value", white, kWhiter);
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < width; ++i) {
      value = 256 * value + static_cast<unsigned char>(heights_bytes[at++]);
    }
    if (value > white) reader.Fail(fmt::format("height value above {}: {}", white, kWhiter));
    return value;
  };
  std::vector<float> heights(std::size_t{columns} * rows);
  // the picture begins at the top, the array at the bottom
  for (std::size_t row = rows; row-- > 0;) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double grey = static_cast<double>(next()) / white;
      heights[row * columns + column] = static_cast<float>(2 * grey - 1);
    }
  }
  return SampledHeights(columns, rows, std::move(heights));
}

SampledHeights ReadPgm(const std::string& path) {
  return ParsePgm(ReadTextFile(path, kMostBytes), path);
}

}  // namespace moontrace

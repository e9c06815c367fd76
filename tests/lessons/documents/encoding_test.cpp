#include "lessons/documents/encoding.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

// "Grüße €" by hand in each encoding.
const std::string kUtf8 =
    "Gr\xC3\xBC\xC3\x9F"
    "e \xE2\x82\xAC";

std::string Wide(bool little) {
  std::string bytes;
  for (const unsigned unit : {0x47U, 0x72U, 0xFCU, 0xDFU, 0x65U, 0x20U, 0x20ACU}) {
    const char low = static_cast<char>(unit & 0xFFU), high = static_cast<char>(unit >> 8U);
    bytes += little ? low : high;
    bytes += little ? high : low;
  }
  return bytes;
}

TEST(DecodeText, KnowsTheEncodingByItsMark) {
  for (const std::string& bytes :
       {"\xEF\xBB\xBF" + kUtf8, "\xFF\xFE" + Wide(true), "\xFE\xFF" + Wide(false)}) {
    EXPECT_EQ(DecodeText(bytes).text, kUtf8);
    EXPECT_EQ(DecodeText(bytes).bad, 0U);
  }
}

TEST(DecodeText, KnowsTheEncodingWithoutAMark) {
  EXPECT_EQ(DecodeText(kUtf8).encoding, "UTF-8");
  EXPECT_EQ(DecodeText(kUtf8).text, kUtf8);
  for (const bool little : {true, false}) {
    const DecodedText wide = DecodeText(Wide(little));
    EXPECT_EQ(wide.encoding, "UTF-16");
    EXPECT_EQ(wide.text, kUtf8);
  }
  const DecodedText narrow = DecodeText(
      "Gr\xFC\xDF"
      "e \x80");
  EXPECT_EQ(narrow.encoding, "Windows-1252");
  EXPECT_EQ(narrow.text, kUtf8);
}

TEST(DecodeText, TakesTheDeclaredEncodingWhereBytesAreNotUtf8) {
  // KOI8-R (RFC 1489): "Мир"; Shift_JIS: "日本".
  EXPECT_EQ(DecodeText("\xED\xC9\xD2", "koi8-r").text, "\xD0\x9C\xD0\xB8\xD1\x80");
  EXPECT_EQ(DecodeText("\x93\xFA\x96\x7B", "Shift_JIS").text, "\xE6\x97\xA5\xE6\x9C\xAC");
  EXPECT_EQ(DecodeText(kUtf8, "iso-8859-1").text, kUtf8) << "a wrong declaration";
  EXPECT_EQ(DecodeText("Gr\xFC\xDF"
                       "e",
                       "no-such-encoding")
                .encoding,
            "Windows-1252");
  EXPECT_EQ(DecodeText("Gr\xFC\xDF"
                       "e",
                       "UTF-8//IGNORE")
                .encoding,
            "Windows-1252");
}

// By `iconv -t` of GNU libc: "Мороз и солнце; день чудесный!" and "これは本です".
TEST(DecodeText, GuessesCyrillicAndJapaneseAndSaysSo) {
  const std::string pushkin = "Мороз и солнце; день чудесный!";
  const DecodedText koi8 = DecodeText(
      "\xed\xcf\xd2\xcf\xda \xc9 \xd3\xcf\xcc\xce\xc3\xc5; \xc4\xc5\xce\xd8 "
      "\xde\xd5\xc4\xc5\xd3\xce\xd9\xca!");
  EXPECT_EQ(koi8.text, pushkin);
  EXPECT_TRUE(koi8.guessed);
  const DecodedText windows = DecodeText(
      "\xcc\xee\xf0\xee\xe7 \xe8 \xf1\xee\xeb\xed\xf6\xe5; \xe4\xe5\xed\xfc "
      "\xf7\xf3\xe4\xe5\xf1\xed\xfb\xe9!");
  EXPECT_EQ(windows.text, pushkin);
  EXPECT_TRUE(windows.guessed);
  const DecodedText japanese = DecodeText("\x82\xb1\x82\xea\x82\xcd\x96\x7b\x82\xc5\x82\xb7");
  EXPECT_EQ(japanese.text, "これは本です");
  EXPECT_TRUE(japanese.guessed);
  EXPECT_TRUE(DecodeText("Gr\xFC\xDF"
                         "e")
                  .guessed);
  EXPECT_FALSE(DecodeText("Gr\xFC\xDF"
                          "e",
                          "iso-8859-1")
                   .guessed);
  EXPECT_FALSE(DecodeText(kUtf8).guessed);
}

TEST(DecodeText, KnowsUtf32ByItsMark) {
  const std::string little("\xFF\xFE\0\0G\0\0\0\xFC\0\0\0\x02\xF6\x01\0", 16);
  const std::string big("\0\0\xFE\xFF\0\0\0G\0\0\0\xFC\0\x01\xF6\x02", 16);
  for (const std::string& bytes : {little, big}) {
    EXPECT_FALSE(IsBinary(bytes));
    const DecodedText decoded = DecodeText(bytes);
    EXPECT_EQ(decoded.encoding, "UTF-32");
    EXPECT_EQ(decoded.text, "Gü😂");
    EXPECT_EQ(decoded.bad, 0U);
  }
  EXPECT_EQ(DecodeText(little + std::string("\0\xD8\0\0x", 5)).bad, 2U);
}

TEST(DecodeText, CountsWhatIsNoCharacter) {
  const DecodedText broken = DecodeText(kUtf8 + kUtf8 + "\xFF");
  EXPECT_EQ(broken.encoding, "UTF-8");
  EXPECT_EQ(broken.text, kUtf8 + kUtf8 + "\xEF\xBF\xBD");
  EXPECT_EQ(broken.bad, 1U);
  // A high surrogate alone (Unicode 3.9, D91).
  const DecodedText alone =
      DecodeText(std::string("\xFF\xFE"
                             "a\0\x00\xD8"
                             "b\0",
                             8));
  EXPECT_EQ(alone.text,
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(alone.bad, 1U);
}

TEST(IsBinary, TellsTextFromOtherBytes) {
  EXPECT_FALSE(IsBinary(kUtf8));
  EXPECT_FALSE(IsBinary(Wide(true)));
  EXPECT_FALSE(IsBinary("\xFF\xFE" + Wide(true)));
  EXPECT_TRUE(IsBinary(std::string("abc\0def", 7)));
  EXPECT_TRUE(IsBinary("\x01\x02\x03\x04 text"));
  EXPECT_FALSE(IsBinary(""));
}

}  // namespace
}  // namespace moontrace

#include "sim/console/line_buffer.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(LineBuffer, CutsBytesIntoLinesHoweverTheyCome) {
  const std::string text = "one\r\n\ntwo three\n";
  for (std::size_t part = 1; part <= text.size(); ++part) {
    LineBuffer lines(9);
    for (std::size_t at = 0; at < text.size(); at += part) lines.Feed(text.substr(at, part));
    EXPECT_FALSE(lines.empty());
    EXPECT_EQ(lines.Next(), "one");
    EXPECT_EQ(lines.Next(), "");
    EXPECT_EQ(lines.Next(), "two three");
    EXPECT_EQ(lines.Next(), std::nullopt);
    EXPECT_TRUE(lines.empty());
    EXPECT_FALSE(lines.TakeDropped());
  }
}

TEST(LineBuffer, KeepsAnUnfinishedLine) {
  LineBuffer lines(9);
  lines.Feed("ab");
  EXPECT_EQ(lines.Next(), std::nullopt);
  lines.Feed("c\nd");
  EXPECT_EQ(lines.Next(), "abc");
  EXPECT_EQ(lines.Next(), std::nullopt);
}

TEST(LineBuffer, DropsLinesThatAreTooLongWholeAndTellsOnce) {
  const std::string text = "ab\n" + std::string(10, 'x') + "\ncd\n";
  for (std::size_t part = 1; part <= text.size(); ++part) {
    LineBuffer lines(9);
    for (std::size_t at = 0; at < text.size(); at += part) lines.Feed(text.substr(at, part));
    EXPECT_EQ(lines.Next(), "ab");
    EXPECT_EQ(lines.Next(), "cd");
    EXPECT_TRUE(lines.TakeDropped());
    EXPECT_FALSE(lines.TakeDropped());
  }
}

}  // namespace
}  // namespace moontrace

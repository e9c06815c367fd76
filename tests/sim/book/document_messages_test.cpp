#include "sim/book/document_messages.h"

#include <gtest/gtest.h>

#include "sim/book/book_messages.h"

namespace moontrace {
namespace {

TEST(DocumentMessages, AGroupOfTheContentsIsNotSaidToBeBroken) {
  EXPECT_EQ(say::ContentsLine({"Part", 1, 4, true}), "Level 1: Part");
  EXPECT_EQ(say::ContentsLine({"Empty", 1, kNoBlock, true}), "Level 1: Empty");
  EXPECT_EQ(say::ContentsLine({"Gone", 1, kNoBlock, false}), "Level 1: Gone (leads nowhere)");
  EXPECT_EQ(say::NumberedContents(2, {"Part", 1, 4, true}, 2), "2: Part, page 3.");
  EXPECT_EQ(say::NumberedContents(2, {"Empty", 1, kNoBlock, true}, 0),
            "2: Empty, without a place.");
}

}  // namespace
}  // namespace moontrace

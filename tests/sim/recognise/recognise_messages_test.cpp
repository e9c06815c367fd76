#include "sim/recognise/recognise_messages.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

// A speech synthesizer says nothing at U+FFFD.
TEST(RecogniseMessages, WhatIsNotKnownIsSpoken) {
  EXPECT_EQ(say::Spoken("mo\xEF\xBF\xBDn"), "mo(unknown)n");
  EXPECT_EQ(say::Spoken("\xEF\xBF\xBD\xEF\xBF\xBD"), "(unknown)(unknown)");
  EXPECT_EQ(say::Spoken("moon"), "moon");
}

}  // namespace
}  // namespace moontrace

#include "textures/base/digest.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

// Expected values: the test vectors that the algorithm's authors publish (test_fnv.c).
TEST(Digest, AgreesWithThePublishedVectors) {
  EXPECT_EQ(DigestOf(""), 0xcbf29ce484222325U);
  EXPECT_EQ(DigestOf("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(DigestOf("foobar"), 0x85944171f73967e8U);
}

TEST(Digest, DoesNotDependOnHowTheBytesAreCut) {
  Digest digest;
  digest.Add("foo");
  digest.Add("");
  digest.Add("bar");
  EXPECT_EQ(digest.value(), DigestOf("foobar"));
}

TEST(Digest, TakesAWordByItsLeastByteFirst) {
  Digest word, bytes;
  word.Add(std::uint64_t{0x6665646362613938U});
  bytes.Add("89abcdef");
  EXPECT_EQ(word.value(), bytes.value());
}

TEST(Digest, TakesANumberByItsBits) {
  Digest number, word;
  number.Add(-2.0);
  word.Add(std::uint64_t{0xc000000000000000U});  // IEEE 754: sign, exponent 1024, fraction 0
  EXPECT_EQ(number.value(), word.value());
}

TEST(Digest, ChangesWithEveryBit) {
  const std::string text(100, 'x');
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string other = text;
    other[bit / 8] = static_cast<char>(other[bit / 8] ^ (1 << bit % 8));
    EXPECT_NE(DigestOf(other), DigestOf(text)) << "bit " << bit;
  }
}

TEST(DigestHex, GoesThereAndBack) {
  EXPECT_EQ(ToHex(0x0123456789abcdefU), "0x0123456789abcdef");
  EXPECT_EQ(FromHex("0x0123456789abcdef"), 0x0123456789abcdefU);
  EXPECT_EQ(FromHex(ToHex(0)), 0U);
}

TEST(DigestHex, RefusesWhatToHexNeverWrites) {
  for (const char* text :
       {"", "0x", "0123456789abcdef01", "0x0123456789abcde", "0x0123456789ABCDEF",
        "0x0123456789abcdeg", "0x0123456789abcdef0", "0x-123456789abcdef"}) {
    EXPECT_FALSE(FromHex(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace moontrace

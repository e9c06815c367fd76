#include "devices/hid/hid_bits.h"

#include <gtest/gtest.h>

#include <array>

namespace moontrace {
namespace {

TEST(HidBits, ReadsLeastBitFirstAcrossBytes) {
  // Bits 5 to 14 of 0xab40, low byte first: 0b01'0101'1010 = 346.
  const std::array<std::uint8_t, 2> report{0x40, 0xab};
  EXPECT_EQ(ReadBits(report, {5, 10, 0, 1023}), (0xab40 >> 5) & 1023);
}

TEST(HidBits, IsSignedWhereTheRangeIs) {
  const std::array<std::uint8_t, 3> report{1, 0x01, 0x80};
  EXPECT_EQ(ReadBits(report, {8, 16, -32767, 32767}), -32767);
  EXPECT_EQ(ReadBits(report, {8, 16, 0, 65535}), 0x8001);
}

TEST(HidBits, WritesOnlyItsOwnBits) {
  std::array<std::uint8_t, 2> report{0xff, 0xff};
  WriteBits(report, {6, 4, 0, 15}, 0);
  EXPECT_EQ(report, (std::array<std::uint8_t, 2>{0x3f, 0xfc}));
}

TEST(HidBits, HoldsNumbersWithinTheirSize) {
  std::array<std::uint8_t, 4> report{};
  WriteBits(report, {0, 8, -128, 127}, 1000);
  WriteBits(report, {8, 8, -128, 127}, -1000);
  WriteBits(report, {16, 8, 0, 255}, -5);
  EXPECT_EQ(report, (std::array<std::uint8_t, 4>{0x7f, 0x80, 0, 0}));
}

TEST(HidBits, IgnoresWhatLiesBeyondTheReport) {
  std::array<std::uint8_t, 2> report{0, 0};
  WriteBits(report, {12, 32, 0, 0xffffffff}, 0xffffffff);
  EXPECT_EQ(report, (std::array<std::uint8_t, 2>{0, 0xf0}));
  EXPECT_EQ(ReadBits(report, {12, 32, 0, 0xffffffff}), 0xf);
}

TEST(HidBits, IsNothingWithoutASize) {
  std::array<std::uint8_t, 1> report{0x55};
  WriteBits(report, {}, 0xff);
  EXPECT_EQ(report[0], 0x55);
  EXPECT_EQ(ReadBits(report, {}), 0);
}

}  // namespace
}  // namespace moontrace

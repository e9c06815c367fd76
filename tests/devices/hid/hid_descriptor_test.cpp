#include "devices/hid/hid_descriptor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "devices/core/device_error.h"
#include "tests/devices/fake/descriptor_writer.h"
#include "tests/devices/fake/pid_descriptors.h"
#include "tests/source_path.h"
#include "textures/base/random.h"

namespace moontrace {
namespace {

using Bytes = std::vector<std::uint8_t>;
using W = fake::DescriptorWriter;

Bytes ThreeAxes() {
  std::ifstream file(SourcePath("tests/data/hid/three_axes.hex"));
  Bytes bytes;
  for (std::string word; file >> word;) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(word, nullptr, 16)));
  }
  return bytes;
}

std::size_t LengthOf(const HidDescriptor& descriptor, HidReportType type, std::uint8_t id) {
  const auto* report = descriptor.Find(type, id);
  return report != nullptr ? report->bytes : 0;
}

const HidField* FieldOf(const HidDescriptor& descriptor, HidReportType type, std::uint8_t id,
                        HidUsage usage) {
  const auto* report = descriptor.Find(type, id);
  if (report == nullptr) return nullptr;
  for (const HidField& field : report->fields) {
    if (std::find(field.usages.begin(), field.usages.end(), usage) != field.usages.end()) {
      return &field;
    }
  }
  return nullptr;
}

void ExpectRefused(const Bytes& bytes, const std::string& what) {
  try {
    ParseHidDescriptor(bytes);
    FAIL() << "taken: " << what;
  } catch (const DeviceError& error) {
    const std::string line = error.what();
    EXPECT_NE(line.find(what), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

// Lengths by the table of the reference (mujoco-and-hid.md, 2.3), which was read from the board's
// own descriptor.
TEST(HidDescriptor, HasTheReportLengthsOfOpenFfBoard) {
  const auto d = ParseHidDescriptor(fake::OpenFfBoardDescriptor());
  using T = HidReportType;
  EXPECT_TRUE(d.is_numbered);
  EXPECT_EQ(LengthOf(d, T::kInput, 0x01), 25u);
  EXPECT_EQ(LengthOf(d, T::kInput, 0x02), 2u);
  EXPECT_EQ(LengthOf(d, T::kInput, 0xa1), 25u);
  EXPECT_EQ(LengthOf(d, T::kOutput, 0x01), 22u);
  EXPECT_EQ(LengthOf(d, T::kOutput, 0x05), 4u);
  EXPECT_EQ(LengthOf(d, T::kOutput, 0x0a), 4u);
  EXPECT_EQ(LengthOf(d, T::kOutput, 0x0b), 2u);
  EXPECT_EQ(LengthOf(d, T::kOutput, 0x0c), 2u);
  EXPECT_EQ(LengthOf(d, T::kOutput, 0x0d), 2u);
  EXPECT_EQ(LengthOf(d, T::kFeature, 0x11), 4u);
  EXPECT_EQ(LengthOf(d, T::kFeature, 0x12), 5u);
  EXPECT_EQ(LengthOf(d, T::kFeature, 0x13), 5u);
}

// The same number serves the state as input and the envelope as output.
TEST(HidDescriptor, KeepsReportNumbersApartByType) {
  const auto d = ParseHidDescriptor(fake::OpenFfBoardDescriptor());
  EXPECT_EQ(LengthOf(d, HidReportType::kInput, 2), 2u);
  EXPECT_EQ(LengthOf(d, HidReportType::kOutput, 2), 10u);
  EXPECT_EQ(d.Find(HidReportType::kFeature, 2), nullptr);
}

TEST(HidDescriptor, ReadsTheThreeAxesOfTheReference) {
  const auto d = ParseHidDescriptor(ThreeAxes());
  ASSERT_EQ(d.applications.size(), 1u);
  EXPECT_EQ(d.applications[0], 0x010004u);
  EXPECT_EQ(LengthOf(d, HidReportType::kInput, 1), 9u);
  EXPECT_EQ(LengthOf(d, HidReportType::kOutput, 1), 11u);
  EXPECT_EQ(LengthOf(d, HidReportType::kFeature, 0x12), 5u);
  const auto* z = FieldOf(d, HidReportType::kInput, 1, 0x010032);
  ASSERT_NE(z, nullptr);
  EXPECT_TRUE(z->is_variable);
  EXPECT_EQ(z->At(2).bit, 8u + 32u);  // after the number, X and Y
  EXPECT_EQ(z->At(2).least, -32767);
  EXPECT_EQ(z->At(2).most, 32767);
}

TEST(HidDescriptor, TellsArraysFromBits) {
  const auto board = ParseHidDescriptor(fake::OpenFfBoardDescriptor());
  const auto rhino = ParseHidDescriptor(fake::RhinoDescriptor());
  const auto* bits = FieldOf(board, HidReportType::kOutput, 0x0c, 0x0f0098);
  const auto* number = FieldOf(rhino, HidReportType::kOutput, 112, 0x0f0098);
  ASSERT_NE(bits, nullptr);
  ASSERT_NE(number, nullptr);
  EXPECT_TRUE(bits->is_variable);
  EXPECT_EQ(bits->count, 6u);
  EXPECT_EQ(bits->first.size, 1);
  EXPECT_FALSE(number->is_variable);
  EXPECT_EQ(number->first.size, 8);
  EXPECT_EQ(number->first.least, 1);
}

TEST(HidDescriptor, SpreadsUsageRangesOverTheNumbers) {
  const auto d = ParseHidDescriptor(fake::OpenFfBoardDescriptor());
  const auto* report = d.Find(HidReportType::kInput, 1);
  ASSERT_NE(report, nullptr);
  const HidField& buttons = report->fields.front();
  ASSERT_EQ(buttons.usages.size(), 64u);
  EXPECT_EQ(buttons.usages[63], 0x090040u);
  EXPECT_EQ(buttons.At(63).bit, 8u + 63u);
}

// HID 1.11, 6.2.2.7: push keeps the global items, pop brings them back.
TEST(HidDescriptor, PushesAndPopsGlobals) {
  const Bytes bytes = {0x05, 1, 0x09, 4,    0xa1, 1, 0x75, 8,    0x95, 1,    0xa4, 0x75, 16,
                       0x95, 3, 0x09, 0x30, 0x81, 2, 0xb4, 0x09, 0x31, 0x81, 2,    0xc0};
  const auto d = ParseHidDescriptor(bytes);
  ASSERT_EQ(d.reports.size(), 1u);
  EXPECT_FALSE(d.is_numbered);
  EXPECT_EQ(d.reports[0].bytes, 1u + 6u + 1u);
  EXPECT_EQ(d.reports[0].fields[1].first.size, 8);
}

// 6.2.2.3: tag 1111 with a length of its own, and what it holds says nothing.
TEST(HidDescriptor, SkipsLongItems) {
  Bytes bytes = {0x05, 1, 0x09, 4, 0xa1, 1, 0xfe, 3, 0xf0, 0xc0, 0xc0, 0xc0, 0xc0};
  const auto d = ParseHidDescriptor(bytes);
  EXPECT_EQ(d.applications.size(), 1u);
}

TEST(HidDescriptor, TakesTheFirstOfDelimitedUsages) {
  const Bytes bytes = {0x05, 1,    0x09, 4,    0xa1, 1,    0xa9, 1,    0x09, 0x30, 0x09,
                       0x31, 0xa9, 0,    0x75, 8,    0x95, 1,    0x81, 2,    0xc0};
  const auto d = ParseHidDescriptor(bytes);
  EXPECT_EQ(d.reports.at(0).fields.at(0).usages, std::vector<HidUsage>{0x010030});
}

// 6.2.2.8: the page that stands at the main item completes a short usage.
TEST(HidDescriptor, CompletesUsagesByThePageAtTheMainItem) {
  const Bytes bytes = {0x05, 1,    0x09, 4,    0xa1, 1,    0x09, 1,   0x05,
                       9,    0x75, 8,    0x95, 1,    0x81, 2,    0xc0};
  const auto d = ParseHidDescriptor(bytes);
  EXPECT_EQ(d.reports.at(0).fields.at(0).usages, std::vector<HidUsage>{0x090001});
}

TEST(HidDescriptor, ReadsAMostOfAllOnesAsUnsignedWhereTheLeastIsZero) {
  const Bytes bytes = {0x05, 1, 0x09, 4, 0xa1, 1,    0x15, 0, 0x25, 0xff,
                       0x75, 8, 0x95, 1, 0x09, 0x30, 0x81, 2, 0xc0};
  EXPECT_EQ(ParseHidDescriptor(bytes).reports.at(0).fields.at(0).first.most, 255);
}

TEST(HidDescriptor, RefusesWhatNoKernelWouldTake) {
  ExpectRefused({}, "is empty");
  ExpectRefused({0x05}, "cut off");
  ExpectRefused({0xfe, 200, 0}, "long item");
  ExpectRefused({0x05, 1, 0xa1, 1}, "inside a collection");
  ExpectRefused({0xc0}, "never began");
  ExpectRefused({0xb4}, "never pushed");
  ExpectRefused({0x85, 0}, "not 1 to 255");
  ExpectRefused(Bytes(40, 0xa0), "too deeply");
  ExpectRefused(Bytes(40, 0xa4), "too often");
  ExpectRefused({0x76, 0x01, 0x01, 0x95, 1, 0x81, 2}, "256 bits");
  ExpectRefused({0x75, 32, 0x97, 0xff, 0xff, 0xff, 0xff, 0x81, 2}, "longer than 4096 bytes");
  ExpectRefused(Bytes(5000, 0xc0), "longer than 4096 bytes");
}

// 4 bytes a round, a thousand rounds of a range of 65536 usages: bounded, whatever it says.
TEST(HidDescriptor, BoundsUsageRanges) {
  Bytes bytes = {0x06, 0x00, 0xff};
  for (int i = 0; i < 300; ++i) {
    const Bytes round = {0x19, 0, 0x2a, 0xff, 0xff, 0x75, 1, 0x95, 1, 0x81, 0};
    bytes.insert(bytes.end(), round.begin(), round.end());
  }
  ExpectRefused(bytes, "too many usages: it is no force-feedback device");
}

/// All fields lie within their report, whatever was read.
void ExpectSound(const HidDescriptor& descriptor) {
  for (const HidReportLayout& report : descriptor.reports) {
    EXPECT_LE(report.bytes, 4097u);
    for (const HidField& field : report.fields) {
      const std::size_t end = field.first.bit + std::size_t{field.count} * field.first.size;
      EXPECT_LE(end, 8 * report.bytes);
      EXPECT_GE(field.first.bit, 8u);
      EXPECT_LE(field.usages.size(), 1024u);
    }
  }
}

TEST(HidDescriptor, TakesOrRefusesEveryMutationOfRealOnes) {
  Random random(20260101);
  int taken = 0, refused = 0;
  for (const Bytes& original :
       {fake::OpenFfBoardDescriptor(), fake::RhinoDescriptor(), ThreeAxes()}) {
    for (int round = 0; round < 3000; ++round) {
      Bytes bytes = original;
      const auto places = 1 + random.Bits() % 4;
      for (std::uint64_t i = 0; i < places && !bytes.empty(); ++i) {
        const auto at = static_cast<std::ptrdiff_t>(random.Bits() % bytes.size());
        const auto byte = static_cast<std::uint8_t>(random.Bits());
        switch (random.Bits() % 4) {
          case 0:
            bytes[static_cast<std::size_t>(at)] = byte;
            break;
          case 1:
            bytes.erase(bytes.begin() + at);
            break;
          case 2:
            bytes.insert(bytes.begin() + at, byte);
            break;
          default:
            bytes.resize(static_cast<std::size_t>(at));
            break;
        }
      }
      try {
        ExpectSound(ParseHidDescriptor(bytes));
        ++taken;
      } catch (const DeviceError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(taken, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace moontrace

#include "devices/hid/pid_codec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "devices/core/device_error.h"
#include "devices/hid/pid_layout.h"
#include "tests/devices/fake/descriptor_writer.h"
#include "tests/devices/fake/pid_descriptors.h"

namespace moontrace {
namespace {

using Bytes = std::vector<std::uint8_t>;

PidLayout Board() { return FindPidLayout(ParseHidDescriptor(fake::OpenFfBoardDescriptor())); }
PidLayout Rhino() { return FindPidLayout(ParseHidDescriptor(fake::RhinoDescriptor())); }

Bytes BytesOf(const HidReport& report) {
  const auto span = report.span();
  return {span.begin(), span.end()};
}

// Expected bytes are put together by hand from the tables of mujoco-and-hid.md, 2.3.

TEST(PidLayout, FindsTheReportsOfOpenFfBoard) {
  const PidLayout layout = Board();
  EXPECT_EQ(layout.effect.report.id, 1);
  EXPECT_EQ(layout.constant.report.id, 5);
  EXPECT_EQ(layout.operation.report.id, 0x0a);
  EXPECT_EQ(layout.free.report.id, 0x0b);
  EXPECT_EQ(layout.control.report.id, 0x0c);
  EXPECT_EQ(layout.gain.report.id, 0x0d);
  EXPECT_EQ(layout.create.report.id, 0x11);
  EXPECT_EQ(layout.load.report.id, 0x12);
  EXPECT_EQ(layout.state.report.id, 2);
  EXPECT_TRUE(layout.motors[0] && layout.motors[1]);
}

TEST(PidLayout, FindsTheReportsOfRhino) {
  const PidLayout layout = Rhino();
  EXPECT_EQ(layout.effect.report.id, 101);
  EXPECT_EQ(layout.constant.report.id, 105);
  EXPECT_EQ(layout.operation.report.id, 110);
  EXPECT_EQ(layout.control.report.id, 112);
  EXPECT_EQ(layout.create.report.id, 5);
  EXPECT_EQ(layout.load.report.id, 6);
}

TEST(PidLayout, NamesAllThatIsMissingInOneLine) {
  fake::DescriptorWriter w;
  w.Page(1).Usage(4).Begin(1).Id(1).Page(15).Usage(0x21).Begin(2);
  w.Usage(0x50).Range(0, 1000).Size(16, 1);
  w.Field(fake::DescriptorWriter::kOutput, fake::DescriptorWriter::kVariable).End().End();
  const auto descriptor = ParseHidDescriptor(w.bytes());
  EXPECT_TRUE(SpeaksPid(descriptor));
  try {
    FindPidLayout(descriptor);
    FAIL() << "found";
  } catch (const DeviceError& error) {
    const std::string line = error.what();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    for (const char* name : {"block index", "constant force (26)", "(73)", "(77)"}) {
      EXPECT_NE(line.find(name), std::string::npos) << line;
    }
  }
}

// The part for rumble of the descriptor that an Xbox pad shows over Bluetooth.
TEST(PidLayout, SaysThatAPadThatRumblesHasNoForceFeedback) {
  const std::vector<std::uint8_t> pad{
      0x05, 0x01, 0x09, 0x05, 0xa1, 0x01, 0x05, 0x0f, 0x09, 0x21, 0x85, 0x03, 0xa1, 0x02, 0x09,
      0x97, 0x15, 0x00, 0x25, 0x01, 0x75, 0x04, 0x95, 0x01, 0x91, 0x02, 0x15, 0x00, 0x25, 0x00,
      0x91, 0x03, 0x09, 0x70, 0x15, 0x00, 0x25, 0x64, 0x75, 0x08, 0x95, 0x04, 0x91, 0x02, 0x09,
      0x50, 0x66, 0x01, 0x10, 0x55, 0x0e, 0x26, 0xff, 0x00, 0x95, 0x01, 0x91, 0x02, 0x09, 0xa7,
      0x91, 0x02, 0x65, 0x00, 0x55, 0x00, 0x09, 0x7c, 0x91, 0x02, 0xc0, 0xc0};
  try {
    FindPidLayout(ParseHidDescriptor(pad));
    FAIL() << "found";
  } catch (const DeviceError& error) {
    EXPECT_STREQ(error.what(), "it is no force-feedback device: its motors only rumble");
  }
}

TEST(PidLayout, FindsAxesAndButtonsOfTheStick) {
  const auto stick = FindStick(ParseHidDescriptor(fake::OpenFfBoardDescriptor()), StickMap{});
  EXPECT_EQ(stick.right.bits.bit, 8u + 64u);
  EXPECT_EQ(stick.away.bits.bit, 8u + 64u + 16u);
  EXPECT_EQ(stick.buttons.size(), 32u);
  EXPECT_FALSE(stick.press.IsThere());
}

TEST(PidLayout, RefusesAnAxisThatIsNotThere) {
  StickMap map;
  map.press = StickMap::Press::kAxis;
  map.press_axis.usage = 0x38;  // a wheel
  EXPECT_THROW(FindStick(ParseHidDescriptor(fake::OpenFfBoardDescriptor()), map), DeviceError);
}

TEST(PidCodec, SetsAnEffectOnEachAxisOfOpenFfBoard) {
  // Block, type 1, duration, repeat, period, delay, gain, button, bits X and direction, 9000.
  const Bytes x = {1, 3, 1, 50, 0, 0, 0, 0, 0, 0, 0, 255, 0, 0x05, 0x28, 0x23, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(BytesOf(EncodeSetEffect(Board(), 3, 0, 0.05)), x);
  // Bits Y and direction, 18000.
  const Bytes y = {1, 4, 1, 50, 0, 0, 0, 0, 0, 0, 0, 255, 0, 0x06, 0x50, 0x46, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(BytesOf(EncodeSetEffect(Board(), 4, 1, 0.05)), y);
}

TEST(PidCodec, NeverSetsAnEndlessDuration) {
  const HidBits at = Board().effect.duration;
  EXPECT_EQ(ReadBits(EncodeSetEffect(Board(), 1, 0, 0).span(), at), 1);
  EXPECT_EQ(ReadBits(EncodeSetEffect(Board(), 1, 0, 1e6).span(), at), 32766);
}

TEST(PidCodec, ScalesAConstantForceToItsRange) {
  EXPECT_EQ(BytesOf(EncodeConstantForce(Board(), 2, 1)), (Bytes{5, 2, 0xff, 0x7f}));
  EXPECT_EQ(BytesOf(EncodeConstantForce(Board(), 2, -1)), (Bytes{5, 2, 0x01, 0x80}));
  EXPECT_EQ(BytesOf(EncodeConstantForce(Rhino(), 2, 0.5)), (Bytes{105, 2, 0x00, 0x08}));  // 2048
}

TEST(PidCodec, HoldsAForceWithinItsRangeAndTakesNoNumberForZero) {
  EXPECT_EQ(BytesOf(EncodeConstantForce(Board(), 2, 7)), (Bytes{5, 2, 0xff, 0x7f}));
  EXPECT_EQ(BytesOf(EncodeConstantForce(Board(), 2, std::nan(""))), (Bytes{5, 2, 0, 0}));
}

TEST(PidCodec, TellsOperationsByNumber) {
  EXPECT_EQ(BytesOf(EncodeOperation(Board(), 2, pid::kStart)), (Bytes{0x0a, 2, 1, 1}));
  EXPECT_EQ(BytesOf(EncodeOperation(Board(), 2, pid::kStop)), (Bytes{0x0a, 2, 3, 1}));
  EXPECT_EQ(BytesOf(EncodeBlockFree(Board(), 2)), (Bytes{0x0b, 2}));
}

TEST(PidCodec, ControlsByBitOrByNumberAsTheDeviceWants) {
  EXPECT_EQ(BytesOf(EncodeControl(Board(), pid::kEnable)), (Bytes{0x0c, 1}));
  EXPECT_EQ(BytesOf(EncodeControl(Board(), pid::kDisable)), (Bytes{0x0c, 2}));
  EXPECT_EQ(BytesOf(EncodeControl(Board(), pid::kStopAll)), (Bytes{0x0c, 4}));
  EXPECT_EQ(BytesOf(EncodeControl(Board(), pid::kReset)), (Bytes{0x0c, 8}));
  EXPECT_EQ(BytesOf(EncodeControl(Rhino(), pid::kDisable)), (Bytes{112, 1}));
  EXPECT_EQ(BytesOf(EncodeControl(Rhino(), pid::kEnable)), (Bytes{112, 2}));
  EXPECT_EQ(BytesOf(EncodeControl(Rhino(), pid::kStopAll)), (Bytes{112, 3}));
  EXPECT_EQ(BytesOf(EncodeControl(Rhino(), pid::kReset)), (Bytes{112, 4}));
}

TEST(PidCodec, CreatesAConstantForceAtFullGain) {
  EXPECT_EQ(BytesOf(EncodeCreateEffect(Board())), (Bytes{0x11, 1, 0, 0}));
  EXPECT_EQ(BytesOf(EncodeDeviceGain(Board())), (Bytes{0x0d, 255}));
}

TEST(PidCodec, ReadsTheAnswerToACreation) {
  using Status = PidBlockLoad::Status;
  const auto load = [](std::uint8_t status) {
    return DecodeBlockLoad(Board(), Bytes{0x12, 7, status, 16, 0});
  };
  EXPECT_EQ(load(1).status, Status::kSuccess);
  EXPECT_EQ(load(1).block, 7);
  EXPECT_EQ(load(2).status, Status::kFull);
  EXPECT_EQ(load(3).status, Status::kError);
  EXPECT_EQ(load(0).status, Status::kPending);
}

TEST(PidCodec, ReadsTheState) {
  const PidState on = DecodeState(Board(), Bytes{2, 0x0a});
  EXPECT_TRUE(on.is_enabled && on.has_power);
  EXPECT_FALSE(on.is_paused || on.safety || on.is_playing);
  const PidState off = DecodeState(Board(), Bytes{2, 0x15});
  EXPECT_FALSE(off.is_enabled || off.has_power);
  EXPECT_TRUE(off.is_paused && off.safety && off.is_playing);
}

TEST(PidCodec, ReadsSharesOfARange) {
  const HidBits bits{8, 16, -32767, 32767};
  EXPECT_EQ(ShareOf(Bytes{1, 0xff, 0x7f}, bits), 1);
  EXPECT_EQ(ShareOf(Bytes{1, 0, 0}, bits), 0);
  EXPECT_EQ(ShareOf(Bytes{1, 0x00, 0x80}, bits), -1);  // beyond the range
}

}  // namespace
}  // namespace moontrace

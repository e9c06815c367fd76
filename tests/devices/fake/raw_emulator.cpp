#include "tests/devices/fake/raw_emulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "tests/devices/fake/descriptor_writer.h"

namespace moontrace::fake {
namespace {

constexpr double kDeadMan = 0.015;  // [s]
constexpr double kPeriod = 1e-3;    // [s]
constexpr int kPeak = 5000;         // [mN]

unsigned CheckSum(Bytes bytes) {
  unsigned sum = 0xffff;
  for (const std::uint8_t byte : bytes) {
    sum = (sum ^ static_cast<unsigned>(byte) << 8) & 0xffff;
    for (int i = 0; i < 8; ++i) sum = (sum << 1 ^ (sum >> 15 != 0 ? 0x1021u : 0u)) & 0xffff;
  }
  return sum;
}

/// A report under construction.
struct Packet {
  std::vector<std::uint8_t> bytes;
  Packet& Add(long long value, int size) {
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    return *this;
  }
  Packet& Close() { return Add(CheckSum(bytes), 2); }
};

class RawEmulator final : public Emulator {
 public:
  Identity Describe() const override {
    DescriptorWriter w;
    w.Page(0xff4d).Usage(1).Begin(1).Page(0xff4d).Range(0, 255);
    w.Id(1).Usage(2).Size(8, 35).Field(DescriptorWriter::kInput, DescriptorWriter::kVariable);
    w.Id(2).Usage(3).Size(8, 17).Field(DescriptorWriter::kOutput, DescriptorWriter::kVariable);
    w.Id(3).Usage(4).Size(8, 37).Field(DescriptorWriter::kFeature, DescriptorWriter::kVariable);
    w.End();
    // A Teensy's id, to show that ids do not matter.
    return {0x16c0, 0x0486, "Emulated", "Self-built arm", "FAKE-R", {{0xff4d, 1}}, w.bytes()};
  }

  void Advance(double time, const Send& send) override {
    time_ = time;
    if (time - heard_ > kDeadMan) has_let_go_ = true;
    const glm::dvec3 before = hand_.p();
    hand_.Advance(time, Force());
    if (time - sent_ < kPeriod) return;
    const double passed = time - sent_;
    sent_ = time;
    const int status = (is_off_ ? 0 : 1) | (has_let_go_ ? 2 : 0) | 4;
    Packet p;
    p.Add(1, 1).Add(status, 1).Add(sequence_++, 2);
    for (int i = 0; i < 3; ++i) p.Add(std::llround((hand_.p()[i] + offset_) * 1e6), 4);
    for (int i = 0; i < 3; ++i) p.Add(std::llround((hand_.p() - before)[i] / passed * 1e6), 4);
    p.Add(std::fmod(time, 1.0) > 0.9 ? 1 : 0, 4);  // a thumb, for a tenth of every second
    p.Add(answered_, 2).Close();
    send(p.bytes);
  }

  void Output(Bytes r, double time, const Send&) override {
    time_ = time;
    if (r.size() < 18 || r[0] != 2) return;
    if (CheckSum(r.first(16)) != (r[16] | static_cast<unsigned>(r[17]) << 8)) return;
    heard_ = time;
    has_let_go_ = false;
    answered_ = r[2] | r[3] << 8;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint8_t* const b = &r[4 + 4 * i];
      const unsigned bits =
          static_cast<unsigned>(b[0] | b[1] << 8 | b[2] << 16) | static_cast<unsigned>(b[3]) << 24;
      const auto value = static_cast<std::int32_t>(bits);
      const int held = std::clamp(static_cast<int>(value), -kPeak, kPeak);
      wanted_[static_cast<int>(i)] = (r[1] & 1) != 0 ? held * 1e-3 : 0;
    }
  }

  bool SetFeature(Bytes) override { return false; }

  int GetFeature(std::span<std::uint8_t> report) override {
    if (report[0] != 3) return -1;
    Packet p;
    p.Add(3, 1).Add(1, 1).Add(0x4e4f4f4d, 4).Add(std::llround(kDeadMan * 1e3), 2);
    p.Add(160000, 4).Add(120000, 4).Add(60000, 4).Add(kPeak, 4).Add(1000, 2).Add(2, 1);
    p.Add(0x3f, 1).Add(1000, 4).Add(1000, 4).Close();
    const std::size_t n = std::min(report.size(), p.bytes.size());
    std::copy_n(p.bytes.begin(), n, report.begin());
    return static_cast<int>(n);
  }

  glm::dvec3 Force() const override {
    return is_off_ || has_let_go_ ? glm::dvec3(0, 0, 0) : wanted_;
  }
  void Jump(double way) override { offset_ += way; }
  void Disable() override { is_off_ = true; }

 private:
  SwingingHand hand_;
  double time_ = 0, heard_ = -1, sent_ = -1, offset_ = 0;
  bool has_let_go_ = true, is_off_ = false;
  int sequence_ = 0, answered_ = 0;
  glm::dvec3 wanted_{0, 0, 0};  // [N]
};

}  // namespace

std::unique_ptr<Emulator> MakeRawEmulator() { return std::make_unique<RawEmulator>(); }

}  // namespace moontrace::fake

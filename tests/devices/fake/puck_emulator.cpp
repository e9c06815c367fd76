#include "tests/devices/fake/puck_emulator.h"

#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "tests/devices/fake/descriptor_writer.h"

namespace moontrace::fake {
namespace {

constexpr double kPeriod = 0.01;  // [s]
constexpr int kFull = 350;

class PuckEmulator final : public Emulator {
 public:
  Identity Describe() const override {
    DescriptorWriter w;
    w.Page(1).Usage(8).Begin(1);
    w.Begin(0).Id(1).Range(-kFull, kFull).UsageRange(0x30, 0x32).Size(16, 3);
    w.Field(DescriptorWriter::kInput, DescriptorWriter::kVariable).End();
    w.Begin(0).Id(2).UsageRange(0x33, 0x35).Size(16, 3);
    w.Field(DescriptorWriter::kInput, DescriptorWriter::kVariable).End();
    w.Begin(2).Id(3).Page(9).UsageRange(1, 2).Range(0, 1).Size(1, 2);
    w.Field(DescriptorWriter::kInput, DescriptorWriter::kVariable).Size(14, 1);
    w.Field(DescriptorWriter::kInput, DescriptorWriter::kConstant).End().End();
    return {0x256f, 0xc635, "Emulated", "Puck", "FAKE-P", {{1, 8}}, w.bytes()};
  }

  void Advance(double time, const Send& send) override {
    if (time - sent_ < kPeriod) return;
    sent_ = time;
    const double phase = std::fmod(time, 8.0);
    const int right = phase < 1 ? kFull : 0;
    const int near = phase >= 6 && phase < 7 ? kFull / 2 : 0;
    const int button = phase >= 1 && phase < 6 ? 1 : 0;
    const bool rests = right == 0 && near == 0 && jump_ == 0;
    if (!rests || !rested_) {
      SendAxes(send, 1, {right + jump_, near, 0});
      SendAxes(send, 2, {0, 0, 0});
    }
    rested_ = rests;
    if (button != button_)
      send(std::array<std::uint8_t, 3>{3, static_cast<std::uint8_t>(button), 0});
    button_ = button;
  }

  void Output(Bytes, double, const Send&) override {}
  bool SetFeature(Bytes) override { return false; }
  int GetFeature(std::span<std::uint8_t>) override { return -1; }
  glm::dvec3 Force() const override { return {0, 0, 0}; }
  void Jump(double) override { jump_ = kFull; }
  void Disable() override {}

 private:
  static void SendAxes(const Send& send, int id, std::array<int, 3> counts) {
    std::array<std::uint8_t, 7> r{static_cast<std::uint8_t>(id)};
    for (std::size_t i = 0; i < 3; ++i) {
      r[1 + 2 * i] = static_cast<std::uint8_t>(counts[i]);
      r[2 + 2 * i] = static_cast<std::uint8_t>(counts[i] >> 8);
    }
    send(r);
  }

  double sent_ = -1;
  bool rested_ = true;
  int button_ = 0, jump_ = 0;
};

}  // namespace

std::unique_ptr<Emulator> MakePuckEmulator() { return std::make_unique<PuckEmulator>(); }

}  // namespace moontrace::fake

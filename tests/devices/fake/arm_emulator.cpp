#include "tests/devices/fake/arm_emulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "tests/devices/fake/descriptor_writer.h"

namespace moontrace::fake {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kDeadMan = 0.5;  // of the firmware [s]

/// What the makers publish of an arm.
struct Arm {
  std::size_t bytes;
  double base, upper, fore;         // links [m]
  double drum_a, drum, capstan;     // diameters [m]
  double torque;                    // of a motor [N m/A]
  double origin_x, origin_z;        // makers' frame: x to the person, y right, z up [m]
  double count_sign, current_sign;  // of a motor against its body
};
constexpr Arm kWoodenArm = {8, 0.08, 0.205, 0.245, 0.16, 0.12, 0.010, 0.0259, 0.22, 0.08, -1, 1};
constexpr Arm kPolhemArm = {14, 0.058, 0.174, 0.133, 0.18, 0.10, 0.010, 0.0538, 0.14, 0.10, -1, -1};

using Angles = glm::dvec3;

/// Where the tip is, frame D.
glm::dvec3 Forward(const Arm& arm, const Angles& t) {
  const double r = arm.upper * std::sin(t.y) + arm.fore * std::sin(t.z);
  const double z = arm.base + arm.upper * std::cos(t.y) - arm.fore * std::cos(t.z);
  return {r * std::sin(t.x), arm.origin_x - r * std::cos(t.x), z - arm.origin_z};
}

/// The angles for a tip, by the law of cosines.
Angles Inverse(const Arm& arm, const glm::dvec3& p) {
  const double x = arm.origin_x - p.y, y = p.x, z = p.z + arm.origin_z - arm.base;
  const double r = std::hypot(x, y);
  const double cosine =
      (arm.upper * arm.upper + arm.fore * arm.fore - r * r - z * z) / (2 * arm.upper * arm.fore);
  const double sum = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double b =
      std::atan2(r, z) - std::atan2(arm.fore * std::sin(sum), arm.upper - arm.fore * cosine);
  return {std::atan2(y, x), b, sum - b};
}

class ArmEmulator final : public Emulator {
 public:
  explicit ArmEmulator(ArmVariant variant)
      : is_teensy_(variant == ArmVariant::kTeensy),
        arm_(variant == ArmVariant::kWooden ? kWoodenArm : kPolhemArm),
        bytes_(is_teensy_ ? 64 : arm_.bytes),
        rest_(Forward(arm_, {0, 0, kTurn / 4})),
        tip_(rest_) {}

  Identity Describe() const override {
    const auto count = static_cast<std::uint32_t>(bytes_);
    DescriptorWriter w;
    w.Page(0xffab).Usage(0x200).Begin(1).Page(0xffab).Range(0, 255);
    w.Usage(1).Size(8, count).Field(DescriptorWriter::kInput, DescriptorWriter::kVariable);
    w.Usage(2).Size(8, count).Field(DescriptorWriter::kOutput, DescriptorWriter::kVariable);
    w.End();
    Identity identity{0x1234, 0x0006, "Emulated", "Arm", "", {{0xffab, 0x200}}, w.bytes()};
    if (is_teensy_) identity.vendor = 0x16c0, identity.product = 0x0486;
    return identity;
  }

  void Advance(double time, const Send&) override {
    time_ = time;
    if (began_ < 0) return;
    if (time - heard_ > kDeadMan) currents_ = {0, 0, 0};
    const double t = time - began_;
    if (t < kArmIsHomed) {
      tip_ = Homed(t);
    } else {
      hand_.Advance(time, Force());
      tip_ = hand_.p();
    }
  }

  void Open() override { began_ = -1; }

  void Output(Bytes r, double time, const Send& send) override {
    if (began_ < 0) began_ = time;
    Advance(time, send);
    heard_ = time;
    if (r.size() == 1 + bytes_) {
      const auto word = [&](std::size_t i) {
        return static_cast<std::int16_t>(r[1 + 2 * i] | r[2 + 2 * i] << 8);
      };
      const bool is_command = bytes_ > 8 && word(3) != 0;
      if (!is_command) currents_ = glm::dvec3(word(0), word(1), word(2)) * 1e-3;
    }
    send(Report());
  }

  bool SetFeature(Bytes) override { return false; }
  int GetFeature(std::span<std::uint8_t>) override { return -1; }

  glm::dvec3 Force() const override {
    if (is_off_) return {0, 0, 0};
    const Angles t = Inverse(arm_, tip_);
    const double ratio = arm_.drum / arm_.capstan, ratio_a = arm_.drum_a / arm_.capstan;
    const glm::dvec3 torque =
        arm_.current_sign * arm_.torque * currents_ * glm::dvec3(ratio_a, ratio, ratio);
    glm::dmat3 columns(1);  // what the tip does by each angle, by differences
    for (int i = 0; i < 3; ++i) {
      Angles more = t, less = t;
      more[i] += 1e-5, less[i] -= 1e-5;
      columns[i] = (Forward(arm_, more) - Forward(arm_, less)) / 2e-5;
    }
    return glm::inverse(glm::transpose(columns)) * torque;
  }

  void Jump(double way) override { offset_ += way; }
  void Disable() override { is_off_ = true; }

 private:
  /// The hand that homes it, at `t` seconds.
  glm::dvec3 Homed(double t) const {
    const auto share = [t](double from, double to) {
      return std::clamp((t - from) / (to - from), 0.0, 1.0);
    };
    const glm::dvec3 little(0, 0, 0.03 * std::sin(kTurn / 2 * share(0, 0.4)));
    const glm::dvec3 asked = rest_ + share(1.6, 1.9) * glm::dvec3(0.025, -0.025, 0.025);
    return asked + little - share(1.9, kArmIsHomed) * asked;
  }

  std::vector<std::uint8_t> Report() {
    const Angles t = Inverse(arm_, tip_ + offset_);
    const Angles rest(0, 0, kTurn / 4);
    std::vector<std::uint8_t> r(bytes_, 0);
    for (int i = 0; i < 3; ++i) {
      const double ratio = (i == 0 ? arm_.drum_a : arm_.drum) / arm_.capstan;
      // Some count the counters happen to stand at when the arm is in its rest: near the wrap.
      const long long count =
          32000 + std::llround(arm_.count_sign * (t[i] - rest[i]) / kTurn * 2000 * ratio);
      r[static_cast<std::size_t>(2 * i)] = static_cast<std::uint8_t>(count);
      r[static_cast<std::size_t>(2 * i + 1)] = static_cast<std::uint8_t>(count >> 8);
    }
    if (bytes_ == 8) {
      r[6] = static_cast<std::uint8_t>(counter_);
      r[7] = static_cast<std::uint8_t>(counter_ >> 8);
      ++counter_;
    }
    return r;
  }

  const bool is_teensy_;
  const Arm arm_;
  const std::size_t bytes_;
  const glm::dvec3 rest_;
  SwingingHand hand_;
  glm::dvec3 tip_, currents_{0, 0, 0};
  double time_ = 0, began_ = -1, heard_ = -1, offset_ = 0;
  int counter_ = 0;
  bool is_off_ = false;
};

}  // namespace

std::unique_ptr<Emulator> MakeArmEmulator(ArmVariant variant) {
  return std::make_unique<ArmEmulator>(variant);
}

}  // namespace moontrace::fake

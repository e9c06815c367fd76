#include "tests/devices/fake/emulator.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "tests/devices/fake/arm_emulator.h"
#include "tests/devices/fake/pid_emulator.h"
#include "tests/devices/fake/puck_emulator.h"
#include "tests/devices/fake/raw_emulator.h"

namespace moontrace::fake {
namespace {

struct Kind {
  std::string_view name;
  std::unique_ptr<Emulator> (*make)();
};

/// A new kind is a line here and an emulator file of its own.
constexpr Kind kKinds[] = {
    {"pid", [] { return MakePidEmulator(PidVariant::kBits); }},
    {"pid-array", [] { return MakePidEmulator(PidVariant::kArray); }},
    {"moontrace-raw", [] { return MakeRawEmulator(); }},
    {"woodenhaptics", [] { return MakeArmEmulator(ArmVariant::kWooden); }},
    {"polhem", [] { return MakeArmEmulator(ArmVariant::kPolhem); }},
    {"polhem-teensy", [] { return MakeArmEmulator(ArmVariant::kTeensy); }},
    {"spacemouse", [] { return MakePuckEmulator(); }},
};

}  // namespace

std::unique_ptr<Emulator> MakeEmulator(std::string_view kind) {
  for (const Kind& known : kKinds) {
    if (known.name == kind) return known.make();
  }
  return nullptr;
}

void SwingingHand::Advance(double time, glm::dvec3 force) {
  constexpr double kMass = 0.1, kStiffness = 200, kDamping = 3, kStep = 2e-4, kTurn = 6.2831853;
  if (time - time_ > 0.1) time_ = time - 0.1;  // nobody looked for long: no more than this
  for (; time_ + kStep <= time; time_ += kStep) {
    const glm::dvec3 aim(0.03 * std::sin(kTurn * time_ / 4), 0.01 * std::sin(kTurn * time_ / 3), 0);
    v_ += kStep / kMass * (force + kStiffness * (aim - p_) - kDamping * v_);
    p_ += kStep * v_;
  }
}

}  // namespace moontrace::fake

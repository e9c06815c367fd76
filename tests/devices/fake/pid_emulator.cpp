#include "tests/devices/fake/pid_emulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "tests/devices/fake/pid_descriptors.h"

namespace moontrace::fake {
namespace {

constexpr int kMostEffects = 40;
constexpr double kQuiet = 0.1;    // a report at least this often [s]
constexpr double kPeriod = 1e-3;  // at most this often [s]
constexpr double kTurn = 6.283185307179586;
constexpr double kCentring = 20;  // of the spring that kArray is born with [N/m]

/// Report numbers and ranges of a variant.
struct Numbers {
  std::uint8_t state, effect, constant, operation, free, control, gain, create, load, pool;
  double magnitude, direction;  // value of full force, of a whole turn
  std::size_t buttons;          // bytes
};
constexpr Numbers kBitsNumbers = {2,    1,    5,    0x0a,  0x0b,  0x0c, 0x0d,
                                  0x11, 0x12, 0x13, 32767, 36000, 8};
constexpr Numbers kArrayNumbers = {2, 101, 105, 110, 111, 112, 113, 5, 6, 7, 4096, 255, 4};

struct Effect {
  bool is_used = false, is_playing = false;
  int duration = 0;                // [ms]; 0 and the greatest: for ever
  double gain = 0, direction = 0;  // share; [rad], clockwise from away
  double magnitude = 0;            // share of full force
  double started = 0;              // [s]
};

int Word(Bytes r, std::size_t at) { return r[at] | r[at + 1] << 8; }

class PidEmulator final : public Emulator {
 public:
  explicit PidEmulator(PidVariant variant)
      : is_bits_(variant == PidVariant::kBits), n_(is_bits_ ? kBitsNumbers : kArrayNumbers) {
    Reset();
  }

  Identity Describe() const override {
    if (is_bits_) {
      return {0x1209,
              0xffb0,
              "Emulated",
              "Stick of bits",
              "FAKE-1",
              {{1, 4}, {0xff00, 1}},
              OpenFfBoardDescriptor()};
    }
    return {0xffff, 0x2055, "Emulated", "Stick of arrays", "FAKE-2", {{1, 4}}, RhinoDescriptor()};
  }

  void Advance(double time, const Send& send) override {
    time_ = time;
    for (Effect& effect : effects_) {
      const bool ends = effect.duration > 0 && effect.duration < 32767;
      if (effect.is_playing && ends && time > effect.started + effect.duration * 1e-3) {
        effect.is_playing = false;
      }
    }
    hand_.Advance(time, Force());
    if (state_is_due_) SendState(send);
    const std::vector<std::uint8_t> report = Position();
    if (time - sent_ < (report == last_ ? kQuiet : kPeriod)) return;
    sent_ = time;
    last_ = report;
    send(report);
  }

  void Output(Bytes r, double time, const Send& send) override {
    time_ = time;
    const bool has_block = r.size() > 1 && r[1] >= 1 && r[1] <= kMostEffects;
    if (r[0] == n_.effect && has_block) SetEffect(r);
    if (r[0] == n_.constant && has_block && r.size() >= 4) {
      const auto value = static_cast<std::int16_t>(Word(r, 2));
      effects_[r[1]].magnitude = std::clamp(value / n_.magnitude, -1.0, 1.0);
    }
    if (r[0] == n_.operation && has_block && r.size() >= 4) Operate(r[1], r[2], send);
    if (r[0] == n_.free && has_block) effects_[r[1]] = {};
    if (r[0] == n_.control && r.size() >= 2) Control(r[1], send);
    if (r[0] == n_.gain && r.size() >= 2) gain_ = r[1] / 255.0;
  }

  bool SetFeature(Bytes report) override {
    if (report[0] != n_.create || report.size() < 4 || report[1] != 1) return false;
    block_ = 0;
    for (int i = is_bits_ ? 1 : 2; i <= kMostEffects && block_ == 0; ++i) {
      if (!effects_[static_cast<std::size_t>(i)].is_used) block_ = i;
    }
    if (block_ > 0) effects_[static_cast<std::size_t>(block_)] = {.is_used = true};
    return true;
  }

  int GetFeature(std::span<std::uint8_t> r) override {
    if (r.size() < 5) return -1;
    if (r[0] == n_.load) {
      r[1] = static_cast<std::uint8_t>(block_), r[2] = block_ > 0 ? 1 : 2, r[3] = 64, r[4] = 0;
      return 5;
    }
    if (r[0] == n_.pool) {
      r[1] = 64, r[2] = 0, r[3] = kMostEffects, r[4] = 1;
      return 5;
    }
    return -1;
  }

  glm::dvec3 Force() const override {
    glm::dvec3 force{0, 0, 0};
    for (const Effect& effect : effects_) {
      if (!effect.is_playing || !is_enabled_ || is_off_) continue;
      const double f = effect.magnitude * effect.gain * gain_ * kPidFullForce;
      // On HID's Y, towards the person, the factor is -cos: so +cos away from the person.
      force += f * glm::dvec3(std::sin(effect.direction), std::cos(effect.direction), 0);
    }
    if (is_centring_) force -= kCentring * hand_.p();
    return force;
  }

  void Jump(double way) override { offset_ += way; }
  void Disable() override { is_off_ = state_is_due_ = true; }

 private:
  void Reset() {
    effects_.fill({});
    gain_ = 1;
    is_enabled_ = false;
    is_centring_ = !is_bits_;  // the firmware's own spring plays again
  }

  void SetEffect(Bytes r) {
    const std::size_t axes = is_bits_ ? 13 : 6;
    if (r.size() < (is_bits_ ? 22u : 9u) || r[2] != 1) return;
    Effect& effect = effects_[r[1]];
    effect.duration = Word(r, 3);
    effect.gain = r[axes - (is_bits_ ? 2 : 1)] / 255.0;
    const bool is_directed = (r[axes] & 4) != 0;
    const double direction = is_bits_ ? Word(r, 14) : r[7];
    effect.direction = is_directed ? direction / n_.direction * kTurn : 0;
  }

  void Operate(std::uint8_t block, std::uint8_t operation, const Send& send) {
    Effect& effect = effects_[block];
    if (block == 1 && operation == 3 && !is_bits_) is_centring_ = false;
    if (operation == 2) {
      for (Effect& other : effects_) other.is_playing = false;
    }
    if (effect.is_used) {
      effect.is_playing = operation < 3;
      effect.started = time_;
    }
    if (!is_bits_ && operation == 3) {
      state_block_ = block;
      SendState(send);
    }
  }

  void Control(std::uint8_t value, const Send& send) {
    // As bits: enable 1, disable 2, stop 4, reset 8. As numbers: disable 1, enable 2, stop 3,
    // reset 4.
    const std::array<int, 5> number = {-1, 2, 1, 3, 4};
    const auto asks = [&](int command) {
      return is_bits_ ? (value >> (command - 1) & 1) != 0
                      : value == number[static_cast<std::size_t>(command)];
    };
    if (asks(4)) Reset();
    if (asks(1)) is_enabled_ = true;
    if (asks(2)) is_enabled_ = false;
    if (asks(3)) {
      for (Effect& effect : effects_) effect.is_playing = false;
    }
    SendState(send);
  }

  void SendState(const Send& send) {
    state_is_due_ = false;
    const bool is_on = is_enabled_ && !is_off_;
    if (is_bits_) {
      send(std::array<std::uint8_t, 2>{2, static_cast<std::uint8_t>(is_on ? 0x0a : 0x08)});
    } else {
      const bool plays = state_block_ == 1 ? is_centring_ : effects_[state_block_].is_playing;
      send(std::array<std::uint8_t, 3>{2, static_cast<std::uint8_t>(is_on ? 0x12 : 0x10),
                                       static_cast<std::uint8_t>(state_block_ << 1 | plays)});
    }
  }

  std::vector<std::uint8_t> Position() const {
    std::vector<std::uint8_t> r(1 + n_.buttons + 16, 0);
    r[0] = 1;
    const auto put = [&](std::size_t axis, double metres) {
      const double share = std::clamp((metres + offset_) / kPidReach, -1.0, 1.0);
      const auto value = static_cast<std::int16_t>(std::lround(share * 32767));
      r[1 + n_.buttons + 2 * axis] = static_cast<std::uint8_t>(value & 0xff);
      r[2 + n_.buttons + 2 * axis] = static_cast<std::uint8_t>(value >> 8 & 0xff);
    };
    put(0, hand_.p().x);
    put(1, -hand_.p().y);  // HID's Y grows towards the person
    return r;
  }

  const bool is_bits_;
  const Numbers n_;
  SwingingHand hand_;
  std::array<Effect, kMostEffects + 1> effects_{};
  int block_ = 0;  // created last
  std::size_t state_block_ = 1;
  bool is_enabled_ = false, is_off_ = false, is_centring_ = false, state_is_due_ = false;
  double gain_ = 1, offset_ = 0, time_ = 0, sent_ = -1;
  std::vector<std::uint8_t> last_;
};

}  // namespace

std::unique_ptr<Emulator> MakePidEmulator(PidVariant variant) {
  return std::make_unique<PidEmulator>(variant);
}

}  // namespace moontrace::fake

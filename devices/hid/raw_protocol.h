#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

namespace moontrace {

/// Our protocol for self-built devices, version 1: raw_protocol.md is its one page for those who
/// build one, with the same bytes. Everything here is pure. Frame D.
inline constexpr std::uint16_t kRawUsagePage = 0xFF4D;
inline constexpr std::uint16_t kRawUsage = 0x0001;
inline constexpr std::uint8_t kRawInputNumber = 1, kRawOutputNumber = 2, kRawHelloNumber = 3;
inline constexpr std::size_t kRawInputBytes = 36, kRawOutputBytes = 18, kRawHelloBytes = 38;
inline constexpr double kRawLongestDeadMan = 0.02;  ///< a device must let go within this [s]

/// Input report: device to program.
struct RawInput {
  std::uint16_t sequence = 0;  ///< one more with each report
  bool ready = false;          ///< homed, safety switch on, motors can push
  bool has_let_go = false;     ///< its dead-man holds the motors off until the next output report
  bool velocity_known = false;
  glm::dvec3 p_D{0, 0, 0};     ///< [m]
  glm::dvec3 v_D{0, 0, 0};     ///< [m/s]
  std::uint32_t buttons = 0;   ///< bit i: button i is held
  std::uint16_t answered = 0;  ///< sequence of the last output report that it took
};

/// Output report: program to device.
struct RawOutput {
  std::uint16_t sequence = 0;
  bool push = false;        ///< false: let go of the motors
  glm::dvec3 f_D{0, 0, 0};  ///< [N]
};

/// Feature report: what the device is, read once when it is opened.
struct RawHello {
  double dead_man = 0;              ///< [s]
  glm::dvec3 workspace_D{0, 0, 0};  ///< edges around the middle [m]
  double peak_force = 0;            ///< on one axis [N]
  double rate = 0;                  ///< reports a second, each way [Hz]
  int buttons = 0;
  glm::bvec3 measures{false, false, false};
  glm::bvec3 pushes{false, false, false};
  double position_step = 0;  ///< [m]
  double force_step = 0;     ///< [N]
};

/// Nothing if the bytes are not such a report of this version: wrong number, size or check sum. A
/// transport may append zeros up to its packet size.
std::optional<RawInput> DecodeRawInput(std::span<const std::uint8_t> report) noexcept;
std::optional<RawOutput> DecodeRawOutput(std::span<const std::uint8_t> report) noexcept;
std::optional<RawHello> DecodeRawHello(std::span<const std::uint8_t> report) noexcept;

/// The bytes of a report. Values are rounded to the wire's units and held within its range; what is
/// not finite becomes zero.
std::array<std::uint8_t, kRawInputBytes> EncodeRawInput(const RawInput& input) noexcept;
std::array<std::uint8_t, kRawOutputBytes> EncodeRawOutput(const RawOutput& output) noexcept;
std::array<std::uint8_t, kRawHelloBytes> EncodeRawHello(const RawHello& hello) noexcept;

/// CRC-16/CCITT-FALSE: polynomial 0x1021, initial value 0xFFFF, nothing reflected.
std::uint16_t RawCheckSum(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace moontrace

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "devices/hid/raw_protocol.h"

namespace moontrace {
namespace {

/// What was taken must be encoded as the same bytes, reserved bits apart.
template <class Decoded, class Encoded>
void CheckAgain(const Decoded& decoded, Encoded encode, std::span<const std::uint8_t> report,
                std::uint8_t reserved, std::size_t reserved_at) {
  if (!decoded) return;
  const auto again = encode(*decoded);
  for (std::size_t i = 0; i + 2 < again.size(); ++i) {
    const auto known = static_cast<std::uint8_t>(i == reserved_at ? ~reserved : 0xFF);
    if ((again[i] & known) != (report[i] & known)) std::abort();
  }
}

}  // namespace
}  // namespace moontrace

/// Bytes as a device may send them, with a right check sum put in so that all fields are reached.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace moontrace;
  const std::span<const std::uint8_t> raw(data, size);
  DecodeRawInput(raw);
  DecodeRawOutput(raw);
  DecodeRawHello(raw);
  std::array<std::uint8_t, 64> report{};
  std::copy_n(raw.begin(), std::min(size, report.size()), report.begin());
  for (const std::size_t bytes : {kRawInputBytes, kRawOutputBytes, kRawHelloBytes}) {
    const std::uint16_t sum = RawCheckSum(std::span(report).first(bytes - 2));
    report[bytes - 2] = static_cast<std::uint8_t>(sum);
    report[bytes - 1] = static_cast<std::uint8_t>(sum >> 8);
    CheckAgain(DecodeRawInput(report), EncodeRawInput, report, 0xF8, 1);
    CheckAgain(DecodeRawOutput(report), EncodeRawOutput, report, 0xFE, 1);
    if (report[26] <= 32) CheckAgain(DecodeRawHello(report), EncodeRawHello, report, 0xC0, 27);
  }
  return 0;
}

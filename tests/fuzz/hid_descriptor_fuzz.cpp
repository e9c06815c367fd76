// Any bytes either parse as a report descriptor whose numbers lie within their reports, or are
// refused by a DeviceError of one line; so are the force-feedback layouts found in it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "devices/core/device_error.h"
#include "devices/hid/hid_descriptor.h"
#include "devices/hid/pid_codec.h"
#include "devices/hid/pid_layout.h"

namespace {

void MustBeOneLine(const moontrace::DeviceError& error) {
  const std::string_view line = error.what();
  if (line.empty() || line.find('\n') != std::string_view::npos) std::abort();
}

void UseAsStick(const moontrace::HidDescriptor& descriptor) {
  using namespace moontrace;
  const PidLayout layout = FindPidLayout(descriptor);
  if (!PidReportsFit(layout)) return;
  HidReport blank;
  blank.size = HidReport::kMostBytes;
  for (const HidReport& report :
       {EncodeSetEffect(layout, 1, 1, 0.05), EncodeConstantForce(layout, 1, 0.5),
        EncodeOperation(layout, 1, pid::kStart), EncodeControl(layout, pid::kEnable)}) {
    if (report.span().size() > HidReport::kMostBytes) std::abort();
  }
  DecodeState(layout, blank.span());
  DecodeBlockLoad(layout, blank.span());
  const StickLayout stick = FindStick(descriptor, StickMap{});
  const double share = ShareOf(blank.span(), stick.right.bits);
  if (!(share >= -1 && share <= 1)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto descriptor = moontrace::ParseHidDescriptor({data, size});
    for (const auto& report : descriptor.reports) {
      for (const auto& field : report.fields) {
        if (field.first.bit + std::size_t{field.count} * field.first.size > 8 * report.bytes) {
          std::abort();
        }
      }
    }
    UseAsStick(descriptor);
  } catch (const moontrace::DeviceError& error) {
    MustBeOneLine(error);
  }
  return 0;
}

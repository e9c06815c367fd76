// Any bytes either are a guidance table or are refused by an InputError of one line; a table's
// gains stay within their bounds.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lessons/guide/guidance_table.h"
#include "textures/base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace moontrace;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const GuidanceTable table = GuidanceTable::Parse(text, "fuzz.toml");
    for (std::size_t mode = 0; mode < kGuidanceModeCount; ++mode) {
      for (double help = 0; help <= 10; help += 0.5) {
        const GuidanceGains gains = table.GainsOf(static_cast<GuidanceMode>(mode), help);
        if (!(gains.stiffness >= 0 && gains.stiffness <= 400)) std::abort();
        if (!(gains.cap > 0 && gains.cap <= GuidanceTable::kHardCap)) std::abort();
      }
    }
  } catch (const InputError& error) {
    const std::string_view line = error.what();
    if (line.empty() || line.find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}

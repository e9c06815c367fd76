// Any bytes as a grey picture: heights within -1..1, or refused with an InputError of one line.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "textures/base/error.h"
#include "textures/field/pgm.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const moontrace::SampledHeights heights = moontrace::ParsePgm(bytes, "a.pgm");
    for (const float height : heights.heights()) {
      if (!(std::abs(height) <= 1)) std::abort();
    }
    // between and beyond the samples too: no more than the bound says
    const double most = heights.GreatestOf(true).height + 1e-12;
    const auto columns = static_cast<double>(heights.columns());
    if (!(std::abs(heights.Tiled(0.37 * columns, 1.5).height) <= most)) std::abort();
    if (!(std::abs(heights.Stretched(0.61 * columns, 1e9).height) <= most)) std::abort();
  } catch (const moontrace::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}

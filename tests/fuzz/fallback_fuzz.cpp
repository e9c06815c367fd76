// Any bytes as a file of transliterations and names: read, or refused in one line; and a text of
// the same bytes is then set or refused.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tests/textures/small_script.h"
#include "textures/base/error.h"
#include "textures/fonts/fallback.h"
#include "textures/typeset/typeset.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace moontrace;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  Script script = SmallScript();
  try {
    ReadFallbacks(bytes, "fuzz.toml", script);
    SetText(bytes, script, DefaultStyle(0.01, Relief::kEngraved, script), FindPage("a5"));
  } catch (const InputError& error) {
    const std::string_view line = error.what();
    if (line.empty() || line.find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}

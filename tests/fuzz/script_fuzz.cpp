// Any bytes as a script: the font up to the first zero byte, its rules behind it. Read whole and
// sound, or refused with an InputError of one line; never anything else.
#include <cstdint>
#include <string_view>

#include "tests/fuzz/sound_script.h"
#include "textures/fonts/script_library.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t zero = bytes.find('\0');
  const std::string_view rules = zero == std::string_view::npos ? "" : bytes.substr(zero + 1);
  moontrace::RequireSoundOrRefused(
      [&] { return moontrace::ParseScript(bytes.substr(0, zero), "a.svg", rules, "a.toml"); });
  return 0;
}

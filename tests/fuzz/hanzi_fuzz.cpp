// Any bytes as medians in JSON, and as a file with such an object a line: sound strokes, a sound
// script, or refused with an InputError of one line.
#include <cstdint>
#include <string_view>

#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/sound_script.h"
#include "textures/fonts/hanzi.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace moontrace;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  RequireSoundOrRefused([&] { return ParseMedians(bytes, "a:1"); });
  const MemoryFile file(bytes);
  RequireSoundOrRefused([&] { return LoadHanziFile(file.path(), {}); });
  RequireSoundOrRefused([&] { return LoadHanziFile(file.path(), {U'一', U'木'}); });
  return 0;
}

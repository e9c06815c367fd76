// Any bytes as a Braille file: a sound document of cells and replacement characters, or refused in
// one line.
#include <cstdint>

#include "tests/fuzz/sound_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  moontrace::RequireSoundDocument(std::string(reinterpret_cast<const char*>(data), size), "a.brf");
  return 0;
}

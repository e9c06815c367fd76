// Any bytes as a text, with and without marks: a sound document whose transcription is UTF-8, or
// refused in one line.
#include <cstdint>

#include "tests/fuzz/sound_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  moontrace::RequireSoundDocument(bytes, "a.txt");
  moontrace::RequireSoundDocument(bytes, "a.txt", true);
  return 0;
}

// Any bytes as a web page: a sound document whose transcription is UTF-8, or refused in one line.
#include <cstdint>

#include "tests/fuzz/sound_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  moontrace::RequireSoundDocument(std::string(reinterpret_cast<const char*>(data), size), "a.html");
  return 0;
}

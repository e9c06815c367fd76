// Any bytes as a KanjiVG character: sound strokes, or refused with an InputError of one line.
#include <cstdint>
#include <string_view>

#include "tests/fuzz/sound_script.h"
#include "textures/fonts/kanjivg.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  moontrace::RequireSoundOrRefused([&] { return moontrace::ParseKanjiVg(bytes, "04e00.svg"); });
  return 0;
}

// Any bytes as a WAV file: samples within -1..1, no longer than asked for at any rate, or refused
// with an InputError of one line.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/audio/wav.h"
#include "textures/base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const moontrace::Wav wav = moontrace::ParseWav(bytes, "a.wav", 0.5);
    const auto mono = moontrace::MonoAt(wav, 48000);
    if (mono.size() > 24001) std::abort();
    for (const float sample : mono) {
      if (!(std::abs(sample) <= 1)) std::abort();
    }
  } catch (const moontrace::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}

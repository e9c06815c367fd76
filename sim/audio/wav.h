#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// Sound as it stands in a WAV file.
struct Wav {
  double rate = 0;             ///< [Hz]
  std::size_t channels = 1;    ///< 1 or 2
  std::vector<float> samples;  ///< -1 to 1, channels in turn
};

/// Reads a RIFF/WAVE file: whole numbers of 8, 16, 24 or 32 bits or floats of 32, one or two
/// channels, 8 to 192 kHz, at most `longest` seconds. Throws InputError (name, cause, cure).
Wav ParseWav(std::string_view bytes, const std::string& name, double longest);

/// A RIFF/WAVE file of 16 bits; values beyond -1 to 1 are held to that.
std::string WavBytes(const Wav& wav);

/// One channel at `rate`: channels averaged, straight lines between samples.
std::vector<float> MonoAt(const Wav& wav, double rate);

}  // namespace moontrace

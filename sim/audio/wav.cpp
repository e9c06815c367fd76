#include "sim/audio/wav.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr double kSlowest = 8000, kFastest = 192000;  // [Hz]
constexpr std::uint32_t kInteger = 1, kFloat = 3, kExtended = 0xFFFE;

[[noreturn]] void Fail(const std::string& name, const std::string& what) {
  throw InputError(fmt::format("{}: {}", OneLine(name, 300), what));
}

/// A little-endian number; the bytes must be there.
std::uint32_t Number(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

std::string Bytes(std::uint32_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
  return bytes;
}

/// Chunk `id` of a RIFF file, cut where the file ends; empty if there is none.
std::string_view Chunk(std::string_view file, std::string_view id) {
  for (std::size_t at = 12; at + 8 <= file.size();) {
    const std::size_t size = Number(file, at + 4, 4);
    if (file.substr(at, 4) == id) return file.substr(at + 8, size);
    at += 8 + size + size % 2;
  }
  return {};
}

float Sample(std::string_view data, std::size_t at, std::size_t bytes, bool is_float) {
  const std::uint32_t raw = Number(data, at, bytes);
  if (is_float) {
    const float value = std::bit_cast<float>(raw);
    return std::isfinite(value) ? std::clamp(value, -1.0F, 1.0F) : 0.0F;
  }
  if (bytes == 1) return static_cast<float>((static_cast<double>(raw) - 128) / 128);
  const auto high = static_cast<std::int32_t>(raw << (32 - 8 * bytes));  // sign at the top
  return static_cast<float>(high / 2147483648.0);
}

}  // namespace

Wav ParseWav(std::string_view bytes, const std::string& name, double longest) {
  if (bytes.size() < 12 || bytes.substr(0, 4) != "RIFF" || bytes.substr(8, 4) != "WAVE") {
    Fail(name, "is no WAV file; convert the sound to one");
  }
  const std::string_view form = Chunk(bytes, "fmt ");
  if (form.size() < 16) Fail(name, "has no \"fmt \" chunk: the file is cut; write it anew");
  std::uint32_t coding = Number(form, 0, 2);
  if (coding == kExtended && form.size() >= 26) coding = Number(form, 24, 2);
  Wav wav;
  wav.channels = Number(form, 2, 2);
  wav.rate = Number(form, 4, 4);
  const std::uint32_t bits = Number(form, 14, 2);
  const bool good = (coding == kInteger && (bits == 8 || bits == 16 || bits == 24 || bits == 32)) ||
                    (coding == kFloat && bits == 32);
  if (!good) Fail(name, "is coded otherwise than PCM; convert it to PCM of 16 bits");
  if (wav.channels < 1 || wav.channels > 2) Fail(name, "has more than two channels; use one");
  if (wav.rate < kSlowest || wav.rate > kFastest) {
    Fail(name, "has a rate outside 8 to 192 kHz; convert it to 48 kHz");
  }
  const std::string_view data = Chunk(bytes, "data");
  const std::size_t width = bits / 8;
  const std::size_t count = data.size() / (width * wav.channels) * wav.channels;
  if (count == 0) Fail(name, "holds no sound; record it anew");
  if (static_cast<double>(count) > longest * wav.rate * static_cast<double>(wav.channels)) {
    Fail(name, fmt::format("is longer than {:g} s; cut it", longest));
  }
  wav.samples.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    wav.samples.push_back(Sample(data, i * width, width, coding == kFloat));
  }
  return wav;
}

std::string WavBytes(const Wav& wav) {
  const auto rate = static_cast<std::uint32_t>(std::lround(wav.rate));
  const auto channels = static_cast<std::uint32_t>(wav.channels);
  const auto size = static_cast<std::uint32_t>(2 * wav.samples.size());
  std::string bytes = "RIFF" + Bytes(36 + size, 4) + "WAVEfmt " + Bytes(16, 4) +
                      Bytes(kInteger, 2) + Bytes(channels, 2) + Bytes(rate, 4) +
                      Bytes(2 * rate * channels, 4) + Bytes(2 * channels, 2) + Bytes(16, 2) +
                      "data" + Bytes(size, 4);
  bytes.reserve(bytes.size() + size);
  for (const float sample : wav.samples) {
    const double held = std::clamp(static_cast<double>(sample), -1.0, 1.0);
    bytes += Bytes(static_cast<std::uint32_t>(std::lround(32767 * held)), 2);
  }
  return bytes;
}

std::vector<float> MonoAt(const Wav& wav, double rate) {
  const std::size_t frames = wav.samples.size() / wav.channels;
  std::vector<float> mono(frames);
  for (std::size_t i = 0; i < frames; ++i) {
    double sum = 0;
    for (std::size_t c = 0; c < wav.channels; ++c) sum += wav.samples[i * wav.channels + c];
    mono[i] = static_cast<float>(sum / static_cast<double>(wav.channels));
  }
  const auto count =
      static_cast<std::size_t>(std::floor(static_cast<double>(frames) * rate / wav.rate));
  std::vector<float> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i) * wav.rate / rate;
    const std::size_t before = std::min(static_cast<std::size_t>(at), frames - 1);
    const std::size_t after = std::min(before + 1, frames - 1);
    const double share = at - static_cast<double>(before);
    out[i] = static_cast<float>((1 - share) * mono[before] + share * mono[after]);
  }
  return out;
}

}  // namespace moontrace

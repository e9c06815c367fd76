#include "sim/audio/wav.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "textures/base/error.h"

namespace moontrace {
namespace {

/// A file by hand: header of `coding`, `channels`, `bits`, then the data.
std::string File(int coding, int channels, int bits, const std::string& data, int rate = 48000) {
  const auto number = [](int value, int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xFF);
    return bytes;
  };
  const std::string form = number(coding, 2) + number(channels, 2) + number(rate, 4) +
                           number(rate * channels * bits / 8, 4) + number(channels * bits / 8, 2) +
                           number(bits, 2);
  return "RIFF" + number(static_cast<int>(36 + data.size()), 4) + "WAVE" + "fmt " + number(16, 4) +
         form + "LIST" + number(3, 4) + "abc" + std::string(1, '\0') +  // padded
         "data" + number(static_cast<int>(data.size()), 4) + data;
}

std::string WhyNot(const std::string& bytes) {
  try {
    ParseWav(bytes, "a.wav", 0.5);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Wav, ReadsEveryWidthOfSample) {
  using namespace std::string_literals;
  const std::vector<float> expected = {0, 0.5F, -1};
  EXPECT_EQ(ParseWav(File(1, 1, 8, "\x80\xC0\x00"s), "", 1).samples, expected);
  EXPECT_EQ(ParseWav(File(1, 1, 16, "\x00\x00\x00\x40\x00\x80"s), "", 1).samples, expected);
  EXPECT_EQ(ParseWav(File(1, 1, 24, "\0\0\0\0\0\x40\0\0\x80"s), "", 1).samples, expected);
  EXPECT_EQ(ParseWav(File(1, 1, 32, "\0\0\0\0\0\0\0\x40\0\0\0\x80"s), "", 1).samples, expected);
  // floats: 0, 0.5 = 3F000000, -1 = BF800000; what is no number is silence
  EXPECT_EQ(ParseWav(File(3, 1, 32, "\0\0\0\0\0\0\0\x3F\0\0\x80\xBF"s), "", 1).samples, expected);
  EXPECT_EQ(ParseWav(File(3, 1, 32, "\0\0\xC0\x7F"s), "", 1).samples, std::vector<float>{0});
}

TEST(Wav, WrittenReadsBack) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> loud(-1, 1);
  Wav wav{44100, 2, {}};
  for (int i = 0; i < 2000; ++i) wav.samples.push_back(loud(random));
  const Wav back = ParseWav(WavBytes(wav), "", 1);
  EXPECT_EQ(back.rate, 44100);
  EXPECT_EQ(back.channels, 2U);
  ASSERT_EQ(back.samples.size(), wav.samples.size());
  for (std::size_t i = 0; i < wav.samples.size(); ++i) {
    EXPECT_NEAR(back.samples[i], wav.samples[i], 1.6 / 32768);  // rounding, and 32767 for 32768
  }
}

TEST(Wav, BecomesOneChannelAtAnotherRate) {
  Wav wav{8000, 2, {}};
  for (int i = 0; i < 800; ++i) {  // 100 Hz left, silence right
    wav.samples.push_back(static_cast<float>(std::sin(2 * M_PI * 100 * i / 8000)));
    wav.samples.push_back(0);
  }
  const std::vector<float> mono = MonoAt(wav, 48000);
  ASSERT_EQ(mono.size(), 4800U);
  for (std::size_t i = 0; i < 4790; ++i) {
    // straight lines between samples err by at most (w dt)^2 / 8 = 0.0008 of the amplitude
    EXPECT_NEAR(mono[i], 0.5 * std::sin(2 * M_PI * 100 * static_cast<double>(i) / 48000), 0.0005);
  }
}

TEST(Wav, RefusesWhatItCannotUseInOneLine) {
  const std::string data(48000, '\0');
  EXPECT_EQ(WhyNot("hello"), "a.wav: is no WAV file; convert the sound to one");
  EXPECT_EQ(WhyNot(File(1, 1, 16, data)), "");
  EXPECT_EQ(WhyNot(File(1, 1, 16, data + "\1\1")), "a.wav: is longer than 0.5 s; cut it");
  EXPECT_EQ(WhyNot(File(85, 1, 16, data)),
            "a.wav: is coded otherwise than PCM; convert it to PCM of 16 bits");
  EXPECT_EQ(WhyNot(File(1, 6, 16, data)), "a.wav: has more than two channels; use one");
  EXPECT_EQ(WhyNot(File(1, 1, 16, data, 1000)),
            "a.wav: has a rate outside 8 to 192 kHz; convert it to 48 kHz");
  EXPECT_EQ(WhyNot(File(1, 1, 16, "")), "a.wav: holds no sound; record it anew");
  EXPECT_EQ(WhyNot(File(1, 1, 16, data).substr(0, 30)),
            "a.wav: has no \"fmt \" chunk: the file is cut; write it anew");
}

TEST(Wav, TakesAnyBytes) {
  const std::string good = File(1, 2, 16, std::string(4000, '\5'));
  std::mt19937 random(11);
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<std::size_t> place(0, 60), cut(0, good.size());
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = good.substr(0, i % 2 == 0 ? good.size() : cut(random));
    for (int k = 0; k < 3 && bytes.size() > 60; ++k) {
      bytes[place(random)] = static_cast<char>(byte(random));
    }
    try {
      const Wav wav = ParseWav(bytes, "a.wav", 0.5);
      EXPECT_LE(MonoAt(wav, 48000).size(), 24001U);
      for (const float sample : wav.samples) EXPECT_LE(std::abs(sample), 1.0F);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find("a.wav: "), 0U);
    }
  }
}

}  // namespace
}  // namespace moontrace

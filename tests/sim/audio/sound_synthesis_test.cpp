#include "sim/audio/sound_synthesis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "tests/sim/sound_fixture.h"

namespace moontrace {
namespace {

constexpr double kLowest = 150, kHighest = 5000;  // of what an earcon may hold [Hz]

/// Amplitudes at multiples of kSoundRate / 65536, through a Hann window (Cooley and Tukey 1965).
class Spectrum {
 public:
  Spectrum(const std::vector<float>& sound, std::size_t from, std::size_t count) : bins_(kSize) {
    const auto length = static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double window = 0.5 - 0.5 * std::cos(kTurn * static_cast<double>(i) / length);
      bins_[Reversed(i)] = 4 / length * window * static_cast<double>(sound[from + i]);
    }
    for (std::size_t half = 1; half < kSize; half *= 2) {
      const std::complex<double> by =
          std::polar(1.0, -std::numbers::pi / static_cast<double>(half));
      for (std::size_t block = 0; block < kSize; block += 2 * half) {
        std::complex<double> turn = 1;
        for (std::size_t i = block; i < block + half; ++i, turn *= by) {
          const std::complex<double> other = turn * bins_[i + half];
          bins_[i + half] = bins_[i] - other;
          bins_[i] += other;
        }
      }
    }
  }
  double At(double pitch) const {
    return std::abs(bins_[static_cast<std::size_t>(std::lround(pitch / kStep))]);
  }
  static constexpr std::size_t kSize = 65536;
  static constexpr double kStep = kSoundRate / kSize;  ///< [Hz]

 private:
  static std::size_t Reversed(std::size_t i) {
    std::size_t reversed = 0;
    for (std::size_t bit = 1; bit < kSize; bit *= 2) {
      reversed = 2 * reversed + ((i & bit) != 0 ? 1 : 0);
    }
    return reversed;
  }
  std::vector<std::complex<double>> bins_;
};

/// What can be told of an earcon by ear, measured in what is heard.
struct Heard {
  std::size_t notes = 0;
  double pitch = 0;   ///< mean of the notes [octaves above 1 Hz]
  int way = 0;        ///< last note above, level with or below the first: 1, 0, -1
  double length = 0;  ///< [s]
  int timbre = 0;     ///< 0 pure, 1 bell, 2 reed, 3 brass
};

/// Parts between silences of 5 ms.
std::vector<std::pair<std::size_t, std::size_t>> Parts(const std::vector<float>& sound) {
  std::vector<std::pair<std::size_t, std::size_t>> parts;
  std::size_t silent = 10000;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    if (std::abs(sound[i]) < 0.01) {
      ++silent;
      continue;
    }
    if (silent > 240) parts.push_back({i, i});
    parts.back().second = i;
    silent = 0;
  }
  return parts;
}

Heard Listen(const std::vector<float>& sound) {
  Heard heard;
  heard.length = static_cast<double>(sound.size()) / kSoundRate;
  double first = 0, last = 0;
  double even = 0, odd = 0, bell = 0;  // partials at 2, 3 and 2.756 times the pitch
  for (const auto& part : Parts(sound)) {
    const std::size_t count = part.second - part.first;
    const Spectrum spectrum(sound, part.first, count);
    double best = 0, pitch = 0;
    for (double f = 100; f < 6000; f += Spectrum::kStep) {
      if (spectrum.At(f) <= best) continue;
      best = spectrum.At(f);
      pitch = f;
    }
    const auto share = [&](double ratio) { return spectrum.At(ratio * pitch) / best; };
    even = std::max(even, share(2));
    odd = std::max(odd, share(3));
    bell = std::max(bell, share(2.756));
    last = std::log2(pitch);
    if (heard.notes == 0) first = last;
    heard.pitch += last;
    ++heard.notes;
  }
  heard.pitch /= static_cast<double>(heard.notes);
  heard.way = last - first > 0.1 ? 1 : (last - first < -0.1 ? -1 : 0);
  constexpr double kThere = 0.15;  // of the pitch's own amplitude
  heard.timbre = even > kThere ? 3 : (bell > odd && bell > kThere ? 1 : (odd > kThere ? 2 : 0));
  return heard;
}

TEST(Earcons, AreShortAndFadeInAndOut) {
  const SoundTable table = Shipped();
  for (const Earcon earcon : AllEarcons()) {
    const std::vector<float> sound = Render(table, earcon);
    ASSERT_FALSE(sound.empty()) << KeyOf(earcon);
    EXPECT_LT(sound.size(), 0.5 * kSoundRate) << KeyOf(earcon);
    EXPECT_GT(sound.size(), 0.1 * kSoundRate) << KeyOf(earcon);
    EXPECT_LT(std::abs(sound.front()), 1e-3);
    EXPECT_LT(std::abs(sound.back()), 1e-3);
  }
}

TEST(Earcons, LieBetween150HertzAnd5Kilohertz) {
  const SoundTable table = Shipped();
  for (const Earcon earcon : AllEarcons()) {
    const std::vector<float> sound = Render(table, earcon);
    double within = 0, all = 0, best = 0, peak = 0;
    const Spectrum spectrum(sound, 0, sound.size());
    for (double f = 20; f < 20000; f += Spectrum::kStep) {
      const double amplitude = spectrum.At(f);
      all += amplitude * amplitude;
      // a swelling note of some 50 ms is spread over some 40 Hz to both sides
      if (f > kLowest - 40 && f < kHighest + 40) within += amplitude * amplitude;
      if (amplitude > best) {
        best = amplitude;
        peak = f;
      }
    }
    EXPECT_GE(peak, kLowest) << KeyOf(earcon);
    EXPECT_LE(peak, kHighest) << KeyOf(earcon);
    EXPECT_GT(within / all, 0.995) << KeyOf(earcon);
  }
}

TEST(Earcons, DifferByTwoThingsEachFromEachOther) {
  // the rule of sounds.toml: timbre, notes, way, mean pitch by 1.5 octaves, length by half
  const SoundTable table = Shipped();
  std::vector<Heard> heard;
  for (const Earcon earcon : AllEarcons()) heard.push_back(Listen(Render(table, earcon)));
  for (std::size_t a = 0; a < heard.size(); ++a) {
    EXPECT_EQ(heard[a].timbre, static_cast<int>(table.earcons[a].timbre)) << KeyOf(AllEarcons()[a]);
    for (std::size_t b = a + 1; b < heard.size(); ++b) {
      const double lengths = heard[a].length / heard[b].length;
      const int things = (heard[a].timbre != heard[b].timbre) + (heard[a].notes != heard[b].notes) +
                         (heard[a].way != heard[b].way) +
                         (std::abs(heard[a].pitch - heard[b].pitch) >= 1.5) +
                         (std::max(lengths, 1 / lengths) >= 1.5);
      EXPECT_GE(things, 2) << KeyOf(AllEarcons()[a]) << " and " << KeyOf(AllEarcons()[b]);
    }
  }
}

TEST(Earcons, OfARecordingFadeAtItsEnds) {
  EarconSound sound;
  sound.recording.assign(9600, 1.0F);
  sound.volume = 0.5;
  const std::vector<float> out = RenderEarcon(sound);
  ASSERT_EQ(out.size(), 9600U);
  EXPECT_EQ(out.front(), 0);
  EXPECT_LT(out.back(), 1e-3);
  EXPECT_FLOAT_EQ(out[4800], 0.5F);
}

/// A second of the way, frame by frame.
struct Way {
  std::vector<float> left, right;
};
Way Follow(PathVoice voice, double seconds, const std::function<PathSound(double)>& at) {
  Way way;
  const auto count = static_cast<std::size_t>(seconds * kSoundRate);
  for (std::size_t i = 0; i < count; ++i) {
    const PathVoice::Frame frame = voice.Next(at(static_cast<double>(i) / kSoundRate));
    way.left.push_back(frame.left);
    way.right.push_back(frame.right);
  }
  return way;
}

/// Phase, amplitude and mean of the sinusoid of `period` that fits best; values at even times that
/// cover whole periods.
struct Fit {
  double phase = 0, amplitude = 0, mean = 0, residual = 0;
};
Fit FitSinusoid(const std::vector<double>& times, const std::vector<double>& values,
                double period) {
  double c = 0, s = 0, m = 0;
  const auto n = static_cast<double>(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    c += 2 / n * values[i] * std::cos(kTurn * times[i] / period);
    s += 2 / n * values[i] * std::sin(kTurn * times[i] / period);
    m += values[i] / n;
  }
  Fit fit{std::atan2(s, c), std::hypot(c, s), m, 0};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double at = m + fit.amplitude * std::cos(kTurn * times[i] / period - fit.phase);
    fit.residual = std::max(fit.residual, std::abs(values[i] - at));
  }
  return fit;
}

TEST(PathVoice, OfACircleIsPitchAndPanAQuarterTurnApart) {
  constexpr double kPeriod = 2;  // [s]
  const auto circle = [](double t) {
    const double angle = kTurn * t / kPeriod;
    return PathSound{true, 0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle), 0};
  };
  const Way way = Follow(PathVoice(PathTone{}), 2 * kPeriod, circle);
  // windows of 20 ms of the second round: pitch by crossings of zero, pan by loudness
  std::vector<double> times, pitches, pans;
  constexpr std::size_t kWindow = 960;
  for (std::size_t from = static_cast<std::size_t>(kPeriod * kSoundRate);
       from + kWindow <= way.left.size(); from += kWindow) {
    double left = 0, right = 0, first = -1, last = -1;
    int crossings = 0;
    for (std::size_t i = from; i < from + kWindow; ++i) {
      left += way.left[i] * way.left[i];
      right += way.right[i] * way.right[i];
      const double before = way.left[i - 1] + way.right[i - 1];
      const double now = way.left[i] + way.right[i];
      if (before < 0 && now >= 0) {
        last = static_cast<double>(i - 1) + before / (before - now);
        if (crossings++ == 0) first = last;
      }
    }
    times.push_back((static_cast<double>(from) + kWindow / 2.0) / kSoundRate);
    pitches.push_back((crossings - 1) * kSoundRate / (last - first));
    pans.push_back(std::atan2(std::sqrt(right), std::sqrt(left)) * 2 / std::numbers::pi);
  }
  const Fit pitch = FitSinusoid(times, pitches, kPeriod), pan = FitSinusoid(times, pans, kPeriod);
  EXPECT_NEAR(pitch.mean, 300, 1);
  EXPECT_NEAR(pitch.amplitude, 100, 1);
  EXPECT_NEAR(pan.mean, 0.5, 0.005);
  EXPECT_NEAR(pan.amplitude, 0.5, 0.005);
  // y is a quarter behind x; both glide alike
  EXPECT_NEAR((pitch.phase - pan.phase) * 360 / kTurn, 90, 1);
  // the middle of the crossings may lie 4 ms beside the window's: 100 Hz times 4 ms times pi
  EXPECT_LT(pitch.residual, 1.5);
  EXPECT_LT(pan.residual, 0.02);
}

double Loudness(const Way& way, double from, double to) {
  double sum = 0;
  const auto begin = static_cast<std::size_t>(from * kSoundRate);
  const auto end = static_cast<std::size_t>(to * kSoundRate);
  for (std::size_t i = begin; i < end; ++i) {
    sum += way.left[i] * way.left[i] + way.right[i] * way.right[i];
  }
  return std::sqrt(sum / static_cast<double>(end - begin));
}

TEST(PathVoice, IsSilentInTheAir) {
  const Way way = Follow(PathVoice(PathTone{}), 1, [](double t) {
    return PathSound{t < 0.3 || t > 0.6, 0.2, 0.7, 0};
  });
  EXPECT_GT(Loudness(way, 0.1, 0.3), 0.3);
  EXPECT_LT(Loudness(way, 0.4, 0.6), 1e-4);  // ten time constants and more behind the lift
  EXPECT_GT(Loudness(way, 0.7, 1), 0.3);
  const Way never = Follow(PathVoice(PathTone{}), 0.1, [](double) { return PathSound{}; });
  EXPECT_EQ(Loudness(never, 0, 0.1), 0);
}

TEST(PathVoice, TremblesLouderTheFartherOffTheLine) {
  const PathTone tone;
  double before = 0;
  for (const double off : {0.0, 0.25, 0.5, 1.0}) {
    const Way way = Follow(PathVoice(tone), 1, [off](double) {
      return PathSound{true, 0, 0.5, off};
    });
    const double amplitude = AmplitudeAt(way.left, 24000, 24000, tone.off_line_pitch);
    // half of it stays at the pitch, the other half goes to both sides by the trembling
    EXPECT_NEAR(amplitude, 0.5 * off * tone.off_line_volume, 0.01);
    EXPECT_TRUE(off == 0 || amplitude > before);
    before = amplitude;
  }
}

TEST(PathVoice, HoldsWhatIsBeyondItsBoxAndWhatIsNoNumber) {
  const double nan = std::nan("");
  for (const PathSound& wild : {PathSound{true, -5, 9, 99}, PathSound{true, nan, nan, nan},
                                PathSound{true, 1e300, -1e300, 1e300}}) {
    const Way way = Follow(PathVoice(PathTone{}), 0.2, [&wild](double) { return wild; });
    for (std::size_t i = 0; i < way.left.size(); ++i) {
      EXPECT_LE(std::abs(way.left[i]), 1.0F);
      EXPECT_LE(std::abs(way.right[i]), 1.0F);
    }
  }
}

}  // namespace
}  // namespace moontrace

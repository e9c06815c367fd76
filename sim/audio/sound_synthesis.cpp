#include "sim/audio/sound_synthesis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "textures/base/units.h"

namespace moontrace {

namespace {

constexpr double kSwell = 0.005, kDying = 0.008;  // of a note [s]
constexpr double kHighestPartial = 5000;          // [Hz]
constexpr double kGlide = 0.008;                  // time constant [s]
constexpr double kTremble = 25;                   // of the tone off the line [Hz]

const double kGlideShare = 1 - std::exp(-1 / (kGlide * kSoundRate));

struct Partial {
  double ratio;    ///< to the note's pitch
  double loud;     ///< at the note's begin
  double damping;  ///< how fast it dies [1/s]
};

constexpr Partial kPure[] = {{1, 1, 0}};
/// The low partials of a struck bar lie at 1, 2.76 and 5.40 (a free bar's bending modes).
constexpr Partial kBell[] = {{1, 1, 6}, {2.756, 0.6, 10}, {5.404, 0.3, 16}};
constexpr Partial kReed[] = {{1, 1, 0}, {3, 1. / 3, 0}, {5, 1. / 5, 0}, {7, 1. / 7, 0}};
constexpr Partial kBrass[] = {{1, 1, 0},    {2, 0.7, 0},  {3, 0.5, 0},
                              {4, 0.35, 0}, {5, 0.25, 0}, {6, 0.2, 0}};

struct Partials {
  const Partial* begin;
  std::size_t count;
};

Partials PartialsOf(Timbre timbre) {
  switch (timbre) {
    case Timbre::kPure:
      return {kPure, std::size(kPure)};
    case Timbre::kBell:
      return {kBell, std::size(kBell)};
    case Timbre::kReed:
      return {kReed, std::size(kReed)};
    case Timbre::kBrass:
      return {kBrass, std::size(kBrass)};
  }
  return {kPure, std::size(kPure)};
}

/// 0 to 1, with a level beginning and end.
double Rise(double share) {
  return share >= 1 ? 1 : (share <= 0 ? 0 : 0.5 - 0.5 * std::cos(std::numbers::pi * share));
}

/// The swelling and dying of what lasts `length` seconds, at `t`.
double Envelope(double t, double length) { return Rise(t / kSwell) * Rise((length - t) / kDying); }

/// Adds a note at its place.
void RenderNote(const Note& note, Timbre timbre, double volume, std::size_t from,
                std::vector<float>& out) {
  const Partials partials = PartialsOf(timbre);
  double all = 0;
  for (std::size_t k = 0; k < partials.count; ++k) {
    if (partials.begin[k].ratio * note.pitch <= kHighestPartial) all += partials.begin[k].loud;
  }
  const auto frames = static_cast<std::size_t>(std::lround(note.length * kSoundRate));
  for (std::size_t i = 0; i < frames && from + i < out.size(); ++i) {
    const double t = static_cast<double>(i) / kSoundRate;
    double sum = 0;
    for (std::size_t k = 0; k < partials.count; ++k) {
      const Partial& partial = partials.begin[k];
      const double pitch = partial.ratio * note.pitch;
      if (pitch > kHighestPartial) continue;
      sum += partial.loud * std::exp(-partial.damping * t) * std::sin(kTurn * pitch * t);
    }
    out[from + i] = static_cast<float>(volume * Envelope(t, note.length) * sum / all);
  }
}

}  // namespace

std::vector<float> RenderEarcon(const EarconSound& sound) {
  if (!sound.recording.empty()) {
    std::vector<float> out = sound.recording;
    const double length = static_cast<double>(out.size()) / kSoundRate;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double faded = Envelope(static_cast<double>(i) / kSoundRate, length);
      out[i] = static_cast<float>(sound.volume * faded * out[i]);
    }
    return out;
  }
  double length = 0;
  for (const Note& note : sound.notes) length += note.length;
  std::vector<float> out(static_cast<std::size_t>(std::lround(length * kSoundRate)));
  double begin = 0;
  for (const Note& note : sound.notes) {
    const auto from = static_cast<std::size_t>(std::lround(begin * kSoundRate));
    if (note.pitch > 0) RenderNote(note, sound.timbre, sound.volume, from, out);
    begin += note.length;
  }
  return out;
}

PathVoice::Frame PathVoice::Next(const PathSound& target) noexcept {
  const auto held = [](double value) { return value > 0 ? std::min(value, 1.0) : 0.0; };
  const bool from_silence = loud_ < 1e-4;
  const auto glide = [](double& value, double to) { value += kGlideShare * (to - value); };
  if (target.in_contact) {
    // a new touch sounds from where it is, without a slide from the last one
    x_ = from_silence ? held(target.x) : x_;
    y_ = from_silence ? held(target.y) : y_;
    glide(x_, held(target.x));
    glide(y_, held(target.y));
    glide(off_, held(target.off_line));
  }
  glide(loud_, target.in_contact ? 1 : 0);

  phase_ += (tone_.low + (tone_.high - tone_.low) * y_) / kSoundRate;
  off_phase_ += tone_.off_line_pitch / kSoundRate;
  tremble_ += kTremble / kSoundRate;
  for (double* phase : {&phase_, &off_phase_, &tremble_}) *phase -= std::floor(*phase);
  const double trembling = 0.5 - 0.5 * std::cos(kTurn * tremble_);
  const double sum = tone_.volume * std::sin(kTurn * phase_) +
                     tone_.off_line_volume * off_ * trembling * std::sin(kTurn * off_phase_);
  const double angle = x_ * std::numbers::pi / 2;
  return {static_cast<float>(loud_ * sum * std::cos(angle)),
          static_cast<float>(loud_ * sum * std::sin(angle))};
}

}  // namespace moontrace

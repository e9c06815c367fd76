#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace moontrace {

/// What an output takes its sound from.
class SoundSource {
 public:
  virtual ~SoundSource() = default;
  /// Fills `frames` pairs, left and right, -1 to 1 at kSoundRate. Called by the output's own
  /// thread; neither allocates nor locks.
  virtual void Render(float* frames, std::size_t count) noexcept = 0;
};

/// An open output, that asks its source until it is destroyed.
class SoundOutput {
 public:
  virtual ~SoundOutput() = default;
  /// Whether it still asks.
  virtual bool Alive() noexcept = 0;
};

/// Opens an output for a source that outlives it. Throws LackError.
using OpenSoundOutput = std::function<std::unique_ptr<SoundOutput>(SoundSource& source)>;

/// The system's usual output, by PortAudio. Throws LackError: no library in this build, no output.
std::unique_ptr<SoundOutput> OpenPortAudio(SoundSource& source);

}  // namespace moontrace

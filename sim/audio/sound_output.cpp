#include "sim/audio/sound_output.h"

#include "sim/audio/sound_messages.h"
#include "textures/base/error.h"

#ifdef MOONTRACE_HAVE_PORTAUDIO
#include <dlfcn.h>
#include <portaudio.h>

#include <cstdarg>

#include "sim/audio/sound_table.h"
#endif

namespace moontrace {

#ifdef MOONTRACE_HAVE_PORTAUDIO

namespace {

void IgnoreAlsa(const char*, int, const char*, int, const char*, ...) {}

/// ALSA and JACK, below PortAudio, write what they try to standard error, in the midst of a lesson.
/// Where they are loaded, they are asked to keep it to themselves.
void KeepLibrariesQuiet() {
  using AlsaHandler = void (*)(const char*, int, const char*, int, const char*, ...);
  using AlsaSetter = int (*)(AlsaHandler);
  if (auto* set = reinterpret_cast<AlsaSetter>(dlsym(RTLD_DEFAULT, "snd_lib_error_set_handler"))) {
    set(IgnoreAlsa);
  }
  using JackSetter = void (*)(void (*)(const char*));
  for (const char* name : {"jack_set_error_function", "jack_set_info_function"}) {
    if (auto* set = reinterpret_cast<JackSetter>(dlsym(RTLD_DEFAULT, name))) {
      set([](const char*) {});
    }
  }
}

class PortAudioOutput final : public SoundOutput {
 public:
  explicit PortAudioOutput(SoundSource& source) : source_(source) {
    KeepLibrariesQuiet();
    Require(Pa_Initialize());
    try {
      Open();
    } catch (...) {
      Pa_Terminate();
      throw;
    }
  }
  ~PortAudioOutput() override {
    Pa_AbortStream(stream_);
    Pa_CloseStream(stream_);
    Pa_Terminate();
  }
  bool Alive() noexcept override { return Pa_IsStreamActive(stream_) == 1; }

 private:
  static void Require(PaError error) {
    if (error != paNoError) throw LackError(say::NoSoundOutput(Pa_GetErrorText(error)));
  }

  void Open() {
    PaStreamParameters output{};
    output.device = Pa_GetDefaultOutputDevice();
    if (output.device == paNoDevice) Require(paDeviceUnavailable);
    output.channelCount = 2;
    output.sampleFormat = paFloat32;
    output.suggestedLatency = Pa_GetDeviceInfo(output.device)->defaultLowOutputLatency;
    Require(Pa_OpenStream(&stream_, nullptr, &output, kSoundRate, paFramesPerBufferUnspecified,
                          paNoFlag, &PortAudioOutput::Fill, &source_));
    const PaError started = Pa_StartStream(stream_);
    if (started != paNoError) Pa_CloseStream(stream_);
    Require(started);
  }

  static int Fill(const void*, void* out, unsigned long frames, const PaStreamCallbackTimeInfo*,
                  PaStreamCallbackFlags, void* source) noexcept {
    static_cast<SoundSource*>(source)->Render(static_cast<float*>(out), frames);
    return paContinue;
  }

  SoundSource& source_;
  PaStream* stream_ = nullptr;
};

}  // namespace

std::unique_ptr<SoundOutput> OpenPortAudio(SoundSource& source) {
  return std::make_unique<PortAudioOutput>(source);
}

#else

std::unique_ptr<SoundOutput> OpenPortAudio(SoundSource&) { throw LackError(say::NoSoundLibrary()); }

#endif

}  // namespace moontrace

#include "sim/audio/sound.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "devices/core/mailbox.h"
#include "sim/audio/sound_messages.h"
#include "sim/audio/sound_mixer.h"
#include "sim/loop/spsc_queue.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostWaiting = 64;              // earcons between two calls of the output
constexpr double kStale = 0.25;                       // age of a place that still sounds [s]
constexpr std::chrono::milliseconds kLook{100};       // at the output
constexpr std::chrono::milliseconds kLastWords{500};  // for an output that does not open

}  // namespace

/// Shared with the thread: an output that hangs while it opens is left behind with it.
struct Sound::State final : public SoundSource {
  explicit State(const SoundTable& table) : earcons(kMostWaiting), mixer(table) {}

  void Render(float* frames, std::size_t count) noexcept override {
    if (silence.exchange(false, std::memory_order_relaxed)) {
      mixer.Hush();
      path.in_contact = false;
    }
    Earcon earcon = Earcon::kSafetyStop;
    while (earcons.Pop(earcon)) mixer.Play(earcon);
    age += static_cast<double>(count) / kSoundRate;
    if (places.Take(path)) age = 0;
    if (age > kStale) path.in_contact = false;  // the lesson no longer reports the tip
    mixer.Render(frames, count, path);
  }

  void Run(const OpenSoundOutput& open);
  void GiveUp(std::string why) {
    const std::lock_guard<std::mutex> guard(mutex);
    sentence = std::move(why);
  }

  // To the output's thread, which neither allocates nor locks.
  SpscQueue<Earcon> earcons;
  Mailbox<PathSound> places;
  std::atomic<bool> silence{false};
  Mixer mixer;     ///< the output's
  PathSound path;  ///< the output's
  double age = 0;  ///< of `path` [s]

  std::mutex mutex;
  std::condition_variable wake;
  std::optional<std::string> sentence;
  bool ending = false, ended = false;
  std::atomic<bool> sounding{false};
};

void Sound::State::Run(const OpenSoundOutput& open) {
  try {
    const std::unique_ptr<SoundOutput> output = open(*this);
    sounding = true;
    std::unique_lock<std::mutex> lock(mutex);
    while (!wake.wait_for(lock, kLook, [this] { return ending; })) {
      lock.unlock();
      const bool alive = output->Alive();
      lock.lock();
      if (alive) continue;
      sentence = say::SoundGone();
      break;
    }
    sounding = false;
  } catch (const LackError& error) {
    GiveUp(error.what());
  } catch (const std::exception& error) {
    GiveUp(say::NoSoundOutput(error.what()));
  }
  {
    const std::lock_guard<std::mutex> guard(mutex);
    ended = true;
  }
  wake.notify_all();
}

Sound::Sound(const SoundTable& table, OpenSoundOutput open)
    : state_(std::make_shared<State>(table)) {
  thread_ = std::thread([state = state_, open = std::move(open)] { state->Run(open); });
}

Sound::~Sound() {
  std::unique_lock<std::mutex> lock(state_->mutex);
  state_->ending = true;
  state_->wake.notify_all();
  const bool ended = state_->wake.wait_for(lock, kLastWords, [this] { return state_->ended; });
  lock.unlock();
  if (ended) {
    thread_.join();
  } else {
    thread_.detach();
  }
}

void Sound::Play(Earcon earcon) noexcept { state_->earcons.Push(earcon); }

void Sound::Follow(const PathSound& now) noexcept { state_->places.Put(now); }

void Sound::Silence() noexcept { state_->silence.store(true, std::memory_order_relaxed); }

std::optional<std::string> Sound::TakeSentence() {
  const std::lock_guard<std::mutex> guard(state_->mutex);
  return std::exchange(state_->sentence, std::nullopt);
}

bool Sound::sounding() const { return state_->sounding; }

}  // namespace moontrace

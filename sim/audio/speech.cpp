#include "sim/audio/speech.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include "sim/audio/speech_messages.h"

extern char** environ;

namespace moontrace {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostWaiting = 64;
constexpr std::chrono::milliseconds kLastWords{200};
constexpr std::chrono::seconds kToStart{5};  ///< for a service that is started
constexpr std::chrono::milliseconds kRetry{50};
constexpr std::string_view kUnixSocket = "unix_socket:";

enum class Kind { kSay, kSpell, kCharacter, kRate };

struct Item {
  Kind kind = Kind::kSay;
  Priority priority = Priority::kText;
  std::string text;
  int rate = 0;
};

/// Where the user's service listens: the runtime folder, without one the cache (as glib has it).
std::string UsersAddress() {
  constexpr const char* kEnd = "/speech-dispatcher/speechd.sock";
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  if (const std::string folder = variable("XDG_RUNTIME_DIR"); !folder.empty()) return folder + kEnd;
  const std::string cache = variable("XDG_CACHE_HOME");
  return (cache.empty() ? variable("HOME") + "/.cache" : cache) + kEnd;
}

/// Asks the service to start itself in the background, detached from our streams.
bool BeginService(const std::atomic<bool>& ending) {
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) return false;
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  }
  char name[] = "speech-dispatcher", spawn[] = "--spawn";
  char* const arguments[] = {name, spawn, nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, name, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return false;
  const Clock::time_point until = Clock::now() + kToStart;
  while (!ending && Clock::now() < until) {
    int status = 0;
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended != 0) return ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    std::this_thread::sleep_for(kRetry);
  }
  return false;
}

}  // namespace

struct Speech::State {
  void Run(const SpeechOptions& options);
  bool Begin(Ssip& service, const SpeechOptions& options);
  bool Reach(Ssip& service);
  void Obey(Ssip& service);
  void GiveUp(std::string why);
  void Push(Item item);
  bool Hurries() const { return ending; }

  std::mutex mutex;  ///< never held while the service is waited for
  std::condition_variable wake;
  std::deque<Item> items;
  bool cancel = false;
  std::optional<std::string> sentence;
  bool given_up = false;
  std::atomic<bool> ending{false}, speaking{false};
  std::thread thread;
};

void Speech::State::GiveUp(std::string why) {
  const std::lock_guard<std::mutex> guard(mutex);
  speaking = false;
  given_up = true;
  items.clear();
  sentence = std::move(why);
}

/// Connected, if need be to a service that was started just now.
bool Speech::State::Reach(Ssip& service) {
  const char* given = std::getenv("SPEECHD_ADDRESS");
  if (given != nullptr && *given != '\0') {
    const std::string_view address = given;
    if (address.substr(0, kUnixSocket.size()) == kUnixSocket) {
      return service.Connect(std::string(address.substr(kUnixSocket.size())));
    }
    GiveUp(say::SpeechAddressUnknown(address));
    return false;
  }
  const std::string address = UsersAddress();
  if (service.Connect(address)) return true;
  if (!BeginService(ending)) return false;
  const Clock::time_point until = Clock::now() + kToStart;
  while (!ending && Clock::now() < until) {
    if (service.Connect(address)) return true;
    std::this_thread::sleep_for(kRetry);
  }
  return false;
}

bool Speech::State::Begin(Ssip& service, const SpeechOptions& options) {
  if (!Reach(service)) return false;
  if (!service.Greet(options)) return false;
  speaking = true;
  return true;
}

void Speech::State::Run(const SpeechOptions& options) {
  Ssip service([this] { return Hurries(); });
  if (Begin(service, options)) Obey(service);
  speaking = false;
  service.Leave();
  if (given_up || ending) return;
  switch (service.fault()) {
    case Ssip::Fault::kNone:
    case Ssip::Fault::kNotThere:
      return GiveUp(say::SpeechNotThere());
    case Ssip::Fault::kSilent:
      return GiveUp(say::SpeechSilent());
    case Ssip::Fault::kGone:
      return GiveUp(say::SpeechGone());
    case Ssip::Fault::kRefused:
      return GiveUp(say::SpeechRefused(service.refusal()));
  }
}

/// Hands over what is said until the end, or until the service fails.
void Speech::State::Obey(Ssip& service) {
  Clock::time_point end = Clock::time_point::max();
  while (service.fault() == Ssip::Fault::kNone) {
    Item item;
    bool cancels = false;
    {
      std::unique_lock<std::mutex> lock(mutex);
      wake.wait(lock, [this] { return ending || cancel || !items.empty(); });
      if (ending && end == Clock::time_point::max()) end = Clock::now() + kLastWords;
      cancels = std::exchange(cancel, false);
      if (!cancels && (items.empty() || Clock::now() >= end)) return;
      if (!cancels) {
        item = std::move(items.front());
        items.pop_front();
      }
    }
    if (cancels) {
      service.Cancel();
    } else if (item.kind == Kind::kSay) {
      service.Speak(item.priority, item.text);
    } else if (item.kind == Kind::kSpell) {
      service.Spell(item.text);
    } else if (item.kind == Kind::kCharacter) {
      service.Character(item.text);
    } else {
      service.SetRate(item.rate);
    }
  }
}

/// When there is no room, the oldest goes that is not important.
void Speech::State::Push(Item item) {
  {
    const std::lock_guard<std::mutex> guard(mutex);
    if (given_up) return;
    if (items.size() >= kMostWaiting) {
      const auto oldest = std::find_if(items.begin(), items.end(), [](const Item& waiting) {
        return waiting.priority != Priority::kImportant;
      });
      if (oldest == items.end()) return;
      items.erase(oldest);
    }
    items.push_back(std::move(item));
  }
  wake.notify_one();
}

Speech::Speech(const SpeechOptions& options) : state_(std::make_unique<State>()) {
  state_->thread = std::thread([state = state_.get(), options] { state->Run(options); });
}

Speech::~Speech() {
  {
    const std::lock_guard<std::mutex> guard(state_->mutex);
    state_->ending = true;
  }
  state_->wake.notify_one();
  state_->thread.join();
}

void Speech::Say(Priority priority, std::string_view text) {
  if (!text.empty()) state_->Push({Kind::kSay, priority, std::string(text), 0});
}

void Speech::Spell(std::string_view word) {
  if (!word.empty()) state_->Push({Kind::kSpell, Priority::kText, std::string(word), 0});
}

void Speech::Character(std::string_view character) {
  if (!character.empty()) {
    state_->Push({Kind::kCharacter, Priority::kText, std::string(character), 0});
  }
}

void Speech::Cancel() {
  {
    const std::lock_guard<std::mutex> guard(state_->mutex);
    auto& items = state_->items;
    items.erase(std::remove_if(items.begin(), items.end(),
                               [](const Item& item) {
                                 return item.kind != Kind::kRate &&
                                        item.priority != Priority::kImportant;
                               }),
                items.end());
    state_->cancel = state_->speaking;
  }
  state_->wake.notify_one();
}

void Speech::SetRate(int rate) { state_->Push({Kind::kRate, Priority::kText, {}, rate}); }

std::optional<std::string> Speech::TakeSentence() {
  const std::lock_guard<std::mutex> guard(state_->mutex);
  return std::exchange(state_->sentence, std::nullopt);
}

bool Speech::speaking() const { return state_->speaking; }

}  // namespace moontrace

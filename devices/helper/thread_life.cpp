#include "devices/helper/thread_life.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <ctime>

namespace moontrace {
namespace {

/// The words that a fault marks.
struct Place {
  std::atomic<LifeWord*> word{nullptr};
  std::atomic<::pid_t> process{0};  ///< a copy made by fork has nothing to mark
};
std::array<Place, 8> places;

void Wake(const LifeWord& word) noexcept {
  syscall(SYS_futex, &word.word, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

/// Calls only what a signal handler may.
extern "C" void MarkDying(int signal, siginfo_t* about, void*) {
  const int kept = errno;
  for (const Place& place : places) {
    LifeWord* const word = place.word.load(std::memory_order_acquire);
    if (word == nullptr || place.process.load(std::memory_order_relaxed) != getpid()) continue;
    word->word.fetch_or(FUTEX_OWNER_DIED, std::memory_order_acq_rel);
    Wake(*word);
  }
  errno = kept;
  // The handler is gone by now. A faulty instruction is run again; a signal that was sent is sent
  // again.
  if (about->si_code <= 0) raise(signal);
}

bool HandleFaults() noexcept {
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) != 0 || (before.sa_flags & SA_SIGINFO) != 0 ||
        before.sa_handler != SIG_DFL) {
      continue;  // a sanitizer's, say
    }
    struct sigaction action {};
    action.sa_sigaction = MarkDying;
    action.sa_flags = static_cast<int>(SA_SIGINFO | SA_RESETHAND | SA_ONSTACK);
    sigaction(signal, &action, nullptr);
  }
  return true;
}

void Register(LifeWord& word) noexcept {
  static const bool handles = HandleFaults();
  static_cast<void>(handles);
  for (Place& place : places) {
    LifeWord* none = nullptr;
    if (!place.word.compare_exchange_strong(none, &word)) continue;
    place.process.store(getpid(), std::memory_order_relaxed);
    return;
  }
}

void Unregister(const LifeWord& word) noexcept {
  for (Place& place : places) {
    if (place.word.load(std::memory_order_relaxed) == &word) place.word.store(nullptr);
  }
}

}  // namespace

Life LifeOf(const LifeWord& word) noexcept {
  const std::uint32_t now = word.word.load(std::memory_order_acquire);
  if (now == 0) return Life::kUnborn;
  const bool has_name = (now & FUTEX_TID_MASK) != 0;  // the kernel takes it away
  if ((now & FUTEX_OWNER_DIED) != 0) return has_name ? Life::kDying : Life::kDied;
  return has_name ? Life::kLives : Life::kEnded;
}

Life AwaitEnd(const LifeWord& word, double time) noexcept {
  const double whole = std::floor(std::max(time, 0.0));
  const timespec until = {static_cast<std::time_t>(whole), static_cast<long>((time - whole) * 1e9)};
  for (;;) {
    const std::uint32_t seen = word.word.load(std::memory_order_acquire);
    const Life life = LifeOf(word);
    if (life != Life::kUnborn && life != Life::kLives) return life;
    // The bitset form takes a time of the clock, not a length; anything but a wake-up ends it.
    const long woken = syscall(SYS_futex, &word.word, FUTEX_WAIT_BITSET, seen, &until, nullptr,
                               FUTEX_BITSET_MATCH_ANY);
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    const bool is_over =
        now.tv_sec > until.tv_sec || (now.tv_sec == until.tv_sec && now.tv_nsec >= until.tv_nsec);
    if (woken != 0 && is_over) return LifeOf(word);
  }
}

LifeNote::LifeNote(LifeWord& word) noexcept : word_(word) {
  syscall(SYS_get_robust_list, 0, &before_, &before_size_);
  entry_.next = &head_.list;
  head_.list.next = &entry_;
  // From the entry, which stays private, to the word, which may be shared.
  head_.futex_offset = static_cast<long>(reinterpret_cast<std::intptr_t>(&word_.word) -
                                         reinterpret_cast<std::intptr_t>(&entry_));
  syscall(SYS_set_robust_list, &head_, sizeof head_);
  // The mark of somebody who waits makes the kernel wake it.
  word_.word.store(static_cast<std::uint32_t>(gettid()) | FUTEX_WAITERS, std::memory_order_release);
  Register(word_);
}

LifeNote::~LifeNote() { Close(kDiedWord); }

void LifeNote::Close(std::uint32_t mark) noexcept {
  if (!is_open_) return;
  is_open_ = false;
  Unregister(word_);
  word_.word.store(mark, std::memory_order_release);
  Wake(word_);
  syscall(SYS_set_robust_list, before_, before_size_);
}

}  // namespace moontrace

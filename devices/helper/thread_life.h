#pragma once

#include <linux/futex.h>

#include <atomic>
#include <cstdint>

namespace moontrace {

/// Whether a thread lives, as a word of memory that processes share. The kernel itself marks the
/// word when the thread ends, however it does (robust futexes: Documentation/locking/
/// robust-futex-ABI in the kernel's sources), and before it takes the process' memory apart: that
/// takes tens of milliseconds, and a pidfd, a pipe or a child's end tell only afterwards. Only the
/// process of the thread needs to write the word. Zero bytes are a good start.
struct LifeWord {
  std::atomic<std::uint32_t> word{0};
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free && sizeof(LifeWord) == 4,
              "a futex, valid across processes");

/// kUnborn: no thread has put its name to the word yet. kEnded: it ended as it should. kDied: it
/// ended in any other way, with its process or alone. kDying: its process has taken a fault
/// (SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT) and does nothing of use any more, but its threads may
/// go on for a while: until a core dump is written, for one.
enum class Life { kUnborn, kLives, kEnded, kDying, kDied };

/// Costs a load: for the tick too.
Life LifeOf(const LifeWord& word) noexcept;

/// Waits while the thread is unborn or lives, at most until `time` of the steady clock [s].
Life AwaitEnd(const LifeWord& word, double time) noexcept;

/// Puts the calling thread's name to a word for as long as this lives: on the thread's stack, one
/// at a time. The thread must take no robust mutex of the C library meanwhile. The first one of a
/// process handles the signals of faults, where nobody else does: they mark the words of eight
/// threads as dying, then do what they did before.
class LifeNote {
 public:
  explicit LifeNote(LifeWord& word) noexcept;
  /// Without End before it, others see a death.
  ~LifeNote();
  LifeNote(const LifeNote&) = delete;
  LifeNote& operator=(const LifeNote&) = delete;

  /// What the thread was there for is done: whoever waits may leave.
  void End() noexcept { Close(kEndedWord); }

  static constexpr std::uint32_t kEndedWord = FUTEX_WAITERS;                    ///< of no thread
  static constexpr std::uint32_t kDiedWord = FUTEX_WAITERS | FUTEX_OWNER_DIED;  ///< as the kernel's

 private:
  void Close(std::uint32_t mark) noexcept;

  LifeWord& word_;
  ::robust_list entry_{};
  ::robust_list_head head_{};
  ::robust_list_head* before_ = nullptr;  ///< the C library's
  std::size_t before_size_ = 0;
  bool is_open_ = true;
};

}  // namespace moontrace

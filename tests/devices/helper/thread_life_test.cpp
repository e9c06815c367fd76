#include "devices/helper/thread_life.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <new>
#include <thread>

#include "tests/signal_child.h"

namespace moontrace {
namespace {

double Later(double seconds) {
  return seconds +
         std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A word in memory that a fork shares.
class SharedWord {
 public:
  SharedWord()
      : place_(mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    word_ = new (place_) LifeWord;
  }
  ~SharedWord() { munmap(place_, 4096); }
  SharedWord(const SharedWord&) = delete;
  SharedWord& operator=(const SharedWord&) = delete;
  LifeWord& operator*() const { return *word_; }

 private:
  void* place_;
  LifeWord* word_;
};

/// A process whose one thread puts its name to the word and does `what`.
template <class What>
pid_t ProcessThat(const SharedWord& word, const What& what) {
  const pid_t child = fork();
  if (child == 0) {
    LifeNote note(*word);
    what(note);
    _exit(0);
  }
  while (LifeOf(*word) == Life::kUnborn) std::this_thread::yield();
  return child;
}

TEST(ThreadLife, IsUnbornUntilAThreadPutsItsNameToIt) {
  LifeWord word;
  EXPECT_EQ(LifeOf(word), Life::kUnborn);
  EXPECT_EQ(AwaitEnd(word, Later(0.002)), Life::kUnborn);
  const LifeNote note(word);
  EXPECT_EQ(LifeOf(word), Life::kLives);
  EXPECT_EQ(AwaitEnd(word, Later(0.002)), Life::kLives);
}

TEST(ThreadLife, TellsAnEndFromADeath) {
  LifeWord ended, died;
  std::thread([&] {
    LifeNote note(ended);
    note.End();
  }).join();
  std::thread([&] { LifeNote note(died); }).join();
  EXPECT_EQ(AwaitEnd(ended, Later(20)), Life::kEnded);
  EXPECT_EQ(AwaitEnd(died, Later(20)), Life::kDied);
}

TEST(ThreadLife, OneThreadAfterTheOtherCanPutItsNameToAWord) {
  LifeWord word;
  for (int i = 0; i < 3; ++i) {
    LifeNote note(word);
    EXPECT_EQ(LifeOf(word), Life::kLives);
    note.End();
    EXPECT_EQ(LifeOf(word), Life::kEnded);
  }
}

TEST(ThreadLifeKilled, IsDeathHoweverTheProcessEnds) {
  for (const int signal : {SIGKILL, SIGTERM}) {
    const SharedWord word;
    const pid_t child = ProcessThat(word, [](LifeNote&) {
      for (;;) pause();
    });
    EXPECT_EQ(LifeOf(*word), Life::kLives);
    EXPECT_EQ(SignalChild(child, signal), 0);
    EXPECT_EQ(AwaitEnd(*word, Later(20)), Life::kDied) << signal;
    waitpid(child, nullptr, 0);
  }
  const SharedWord word;
  const pid_t child = ProcessThat(word, [](LifeNote&) {});  // ends without a word
  EXPECT_EQ(AwaitEnd(*word, Later(20)), Life::kDied);
  waitpid(child, nullptr, 0);
}

TEST(ThreadLifeKilled, AFaultIsSeenWhileTheProcessIsStillThere) {
  // The other thread cannot end yet: the kernel waits in the call, as it does in a core dump.
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS}) {
    const SharedWord word;
    const pid_t child = ProcessThat(word, [signal](LifeNote&) {
      if (signal == SIGABRT) std::abort();
      raise(signal);
    });
    Life seen = AwaitEnd(*word, Later(20));
    EXPECT_TRUE(seen == Life::kDying || seen == Life::kDied) << signal;
    int status = 0;
    waitpid(child, &status, 0);
    // It dies of the signal all the same.
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(LifeOf(*word), Life::kDied);
  }
}

TEST(ThreadLifeKilled, ACopyOfTheProcessHasNothingToTell) {
  LifeWord word;
  const LifeNote note(word);
  const pid_t child = fork();
  if (child == 0) std::abort();
  waitpid(child, nullptr, 0);
  EXPECT_EQ(LifeOf(word), Life::kLives);
}

}  // namespace
}  // namespace moontrace

#include "sim/loop/spsc_queue.h"

#include <gtest/gtest.h>

#include <thread>

namespace moontrace {
namespace {

TEST(SpscQueue, GivesInOrderWhatItWasGiven) {
  SpscQueue<int> queue(3);
  for (int i = 0; i < 3; ++i) queue.Push(i);
  int value = -1;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(queue.Pop(value));
    EXPECT_EQ(value, i);
  }
  EXPECT_FALSE(queue.Pop(value));
}

TEST(SpscQueue, DropsAndCountsWhatDoesNotFit) {
  SpscQueue<int> queue(3);  // holds three: the ring has four places, one stays empty
  for (int i = 0; i < 10; ++i) queue.Push(i);
  EXPECT_EQ(queue.dropped(), 7U);
  int value = -1;
  ASSERT_TRUE(queue.Pop(value));
  EXPECT_EQ(value, 0);  // what was there stays
}

TEST(SpscQueue, LosesNothingBetweenThreads) {
  constexpr int kCount = 100000;
  SpscQueue<int> queue(64);
  std::atomic<bool> written{false};
  std::thread writer([&] {
    for (int i = 0; i < kCount; ++i) queue.Push(i);
    written = true;
  });
  int last = -1, taken = 0, value = 0;
  for (bool more = true; more;) {
    more = !written;  // looked at before the queue: nothing comes behind it
    while (queue.Pop(value)) {
      EXPECT_GT(value, last);
      last = value;
      ++taken;
    }
  }
  writer.join();
  EXPECT_EQ(taken + static_cast<int>(queue.dropped()), kCount);
}

}  // namespace
}  // namespace moontrace

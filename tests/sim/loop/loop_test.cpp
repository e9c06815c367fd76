#include "sim/loop/loop.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <glm/vec3.hpp>
#include <system_error>
#include <thread>

#include "devices/core/device_error.h"
#include "tests/sim/loop_fixture.h"

namespace moontrace {
namespace {

/// Starts threads until the one numbered `failing`, from 0; waits with the failure until the page
/// has been felt.
struct FailingStart {
  static std::thread Start(std::function<void()> run) {
    if (started++ < failing) return std::thread(std::move(run));
    while (failing > 0 && log->reads < 500) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  }
  static inline int started = 0, failing = 0;
  static inline const DeviceLog* log = nullptr;
};

/// Waits until `done`; a broken loop ends the test instead of hanging it.
void Await(const std::function<bool()>& done) {
  bool is_done = done();
  for (int i = 0; i < 20000 && !is_done; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    is_done = done();
  }
  ASSERT_TRUE(is_done);
}

std::unique_ptr<Loop> Start(DeviceLog& log, ScriptedDevice::ReadFunction read,
                            DeviceSource source = {}) {
  return std::make_unique<Loop>(Scene::Load("", SceneOptions{}), std::make_unique<TextureField>(),
                                std::make_unique<ScriptedDevice>(log, std::move(read)),
                                std::move(source), DevicePlace{}, LoopOptions{});
}

/// No other page than the first, number 0, was ever felt.
void ExpectFirstPage(Loop& loop) {
  LoopSnapshot snapshot;
  ASSERT_TRUE(loop.TakeSnapshot(snapshot));
  EXPECT_EQ(snapshot.page, 0U);
  LoopEvent event;
  while (loop.TakeEvent(event)) EXPECT_NE(event.kind, LoopEventKind::kPageChanged);
}

TEST(Loop, TicksAndEndsWithZeroForce) {
  DeviceLog log;
  const std::unique_ptr<Loop> loop = Start(log, HoldAt(kPressed));
  Await([&log] { return log.reads > 500; });
  loop->End();
  EXPECT_EQ(log.last(), glm::dvec3(0, 0, 0));
  const LoopReport& report = loop->report();
  EXPECT_EQ(report.ticks, static_cast<std::uint64_t>(log.reads));
  EXPECT_EQ(report.lateness.count(), report.ticks);
  EXPECT_EQ(report.cost.count(), report.ticks);
  EXPECT_GT(report.cost.max(), 0);
  EXPECT_EQ(loop->not_realtime().find('\n'), std::string::npos);
}

TEST(Loop, WithoutAllItsThreadsEndsWithZeroForceAndOneLine) {
  for (int failing = 0; failing < 3; ++failing) {
    DeviceLog log;
    FailingStart::started = 0;
    FailingStart::failing = failing;
    FailingStart::log = &log;
    try {
      const Loop loop(Scene::Load("", SceneOptions{}), std::make_unique<TextureField>(),
                      std::make_unique<ScriptedDevice>(log, HoldAt(kPressed)), {}, DevicePlace{},
                      LoopOptions{}, FailingStart::Start);
      ADD_FAILURE() << "started without thread " << failing;
    } catch (const LackError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    EXPECT_TRUE(log.destroyed);
    EXPECT_EQ(log.last(), glm::dvec3(0, 0, 0));
    ASSERT_FALSE(log.written.empty());
    const bool was_felt = std::any_of(log.written.begin(), log.written.end(),
                                      [](glm::dvec3 f_D) { return f_D != glm::dvec3(0, 0, 0); });
    EXPECT_EQ(was_felt, failing > 0);
  }
}

TEST(Loop, OpensALostDeviceAgain) {
  DeviceLog first, second;
  first.why_lost = "the plug-in hung";
  int tries = 0;
  const std::unique_ptr<Loop> loop = Start(
      first,
      [](int n, DeviceState& state) {
        return n < 300 ? HoldAt(kPressed)(n, state) : DeviceStatus::kLost;
      },
      [&](const std::atomic<bool>&) -> std::unique_ptr<Device> {
        if (++tries == 1) throw DeviceError("not there yet");
        return std::make_unique<ScriptedDevice>(second, HoldAt(kPressed));
      });
  LoopEvent event;
  Await([&] {
    return loop->TakeEvent(event) && event.kind == LoopEventKind::kSafety &&
           event.safety == SafetyEvent::kDeviceLost;
  });
  EXPECT_EQ(loop->WhyGone(), "the plug-in hung");
  Await([&loop] { return loop->WhyLost() == "not there yet"; });
  Await([&second] { return second.reads > 300; });
  loop->End();
  EXPECT_TRUE(first.destroyed);
  EXPECT_EQ(first.last(), glm::dvec3(0, 0, 0));
  EXPECT_EQ(second.written.front(), glm::dvec3(0, 0, 0));
  EXPECT_EQ(tries, 2);
  EXPECT_EQ(loop->WhyLost(), "");
}

TEST(Loop, ADeviceIsLostFromTheFirstUntilItIsOpenedAgain) {
  DeviceLog first, second;
  std::atomic<bool> opens{false};
  const std::unique_ptr<Loop> loop = Start(
      first,
      [](int n, DeviceState& state) {
        return n < 300 ? HoldAt(kPressed)(n, state) : DeviceStatus::kLost;
      },
      [&](const std::atomic<bool>& ending) -> std::unique_ptr<Device> {
        while (!opens && !ending) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return std::make_unique<ScriptedDevice>(second, HoldAt(kPressed));
      });
  EXPECT_FALSE(loop->lost());
  Await([&loop] { return loop->lost(); });
  EXPECT_EQ(loop->WhyLost(), "");  // the first try has not ended
  opens = true;
  Await([&loop] { return !loop->lost(); });
  loop->End();
}

TEST(Loop, ChangesPagesAgainAndAgain) {
  DeviceLog log;
  const std::unique_ptr<Loop> loop = Start(log, HoldAt(kPressed));
  for (std::uint32_t page = 1; page <= 5; ++page) {
    PageChange change;
    change.field = std::make_unique<TextureField>(GrooveAlongY());
    change.page = page;
    loop->ChangePage(std::move(change));  // returns, so the old page is out of use: it is freed
  }
  LoopSnapshot snapshot;
  Await([&] { return loop->TakeSnapshot(snapshot) && snapshot.page == 5; });
}

TEST(Loop, APageThatCannotBeRenderedChangesNothing) {
  DeviceLog log;
  const std::unique_ptr<Loop> loop = Start(log, HoldAt(kPressed));
  PageChange change;
  // a tenth of a micrometre of rounding on a flank of slope 5: too stiff for any sub-steps
  change.field = std::make_unique<TextureField>(GrooveAlongY({0.001, 0.0025, 1e-7}));
  change.page = 7;
  EXPECT_THROW(loop->ChangePage(std::move(change)), InputError);
  const int reads = log.reads;
  Await([&] { return log.reads > reads + 10; });
  ExpectFirstPage(*loop);
}

TEST(Loop, ChangePageReturnsThoughTheLoopHasEnded) {
  DeviceLog log;
  const std::unique_ptr<Loop> loop = Start(log, HoldAt(kPressed));
  Await([&log] { return log.reads > 10; });
  loop->End();
  DeviceLog other;
  PageChange change;
  change.field = std::make_unique<TextureField>();
  change.page = 7;
  change.device = std::make_unique<ScriptedDevice>(other, HoldAt(kPressed));
  loop->ChangePage(std::move(change));  // returns: else this test would hang
  ExpectFirstPage(*loop);
  EXPECT_TRUE(other.destroyed);
  EXPECT_EQ(other.reads, 0);
  EXPECT_FALSE(log.destroyed);
}

TEST(Loop, SnapshotsAreOfOneTick) {
  DeviceLog log;
  const std::unique_ptr<Loop> loop = Start(log, [](int n, DeviceState& state) {
    return HoldAt({0.1 + 1e-6 * (n % 1000), 0.1, -0.001})(n, state);
  });
  std::uint64_t last = 0;
  int taken = 0;
  Await([&] {
    LoopSnapshot snapshot;
    if (!loop->TakeSnapshot(snapshot)) return false;
    EXPECT_GT(snapshot.tick, last);
    EXPECT_EQ(snapshot.tip_P.x, snapshot.device.p_D.x);  // D is W, W is P
    last = snapshot.tick;
    return ++taken > 200;
  });
}

TEST(Loop, SamplesComeInOrderAndNoneIsMissing) {
  DeviceLog log;
  const std::unique_ptr<Loop> loop = Start(log, HoldAt(kPressed));
  std::uint64_t taken = 0;
  double last = -1;
  const auto take = [&] {
    LoopSample sample;
    while (loop->TakeSample(sample)) {
      EXPECT_GT(sample.time, last);
      last = sample.time;
      ++taken;
    }
  };
  Await([&] {
    take();
    return taken > 500;
  });
  loop->End();
  take();
  EXPECT_EQ(taken + loop->report().samples_dropped, loop->report().ticks);
}

TEST(Loop, ASilenceIsSeenAndBeginsAgainFromZero) {
  DeviceLog log;
  std::size_t written = 0;
  const std::unique_ptr<Loop> loop = Start(log, [&](int n, DeviceState& state) {
    if (n == 600) {
      written = log.written.size();
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    return HoldAt(kPressed)(n, state);
  });
  Await([&log] { return log.reads > 620; });
  loop->End();
  // the hanging tick's own command is the first, that of the tick behind it the second
  EXPECT_EQ(log.written.at(written + 1), glm::dvec3(0, 0, 0));
  EXPECT_GE(loop->report().late_loops, 1U);
  EXPECT_GE(loop->report().safety_counts[static_cast<std::size_t>(SafetyEvent::kLateLoop)], 1U);
  EXPECT_GE(loop->report().lost_ticks, 190U);
}

}  // namespace
}  // namespace moontrace

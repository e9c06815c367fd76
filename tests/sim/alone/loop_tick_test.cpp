// The loop's thread allocates nothing and asks the system for nothing but time and sleep while it
// ticks. A filter of system calls (seccomp) is laid upon that very thread by the device it reads;
// every call but the allowed ones raises SIGSYS there, which is counted. malloc and its like are
// counted on the same thread. An executable of its own, since it replaces malloc. Sanitizers
// replace it too and make calls of their own: with them there is nothing to count.

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <glm/vec3.hpp>
#include <thread>

#include "lessons/guide/guidance_path.h"
#include "sim/loop/loop.h"
#include "tests/counted_memory.h"
#include "tests/sim/scene_fixture.h"

#ifdef MOONTRACE_COUNTED_MEMORY

namespace {
thread_local bool watched = false;  ///< this thread ticks
std::atomic<bool> counting{false};
std::atomic<long> allocations{0};
std::atomic<long> calls{0};
std::atomic<int> last_call{-1};

extern "C" void OnForbiddenCall(int, siginfo_t* info, void*) {
  if (!counting) return;
  ++calls;
  last_call = info->si_syscall;
}
}  // namespace

void OnAllocation() noexcept {
  if (watched && counting) ++allocations;
}

namespace moontrace {
namespace {

/// Lays the filter upon the calling thread. Leaving (exit) must stay allowed, and so must the
/// return from the counting handler.
bool Confine() noexcept {
  struct sigaction action = {};
  action.sa_sigaction = OnForbiddenCall;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSYS, &action, nullptr);
  const auto allow = [](unsigned number, unsigned char jump) {
    return sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, number, jump, 0);
  };
  sock_filter filter[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      allow(SYS_clock_nanosleep, 6),
      allow(SYS_futex, 5),
      allow(SYS_clock_gettime, 4),
      allow(SYS_exit, 3),
      allow(SYS_exit_group, 2),
      allow(SYS_rt_sigreturn, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program = {static_cast<unsigned short>(std::size(filter)), filter};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// Goes in and out of contact, across a groove; now and then its reading is broken, or the tip
/// jumps. Confines the loop's thread at the 100th reading.
class ConfiningDevice final : public Device {
 public:
  explicit ConfiningDevice(bool misbehaves) : misbehaves_(misbehaves) {}
  DeviceLimits Limits() const noexcept override { return {}; }
  DeviceStatus Read(DeviceState& state) noexcept override {
    const int n = reads++;
    if (n == 50) {  // a thread's first allocation asks the system for its heap
      allocated = malloc(1);
      free(allocated);
      allocated = nullptr;
    }
    if (n == 100) {
      confined = Confine();
      watched = true;
      counting = true;
    }
    if (misbehaves_ && n == 200) {
      syscall(SYS_getppid);
      allocated = malloc(1);
    }
    if (n % 700 == 699) return DeviceStatus::kNoNewData;
    const double z = n % 1000 == 999 ? NAN : 0.001 * std::sin(0.02 * n) - 0.0005;
    state.p_D = {0.1 + 0.002 * std::sin(0.01 * n) + (n % 900 == 899 ? 0.02 : 0), 0.1, z};
    state.buttons = n % 600 < 100 ? 1U : 0U;
    return DeviceStatus::kOk;
  }
  DeviceStatus Write(glm::dvec3) noexcept override { return DeviceStatus::kOk; }

  std::atomic<int> reads{0};
  std::atomic<bool> confined{false};
  void* volatile allocated = nullptr;

 private:
  bool misbehaves_ = false;
};

/// A push along the way of the device, of each mode in turn.
std::shared_ptr<const GuidancePlan> PlanOf(GuidanceMode mode) {
  IntendedStroke stroke;
  stroke.spine_P = {Line{{0.095, 0.1}, {0.1, 0.1}}, Arc{{0.1, 0.102}, 0.002, -1.5, 3}};
  stroke.width = 0.0014;
  GuidancePlan plan;
  plan.mode = mode;
  plan.gains = GuidanceTable::Shipped().GainsOf(mode, 8);
  plan.path = MakeGuidancePath({stroke, stroke});
  return std::make_shared<const GuidancePlan>(plan);
}

/// Runs a loop for 2600 ticks under the filter, with a push of each mode, two page changes and a
/// stop. False: this system has no such filter.
bool RunConfined(bool misbehaves) {
  allocations = calls = 0;
  auto device = std::make_unique<ConfiningDevice>(misbehaves);
  ConfiningDevice& watched_device = *device;
  Loop loop(Scene::Load("", SceneOptions{}), std::make_unique<TextureField>(GrooveAlongY()),
            std::move(device), {}, DevicePlace{}, LoopOptions{});
  const auto await = [&](int reads) {
    while (watched_device.reads < reads) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  await(300);
  for (const GuidanceMode mode : {GuidanceMode::kAttract, GuidanceMode::kRail, GuidanceMode::kBead,
                                  GuidanceMode::kAmplify, GuidanceMode::kCorridor}) {
    loop.Guide(PlanOf(mode));
    await(watched_device.reads + 60);
  }
  for (std::uint32_t page = 1; page <= 2; ++page) {
    PageChange change;
    change.field = std::make_unique<TextureField>(GrooveAlongY());
    change.page = page;
    change.anchor = PageAnchor{{0.1, 0.1}, {0.1, 0.1}, 1.25};
    change.tilt = 0.1 * page;
    loop.ChangePage(std::move(change));
    loop.Guide(PlanOf(GuidanceMode::kBead));
  }
  loop.Stop();
  await(1600);
  loop.GoOn();
  await(2700);
  counting = false;
  const bool confined = watched_device.confined;
  free(watched_device.allocated);
  return confined;
}

TEST(LoopTickAlone, TheCountersCount) {
  if (!RunConfined(true)) GTEST_SKIP() << "no seccomp filter on this system";
  EXPECT_GE(allocations, 1);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(last_call, SYS_getppid);
}

TEST(LoopTickAlone, AllocatesNothingAndCallsOnlyForSleep) {
  if (!RunConfined(false)) GTEST_SKIP() << "no seccomp filter on this system";
  EXPECT_EQ(allocations, 0);
  EXPECT_EQ(calls, 0) << "system call " << last_call;
}

}  // namespace
}  // namespace moontrace

#else

namespace moontrace {
namespace {
TEST(LoopTickAlone, IsNotCountedUnderSanitizers) { GTEST_SKIP(); }
}  // namespace
}  // namespace moontrace

#endif

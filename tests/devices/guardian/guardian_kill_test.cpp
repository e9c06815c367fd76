// Programs that push are killed and stopped at random instants; what their devices are told, and
// when, is compared with the bounds that devices/guardian/guardian.h promises.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/devices/fake_hid.h"
#include "tests/devices/plugin_fixture.h"
#include "tests/signal_child.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

// From the end to zero [s]. A safety deadline, hence the one kind of test that measures time.
constexpr double kAfterDeath = 0.005;
constexpr double kAfterSilence = 0.025;
/// Where no real-time priority is allowed the system runs guardian and program when it likes.
constexpr double kWithoutPriority = 1;

/// Whether threads of this process may run ahead of ordinary ones.
bool HasPriority() {
  static const bool has = [] {
    bool allowed = false;
    std::thread([&allowed] {
      sched_param parameter{};
      parameter.sched_priority = 1;
      allowed = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) == 0;
    }).join();
    return allowed;
  }();
  return has;
}

/// Kills of each kind of device in the slow tests: forty, or as many as are asked for. The table in
/// the pages is of two hundred.
int Kills() {
  const char* const given = std::getenv("MOONTRACE_KILLS");
  return given != nullptr ? std::max(4, std::atoi(given)) : 40;
}

double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool ComesTrue(const std::function<bool()>& what) {
  const double end = Now() + 20;
  while (!what()) {
    if (Now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

/// How a program ends: two by a signal from outside, two by a fault of its own.
enum class Way : std::size_t { kKilled, kSegmentFault, kAbort, kStopped };
constexpr std::array<const char*, 4> kWays{"killed", "segment fault", "abort", "stopped"};

/// A program that pushes a device, in a process of its own, and ends in some way at a random
/// instant.
class Pusher {
 public:
  Pusher(const std::string& device, Way way, std::mt19937& random) : way_(way) {
    wait_ = std::uniform_int_distribution<int>(0, 40'000)(random);
    int ends[2] = {-1, -1};
    EXPECT_EQ(pipe2(ends, O_CLOEXEC), 0);
    said_ = fdopen(ends[0], "r");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::vector<std::string> words{
        std::filesystem::read_symlink("/proc/self/exe").parent_path() / "push_device",
        SourcePath("devices/profiles"), device};
    if (CrashesItself()) {
      words.emplace_back(way == Way::kAbort ? "abort" : "segv");
      words.push_back(std::to_string(21 + wait_ / 1000));
    }
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    EXPECT_EQ(posix_spawn(&pid_, arguments[0], &actions, nullptr, arguments.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
  }
  ~Pusher() {
    SignalChild(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    std::fclose(said_);
  }
  Pusher(const Pusher&) = delete;
  Pusher& operator=(const Pusher&) = delete;

  /// Waits until it pushes.
  bool Pushes() const {
    const std::string line = Line();
    EXPECT_EQ(line, "pushing\n");
    return line == "pushing\n";
  }
  /// Lets it end in its way; when it did [s].
  double End() const {
    if (CrashesItself()) return std::atof(Line().c_str());
    std::this_thread::sleep_for(std::chrono::microseconds(wait_));
    return Send(way_ == Way::kStopped ? SIGSTOP : SIGKILL);
  }
  /// Sends it a signal; when [s].
  double Send(int signal) const {
    const double now = Now();
    EXPECT_EQ(SignalChild(pid_, signal), 0);
    return now;
  }
  double Bound() const {
    if (!HasPriority()) return kWithoutPriority;
    return way_ == Way::kStopped ? kAfterSilence : kAfterDeath;
  }
  /// Whether a dead one's output is closed by all: nobody holds a pipe of a program that has ended.
  bool PipeIsClosed() const { return way_ == Way::kStopped || Line().empty(); }

 private:
  bool CrashesItself() const { return way_ == Way::kSegmentFault || way_ == Way::kAbort; }
  std::string Line() const {
    char text[256] = {};
    return std::fgets(text, sizeof text, said_) != nullptr ? text : "";
  }

  const Way way_;
  int wait_ = 0;  // before it ends [us]
  ::pid_t pid_ = -1;
  std::FILE* said_ = nullptr;
};

/// Whether a device is commanded to push, after its newest command.
struct Command {
  double time = 0;  ///< steady clock [s]
  bool pushes = false;
};

/// The commands of one emulated device.
std::vector<Command> CommandsOf(const FakeHid& fake, const std::string& name) {
  constexpr int kPidConstant = 5, kPidOperation = 10, kPidStop = 3;
  const double began = FakeHid::Began();
  std::map<int, bool> pid;  // which effects push
  std::vector<Command> commands;
  for (const FakeHid::Line& line : fake.Log("out")) {
    if (line.kind != name || line.bytes.size() < 4) continue;
    const auto& b = line.bytes;
    Command command{began + 1e-3 * line.time, false};
    if (name.rfind("pid", 0) == 0) {
      if (b[0] == kPidConstant) pid[b[1]] = b[2] != 0 || b[3] != 0;
      if (b[0] == kPidOperation && b[2] == kPidStop) pid[b[1]] = false;
      command.pushes = std::ranges::any_of(pid, [](const auto& effect) { return effect.second; });
    } else if (name.rfind("moontrace-raw", 0) == 0) {
      command.pushes = (b[1] & 1) != 0 && std::any_of(b.begin() + 4, b.begin() + 16,
                                                      [](int byte) { return byte != 0; });
    } else {  // an arm
      command.pushes = std::any_of(b.begin(), b.end(), [](int byte) { return byte != 0; });
    }
    commands.push_back(command);
  }
  return commands;
}

/// When the pushing ended for good; nothing if it goes on, or never was.
std::optional<double> EndOf(const std::vector<Command>& commands) {
  std::optional<double> end;
  bool pushed = false;
  for (const Command& command : commands) {
    if (command.pushes) {
      end.reset();
      pushed = true;
    } else if (pushed && !end) {
      end = command.time;
    }
  }
  return end;
}

/// From the end to zero, by the way of ending [ms].
class Latencies {
 public:
  void Add(Way way, std::optional<double> seconds) {
    if (seconds) all_[static_cast<std::size_t>(way)].push_back(1e3 * *seconds);
  }
  std::size_t Count() const {
    return all_[0].size() + all_[1].size() + all_[2].size() + all_[3].size();
  }
  void Print(const std::string& kind) {
    for (std::size_t way = 0; way < all_.size(); ++way) {
      std::vector<double>& all = all_[way];
      if (all.empty()) continue;
      std::ranges::sort(all);
      std::printf("%-14s %-13s %3zu times: zero after %6.2f ms in the median, %6.2f ms at most\n",
                  kind.c_str(), kWays[way], all.size(), all[all.size() / 2], all.back());
    }
  }

 private:
  std::array<std::vector<double>, 4> all_;
};

/// Ends a program and gives the time until its device was told zero for good [s]; nothing if the
/// machine had held the program up for so long that the device was let go of before: that is right,
/// and shows nothing of an end.
std::optional<double> EndOne(Pusher& pusher,
                             const std::function<std::vector<Command>()>& commands) {
  const double ended = pusher.End();
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  std::optional<double> zero;
  EXPECT_TRUE(ComesTrue([&] { return (zero = EndOf(commands())).has_value(); }));
  EXPECT_TRUE(pusher.PipeIsClosed());
  if (!zero || *zero < ended) return std::nullopt;
  EXPECT_LT(*zero - ended, pusher.Bound());
  return *zero - ended;
}

Way WayOf(int i) { return static_cast<Way>(i % 4); }

/// Orphans become the test's own, so that none can hide.
class Orphans {
 public:
  Orphans() { prctl(PR_SET_CHILD_SUBREAPER, 1UL, 0UL, 0UL, 0UL); }
  ~Orphans() { prctl(PR_SET_CHILD_SUBREAPER, 0UL, 0UL, 0UL, 0UL); }
  Orphans(const Orphans&) = delete;
  Orphans& operator=(const Orphans&) = delete;
  /// Whether all children and orphans have ended; collects them.
  static bool HaveEnded() {
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    return errno == ECHILD;
  }
};

class Killing : public testing::Test {
 protected:
  /// Ends `count` programs, `at_once` of them at a time, each with a device of its own of the kind
  /// and each in another way, and checks what became of the devices.
  void EndAll(const std::string& kind, const std::string& device, int count, int at_once) {
    const Orphans orphans;
    Latencies latencies;
    // What was let go of before its end, since the machine held it up, does not count.
    const auto wanted = static_cast<std::size_t>(count);
    for (int done = 0; latencies.Count() < wanted && done < 2 * count; done += at_once) {
      std::string kinds = kind;
      for (int i = 1; i < at_once; ++i) kinds.append(",").append(kind);
      const FakeHid fake(kinds);
      std::vector<std::unique_ptr<Pusher>> pushers;
      for (int i = 0; i < at_once; ++i) {
        pushers.push_back(std::make_unique<Pusher>(Numbered(device, i), WayOf(done + i), random_));
      }
      for (int i = 0; i < at_once; ++i) {
        SCOPED_TRACE(Numbered(device, i) + ", " + kWays[static_cast<std::size_t>(WayOf(done + i))]);
        Pusher& pusher = *pushers[static_cast<std::size_t>(i)];
        ASSERT_TRUE(pusher.Pushes());
        const auto commands = [&] { return CommandsOf(fake, Numbered(kind, i)); };
        latencies.Add(WayOf(done + i), EndOne(pusher, commands));
      }
      pushers.clear();
      ASSERT_TRUE(ComesTrue(Orphans::HaveEnded)) << "a process was left behind";
    }
    latencies.Print(kind);
    EXPECT_GE(latencies.Count(), static_cast<std::size_t>(count)) << "the machine is too busy";
  }

  static std::string Numbered(const std::string& name, int i) {
    return i == 0 ? name : name + "-" + std::to_string(i + 1);
  }

  std::mt19937 random_{20};
};

TEST_F(Killing, LetsGoOfAJoystick) { EndAll("pid", "openffboard", 4, 4); }
TEST_F(Killing, LetsGoOfASelfBuiltDevice) { EndAll("moontrace-raw", "moontrace-raw", 4, 4); }

TEST_F(Killing, GivesTheDeviceBackToAProgramThatGoesOn) {
  const Orphans orphans;
  for (const auto& both :
       {std::pair{"pid", "openffboard"}, std::pair{"moontrace-raw", "moontrace-raw"}}) {
    const char *kind = both.first, *device = both.second;
    const FakeHid fake(kind);
    {
      Pusher pusher(device, Way::kStopped, random_);
      ASSERT_TRUE(pusher.Pushes());
      for (int times = 0; times < 3; ++times) {
        pusher.Send(SIGSTOP);
        ASSERT_TRUE(ComesTrue([&] { return EndOf(CommandsOf(fake, kind)).has_value(); })) << kind;
        pusher.Send(SIGCONT);
        ASSERT_TRUE(ComesTrue([&] { return !EndOf(CommandsOf(fake, kind)).has_value(); })) << kind;
        ASSERT_TRUE(ComesTrue([&] {  // and it is felt
          const auto forces = fake.Log("force");
          return !forces.empty() && forces.back().force[0] > 0.2;
        })) << kind;
      }
    }
    EXPECT_TRUE(ComesTrue(Orphans::HaveEnded));
  }
}

class SlowKilling : public Killing {};

TEST_F(SlowKilling, LetsGoOfAJoystick) { EndAll("pid", "openffboard", Kills(), 5); }
TEST_F(SlowKilling, LetsGoOfASelfBuiltDevice) {
  EndAll("moontrace-raw", "moontrace-raw", Kills(), 5);
}
TEST_F(SlowKilling, LetsGoOfAWoodenHaptics) {
  EndAll("woodenhaptics", "woodenhaptics", Kills(), 5);
}
TEST_F(SlowKilling, LetsGoOfAPolhem) { EndAll("polhem-teensy", "polhem-teensy", Kills(), 5); }

class KillingPlugins : public PluginTest {
 protected:
  void EndAll(int count) {
    const Orphans orphans;
    const std::string times = (folder / "times").string();
    setenv("MOONTRACE_TEST_TIMES", times.c_str(), 1);
    const std::string plugin = "plugin:" + Plugin("none");
    Latencies latencies;
    for (int i = 0; latencies.Count() < static_cast<std::size_t>(count) && i < 2 * count; ++i) {
      SCOPED_TRACE(kWays[static_cast<std::size_t>(WayOf(i))]);
      std::filesystem::remove(times);
      {
        Pusher pusher(plugin, WayOf(i), random_);
        ASSERT_TRUE(pusher.Pushes());
        latencies.Add(WayOf(i), EndOne(pusher, [&] { return Commands(times); }));
      }
      ASSERT_TRUE(ComesTrue(Orphans::HaveEnded)) << "a process was left behind";
    }
    latencies.Print("plug-in");
    EXPECT_GE(latencies.Count(), static_cast<std::size_t>(count)) << "the machine is too busy";
    unsetenv("MOONTRACE_TEST_TIMES");
  }

 private:
  static std::vector<Command> Commands(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<Command> commands;
    double timed[4];  // as tests/devices/plugins/faulty.c writes them
    while (file.read(reinterpret_cast<char*>(timed), sizeof timed)) {
      commands.push_back({timed[0], timed[1] != 0 || timed[2] != 0 || timed[3] != 0});
    }
    return commands;
  }

  std::mt19937 random_{21};
};

TEST_F(KillingPlugins, LetGo) { EndAll(4); }

class SlowKillingPlugins : public KillingPlugins {};

TEST_F(SlowKillingPlugins, LetGo) { EndAll(Kills()); }

}  // namespace
}  // namespace moontrace

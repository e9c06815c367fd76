#include "devices/guardian/guardian.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "devices/core/device_error.h"
#include "devices/hid/raw_device.h"
#include "tests/devices/device_run.h"
#include "tests/devices/fake_hid.h"
#include "tests/signal_child.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

bool ComesTrue(const std::function<bool()>& what) {
  for (int tries = 0; tries < 20000; ++tries) {
    if (what()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

std::unique_ptr<Device> Open() {
  return MakeRawDevice(FindHid(0x16c0, 0x0486),
                       LoadProfile(SourcePath("devices/profiles/moontrace-raw.toml")), 0.001);
}

/// The guardians that this process has started and not yet collected.
std::vector<pid_t> Guardians() {
  std::vector<pid_t> found;
  std::ifstream children("/proc/self/task/" + std::to_string(gettid()) + "/children");
  for (pid_t child = 0; children >> child;) {
    std::ifstream file("/proc/" + std::to_string(child) + "/comm");
    std::string name;
    std::getline(file, name);
    if (name == "moontrace-guard") found.push_back(child);  // the kernel keeps 15 letters
  }
  return found;
}

/// The report of zero force, as raw devices take it.
bool EndsLetGo(const FakeHid& fake) {
  const auto lines = fake.Log("out", kRawOutputNumber);
  return !lines.empty() && (lines.back().bytes.at(1) & 1) == 0;
}

TEST(GuardianProcess, LivesAsLongAsItsDeviceIsOpen) {
  const FakeHid fake("moontrace-raw");
  for (int times = 0; times < 3; ++times) {
    auto device = Open();
    EXPECT_EQ(Guardians().size(), 1u);
    RunDevice(*device, 20, {1, 0, 0});
    device.reset();
    EXPECT_TRUE(Guardians().empty());  // nor is there one that has ended and was not collected
  }
}

TEST(GuardianProcess, HoldsNothingOfTheProgramOpen) {
  int ends[2] = {-1, -1};
  ASSERT_EQ(pipe(ends), 0);  // not closed on exec, as a shell's are
  const FakeHid fake("moontrace-raw");
  const auto device = Open();
  const std::vector<pid_t> guardians = Guardians();
  ASSERT_EQ(guardians.size(), 1u);
  const std::string process = "/proc/" + std::to_string(guardians[0]);
  for (const auto& entry : fs::directory_iterator(process + "/fd")) {
    const std::string file = fs::read_symlink(entry.path()).string();
    EXPECT_TRUE(file == "/dev/null" || file.rfind("/memfd:moontrace-guardian", 0) == 0 ||
                file.rfind("socket:", 0) == 0)  // the emulated device
        << file;
  }
  EXPECT_EQ(fs::read_symlink(process + "/cwd"), "/");
  EXPECT_NE(getsid(guardians[0]), getsid(0));  // beyond Ctrl-C
  close(ends[0]);
  close(ends[1]);
}

TEST(GuardianProcess, IsEndedByNoSignalThatAProgramIsToldToEndBy) {
  const FakeHid fake("moontrace-raw");
  const auto device = Open();
  ASSERT_EQ(Guardians().size(), 1u);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) SignalChild(Guardians()[0], signal);
  const DeviceRun run = RunDevice(*device, 100, {1, 0, 0});
  EXPECT_EQ(run.lost, 0);
  EXPECT_EQ(Guardians().size(), 1u);
}

TEST(GuardianProcess, WithoutItThereIsNoForce) {
  const FakeHid fake("moontrace-raw");
  const auto device = Open();
  RunDevice(*device, 50, {1, 0, 0});
  ASSERT_EQ(Guardians().size(), 1u);
  SignalChild(Guardians()[0], SIGKILL);
  const DeviceRun run = RunDevice(*device, 20000, {1, 0, 0});  // ends when it is lost
  EXPECT_EQ(run.lost, 1);
  EXPECT_EQ(device->WhyLost(), "its guardian process ended");
  EXPECT_TRUE(ComesTrue([&] { return EndsLetGo(fake); }));
}

TEST(GuardianProcess, LetsGoOfAnIdleDeviceOnlyInTheEnd) {
  const FakeHid fake("moontrace-raw");
  auto device = Open();
  RunDevice(*device, 30, {1, 0, 0});
  RunDevice(*device, 30, {0, 0, 0});
  const auto told = fake.Log("out").size();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // silent, with nothing to let go of
  // The program itself repeats its zero for 20 ms, every 5 ms.
  EXPECT_LE(fake.Log("out").size(), told + 6);
}

TEST(GuardianProcess, IsRefusedInOneLineWhereItsDeviceCannotBeOpened) {
  const FakeHid fake("moontrace-raw");
  try {
    const Guardian guardian({"/dev/hidraw-absent", "absent", {{2, 0}}, {}});
    FAIL() << "opened";
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("/dev/hidraw-absent"), std::string::npos)
        << error.what();
  }
  EXPECT_TRUE(Guardians().empty());
}

TEST(GuardianProcess, RefusesToBeStartedByHand) {
  const int status =
      std::system((HelperPath("moontrace-guardian") + " 2>/dev/null </dev/null 3<&-").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

/// A program that pushes, on a terminal of its own, and what can be read there.
class OnTerminal {
 public:
  OnTerminal() {
    pid_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (pid_ != 0) return;
    const std::string program = fs::read_symlink("/proc/self/exe").parent_path() / "push_device";
    execl(program.c_str(), program.c_str(), SourcePath("devices/profiles").c_str(), "moontrace-raw",
          nullptr);
    _exit(1);
  }
  ~OnTerminal() {
    if (!started()) return;
    SignalChild(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    close(terminal_);
  }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  /// Not where /dev/pts is missing, as in a bare chroot.
  bool started() const { return pid_ > 0; }
  bool Says(const std::string& part) {
    fcntl(terminal_, F_SETFL, O_NONBLOCK);
    return ComesTrue([&] {
      char text[512];
      const ssize_t got = read(terminal_, text, sizeof text);
      if (got > 0) said_.append(text, static_cast<std::size_t>(got));
      return said_.find(part) != std::string::npos;
    });
  }
  void Send(int signal) const { SignalChild(pid_, signal); }

 private:
  pid_t pid_ = -1;
  int terminal_ = -1;
  std::string said_;
};

TEST(GuardianKilling, SaysOnTheTerminalWhatItDid) {
  const FakeHid fake("moontrace-raw");
  OnTerminal program;
  if (!program.started()) GTEST_SKIP() << "no pseudo-terminals here: /dev/pts is missing";
  ASSERT_TRUE(program.Says("pushing"));
  program.Send(SIGSTOP);
  EXPECT_TRUE(
      program.Says("Force off while Moontrace hangs or is stopped: moontrace-raw is let go of."));
  program.Send(SIGKILL);
  EXPECT_TRUE(
      program.Says("Force off: Moontrace could not let go of moontrace-raw, so its guardian did."));
}

}  // namespace
}  // namespace moontrace

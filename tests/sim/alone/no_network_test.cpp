// Records, reports and lessons never ask for a network: in a process that the kernel kills at its
// first socket that is not of this machine (seccomp), they go through.
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <functional>

#include "lessons/records/records.h"
#include "tests/sim/learn_fixture.h"

namespace moontrace {
namespace {

#ifdef __x86_64__
constexpr unsigned kArchitecture = AUDIT_ARCH_X86_64;
#else
constexpr unsigned kArchitecture = AUDIT_ARCH_AARCH64;
#endif

/// From now on the process dies by SIGSYS when it asks for a socket other than AF_UNIX.
bool ForbidNetwork() {
  sock_filter filter[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 0, 4),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_socket, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[0])),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AF_UNIX, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{sizeof filter / sizeof filter[0], filter};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

constexpr int kNoFilter = 77;

/// How a process ends that does `work` without a network.
int WithoutNetwork(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) _exit(ForbidNetwork() ? work() : kNoFilter);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

bool Exited(int status, int code) { return WIFEXITED(status) && WEXITSTATUS(status) == code; }

class NoNetwork : public LearnTest {
 protected:
  void SetUp() override {
    if (Exited(WithoutNetwork([] { return 0; }), kNoFilter)) {
      GTEST_SKIP() << "this kernel has no seccomp";
    }
  }

  void ExpectGood(std::vector<std::string> args, const std::string& input = "") {
    args.emplace_back("--records");
    args.push_back(In("records.sqlite"));
    const int status = WithoutNetwork([&] { return RunLine(args, input).code; });
    EXPECT_TRUE(Exited(status, 0)) << args[0] << " " << args[1] << ": " << status;
  }
};

// The guard itself: without it the test could not fail.
TEST_F(NoNetwork, KillsWhoeverAsksForIt) {
  for (const int family : {AF_INET, AF_INET6}) {
    const int status = WithoutNetwork([family] {
      socket(family, SOCK_DGRAM, 0);
      return 0;
    });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGSYS) << status;
  }
  EXPECT_TRUE(
      Exited(WithoutNetwork([] { return socket(AF_UNIX, SOCK_STREAM, 0) < 0 ? 1 : 0; }), 0));
}

TEST_F(NoNetwork, IsAskedForByNoWorkOnRecords) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  {
    Records records = Records::Open(In("records.sqlite"));
    LearnerEntry learner;
    learner.pseudonym = "bat";
    records.AddLearner(learner);
    Trial trial;
    trial.lesson = "01-t-i";
    trial.item = std::string("i");
    trial.time = 1'700'000'000;
    records.Add("bat", "learn-moon", trial);
  }
  ExpectGood({"records", "list"});
  ExpectGood({"records", "export", "bat", "--output", In("bat.json")});
  ExpectGood({"report", "bat"});
  ExpectGood({"report", "bat", "--html", In("bat.html")});
  ExpectGood({"records", "consent", "bat", "yes"});
  ExpectGood({"records", "erase", "bat", "--yes"});
  ExpectGood({"records", "import", In("bat.json")});
}

TEST_F(NoNetwork, IsAskedForByNoLesson) {
  const int status =
      WithoutNetwork([&] { return RunLine(Learn(), "next\nagain\nnext\nquit\n").code; });
  EXPECT_TRUE(Exited(status, 0)) << status;
}

}  // namespace
}  // namespace moontrace

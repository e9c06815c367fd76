#include "sim/session/view_feed.h"

#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "sim/session/view_messages.h"
#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

/// The same as a full disk, for any user, while it lives: no file becomes longer.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

class ViewFeedFrames : public CliTest {};

TEST_F(ViewFeedFrames, ThatCannotBeWrittenAreNotClaimed) {
  for (const bool json : {false, true}) {
    std::vector<std::string> args = {"trace", "i", "--frames", In("f")};
    if (json) args.emplace_back("--json");
    Outcome outcome;
    {
      const FileSizeLimit limit(1000);
      outcome = RunLine(args);
    }
    EXPECT_EQ(outcome.code, exit_code::kLack) << outcome.err;
    if (outcome.err.find(say::FramesNotWhole()) == std::string::npos) return;  // nothing draws here
    EXPECT_TRUE(std::filesystem::is_empty(In("f")));
    if (json) {
      EXPECT_EQ(outcome.Json()["view"]["frames"], 0);
      continue;
    }
    EXPECT_EQ(outcome.out.rfind("Traced: ", 0), 0U) << outcome.out;
    EXPECT_EQ(outcome.out.find(say::FramesIn()), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("View:"), std::string::npos) << outcome.out;
  }
}

}  // namespace
}  // namespace moontrace

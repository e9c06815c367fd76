#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace moontrace {

/// Exit codes of every command (design section 8).
namespace exit_code {
inline constexpr int kGood = 0;
inline constexpr int kFailed = 1;
inline constexpr int kUsage = 2;
inline constexpr int kInput = 3;
inline constexpr int kLack = 4;
inline constexpr int kInterrupted = 130;
inline constexpr int kReaderLeft = 141;
}  // namespace exit_code

/// The command line is wrong: one line; exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The work was done and did not succeed: one line; exit code 1.
class WorkFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Someone asked the program to stop (Ctrl-C); exit code 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// What is said is no longer taken: whoever read it has left (exit code 141, quietly), or it has no
/// room (exit code 4). Work ends as it does when someone asks it to.
class OutputLost : public Interrupted {};

/// Columns to which lines of an output are broken; 0: not at all.
std::size_t TerminalColumns(int file_descriptor);

/// The text interface: plain lines, results on one stream, messages on another. Lines are broken
/// between words to 80 characters, or to what SetColumns says.
class Console {
 public:
  Console(std::istream& in, std::ostream& out, std::ostream& err,
          const std::atomic<bool>* stop = nullptr);

  /// `--json`: no results in words. `--quiet`: no remarks, signs of life and happenings.
  void Set(bool json, bool quiet) {
    json_ = json;
    quiet_ = quiet;
  }

  /// Asked before each line, since a terminal's width may change: 80 where nothing is set, 0 where
  /// lines are not to be broken.
  using Columns = std::function<std::size_t()>;
  void SetColumns(Columns out, Columns err) {
    out_columns_ = std::move(out);
    err_columns_ = std::move(err);
  }

  /// How the program was called, as typed in a shell: lines that name a command line, "moontrace"
  /// and one of `commands`, show it thus, so that it can be typed as it stands. Empty: "moontrace".
  void SetCalled(std::string_view called, std::vector<std::string> commands);

  void Result(std::string_view line);  ///< on stdout, wrapped at words
  void Help(std::string_view lines);   ///< likewise, several lines; with `--json` too
  /// On stdout, wrapped: progress, which is no result. Not with `--quiet`.
  void Happening(std::string_view line) {
    if (!quiet_) Result(line);
  }
  void Path(std::string_view path);    ///< on stdout, alone on its line, never wrapped
  void Remark(std::string_view line);  ///< on stderr, wrapped at words
  /// On stderr, one line however long, broken between words at a terminal only: what a path or a
  /// name may hold to break it is shown as "?".
  void Error(std::string_view line);
  void Json(std::string_view text);  ///< on stdout, as it is, with a line's end

  /// A sign of life on stderr if nothing was said for 30 s.
  void Alive(double done);

  /// Throws Interrupted once a stop was asked for, OutputLost once results can no longer be
  /// written; called between pieces of long work.
  void CheckStop() const;
  /// Whoever read standard output has left, as `| head` does. Not of streams of a test's own.
  bool ReaderLeft() const;

  std::istream& in() { return in_; }
  std::ostream& out() { return out_; }
  const std::atomic<bool>* stop() const { return stop_; }

 private:
  void Spoke();
  std::string AsTyped(std::string_view lines) const;
  std::string Shown(std::string_view lines, const Columns& columns) const;

  std::istream& in_;
  std::ostream& out_;
  std::ostream& err_;
  const std::atomic<bool>* stop_;
  Columns out_columns_, err_columns_;
  std::string called_ = "moontrace";
  std::vector<std::string> commands_;
  bool json_ = false;
  bool quiet_ = false;
  double last_spoke_;  ///< [s], of a clock that never goes back; <chrono> takes long to compile
};

}  // namespace moontrace

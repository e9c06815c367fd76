#include "sim/console/console.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <iostream>

#include "sim/console/line_wrap.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

/// [s]
double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr std::string_view kUsuallyCalled = "moontrace";

bool InWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Whether what was read before belongs to the name that follows, as in "./moontrace".
bool IsGlued(std::string_view before) {
  return !before.empty() && (InWord(before.back()) || std::string_view("/_-.").find(
                                                          before.back()) != std::string_view::npos);
}

bool BeginsWithOneOf(std::string_view text, const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(), [text](const std::string& word) {
    return text.substr(0, word.size()) == word &&
           (text.size() == word.size() || !InWord(text[word.size()]));
  });
}

std::string StillWorking(double done) {
  return fmt::format("Still working: {} percent done.", static_cast<int>(std::floor(100 * done)));
}

}  // namespace

Console::Console(std::istream& in, std::ostream& out, std::ostream& err,
                 const std::atomic<bool>* stop)
    : in_(in), out_(out), err_(err), stop_(stop), last_spoke_(Now()) {}

void Console::Spoke() { last_spoke_ = Now(); }

void Console::SetCalled(std::string_view called, std::vector<std::string> commands) {
  called_ = called.empty() ? std::string(kUsuallyCalled) : OneLine(called, called.size());
  commands_ = std::move(commands);
}

std::string Console::AsTyped(std::string_view lines) const {
  std::string typed;
  std::size_t done = 0;
  for (std::size_t at = 0; (at = lines.find(kUsuallyCalled, at)) != std::string_view::npos;) {
    const std::size_t end = at + kUsuallyCalled.size();
    const std::string_view rest = lines.substr(end);
    const bool is_typed = !IsGlued(lines.substr(0, at)) && !rest.empty() && rest.front() == ' ' &&
                          BeginsWithOneOf(rest.substr(1), commands_);
    if (is_typed) {
      typed.append(lines.substr(done, at - done)).append(called_);
      done = end;
    }
    at = end;
  }
  return typed.append(lines.substr(done));
}

std::string Console::Shown(std::string_view lines, const Columns& columns) const {
  const std::string typed = AsTyped(lines);
  return columns ? Wrapped(typed, columns()) : Wrapped(typed);
}

std::size_t TerminalColumns(int file_descriptor) {
  constexpr std::size_t kUsual = 80, kFewest = 20;
  if (isatty(file_descriptor) == 0) return 0;  // a pipe or a file: whoever reads it breaks it
  winsize size{};
  const bool known = ioctl(file_descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? std::max<std::size_t>(kFewest, size.ws_col) : kUsual;
}

void Console::Result(std::string_view line) {
  if (json_) return;
  out_ << Shown(line, out_columns_);
  Spoke();
}

void Console::Help(std::string_view lines) { out_ << Shown(lines, out_columns_); }

void Console::Path(std::string_view path) {
  if (json_) return;
  out_ << path << '\n';
  Spoke();
}

void Console::Remark(std::string_view line) {
  if (quiet_) return;
  err_ << Shown(line, err_columns_);
  Spoke();
}

void Console::Error(std::string_view line) {
  const std::string whole = AsTyped(OneLine(line, line.size()));
  err_ << (err_columns_ ? Wrapped(whole, err_columns_()) : whole + '\n');
}

void Console::Json(std::string_view text) { out_ << text << '\n'; }

void Console::Alive(double done) {
  if (Now() - last_spoke_ < 30) return;
  out_.flush();
  Remark(StillWorking(done));
  err_.flush();
}

void Console::CheckStop() const {
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) throw Interrupted();
  if (!out_ || ReaderLeft()) throw OutputLost();
}

/// Asked of the pipe, not of errno: a stream does not keep why it failed.
bool Console::ReaderLeft() const {
  if (&out_ != &std::cout) return false;
  pollfd pipe{STDOUT_FILENO, 0, 0};
  return poll(&pipe, 1, 0) > 0 && (pipe.revents & (POLLERR | POLLHUP)) != 0;
}

}  // namespace moontrace

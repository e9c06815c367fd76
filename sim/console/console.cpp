#include "sim/console/console.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
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

std::string Broken(std::string_view lines, const Console::Columns& columns) {
  return columns ? Wrapped(lines, columns()) : Wrapped(lines);
}

std::string StillWorking(double done) {
  return fmt::format("Still working: {} percent done.", static_cast<int>(std::floor(100 * done)));
}

}  // namespace

Console::Console(std::istream& in, std::ostream& out, std::ostream& err,
                 const std::atomic<bool>* stop)
    : in_(in), out_(out), err_(err), stop_(stop), last_spoke_(Now()) {}

void Console::Spoke() { last_spoke_ = Now(); }

std::size_t TerminalColumns(int file_descriptor) {
  constexpr std::size_t kUsual = 80, kFewest = 20;
  if (isatty(file_descriptor) == 0) return 0;  // a pipe or a file: whoever reads it breaks it
  winsize size{};
  const bool known = ioctl(file_descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? std::max<std::size_t>(kFewest, size.ws_col) : kUsual;
}

void Console::Result(std::string_view line) {
  if (json_) return;
  out_ << Broken(line, out_columns_);
  Spoke();
}

void Console::Help(std::string_view lines) { out_ << Broken(lines, out_columns_); }

void Console::Path(std::string_view path) {
  if (json_) return;
  out_ << path << '\n';
  Spoke();
}

void Console::Remark(std::string_view line) {
  if (quiet_) return;
  err_ << Broken(line, err_columns_);
  Spoke();
}

void Console::Error(std::string_view line) {
  const std::string whole = OneLine(line, line.size());
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

#include "sim/console/line_reader.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <iostream>
#include <thread>

namespace moontrace {

namespace {
constexpr std::size_t kLongestLine = 1000;
constexpr int kRestOfKey = 50;  ///< the bytes of a key come within [ms]

/// Where a terminal shows what is typed: on itself, whatever standard output is.
void Echo(const std::string& text) {
  const int flags = fcntl(STDIN_FILENO, F_GETFL);
  const bool writable = flags >= 0 && (flags & O_ACCMODE) == O_RDWR;
  if (text.empty() || (!writable && isatty(STDERR_FILENO) == 0)) return;
  // what cannot be shown is typed all the same
  [[maybe_unused]] const ssize_t written =
      write(writable ? STDIN_FILENO : STDERR_FILENO, text.data(), text.size());
}

}  // namespace

LineReader::LineReader(std::istream& in)
    : in_(in), standard_(&in == &std::cin), editor_(kLongestLine) {
  if (standard_) terminal_ = RawTerminalIfOurs();
  if (terminal_) TakeEarly();
}

/// What was typed before the terminal was the program's.
void LineReader::TakeEarly() {
  char block[4096];  // no terminal holds more
  pollfd wait{STDIN_FILENO, POLLIN, 0};
  if (poll(&wait, 1, 0) <= 0 || (wait.revents & POLLIN) == 0) return;
  const ssize_t count = read(STDIN_FILENO, block, sizeof block);
  if (count > 0) Take({block, static_cast<std::size_t>(count)}, true);
}

std::optional<std::string> LineReader::TakeTyped() {
  if (typed_.empty()) return std::nullopt;
  std::string line = std::move(typed_.front());
  typed_.pop_front();
  return line;
}

void LineReader::Take(std::string_view bytes, bool early) {
  if (!terminal_) {
    begun_.append(bytes);
    return;
  }
  LineEditor::Typed typed = editor_.Take(bytes, early);
  Echo(typed.echo);
  for (std::string& line : typed.lines) typed_.push_back(std::move(line));
  ended_ = typed.ended;
}

std::optional<std::string> LineReader::Whole() {
  std::size_t end = begun_.find('\n');
  if (dropping_) {
    begun_.erase(0, end == std::string::npos ? begun_.size() : end + 1);
    if (end == std::string::npos) return std::nullopt;
    dropping_ = false;
    end = begun_.find('\n');
  }
  if (end == std::string::npos && begun_.size() < kLongestLine) return std::nullopt;
  std::string line = begun_.substr(0, std::min(end, kLongestLine));
  dropping_ = end == std::string::npos;  // its end must not be read as a word
  begun_.erase(0, dropping_ ? begun_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

std::optional<std::string> LineReader::Next(int milliseconds) {
  std::optional<std::string> line = Look(milliseconds);
  given_ = given_ || line.has_value();
  return line;
}

std::optional<std::string> LineReader::Look(int milliseconds) {
  if (std::optional<std::string> line = terminal_ ? TakeTyped() : Whole()) return line;
  if (!standard_ && !ended_) {
    std::string line;
    if (std::getline(in_, line)) begun_ += line + '\n';
    ended_ = !in_;
    if (std::optional<std::string> whole = Whole()) return whole;
  }
  if (ended_ || !standard_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    return std::nullopt;
  }
  const bool holds = editor_.holds();
  pollfd wait{STDIN_FILENO, POLLIN, 0};
  const int ready = poll(&wait, 1, holds ? std::max(milliseconds, kRestOfKey) : milliseconds);
  if (ready == 0 && holds) editor_.ForgetBegun();
  if (ready <= 0 || (wait.revents & (POLLIN | POLLHUP)) == 0) return {};
  char block[512];
  const ssize_t count = read(STDIN_FILENO, block, sizeof block);
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return {};
  if (count > 0) {
    Take({block, static_cast<std::size_t>(count)});
  } else {
    ended_ = true;
    if (!begun_.empty()) begun_ += '\n';
  }
  return terminal_ ? TakeTyped() : Whole();
}

}  // namespace moontrace

#include "sim/console/line_reader.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>

namespace moontrace {

namespace {
constexpr std::size_t kLongestLine = 1000;
}

LineReader::LineReader(std::istream& in) : in_(in), terminal_(&in == &std::cin) {}

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
  if (std::optional<std::string> line = Whole()) return line;
  if (!terminal_ && !ended_) {
    std::string line;
    if (std::getline(in_, line)) begun_ += line + '\n';
    ended_ = !in_;
    if (std::optional<std::string> whole = Whole()) return whole;
  }
  if (ended_ || !terminal_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    return std::nullopt;
  }
  pollfd wait{STDIN_FILENO, POLLIN, 0};
  if (poll(&wait, 1, milliseconds) <= 0 || (wait.revents & (POLLIN | POLLHUP)) == 0) return {};
  char block[512];
  const ssize_t count = read(STDIN_FILENO, block, sizeof block);
  if (count <= 0) {
    ended_ = true;
    if (!begun_.empty()) begun_ += '\n';
    return Whole();
  }
  begun_.append(block, static_cast<std::size_t>(count));
  return Whole();
}

}  // namespace moontrace

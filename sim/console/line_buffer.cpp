#include "sim/console/line_buffer.h"

#include <utility>

namespace moontrace {

void LineBuffer::Feed(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    const bool whole = end != std::string_view::npos;
    const std::string_view part = bytes.substr(0, whole ? end : bytes.size());
    bytes.remove_prefix(whole ? end + 1 : bytes.size());
    const std::size_t before = begun_.rfind('\n');
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    if (!dropping_ && begun_.size() - begin + part.size() > longest_) {
      begun_.resize(begin);
      dropping_ = dropped_ = true;
    }
    if (!dropping_) begun_.append(part);
    if (!whole) return;
    if (!dropping_) begun_ += '\n';
    dropping_ = false;
  }
}

std::optional<std::string> LineBuffer::Next() {
  const std::size_t end = begun_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = begun_.substr(0, end);
  begun_.erase(0, end + 1);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

bool LineBuffer::TakeDropped() { return std::exchange(dropped_, false); }

}  // namespace moontrace

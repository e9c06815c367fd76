#include "sim/view/view_mailbox.h"

#include <algorithm>
#include <utility>

namespace moontrace {

void TimeLog::Add(double ms) {
  kept_.at(count_++ % kept_.size()) = static_cast<float>(ms);
  slowest_ = std::max(slowest_, ms);
}

double TimeLog::Median() const {
  std::vector<float> times(
      kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(std::min(count_, kept_.size())));
  if (times.empty()) return 0;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

ViewNews ViewMailbox::TakeNews() {
  const std::lock_guard<std::mutex> lock(mutex);
  return std::exchange(news, {});
}

bool ViewMailbox::Stopped() {
  const std::lock_guard<std::mutex> lock(mutex);
  return stop;
}

void ViewMailbox::Fail(const std::string& why) {
  {
    const std::lock_guard<std::mutex> lock(mutex);
    failure = why;
  }
  changed.notify_all();
}

void ViewMailbox::Say(std::string line) {
  const std::lock_guard<std::mutex> lock(mutex);
  lines.push_back(std::move(line));
}

void ViewMailbox::Notice(std::string sentence) {
  const std::lock_guard<std::mutex> lock(mutex);
  notices.push_back(std::move(sentence));
}

std::optional<std::string> ViewMailbox::TakeFrom(std::deque<std::string> ViewMailbox::*texts) {
  const std::lock_guard<std::mutex> lock(mutex);
  std::deque<std::string>& from = this->*texts;
  if (from.empty()) return std::nullopt;
  std::string text = std::move(from.front());
  from.pop_front();
  return text;
}

}  // namespace moontrace

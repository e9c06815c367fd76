#include "sim/console/console.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <istream>
#include <ostream>

#include "sim/console/line_wrap.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

/// [s]
double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string StillWorking(double done) {
  return fmt::format("Still working: {} percent done.", static_cast<int>(std::floor(100 * done)));
}

}  // namespace

Console::Console(std::istream& in, std::ostream& out, std::ostream& err,
                 const std::atomic<bool>* stop)
    : in_(in), out_(out), err_(err), stop_(stop), last_spoke_(Now()) {}

void Console::Spoke() { last_spoke_ = Now(); }

void Console::Result(std::string_view line) {
  if (json_) return;
  out_ << Wrapped(line);
  Spoke();
}

void Console::Path(std::string_view path) {
  if (json_) return;
  out_ << path << '\n';
  Spoke();
}

void Console::Remark(std::string_view line) {
  if (quiet_) return;
  err_ << Wrapped(line);
  Spoke();
}

void Console::Error(std::string_view line) { err_ << OneLine(line, line.size()) << '\n'; }

void Console::Json(std::string_view text) { out_ << text << '\n'; }

void Console::Alive(double done) {
  if (Now() - last_spoke_ < 30) return;
  out_.flush();
  Remark(StillWorking(done));
  err_.flush();
}

void Console::CheckStop() const {
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) throw Interrupted();
}

}  // namespace moontrace

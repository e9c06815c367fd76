#include "sim/library/stepping/mujoco_errors.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>

// What MuJoCo asks first, of this thread alone, before the handlers of the whole program. It has
// them for its binding for Python and declares them in no header.
extern "C" {  // NOLINTBEGIN(readability-identifier-naming)
using MujocoHandler = void (*)(const char*);
[[gnu::weak]] MujocoHandler _mjPRIVATE__get_tls_error_fn();
[[gnu::weak]] void _mjPRIVATE__set_tls_error_fn(MujocoHandler handler);
}  // NOLINTEND(readability-identifier-naming)

namespace moontrace {
namespace {

thread_local std::jmp_buf* way_out = nullptr;
thread_local std::array<char, 300> said{};

void Leave(const char* message) {
  const std::size_t length = std::min(std::strlen(message), said.size() - 1);
  std::copy_n(message, length, said.begin());
  said[length] = '\0';
  std::replace(said.begin(), said.begin() + static_cast<std::ptrdiff_t>(length), '\n', ' ');
  std::longjmp(*way_out, 1);  // NOLINT(cert-err52-cpp,modernize-avoid-setjmp-longjmp)
}

}  // namespace

const char* LastMujocoError() noexcept { return said.data(); }

bool RunMujocoWork(void (*work)(void*), void* context) noexcept {
  if (_mjPRIVATE__set_tls_error_fn == nullptr || _mjPRIVATE__get_tls_error_fn == nullptr) {
    work(context);  // a MuJoCo without them
    return true;
  }
  const MujocoHandler before = _mjPRIVATE__get_tls_error_fn();
  std::jmp_buf here;
  way_out = &here;
  _mjPRIVATE__set_tls_error_fn(Leave);
  const bool whole = setjmp(here) == 0;  // NOLINT(cert-err52-cpp)
  if (whole) work(context);
  _mjPRIVATE__set_tls_error_fn(before);
  return whole;
}

}  // namespace moontrace

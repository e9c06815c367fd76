#include "textures/base/case_fold.h"

#include <utf8proc.h>

#include <cstdlib>
#include <memory>

namespace moontrace {

std::string CaseFolded(std::string_view utf8) {
  const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(utf8.data());
  utf8proc_uint8_t* made = nullptr;
  const auto options =
      static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE | UTF8PROC_CASEFOLD);
  const auto length =
      utf8proc_map(bytes, static_cast<utf8proc_ssize_t>(utf8.size()), &made, options);
  const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> folded(made, &std::free);
  if (length < 0) return std::string(utf8);
  return {reinterpret_cast<const char*>(folded.get()), static_cast<std::size_t>(length)};
}

}  // namespace moontrace

#include "sim/app/guide_messages.h"

#include <fmt/core.h>

namespace moontrace::say {

std::string Guided(GuidanceMode mode, double help, double mean_force, double work) {
  return fmt::format("Push: {}, help {:g}; {:.2f} N on average, {:.1f} mJ done.", NameOf(mode),
                     help, mean_force, 1e3 * work);
}

}  // namespace moontrace::say

#include "sim/app/gallery_messages.h"

#include <fmt/core.h>

#include "sim/wording/words.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string GalleryOutcome(std::size_t drawn, std::size_t missing) {
  const std::string rest = missing == 0 ? "" : fmt::format(", {} missing on this machine", missing);
  return fmt::format("{} with words{}, gathered in:", Counted(drawn, "picture", "pictures"), rest);
}

std::string ExhibitMissing(std::string_view title, std::string_view why) {
  return fmt::format("Not shown: {}; {}.", title, OneLine(why, 200));
}

std::string ExhibitFailed(std::string_view title, std::string_view why) {
  return fmt::format("picture '{}': {}", title, OneLine(why, 200));
}

}  // namespace moontrace::say

#include "sim/app/model_messages.h"

#include <fmt/format.h>

#include "textures/text_file.h"

namespace moontrace::say {

std::string PageMoves(std::string_view geom) {
  return fmt::format("The geom '{}' can move: no force bound holds for it.", OneLine(geom, 60));
}

}  // namespace moontrace::say

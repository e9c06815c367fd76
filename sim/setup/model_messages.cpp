#include "sim/setup/model_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string PageMoves(std::string_view geom) {
  return fmt::format("The geom '{}' can move: no force bound holds for it.", OneLine(geom));
}

std::string PagesOnGeom(std::size_t pages, std::string_view geom) {
  return fmt::format("{} pages: the text does not fit on the geom '{}', one lies on it at a time.",
                     pages, OneLine(geom));
}

std::string GeomIsSmaller(std::string_view geom, const PageSpec& sheet) {
  return fmt::format("--page is larger than the geom '{}': the text is set on its {} by {} mm.",
                     OneLine(geom), Short(kMillimetres * sheet.width, 1),
                     Short(kMillimetres * sheet.height, 1));
}

std::string LabelLacksText(std::string_view model, std::string_view geom) {
  return fmt::format("{}: label on '{}' has no text: write text='...' in it, or give a text", model,
                     OneLine(geom));
}

std::string InLabel(std::string_view model, std::string_view geom, std::string_view error) {
  return fmt::format("{}: label on '{}': {}", model, OneLine(geom), error);
}

}  // namespace moontrace::say

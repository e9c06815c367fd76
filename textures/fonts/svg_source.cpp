#include "textures/fonts/svg_source.h"

#include <algorithm>

#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"
#include "textures/fonts/svg_path.h"

namespace moontrace {

SvgSource::SvgSource(std::string_view svg, const std::string& file_name)
    : text_(svg), file_(file_name) {
  if (svg.size() > kMaxSvgBytes) {
    throw InputError(file_name + ": holds more than 64 MB; simplify the font");
  }
  buffer_ = svg;
  const pugi::xml_parse_result result = document_.load_buffer_inplace(
      buffer_.data(), buffer_.size(), pugi::parse_escapes, pugi::encoding_utf8);
  const bool marked = svg.substr(0, 2) == "\xFF\xFE" || svg.substr(0, 2) == "\xFE\xFF";
  if (result.status == pugi::status_no_document_element && !marked) {
    Fail(0, "no XML in this file; give an SVG 1.1 font");
  }
  RequireUtf8(svg, file_name);
  if (!result) {
    Fail(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
         std::string("broken XML: ") + result.description() + "; give an SVG 1.1 font");
  }
}

void SvgSource::Fail(std::size_t offset, const std::string& problem) const {
  const TextPlace place = PlaceOf(text_, offset);
  throw InputError(file_ + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) +
                   ": " + problem);
}

void SvgSource::Fail(pugi::xml_node node, const std::string& problem) const {
  // pugixml gives the place of the name, behind the "<".
  Fail(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug() - 1, 0)), problem);
}

void SvgSource::Fail(pugi::xml_node node, pugi::xml_attribute attribute, std::size_t inside,
                     const std::string& problem) const {
  const std::ptrdiff_t start = attribute.value() - buffer_.data();
  if (start < 0 || static_cast<std::size_t>(start) > buffer_.size()) Fail(node, problem);
  Fail(static_cast<std::size_t>(start) + inside, problem);
}

std::optional<double> SvgSource::NumberOf(pugi::xml_node node, const char* name) const {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) return std::nullopt;
  const std::string_view text = attribute.value();
  std::size_t offset = 0;
  const std::optional<double> number = ReadSvgNumber(text, offset);
  if (!number || offset != text.size()) {
    Fail(node, attribute, 0,
         std::string(name) + " is '" + OneLine(text, 40) + "'; give a finite number");
  }
  return number;
}

}  // namespace moontrace

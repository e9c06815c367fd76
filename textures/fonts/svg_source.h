#pragma once

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace moontrace {

/// Greatest size of an SVG font file [bytes]: the 9500 characters of Make Me a Hanzi take some 25
/// MB as WriteSvgFont writes them, and 40 MB once fontforge has saved them.
constexpr std::size_t kMaxSvgBytes = std::size_t{64} << 20U;

/// An SVG document, parsed in place, so that every value can be traced to its byte in the file. For
/// the readers of SVG only. External entities are not read.
class SvgSource {
 public:
  /// Keeps a reference to `svg`. Throws InputError (file:line:column, cause, cure): more than 64
  /// MB, not UTF-8, no or broken XML.
  SvgSource(std::string_view svg, const std::string& file_name);

  pugi::xml_node root() const { return document_.document_element(); }

  [[noreturn]] void Fail(std::size_t offset, const std::string& problem) const;
  [[noreturn]] void Fail(pugi::xml_node node, const std::string& problem) const;
  /// `inside` counts bytes from the value's first.
  [[noreturn]] void Fail(pugi::xml_node node, pugi::xml_attribute attribute, std::size_t inside,
                         const std::string& problem) const;

  /// The attribute as a finite number; nothing when it is absent. Throws InputError for others.
  std::optional<double> NumberOf(pugi::xml_node node, const char* name) const;

 private:
  std::string_view text_;
  std::string buffer_;
  std::string file_;
  pugi::xml_document document_;
};

}  // namespace moontrace

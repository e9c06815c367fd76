#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// A file of a book, as its package lists it.
struct EpubItem {
  std::string id;
  std::optional<std::string> path;  ///< within the archive; nothing: the address leaves the book
  std::string address;              ///< as it is written
  std::string media_type;
  std::string fallback;  ///< id of what stands in for it
  std::string properties;
};

/// A chapter in the reading order.
struct EpubSpineItem {
  std::size_t item = 0;  ///< in EpubPackage::items
  bool linear = true;
};

/// What a book says of itself (EPUB 2 and 3, package document).
struct EpubPackage {
  std::string path;  ///< of the package within the archive
  std::vector<std::string> titles, authors;
  std::string language;
  std::vector<EpubItem> items;
  std::vector<EpubSpineItem> spine;
  std::vector<std::string> missing;       ///< ids in the spine that no item has
  std::optional<std::size_t> navigation;  ///< item with the table of contents of EPUB 3
  std::optional<std::size_t> ncx;         ///< that of EPUB 2
};

/// An address in a table of contents, and its words.
struct EpubTarget {
  std::string title;
  int level = 1;
  std::string path;  ///< within the archive; empty: leads nowhere
  std::string id;
  bool group = false;  ///< has no link
};

/// A book's tables of contents and of printed pages.
struct EpubNavigation {
  std::vector<EpubTarget> contents, pages;
};

/// `address` as a path within the archive, as seen from the file `base`: without its part behind
/// "#", which goes to `id`, "%20" decoded. Above the archive's root there is the root again (EPUB
/// reading systems 3.3, 4.1.1), so no address leaves it. Nothing where it is on the web.
std::optional<std::string> ResolvePath(std::string_view base, std::string_view address,
                                       std::string* id = nullptr);

/// The path of the package in META-INF/container.xml; nothing where that is none.
std::optional<std::string> ReadContainer(const std::string& xml);

/// A package without a spine is read in the order of its manifest. Throws InputError (`name`,
/// cause): `xml` is no package, or one without chapters.
EpubPackage ReadPackage(const std::string& xml, const std::string& path, const std::string& name);

/// Paths that META-INF/encryption.xml says are encrypted; fonts that are only obfuscated are not
/// among them.
std::vector<std::string> ReadEncryption(const std::string& xml);

/// Nothing where the XML is not well-formed: then it must not be shown (EPUB 3.3 reading systems).
std::optional<EpubNavigation> ReadNavigation(const std::string& xhtml, const std::string& path);
std::optional<EpubNavigation> ReadNcx(const std::string& xml, const std::string& path);

}  // namespace moontrace

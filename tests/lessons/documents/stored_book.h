#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Zip archives and books made by tests, without a library: entries are stored, not packed
/// (PKWARE's APPNOTE, method 0).
namespace moontrace {

using ZipEntries = std::vector<std::pair<std::string, std::string>>;

inline std::uint32_t Crc32(std::string_view bytes) {
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ (0xEDB88320U & (0U - (crc & 1U)));
  }
  return ~crc;
}

inline void PutWord(std::string& bytes, std::uint32_t value, int size) {
  for (int i = 0; i < size; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

inline std::string StoredZip(const ZipEntries& entries) {
  std::string zip, directory;
  for (const auto& [name, bytes] : entries) {
    const auto size = static_cast<std::uint32_t>(bytes.size());
    const auto length = static_cast<std::uint32_t>(name.size());
    std::string common;
    PutWord(common, 10, 2);    // version needed
    PutWord(common, 0, 4);     // flags, method
    PutWord(common, 0, 2);     // time
    PutWord(common, 0x21, 2);  // 1980-01-01
    PutWord(common, Crc32(bytes), 4);
    PutWord(common, size, 4);
    PutWord(common, size, 4);
    PutWord(common, length, 2);
    PutWord(common, 0, 2);  // extra
    directory += "PK\x01\x02";
    PutWord(directory, 10, 2);
    directory += common;
    PutWord(directory, 0, 4);  // comment, disk
    PutWord(directory, 0, 2);  // attributes
    PutWord(directory, 0, 4);
    PutWord(directory, static_cast<std::uint32_t>(zip.size()), 4);
    directory += name;
    zip.append("PK\x03\x04").append(common).append(name).append(bytes);
  }
  const auto begin = static_cast<std::uint32_t>(zip.size());
  const auto count = static_cast<std::uint32_t>(entries.size());
  zip += directory + "PK\x05\x06";
  PutWord(zip, 0, 4);
  PutWord(zip, count, 2);
  PutWord(zip, count, 2);
  PutWord(zip, static_cast<std::uint32_t>(directory.size()), 4);
  PutWord(zip, begin, 4);
  PutWord(zip, 0, 2);
  return zip;
}

inline const char* const kContainer =
    "<?xml version='1.0'?><container xmlns='urn:oasis:names:tc:opendocument:xmlns:container'>"
    "<rootfiles><rootfile full-path='OPS/book.opf' media-type='application/oebps-package+xml'/>"
    "</rootfiles></container>";

inline std::string Package(const std::string& manifest, const std::string& spine,
                           const std::string& toc = "") {
  return "<?xml version='1.0'?><package xmlns='http://www.idpf.org/2007/opf' version='3.0'>"
         "<metadata xmlns:dc='http://purl.org/dc/elements/1.1/'><dc:title>Sea &amp; Land</dc:title>"
         "<dc:title>A subtitle</dc:title><dc:creator>A. Sailor</dc:creator>"
         "<dc:language>en</dc:language></metadata><manifest>" +
         manifest + "</manifest><spine" + toc + ">" + spine + "</spine></package>";
}

inline std::string Chapter(const std::string& body, const std::string& doctype = "") {
  return "<?xml version='1.0'?>" + doctype +
         "<html xmlns='http://www.w3.org/1999/xhtml' xmlns:epub='http://www.idpf.org/2007/ops'>"
         "<head><title/></head><body>" +
         body + "</body></html>";
}

/// A book of chapters c0.xhtml, c1.xhtml and so on, in this order.
inline ZipEntries Book(const std::vector<std::string>& chapters) {
  std::string manifest, spine;
  ZipEntries entries = {{"mimetype", "application/epub+zip"},
                        {"META-INF/container.xml", kContainer}};
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    const std::string id = "c" + std::to_string(i);
    manifest.append("<item id='").append(id).append("' href='").append(id);
    manifest += ".xhtml' media-type='application/xhtml+xml'/>";
    spine += "<itemref idref='" + id + "'/>";
    entries.emplace_back("OPS/" + id + ".xhtml", chapters[i]);
  }
  entries.emplace_back("OPS/book.opf", Package(manifest, spine));
  return entries;
}

}  // namespace moontrace

// The files of a book, each behind a line "=== NAME", stored in an archive; bytes that begin as an
// archive does are one. A sound document, or refused in one line.
#include <cstdint>
#include <string_view>

#include "tests/fuzz/sound_document.h"
#include "tests/lessons/documents/stored_book.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.substr(0, 2) == "PK") {
    moontrace::RequireSoundDocument(std::string(bytes), "a.epub");
    return 0;
  }
  moontrace::ZipEntries entries;
  // with a package at the root it is eBraille, which needs none
  if (bytes.find("=== package.opf\n") == std::string_view::npos) {
    entries.emplace_back("META-INF/container.xml", moontrace::kContainer);
  }
  for (std::size_t at = bytes.find("=== "); at != std::string_view::npos;) {
    const std::size_t next = bytes.find("=== ", at + 1);
    const std::string_view part =
        bytes.substr(at + 4, next == std::string_view::npos ? next : next - at - 4);
    const std::size_t line = part.find('\n');
    if (line != std::string_view::npos && line < 1000) {
      entries.emplace_back(std::string(part.substr(0, line)), std::string(part.substr(line + 1)));
    }
    at = next;
  }
  moontrace::RequireSoundDocument(moontrace::StoredZip(entries), "a.epub");
  return 0;
}

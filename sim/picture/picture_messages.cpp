#include "sim/picture/picture_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string_view ReliefWord(const TypeStyle& style) {
  return style.relief == Relief::kEngraved ? "groove" : "ridge";
}

std::string TooManyPictures(std::size_t pages, std::size_t limit) {
  return fmt::format(
      "--picture would write {} files, at most {}: name a .pdf, which holds all pages", pages,
      limit);
}

std::string PagePictureTitle(std::string_view script, std::size_t page, std::size_t pages) {
  if (pages == 1) return fmt::format("A page in {}", script);
  return fmt::format("Page {} of {} in {}", page + 1, pages, script);
}

std::string PagePictureWords(std::size_t signs, std::size_t lines, const TypeStyle& style) {
  return fmt::format("{} in {}, {} mm high, {} {} mm wide.", Counted(signs, "sign", "signs"),
                     Counted(lines, "line", "lines"), Short(kMillimetres * style.size, 2),
                     ReliefWord(style), Short(kMillimetres * style.width, 2));
}

std::string TableTitle(const Script& script) {
  return fmt::format("The signs of {}", OneLine(script.title, 60));
}

std::string TableWords(const Script& script, std::size_t shown) {
  return fmt::format(
      "{} of {}, in rows of eight, each with its name below. A ring marks where a stroke starts. "
      "By {}; licence {}.",
      Counted(shown, "sign", "signs"), OneLine(script.title, 60), OneLine(script.author, 120),
      OneLine(script.licence, 80));
}

}  // namespace moontrace::say

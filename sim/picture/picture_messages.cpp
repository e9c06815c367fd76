#include "sim/picture/picture_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "sim/setup/setup_messages.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

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

std::string TracePictureTitle(std::string_view script, const TypeStyle& style, bool blank) {
  return fmt::format("{} traced, letters {} mm high{}", script, Short(kMillimetres * style.size, 2),
                     blank ? ", on a blank page" : "");
}

std::string TracePictureWords(std::string_view text, const TraceMetrics& total) {
  if (!(total.contact_share > 0)) return fmt::format("Text: {}. Never touched.", OneLine(text));
  return fmt::format("Text: {}. Covered: {}. Mean error: {} mm. Left: {}.", OneLine(text),
                     Percent(total.coverage), Short(kMillimetres * total.mean_error, 3),
                     Times(total.excursions));
}

std::string TracePictureLegend(const TypeStyle& style, bool blank, bool rings) {
  const std::string_view relief = ReliefWord(style);
  const std::string ground = blank ? fmt::format("Dashed grey: where each {} would be.", relief)
                                   : fmt::format("Grey band: the {}, {} mm wide.", relief,
                                                 Short(kMillimetres * style.width, 2));
  return fmt::format("{} Blue line: the tip of the stylus.{}", ground,
                     rings ? " Orange rings: where it left." : "");
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

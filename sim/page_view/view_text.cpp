#include "sim/page_view/view_text.h"

#include <fmt/core.h>

#include <sstream>
#include <utility>

namespace moontrace {

namespace {

/// Within a character of several bytes.
bool IsInner(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80; }

}  // namespace

void DropFirst(std::string& text) {
  std::size_t next = 1;
  while (next < text.size() && IsInner(text[next])) ++next;
  text.erase(0, next);
}

void DropLast(std::string& text) {
  while (text.size() > 1 && IsInner(text.back())) text.pop_back();
  if (!text.empty()) text.pop_back();
}

std::vector<std::string> RowsOf(std::string_view text, int room, std::size_t most,
                                const TextWidthOf& width) {
  std::vector<std::string> rows(1);
  std::istringstream words{std::string(text)};
  std::string word;
  while (words >> word) {
    const std::string longer = rows.back().empty() ? word : fmt::format("{} {}", rows.back(), word);
    if (rows.back().empty() || width(longer) <= room) {
      rows.back() = longer;
    } else if (rows.size() < most) {
      rows.push_back(word);
    } else {
      std::string& last = rows.back();
      while (!last.empty() && width(last + "...") > room) DropLast(last);
      last += "...";
      break;
    }
  }
  return rows;
}

std::vector<std::string> NewestRowsOf(const std::vector<std::string>& texts, int room,
                                      std::size_t most, const TextWidthOf& width) {
  std::string told;
  for (std::size_t i = texts.size(); i-- > 0;) {
    std::string longer = told.empty() ? texts[i] : texts[i] + ' ' + told;
    const bool fits = RowsOf(longer, room, most + 1, width).size() <= most;
    if (!fits && !told.empty()) break;
    told = std::move(longer);
  }
  return RowsOf(told, room, most, width);
}

void WriteText(std::string_view text, int x, int y, int room, bool big, const Color& color,
               Canvas& canvas) {
  std::string fitting(text);
  while (!fitting.empty() && canvas.TextWidth(fitting, big) > room) DropLast(fitting);
  if (!fitting.empty()) canvas.Text(fitting, x, y, big, color);
}

}  // namespace moontrace

#include "sim/view/view_text.h"

#include <fmt/core.h>
#include <mujoco/mujoco.h>

#include <sstream>

namespace moontrace {

std::string AsciiOf(std::string_view text, std::string_view other) {
  std::string ascii;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      ascii += c;
    } else if (byte < 0x80 || byte >= 0xc0) {  // one for each character of several bytes
      ascii += other;
    }
  }
  return ascii;
}

int TextWidth(const std::string& ascii, bool big, const mjrContext_& context) {
  int width = 0;
  for (const char c : ascii) {
    const auto index = static_cast<unsigned char>(c) % 127;
    width += big ? context.charWidthBig[index] : context.charWidth[index];
  }
  return width;
}

std::vector<std::string> RowsOf(const std::string& ascii, int room, std::size_t most,
                                const mjrContext_& context) {
  std::vector<std::string> rows(1);
  std::istringstream words(ascii);
  std::string word;
  while (words >> word) {
    const std::string longer = rows.back().empty() ? word : fmt::format("{} {}", rows.back(), word);
    if (rows.back().empty() || TextWidth(longer, false, context) <= room) {
      rows.back() = longer;
    } else if (rows.size() < most) {
      rows.push_back(word);
    } else {
      std::string& last = rows.back();
      while (!last.empty() && TextWidth(last + "...", false, context) > room) last.pop_back();
      last += "...";
      break;
    }
  }
  return rows;
}

void WriteText(const std::string& ascii, int x, int y, int room, bool big, const Color& color,
               const mjrContext_& context) {
  std::string text = ascii;
  while (!text.empty() && TextWidth(text, big, context) > room) text.pop_back();
  if (text.empty()) return;
  // a label writes in the middle of its rectangle: one that is as wide as the text
  const mjrRect rect = {x, y, TextWidth(text, big, context),
                        big ? context.charHeightBig : context.charHeight};
  mjr_label(rect, big ? mjFONT_BIG : mjFONT_NORMAL, text.c_str(), 0, 0, 0, 0,
            static_cast<float>(color.red), static_cast<float>(color.green),
            static_cast<float>(color.blue), &context);
}

void FillBox(const PixelBox& box, const Color& color) {
  mjr_rectangle({box.x, box.y, box.width, box.height}, static_cast<float>(color.red),
                static_cast<float>(color.green), static_cast<float>(color.blue), 1);
}

void FrameBox(const PixelBox& box, int thick, const Color& color) {
  FillBox({box.x - thick, box.y - thick, box.width + 2 * thick, thick}, color);
  FillBox({box.x - thick, box.y + box.height, box.width + 2 * thick, thick}, color);
  FillBox({box.x - thick, box.y, thick, box.height}, color);
  FillBox({box.x + box.width, box.y, thick, box.height}, color);
}

}  // namespace moontrace

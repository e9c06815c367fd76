#include "sim/picture/drawing.h"

#include <algorithm>
#include <cstddef>

#include "textures/base/text_file.h"

namespace moontrace {

std::vector<TextMark> TextBlock(std::string_view words, glm::dvec2 top_left, double width,
                                double height, Color color) {
  const auto room = static_cast<std::size_t>(std::max(1.0, width / (0.75 * height)));
  std::vector<TextMark> lines;
  std::string line;
  const auto end_line = [&] {
    const double down = height * (1.0 + 1.7 * static_cast<double>(lines.size()));
    lines.push_back({{top_left.x, top_left.y - down}, height, line, color});
    line.clear();
  };
  while (!words.empty()) {
    const std::size_t space = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, space);
    words.remove_prefix(std::min(space + 1, words.size()));
    if (word.empty()) continue;
    if (!line.empty() && CountCharacters(line) + 1 + CountCharacters(word) > room) end_line();
    if (!line.empty()) line += ' ';
    line += word;
  }
  if (!line.empty()) end_line();
  return lines;
}

}  // namespace moontrace

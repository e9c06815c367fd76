#include "sim/console/wording.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string Counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string Times(std::size_t count) {
  if (count == 0) return "never";
  return count == 1 ? "once" : fmt::format("{} times", count);
}

std::string Joined(const std::vector<std::string>& words, std::string_view last) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 == words.size() ? std::string(last) : ", ";
    list += words[i];
  }
  return list;
}

std::string Short(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string Plain(double value) {
  if (value == 0 || !std::isfinite(value)) return Short(value, 0);
  const int whole_digits = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  return Short(value, std::clamp(4 - whole_digits, 0, 15));
}

std::string Percent(double share, int decimals) {
  const double parts = std::pow(10, decimals);
  return Short(std::floor(100 * parts * share + 1e-9) / parts, decimals) + " percent";
}

std::string Unbroken(std::string_view text) {
  std::string line(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

std::string Quoted(std::string_view text) { return fmt::format("\"{}\"", OneLine(text)); }

std::string DidYouMean(std::string_view nearest) {
  return nearest.empty() ? std::string() : fmt::format("did you mean {}? ", nearest);
}

std::string NearestListed(std::string_view word, std::string_view list) {
  std::vector<std::string> words(1);
  for (const char c : list) {
    if (c != ' ' && c != ',') {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  words.erase(std::remove_if(words.begin(), words.end(),
                             [](const std::string& w) { return w == "or" || w.size() < 2; }),
              words.end());
  return NearestWord(word, words);
}

}  // namespace moontrace::say

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// MathML as one line of text: fractions as a/b, powers as a^b, indices as a_b, roots by their
/// sign, what has several parts in parentheses. Rows of a matrix are apart by "; ".
class MathText {
 public:
  void Open(std::string_view name);
  void Text(std::string_view utf8);
  void Close();
  const std::string& text() const { return text_; }

 private:
  struct Element {
    std::string name;
    int children = 0;
    bool bracket = false;   // a parenthesis closes behind it, if it has several parts
    std::size_t begin = 0;  // of its text
    int leaves = 0;         // numbers, names and operators in it
  };
  bool InLeaf() const;
  std::vector<Element> open_;
  std::string text_;
};

}  // namespace moontrace

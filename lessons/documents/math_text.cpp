#include "lessons/documents/math_text.h"

#include <algorithm>

namespace moontrace {
namespace {

bool IsLeaf(std::string_view name) {
  return name == "mi" || name == "mn" || name == "mo" || name == "mtext" || name == "ms";
}

/// What stands before the child of that number, from 0; for parts that are read as one thing.
std::string_view Before(std::string_view parent, int child) {
  if (parent == "mfrac") return child == 1 ? "/" : "";
  if (parent == "msup" || parent == "mover") return child == 1 ? "^" : "";
  if (parent == "msub" || parent == "munder") return child == 1 ? "_" : "";
  if (parent == "msubsup" || parent == "munderover")
    return child == 1 ? "_" : child == 2 ? "^" : "";
  if (parent == "mroot") return child == 1 ? "^1/" : "";
  if (parent == "mtable") return child > 0 ? "; " : "";
  if (parent == "mtr") return child > 0 ? ", " : "";
  return "";
}

bool HasParts(std::string_view name) {
  return name == "mfrac" || name == "msup" || name == "msub" || name == "msubsup" ||
         name == "mover" || name == "munder" || name == "munderover" || name == "mroot";
}

}  // namespace

bool MathText::InLeaf() const {
  return std::any_of(open_.begin(), open_.end(),
                     [](const Element& element) { return IsLeaf(element.name); });
}

void MathText::Open(std::string_view name) {
  Element element{std::string(name), 0, false};
  if (!open_.empty()) {
    Element& parent = open_.back();
    text_ += Before(parent.name, parent.children);
    element.bracket = HasParts(parent.name) && !IsLeaf(name);
    if (parent.name == "msqrt" && parent.children == 0) text_ += "(";
    ++parent.children;
  }
  if (element.bracket) text_ += '(';
  if (name == "msqrt" || name == "mroot") text_ += "\xE2\x88\x9A";
  open_.push_back(std::move(element));
}

void MathText::Text(std::string_view utf8) {
  if (!InLeaf()) return;  // else only blanks stand there
  const std::size_t begin = utf8.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) {
    if (open_.back().name == "mtext") text_ += ' ';
    return;
  }
  if (open_.back().name == "mtext") {
    text_ += utf8;
  } else {
    text_ += utf8.substr(begin, utf8.find_last_not_of(" \t\r\n") - begin + 1);
  }
}

void MathText::Close() {
  if (open_.empty()) return;
  if (open_.back().name == "msqrt" && open_.back().children > 0) text_ += ')';
  if (open_.back().bracket) text_ += ')';
  open_.pop_back();
}

}  // namespace moontrace

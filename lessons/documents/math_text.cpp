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
  if (parent == "mtr" || parent == "mfenced") return child > 0 ? ", " : "";
  if (parent == "mmultiscripts") return child == 0 ? "" : child % 2 == 1 ? "_" : "^";
  return "";
}

bool HasParts(std::string_view name) {
  return name == "mfrac" || name == "msup" || name == "msub" || name == "msubsup" ||
         name == "mmultiscripts" || name == "mover" || name == "munder" || name == "munderover" ||
         name == "mroot";
}

/// Operators without a mark in print (MathML Core, invisible operators), of which a function's is
/// heard as a pause.
bool IsInvisible(std::string_view text) {
  return text == "\xE2\x81\xA1" || text == "\xE2\x81\xA2" || text == "\xE2\x81\xA3" ||
         text == "\xE2\x81\xA4";
}
constexpr std::string_view kOfFunction = "\xE2\x81\xA1";

/// Marks that stand raised by themselves: prime, double prime.
bool IsPrime(std::string_view text) {
  return text == "'" || text == "\xE2\x80\xB2" || text == "\xE2\x80\xB3";
}

/// A script that is left empty, and what parts those behind the base from those before it.
bool IsNone(std::string_view name) { return name == "none" || name == "mprescripts"; }

}  // namespace

bool MathText::InLeaf() const {
  return std::any_of(open_.begin(), open_.end(),
                     [](const Element& element) { return IsLeaf(element.name); });
}

void MathText::Open(std::string_view name) {
  Element element;
  element.name = name;
  if (!open_.empty()) {
    Element& parent = open_.back();
    if (!IsNone(name)) text_ += Before(parent.name, parent.children);
    element.bracket = HasParts(parent.name) && !IsLeaf(name) && !IsNone(name);
    if (parent.name == "msqrt" && parent.children == 0) text_ += "(";
    parent.children = name == "mprescripts" ? 1 : parent.children + 1;
  }
  element.begin = text_.size();
  if (element.bracket || name == "mfenced") text_ += '(';
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
    return;
  }
  const std::string_view sign = utf8.substr(begin, utf8.find_last_not_of(" \t\r\n") - begin + 1);
  if (IsPrime(sign) && text_.ends_with('^')) text_.pop_back();
  if (!IsInvisible(sign)) text_ += sign;
  if (sign == kOfFunction) text_ += ' ';
}

void MathText::Close() {
  if (open_.empty()) return;
  if (open_.back().name == "msqrt" && open_.back().children > 0) text_ += ')';
  if (open_.back().name == "mfenced") text_ += ')';
  const Element element = open_.back();
  const int leaves = element.leaves + (IsLeaf(element.name) ? 1 : 0);
  if (element.bracket && leaves <= 1) {
    text_.erase(element.begin, 1);  // of one sign: it needs none
  } else if (element.bracket) {
    text_ += ')';
  }
  open_.pop_back();
  if (!open_.empty()) open_.back().leaves += leaves;
}

}  // namespace moontrace

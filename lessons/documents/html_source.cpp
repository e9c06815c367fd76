#include "lessons/documents/html_source.h"

#include <algorithm>
#include <array>
#include <vector>

#include "lessons/documents/document.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr std::size_t kDeepest = 400;
constexpr std::size_t kMostAttributes = 60;
constexpr std::size_t kMisplaced = 64;  // elements that an end tag may close with its own
constexpr std::size_t kNone = std::string_view::npos;

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

template <std::size_t N>
bool IsAmong(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// They end by themselves, so they do not nest.
bool NestsNot(std::string_view name) {
  static constexpr std::array<std::string_view, 33> kNames = {
      "area", "base",  "br",      "col",   "embed",    "hr",    "img",    "input",    "link",
      "meta", "param", "source",  "track", "wbr",      "p",     "li",     "dt",       "dd",
      "tr",   "td",    "th",      "thead", "tbody",    "tfoot", "option", "colgroup", "html",
      "head", "body",  "caption", "frame", "basefont", "image"};
  return IsAmong(name, kNames);
}

bool IsLook(std::string_view name) {
  static constexpr std::array<std::string_view, 14> kNames = {
      "b", "big",   "code",   "em",     "font", "i", "nobr",
      "s", "small", "strike", "strong", "tt",   "u", "mark"};
  return IsAmong(name, kNames);
}

/// In a drawing or a formula they end it.
bool IsBreakout(std::string_view name) {
  static constexpr std::array<std::string_view, 44> kNames = {
      "b",      "big",  "blockquote", "body",  "br",   "center", "code",    "dd",   "div",
      "dl",     "dt",   "em",         "embed", "h1",   "h2",     "h3",      "h4",   "h5",
      "h6",     "head", "hr",         "i",     "img",  "li",     "listing", "menu", "meta",
      "nobr",   "ol",   "p",          "pre",   "ruby", "s",      "small",   "span", "strong",
      "strike", "sub",  "sup",        "table", "tt",   "u",      "ul",      "var"};
  return IsAmong(name, kNames) || name == "font";
}

/// Within a drawing or a formula, elements that hold HTML again.
bool HoldsHtml(std::string_view name) {
  static constexpr std::array<std::string_view, 9> kNames = {
      "foreignobject", "desc", "title", "annotation-xml", "mi", "mo", "mn", "ms", "mtext"};
  return IsAmong(name, kNames);
}

/// Text up to their end tag.
bool IsRaw(std::string_view name) {
  static constexpr std::array<std::string_view, 7> kNames = {
      "script", "style", "textarea", "title", "xmp", "iframe", "noembed"};
  return IsAmong(name, kNames);
}

/// Text for browsers that are older than frames, which nobody is shown.
bool IsOutdated(std::string_view name) { return name == "iframe" || name == "noembed"; }

/// What an element is called for the parser. Frames are not read, what stands in for them is.
std::string WrittenName(const std::string& name) {
  if (IsLook(name)) return "span";
  return name == "frameset" || name == "noframes" ? "div" : name;
}

class Tamer {
 public:
  Tamer(std::string_view html, const std::string& name, bool xhtml)
      : html_(html), name_(name), xhtml_(xhtml) {
    tamed_.html.reserve(html.size() + 16);
  }

  TamedHtml Run() {
    while (at_ < html_.size()) {
      const std::size_t open = std::min(html_.find('<', at_), html_.size());
      Keep(open);
      if (open == html_.size()) break;
      if (html_.compare(open, 4, "<!--") == 0) {
        SkipComment();
      } else if (open + 1 < html_.size() && IsLetter(html_[open + 1])) {
        TakeStart();
      } else if (open + 2 < html_.size() && html_[open + 1] == '/' && IsLetter(html_[open + 2])) {
        TakeEnd();
      } else {
        Keep(open + 1);
      }
    }
    return std::move(tamed_);
  }

 private:
  void Keep(std::size_t end) {
    tamed_.html.append(html_.substr(at_, end - at_));
    at_ = end;
  }
  void SkipComment() {
    const std::size_t end = html_.find("-->", at_ + 2);
    if (end == kNone) {
      Keep(html_.size());  // the parser knows what an open comment means
    } else {
      at_ = end + 3;
    }
  }
  std::string ReadName() {
    const std::size_t begin = at_;
    while (at_ < html_.size() && !IsBlank(html_[at_]) && html_[at_] != '>' && html_[at_] != '/') {
      ++at_;
    }
    return LowerCase(html_.substr(begin, std::min<std::size_t>(at_ - begin, 64)));
  }

  /// Past one attribute, or what stands in its place.
  std::string_view ReadAttribute() {
    const std::size_t begin = at_;
    while (at_ < html_.size() && !IsBlank(html_[at_]) && html_[at_] != '>' && html_[at_] != '=') {
      ++at_;
    }
    std::size_t next = at_;
    while (next < html_.size() && IsBlank(html_[next])) ++next;
    if (next >= html_.size() || html_[next] != '=') return html_.substr(begin, at_ - begin);
    at_ = next + 1;
    while (at_ < html_.size() && IsBlank(html_[at_])) ++at_;
    if (at_ < html_.size() && (html_[at_] == '"' || html_[at_] == '\'')) {
      at_ = std::min(html_.find(html_[at_], at_ + 1), html_.size() - 1) + 1;
    } else {
      while (at_ < html_.size() && !IsBlank(html_[at_]) && html_[at_] != '>') ++at_;
    }
    return html_.substr(begin, at_ - begin);
  }

  /// The attributes that are kept, and the tag's end.
  std::string ReadAttributes(bool& closes) {
    std::string kept;
    std::size_t count = 0;
    closes = false;
    while (at_ < html_.size() && html_[at_] != '>') {
      if (IsBlank(html_[at_])) {
        ++at_;
        continue;
      }
      if (html_[at_] == '/') {
        closes = at_ + 1 < html_.size() && html_[at_ + 1] == '>';
        ++at_;
        continue;
      }
      const std::size_t before = at_;
      const std::string_view attribute = ReadAttribute();
      if (at_ == before) ++at_;  // a lone "="
      const bool data = attribute.find("=\"data:") != kNone || attribute.find("='data:") != kNone;
      if (count++ < kMostAttributes && !data && !attribute.empty()) {
        kept += ' ';
        kept += attribute;
      }
    }
    if (at_ < html_.size()) ++at_;
    return kept;
  }

  bool InForeign() const { return !open_.empty() && open_.back().foreign; }
  void LeaveForeign() {
    while (InForeign()) open_.pop_back();
  }
  void Push(const std::string& name) {
    const bool foreign = name == "svg" || name == "math" || (InForeign() && !HoldsHtml(name));
    open_.push_back({name, foreign});
  }

  void TakeStart() {
    if (++elements_ > kMostElements) {
      throw InputError(name_ + ": holds more than " + std::to_string(kMostElements) +
                       " elements; split it");
    }
    ++at_;
    const std::string name = ReadName();
    bool closes = false;
    const std::string attributes = ReadAttributes(closes);
    if (IsBreakout(name)) LeaveForeign();
    const bool foreign = InForeign();
    const bool raw = IsRaw(name) && !foreign;
    // Else the slash says nothing in HTML.
    const bool empty = closes && (foreign || xhtml_) && !NestsNot(name);
    if (!NestsNot(name) && !empty && !raw) {
      if (open_.size() >= kDeepest) {
        ++dropped_;
        ++tamed_.flattened;
        return;
      }
      Push(name);
    }
    const std::string written = WrittenName(name);
    tamed_.html += '<';
    tamed_.html += written;
    tamed_.html += attributes;
    tamed_.html += closes ? "/>" : ">";
    if (empty && !foreign) {
      tamed_.html += "</";
      tamed_.html += written;
      tamed_.html += '>';
    } else if (raw) {
      KeepRaw(name);
    }
  }

  void KeepRaw(const std::string& name) {
    for (std::size_t end = at_;; end += 2) {
      end = html_.find("</", end);
      if (end == kNone) {
        if (!IsOutdated(name)) Keep(html_.size());
        at_ = html_.size();
        return;
      }
      if (LowerCase(html_.substr(end + 2, name.size())) == name) {
        if (IsOutdated(name)) at_ = end;
        Keep(std::min(html_.find('>', end), html_.size() - 1) + 1);
        return;
      }
    }
  }

  void TakeEnd() {
    at_ += 2;
    const std::string name = ReadName();
    at_ = std::min(html_.find('>', at_), html_.size() - 1) + 1;
    if (!NestsNot(name)) {
      if (dropped_ > 0) {
        --dropped_;
        return;
      }
      const auto last =
          open_.rbegin() + static_cast<std::ptrdiff_t>(std::min(open_.size(), kMisplaced));
      const auto found = std::find_if(open_.rbegin(), last, [&name](const OpenElement& element) {
        return element.name == name;
      });
      if (found != last) open_.erase(std::prev(found.base()), open_.end());
    }
    tamed_.html += "</";
    tamed_.html += WrittenName(name);
    tamed_.html += '>';
  }

  std::string_view html_;
  const std::string& name_;
  bool xhtml_ = false;
  std::size_t at_ = 0;
  std::size_t elements_ = 0, dropped_ = 0;
  struct OpenElement {
    std::string name;
    bool foreign = false;  // its content is of a drawing or a formula
  };
  std::vector<OpenElement> open_;
  TamedHtml tamed_;
};

}  // namespace

TamedHtml TameHtml(std::string_view html, const std::string& name, bool xhtml) {
  return Tamer(html, name, xhtml).Run();
}

std::string DeclaredEncoding(std::string_view bytes) {
  const std::string head = LowerCase(bytes.substr(0, 4096));
  std::size_t at = kNone;
  if (head.rfind("<?xml", 0) == 0) {
    const std::size_t end = head.find("?>");
    at = head.find("encoding");
    if (at > end) at = kNone;
    if (at != kNone) at += 8;
  }
  if (at == kNone) {
    at = head.find("charset");
    const std::size_t meta = at == kNone ? kNone : head.rfind("<meta", at);
    if (meta == kNone || head.find('>', meta) < at) return {};
    at += 7;
  }
  at = head.find_first_not_of(" \t\r\n=\"'", at);
  if (at == kNone) return {};
  return head.substr(at, std::min(head.find_first_of(" \t\r\n\"'/>;?", at), head.size()) - at);
}

}  // namespace moontrace

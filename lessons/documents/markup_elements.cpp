#include "lessons/documents/markup_elements.h"

#include <algorithm>
#include <charconv>
#include <unordered_map>

#include "textures/base/text_file.h"

namespace moontrace {
namespace {

using Role = ElementRole;
using RoleTable = std::unordered_map<std::string_view, Role>;

const RoleTable& NamedRoles() {
  static const RoleTable table = [] {
    RoleTable roles = {{"script", Role::kSilent},
                       {"style", Role::kSilent},
                       {"template", Role::kSilent},
                       {"datalist", Role::kSilent},
                       {"annotation", Role::kSilent},
                       {"annotation-xml", Role::kSilent},
                       {"metadata", Role::kSilent},
                       {"head", Role::kHead},
                       {"title", Role::kTitle},
                       {"meta", Role::kMeta},
                       {"h1", Role::kHeading},
                       {"h2", Role::kHeading},
                       {"h3", Role::kHeading},
                       {"h4", Role::kHeading},
                       {"h5", Role::kHeading},
                       {"h6", Role::kHeading},
                       {"p", Role::kParagraph},
                       {"br", Role::kBreak},
                       {"hr", Role::kRule},
                       {"pre", Role::kPreformatted},
                       {"listing", Role::kPreformatted},
                       {"xmp", Role::kPreformatted},
                       {"plaintext", Role::kPreformatted},
                       {"textarea", Role::kPreformatted},
                       {"blockquote", Role::kQuotation},
                       {"q", Role::kQuote},
                       {"ul", Role::kList},
                       {"menu", Role::kList},
                       {"dir", Role::kList},
                       {"dl", Role::kList},
                       {"ol", Role::kOrderedList},
                       {"li", Role::kItem},
                       {"dt", Role::kTerm},
                       {"dd", Role::kDefinition},
                       {"table", Role::kTable},
                       {"caption", Role::kCaption},
                       {"thead", Role::kTableHead},
                       {"tr", Role::kRow},
                       {"td", Role::kCell},
                       {"th", Role::kHeaderCell},
                       {"a", Role::kLink},
                       {"img", Role::kImage},
                       {"svg", Role::kDrawing},
                       {"math", Role::kMath},
                       {"audio", Role::kMedia},
                       {"video", Role::kMedia},
                       {"iframe", Role::kMedia},
                       {"object", Role::kMedia},
                       {"embed", Role::kMedia},
                       {"applet", Role::kMedia},
                       {"canvas", Role::kMedia},
                       {"rt", Role::kReading},
                       {"rp", Role::kReading},
                       {"sup", Role::kRaised},
                       {"sub", Role::kLowered},
                       {"input", Role::kInput},
                       {"switch", Role::kSwitch},
                       {"epub:switch", Role::kSwitch}};
    for (const std::string_view block :
         {"address",  "article",    "aside",  "body",   "center",   "details",  "dialog", "div",
          "fieldset", "figcaption", "figure", "footer", "form",     "frameset", "header", "hgroup",
          "html",     "legend",     "main",   "nav",    "noscript", "optgroup", "option", "search",
          "section",  "summary",    "tbody",  "tfoot",  "colgroup", "button",   "select"}) {
      roles.emplace(block, Role::kBlock);
    }
    return roles;
  }();
  return table;
}

std::string WithoutBlanks(std::string_view text) {
  std::string kept = LowerCase(text);
  std::erase_if(kept, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
  return kept;
}

}  // namespace

ElementRole RoleOf(std::string_view name, const MarkupAttributes& attributes) {
  const std::string_view role = attributes["role"];
  if (role == "heading") return Role::kHeading;
  if (role == "math" && name != "math") return Role::kInline;
  const auto found = NamedRoles().find(name);
  return found == NamedRoles().end() ? Role::kInline : found->second;
}

bool FitsInSwitch(std::string_view name, const MarkupAttributes& attributes,
                  std::string_view language) {
  const std::size_t colon = name.find(':');
  const std::string_view local = colon == std::string_view::npos ? name : name.substr(colon + 1);
  if (local == "case") {
    const std::string_view elements = attributes["required-namespace"];
    return elements == "http://www.w3.org/1999/xhtml" ||
           elements == "http://www.w3.org/1998/Math/MathML";
  }
  if (!attributes["requiredExtensions"].empty()) return false;
  const std::string wanted = LowerCase(attributes["systemLanguage"]);
  if (wanted.empty()) return true;
  const std::string own = LowerCase(language.substr(0, language.find('-')));
  for (std::size_t at = 0; !own.empty() && at < wanted.size();) {
    const std::size_t end = std::min(wanted.find(',', at), wanted.size());
    const std::string one = WithoutBlanks(std::string_view(wanted).substr(at, end - at));
    if (one.substr(0, one.find('-')) == own) return true;
    at = end + 1;
  }
  return false;
}

bool IsHiddenElement(std::string_view name, const MarkupAttributes& attributes) {
  // MediaWiki's style sheet shows it to readers who do not see, and hides the picture of it.
  if (HasWord(attributes["class"], "mwe-math-mathml-a11y")) return false;
  if (attributes.Has("hidden") || attributes["aria-hidden"] == "true") return true;
  if (name == "dialog" && !attributes.Has("open")) return true;
  if (name == "input" && LowerCase(attributes["type"]) == "hidden") return true;
  // Of a drawing: HTML knows no such attributes.
  if (attributes["display"] == "none" || attributes["visibility"] == "hidden") return true;
  const std::string_view style = attributes["style"];
  if (style.empty() || style.size() > 4096) return false;
  const std::string packed = WithoutBlanks(style);
  return packed.find("display:none") != std::string::npos ||
         packed.find("visibility:hidden") != std::string::npos;
}

std::string PageName(std::string_view said) {
  constexpr std::size_t kLongest = 12;  // characters of a page's name, as "viii" or "A-12"
  std::string name;
  for (std::size_t at = 0; at < said.size() && name.size() < 64; ++at) {
    const bool hard = said.substr(at, 2) == "\xC2\xA0";
    if (hard) ++at;
    name += hard || std::string_view("\t\r\n[](){}|").find(said[at]) != std::string_view::npos
                ? ' '
                : said[at];
  }
  const auto trim = [&name](std::string_view what) {
    name.erase(0, std::min(name.find_first_not_of(what), name.size()));
    name.erase(name.find_last_not_of(what) + 1);
  };
  trim(" .,:;");
  for (const std::string_view word : {"page", "pg.", "pg", "p."}) {
    if (LowerCase(name.substr(0, word.size())) != word) continue;
    name.erase(0, word.size());
    break;
  }
  trim(" .,:;");
  const bool sound = name.size() <= kLongest && name.find(' ') == std::string::npos;
  return sound ? name : std::string();
}

bool IsOnlyBlanks(std::string_view text) {
  return text.find_first_not_of(" \t\r\n\f") == std::string_view::npos;
}

bool HasWord(std::string_view words, std::string_view word) {
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find_first_of(" \t\n\r\f", at), words.size());
    if (LowerCase(words.substr(at, end - at)) == word) return true;
    at = end + 1;
  }
  return false;
}

int WholeNumber(std::string_view text, int otherwise) {
  int value = otherwise;
  std::from_chars(text.data(), text.data() + std::min<std::size_t>(text.size(), 9), value);
  return value;
}

}  // namespace moontrace

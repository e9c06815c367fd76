#include "lessons/documents/xml_markup.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "lessons/documents/document.h"
#include "lessons/documents/html_tree.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

constexpr std::size_t kLongestName = 40;      // of an entity [bytes]
constexpr std::size_t kLongestEntity = 1000;  // what a declared one stands for [bytes]
constexpr std::size_t kMostEntities = 1000;
constexpr std::size_t kNone = std::string_view::npos;

/// "#65" or "#x41".
std::optional<std::string> ByNumber(std::string_view name) {
  const bool hexadecimal = name.size() > 1 && (name[1] == 'x' || name[1] == 'X');
  const std::string_view digits = name.substr(hexadecimal ? 2 : 1);
  unsigned code = 0;
  const auto read =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, hexadecimal ? 16 : 10);
  if (digits.empty() || read.ec != std::errc() || read.ptr != digits.data() + digits.size() ||
      code == 0 || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) {
    return std::nullopt;
  }
  return ToUtf8(code);
}

class References {
 public:
  explicit References(MarkupSink& sink) : sink_(sink) {
    names_ = {{"amp", "&"}, {"lt", "<"}, {"gt", ">"}, {"quot", "\""}, {"apos", "'"}};
  }

  /// `<!ENTITY name "text">` of a document type.
  void Declare(std::string_view doctype) {
    for (std::size_t at = doctype.find("<!ENTITY"); at != kNone && names_.size() < kMostEntities;
         at = doctype.find("<!ENTITY", at + 1)) {
      const std::size_t name = doctype.find_first_not_of(" \t\r\n", at + 8);
      if (name == kNone) return;
      const std::size_t name_end = doctype.find_first_of(" \t\r\n", name);
      if (name_end == kNone) return;
      const std::size_t quote = doctype.find_first_not_of(" \t\r\n", name_end);
      if (quote == kNone || (doctype[quote] != '"' && doctype[quote] != '\'')) continue;
      const std::size_t end = doctype.find(doctype[quote], quote + 1);
      if (end == kNone) return;
      const std::string_view value = doctype.substr(quote + 1, end - quote - 1);
      if (value.size() > kLongestEntity || value.find('<') != kNone) continue;
      const std::optional<std::string> text = Expanded(value);
      if (text) names_.emplace(std::string(doctype.substr(name, name_end - name)), *text);
    }
  }

  std::string Decoded(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t mark = std::min(text.find('&', at), text.size());
      decoded.append(text.substr(at, mark - at));
      if (mark == text.size()) break;
      const std::size_t end = text.substr(0, mark + kLongestName).find(';', mark);
      const std::string* found = end == kNone ? nullptr : Of(text.substr(mark + 1, end - mark - 1));
      if (found == nullptr) {
        decoded += '&';
        at = mark + 1;
      } else {
        decoded += *found;
        at = end + 1;
      }
    }
    return decoded;
  }

 private:
  /// An entity's text of characters and numbers alone.
  static std::optional<std::string> Expanded(std::string_view value) {
    std::string text;
    for (std::size_t at = 0; at < value.size();) {
      const std::size_t mark = std::min(value.find('&', at), value.size());
      text.append(value.substr(at, mark - at));
      if (mark == value.size()) break;
      const std::size_t end = value.find(';', mark);
      if (end == kNone || value[mark + 1] != '#') return std::nullopt;
      const std::optional<std::string> character = ByNumber(value.substr(mark + 1, end - mark - 1));
      if (!character) return std::nullopt;
      text += *character;
      at = end + 1;
    }
    return text;
  }

  const std::string* Of(std::string_view name) {
    const auto known = names_.find(name);
    if (known != names_.end()) return &known->second;
    if (name.empty()) return nullptr;
    std::optional<std::string> found = name[0] == '#' ? ByNumber(name) : ByHtml(name);
    if (found && names_.size() < kMostEntities) {
      return &names_.emplace(std::string(name), *found).first->second;
    }
    if (found) {
      last_ = *found;
      return &last_;
    }
    sink_.UnknownEntity(name);
    return nullptr;
  }

  /// Each unknown name is looked up once.
  std::optional<std::string> ByHtml(std::string_view name) {
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    });
    if (!plain || unknown_.count(name) > 0 || unknown_.size() >= kMostEntities) return std::nullopt;
    std::optional<std::string> found = NamedCharacters(name);
    if (!found) unknown_.emplace(std::string(name), true);
    return found;
  }

  MarkupSink& sink_;
  std::map<std::string, std::string, std::less<>> names_;
  std::map<std::string, bool, std::less<>> unknown_;
  std::string last_;
};

std::string_view LocalName(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == kNone ? name : name.substr(colon + 1);
}

/// As MarkupSink wants them.
std::string_view AttributeName(std::string_view name) {
  const std::string_view local = LocalName(name);
  if (local.size() == name.size()) return name;
  if (local == "type") return "epub:type";
  if (local == "href") return "xlink:href";
  return name;
}

/// More than this are not told apart, so that time is bounded.
constexpr std::size_t kMostPrefixes = 100;

/// Prefixes of names that are declared where one is (Namespaces in XML 1.0).
class Prefixes {
 public:
  /// What is wrong with the names of an element that opens; empty: nothing.
  std::string Open(pugi::xml_node node) {
    begins_.push_back(declared_.size());
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const std::string_view name = attribute.name();
      if (name.substr(0, 6) == "xmlns:") declared_.push_back(name.substr(6));
    }
    std::string fault = FaultOf(node.name());
    std::size_t count = 0;
    for (pugi::xml_attribute one = node.first_attribute(); one && fault.empty() && ++count <= 60;
         one = one.next_attribute()) {
      fault = FaultOf(one.name());
      for (auto other = node.first_attribute(); other != one; other = other.next_attribute()) {
        if (std::string_view(other.name()) == one.name()) {
          fault = std::string("attribute ") + one.name() + " twice";
        }
      }
    }
    return fault;
  }
  void Close() {
    declared_.resize(begins_.back());
    begins_.pop_back();
  }

 private:
  std::string FaultOf(std::string_view name) const {
    const std::size_t colon = name.find(':');
    if (colon == kNone) return {};
    const std::string_view prefix = name.substr(0, colon);
    if (prefix.empty() || name.find(':', colon + 1) != kNone || colon + 1 == name.size()) {
      return "name " + std::string(name);
    }
    const bool known = declared_.size() > kMostPrefixes || prefix == "xml" || prefix == "xmlns" ||
                       std::find(declared_.rbegin(), declared_.rend(), prefix) != declared_.rend();
    return known ? std::string() : "undeclared prefix " + std::string(prefix);
  }

  std::vector<std::string_view> declared_;
  std::vector<std::size_t> begins_;
};

class Walk {
 public:
  Walk(const std::string& name, MarkupSink& sink) : name_(name), sink_(sink), references_(sink) {}

  void Run(const pugi::xml_document& document) {
    for (const pugi::xml_node child : document.children()) {
      if (child.type() == pugi::node_doctype) references_.Declare(child.value());
    }
    const pugi::xml_node root = document.document_element();
    Open(root);
    for (pugi::xml_node node = root;;) {
      if (const pugi::xml_node child = node.first_child()) {
        node = child;
        Enter(node);
        continue;
      }
      while (!node.next_sibling()) {
        if (node.type() == pugi::node_element) Close();
        if (node == root) return;
        node = node.parent();
        if (node == root) return Close();
      }
      if (node.type() == pugi::node_element) Close();
      if (node == root) return;
      node = node.next_sibling();
      Enter(node);
    }
  }

 private:
  void Enter(pugi::xml_node node) {
    if (node.type() == pugi::node_element) Open(node);
    if (node.type() == pugi::node_pcdata) sink_.Text(references_.Decoded(node.value()));
    if (node.type() == pugi::node_cdata) sink_.Text(node.value());
  }

  void Open(pugi::xml_node node) {
    if (++elements_ > kMostElements) {
      throw InputError(name_ + ": holds more than " + std::to_string(kMostElements) +
                       " elements; split it");
    }
    std::size_t count = 0;
    values_.clear();
    attributes_.clear();
    for (const pugi::xml_attribute attribute : node.attributes()) {
      if (++count > 60) break;
      values_.push_back(references_.Decoded(attribute.value()));
    }
    count = 0;
    for (const pugi::xml_attribute attribute : node.attributes()) {
      if (count == values_.size()) break;
      attributes_.Add(AttributeName(attribute.name()), values_[count++]);
    }
    CheckNames(node);
    sink_.Open(LowerCase(LocalName(node.name())), attributes_);
  }

  void Close() {
    if (!faulty_) prefixes_.Close();
    sink_.Close();
  }

  /// Until the first fault.
  void CheckNames(pugi::xml_node node) {
    if (faulty_) return;
    const std::string fault = prefixes_.Open(node);
    faulty_ = !fault.empty();
    if (faulty_) sink_.Fault(fault);
  }

  const std::string& name_;
  MarkupSink& sink_;
  References references_;
  Prefixes prefixes_;
  bool faulty_ = false;
  std::size_t elements_ = 0;
  std::vector<std::string> values_;
  MarkupAttributes attributes_;
};

}  // namespace

bool ReadXmlMarkup(std::string_view xml, const std::string& name, MarkupSink& sink) {
  pugi::xml_document document;
  // References stay, since it would leave unknown ones and decode "&amp;nbsp;" twice.
  const unsigned options =
      pugi::parse_cdata | pugi::parse_doctype | pugi::parse_ws_pcdata | pugi::parse_eol;
  const pugi::xml_parse_result parsed =
      document.load_buffer(xml.data(), xml.size(), options, pugi::encoding_utf8);
  if (!parsed || !document.document_element()) return false;
  Walk(name, sink).Run(document);
  return true;
}

}  // namespace moontrace

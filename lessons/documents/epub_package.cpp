#include "lessons/documents/epub_package.h"

#include <algorithm>
#include <charconv>
#include <pugixml.hpp>
#include <unordered_map>

#include "lessons/documents/html_tree.h"
#include "lessons/documents/markup_elements.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostItems = 20'000;
constexpr int kDeepest = 20;
constexpr std::size_t kLongestName = 40;  // of a character [bytes]
constexpr std::size_t kMostNames = 1000;  // that are told apart
constexpr std::size_t kNone = std::string_view::npos;

std::string_view LocalName(pugi::xml_node node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == kNone ? name : name.substr(colon + 1);
}

std::string_view Attribute(pugi::xml_node node, std::string_view local) {
  for (const pugi::xml_attribute attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    const std::size_t colon = name.find(':');
    if ((colon == kNone ? name : name.substr(colon + 1)) == local) return attribute.value();
  }
  return {};
}

pugi::xml_node Child(pugi::xml_node node, std::string_view name) {
  for (const pugi::xml_node child : node.children()) {
    if (LocalName(child) == name) return child;
  }
  return {};
}

/// What is said for a node in place of what it holds; empty: nothing is.
std::string_view Alternative(pugi::xml_node node) {
  const std::string_view name = LocalName(node);
  if (name == "math") return Attribute(node, "alttext");
  if (name == "svg") return Attribute(node, "aria-label");
  if (name != "img") return {};
  const std::string_view words = Attribute(node, "alt");
  return words.empty() ? Attribute(node, "title") : words;
}

/// The text below a node, its blanks single spaces. Without recursion.
std::string TextOf(pugi::xml_node root) {
  std::string text;
  const auto take = [&text](std::string_view part) {
    for (const char c : part) {
      const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
      if (!blank) {
        text += c;
      } else if (!text.empty() && text.back() != ' ') {
        text += ' ';
      }
    }
  };
  for (pugi::xml_node node = root; node;) {
    if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata) take(node.value());
    const std::string_view words = Alternative(node);
    take(words);
    if (const pugi::xml_node child = node.first_child(); child && words.empty()) {
      node = child;
      continue;
    }
    while (node != root && !node.next_sibling()) node = node.parent();
    if (node == root) break;
    node = node.next_sibling();
  }
  if (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

/// HTML's named characters as themselves, since the parser knows the five of XML alone.
std::string WithoutNames(std::string_view xml) {
  std::unordered_map<std::string_view, std::optional<std::string>> known;
  for (const std::string_view name : {"amp", "lt", "gt", "quot", "apos"}) known[name];
  std::string plain;
  plain.reserve(xml.size());
  for (std::size_t at = 0; at < xml.size();) {
    const std::size_t mark = std::min(xml.find('&', at), xml.size());
    plain.append(xml.substr(at, mark - at));
    at = mark;
    if (mark == xml.size()) break;
    const std::size_t end = xml.substr(0, mark + kLongestName).find(';', mark);
    const std::string_view name =
        end == kNone ? std::string_view() : xml.substr(mark + 1, end - mark - 1);
    if (!name.empty() && name[0] != '#' && known.size() < kMostNames && known.count(name) == 0) {
      known[name] = NamedCharacters(name);
    }
    const auto found = known.find(name);
    if (found == known.end() || !found->second ||
        found->second->find_first_of("<&") != std::string::npos) {
      plain += xml[at++];
    } else {
      plain += *found->second;
      at = end + 1;
    }
  }
  return plain;
}

std::optional<pugi::xml_node> Root(pugi::xml_document& document, const std::string& encoded) {
  const std::string xml = WithoutNames(encoded);
  const pugi::xml_parse_result parsed =
      document.load_buffer(xml.data(), xml.size(), pugi::parse_default | pugi::parse_ws_pcdata,
                           pugi::encoding_utf8);  // decoded already, whatever it declares
  if (!parsed || !document.document_element()) return std::nullopt;
  return document.document_element();
}

std::optional<std::string> Unescaped(std::string_view address) {
  std::string plain;
  for (std::size_t i = 0; i < address.size(); ++i) {
    unsigned code = 0;
    if (address[i] == '%' && i + 2 < address.size() &&
        std::from_chars(address.data() + i + 1, address.data() + i + 3, code, 16).ptr ==
            address.data() + i + 3) {
      if (code == 0) return std::nullopt;
      plain += static_cast<char>(code);
      i += 2;
    } else {
      plain += address[i];
    }
  }
  return plain;
}

void ReadMetadata(pugi::xml_node metadata, EpubPackage& package) {
  for (const pugi::xml_node node : metadata.children()) {
    const std::string_view name = LocalName(node);
    if (name == "dc-metadata" || name == "x-metadata") {  // of OEBPS 1.2
      ReadMetadata(node, package);
      continue;
    }
    const std::string text = TextOf(node);
    if (text.empty()) continue;
    if (name == "title") package.titles.push_back(text);
    if (name == "creator") package.authors.push_back(text);
    if (name == "language" && package.language.empty()) package.language = text;
  }
}

void ReadManifest(pugi::xml_node manifest, EpubPackage& package, const std::string& name) {
  for (const pugi::xml_node node : manifest.children()) {
    if (LocalName(node) != "item") continue;
    if (package.items.size() >= kMostItems) {
      throw InputError(name + ": lists more than " + std::to_string(kMostItems) +
                       " files; no book does");
    }
    EpubItem item;
    item.id = Attribute(node, "id");
    item.address = Attribute(node, "href");
    item.path = ResolvePath(package.path, item.address);
    item.media_type = LowerCase(Attribute(node, "media-type"));
    item.fallback = Attribute(node, "fallback");
    item.properties = Attribute(node, "properties");
    if (HasWord(item.properties, "nav") && !package.navigation) {
      package.navigation = package.items.size();
    }
    package.items.push_back(std::move(item));
  }
}

void ReadSpine(pugi::xml_node spine, EpubPackage& package) {
  std::unordered_map<std::string_view, std::size_t> by_id;
  for (std::size_t i = 0; i < package.items.size(); ++i) by_id.emplace(package.items[i].id, i);
  for (const pugi::xml_node node : spine.children()) {
    if (LocalName(node) != "itemref" || package.spine.size() >= kMostItems) continue;
    const auto found = by_id.find(Attribute(node, "idref"));
    if (found == by_id.end()) {
      package.missing.emplace_back(Attribute(node, "idref"));
    } else {
      package.spine.push_back({found->second, Attribute(node, "linear") != "no"});
    }
  }
  const auto ncx = by_id.find(Attribute(spine, "toc"));
  if (ncx != by_id.end()) package.ncx = ncx->second;
  for (std::size_t i = 0; i < package.items.size() && !package.ncx; ++i) {
    if (package.items[i].media_type == "application/x-dtbncx+xml") package.ncx = i;
  }
}

/// Of a book without an order: its pages as they are listed, outside of the order.
void ReadUnordered(EpubPackage& package) {
  for (std::size_t i = 0; i < package.items.size(); ++i) {
    const EpubItem& item = package.items[i];
    const bool page = item.media_type == "application/xhtml+xml" ||
                      item.media_type == "text/html" || item.media_type == "text/x-oeb1-document";
    if (page && !HasWord(item.properties, "nav")) package.spine.push_back({i, false});
  }
}

EpubTarget Target(std::string title, int level, std::string_view base, std::string_view address) {
  EpubTarget target{std::move(title), level, {}, {}, address.empty()};
  if (!address.empty()) {
    target.path = ResolvePath(base, address, &target.id).value_or(std::string());
  }
  return target;
}

/// Items of an `ol` of EPUB 3's navigation document.
void ReadNavList(pugi::xml_node list, int level, const std::string& path,
                 std::vector<EpubTarget>& targets) {
  if (level > kDeepest) return;
  for (const pugi::xml_node item : list.children()) {
    if (LocalName(item) != "li" || targets.size() >= kMostItems) continue;
    for (const pugi::xml_node node : item.children()) {
      const std::string_view name = LocalName(node);
      if (name == "a" || name == "span") {
        std::string title = TextOf(node);
        if (title.empty()) title = Attribute(node, "title");
        targets.push_back(Target(std::move(title), level, path, Attribute(node, "href")));
      }
      if (name == "ol") ReadNavList(node, level + 1, path, targets);
    }
  }
}

void ReadNavPoints(pugi::xml_node parent, int level, const std::string& path,
                   std::vector<EpubTarget>& targets) {
  if (level > kDeepest) return;
  for (const pugi::xml_node node : parent.children()) {
    const std::string_view name = LocalName(node);
    if ((name != "navPoint" && name != "pageTarget") || targets.size() >= kMostItems) continue;
    targets.push_back(Target(TextOf(Child(node, "navLabel")), level, path,
                             Attribute(Child(node, "content"), "src")));
    ReadNavPoints(node, level + 1, path, targets);
  }
}

}  // namespace

std::optional<std::string> ResolvePath(std::string_view base, std::string_view address,
                                       std::string* id) {
  const std::size_t mark = address.find('#');
  if (mark != kNone && id != nullptr) {
    *id = Unescaped(address.substr(mark + 1)).value_or(std::string());
  }
  address = address.substr(0, mark);
  const std::size_t colon = address.find(':');
  if (colon != kNone && colon < address.find('/')) return std::nullopt;  // http:, file:, data:
  if (address.substr(0, 2) == "//") return std::nullopt;
  const std::optional<std::string> plain = Unescaped(address.substr(0, address.find('?')));
  if (!plain) return std::nullopt;
  if (plain->empty()) return std::string(base);
  std::vector<std::string_view> parts;
  const auto walk = [&parts](std::string_view path) {
    for (std::size_t at = 0; at <= path.size();) {
      const std::size_t end = std::min(path.find('/', at), path.size());
      const std::string_view part = path.substr(at, end - at);
      if (part == "..") {
        if (!parts.empty()) parts.pop_back();
      } else if (!part.empty() && part != ".") {
        parts.push_back(part);
      }
      at = end + 1;
    }
  };
  const std::size_t slash = base.rfind('/');
  if (plain->front() != '/' && slash != kNone) walk(base.substr(0, slash));
  walk(*plain);
  std::string path;
  for (const std::string_view part : parts) {
    if (!path.empty()) path += '/';
    path += part;
  }
  return path;
}

std::optional<std::string> ReadContainer(const std::string& xml) {
  pugi::xml_document document;
  const std::optional<pugi::xml_node> root = Root(document, xml);
  if (!root) return std::nullopt;
  std::optional<std::string> other;  // of another type than it should have
  for (const pugi::xml_node node : Child(*root, "rootfiles").children()) {
    if (LocalName(node) != "rootfile") continue;
    const std::string_view type = Attribute(node, "media-type");
    std::optional<std::string> path = ResolvePath("", Attribute(node, "full-path"));
    if (type.empty() || type == "application/oebps-package+xml") return path;
    if (!other && path && path->ends_with(".opf")) other = std::move(path);
  }
  return other;
}

EpubPackage ReadPackage(const std::string& xml, const std::string& path, const std::string& name) {
  pugi::xml_document document;
  const std::optional<pugi::xml_node> root = Root(document, xml);
  if (!root || LocalName(*root) != "package") {
    throw InputError(name + ": is a damaged book (" + OneLine(path) +
                     " in it is no package of EPUB); get it again");
  }
  EpubPackage package;
  package.path = path;
  ReadMetadata(Child(*root, "metadata"), package);
  ReadManifest(Child(*root, "manifest"), package, name);
  ReadSpine(Child(*root, "spine"), package);
  if (package.spine.empty()) ReadUnordered(package);
  if (package.spine.empty()) {
    throw InputError(name + ": is a book without chapters (" + OneLine(path) +
                     " in it lists none); get it again");
  }
  return package;
}

std::vector<std::string> ReadEncryption(const std::string& xml) {
  static constexpr std::string_view kFonts[] = {"http://www.idpf.org/2008/embedding",
                                                "http://ns.adobe.com/pdf/enc#RC"};
  std::vector<std::string> paths;
  pugi::xml_document document;
  const std::optional<pugi::xml_node> root = Root(document, xml);
  if (!root) return paths;
  for (const pugi::xml_node data : root->children()) {
    if (LocalName(data) != "EncryptedData") continue;
    const std::string_view method = Attribute(Child(data, "EncryptionMethod"), "Algorithm");
    if (std::find(std::begin(kFonts), std::end(kFonts), method) != std::end(kFonts)) continue;
    const pugi::xml_node reference = Child(Child(data, "CipherData"), "CipherReference");
    const std::optional<std::string> path = ResolvePath("", Attribute(reference, "URI"));
    if (path) paths.push_back(*path);
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::optional<EpubNavigation> ReadNavigation(const std::string& xhtml, const std::string& path) {
  pugi::xml_document document;
  const std::optional<pugi::xml_node> root = Root(document, xhtml);
  if (!root) return std::nullopt;
  EpubNavigation navigation;
  for (pugi::xml_node node = *root; node;) {  // in document order, without recursion
    if (LocalName(node) == "nav") {
      const std::string_view type = Attribute(node, "type");
      const bool pages = HasWord(type, "page-list");
      if (pages || HasWord(type, "toc")) {
        for (const pugi::xml_node child : node.children()) {
          if (LocalName(child) != "ol") continue;
          ReadNavList(child, 1, path, pages ? navigation.pages : navigation.contents);
        }
      }
    } else if (const pugi::xml_node child = node.first_child()) {
      node = child;
      continue;
    }
    while (node != *root && !node.next_sibling()) node = node.parent();
    if (node == *root) break;
    node = node.next_sibling();
  }
  return navigation;
}

std::optional<EpubNavigation> ReadNcx(const std::string& xml, const std::string& path) {
  pugi::xml_document document;
  const std::optional<pugi::xml_node> root = Root(document, xml);
  if (!root) return std::nullopt;
  EpubNavigation navigation;
  ReadNavPoints(Child(*root, "navMap"), 1, path, navigation.contents);
  ReadNavPoints(Child(*root, "pageList"), 1, path, navigation.pages);
  return navigation;
}

}  // namespace moontrace

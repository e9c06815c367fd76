#include "sim/physics/mjcf.h"

#include <filesystem>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string_view>

#include "sim/physics/mjcf_sizes.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kGreatestIncluded = std::size_t{64} << 20;  ///< all includes [bytes]
constexpr std::size_t kGreatestIncludes = 1000;

pugi::xml_node ParseInto(pugi::xml_document& document, const std::string& xml,
                         const std::string& name) {
  RequireFewTags(xml, name);
  // white space and comments stay, so that MuJoCo's line numbers are nearly the file's
  constexpr unsigned kKeep = pugi::parse_default | pugi::parse_ws_pcdata | pugi::parse_comments;
  const pugi::xml_parse_result result = document.load_buffer(xml.data(), xml.size(), kKeep);
  if (result) return document.document_element();
  const TextPlace place = PlaceOf(xml, static_cast<std::size_t>(result.offset));
  throw InputError(name + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) +
                   ": broken XML: " + result.description() + "; mend it there");
}

bool IsElement(const pugi::xml_node& node, std::string_view name) {
  return node.type() == pugi::node_element && name == node.name();
}

/// Replaces every include by the children of the included document's first element, as MuJoCo does.
class Includes {
 public:
  Includes(const std::string& folder, const std::string& name) : folder_(folder), name_(name) {}

  void Expand(pugi::xml_node root) {
    const auto is_include = [](const pugi::xml_node& node) { return IsElement(node, "include"); };
    while (pugi::xml_node include = root.find_node(is_include)) {
      const std::string file = include.attribute("file").value();
      if (file.empty())
        throw InputError(name_ + ": an <include> names no file; write file=\"...\"");
      const fs::path path = (fs::path(folder_) / file).lexically_normal();
      if (!seen_.insert(path).second || seen_.size() > kGreatestIncludes) {
        throw InputError(name_ + ": includes '" + OneLine(file) +
                         "' more than once; include each file once");
      }
      pugi::xml_document part;
      const std::string where = name_ + ": included " + OneLine(path.string(), 200);
      const std::string text = ReadTextFile(path.string(), kGreatestIncluded);
      bytes_ += text.size();
      if (bytes_ > kGreatestIncluded) {
        throw InputError(where + ": all includes together hold more than 64 MB; include less");
      }
      const pugi::xml_node children = ParseInto(part, text, where);
      pugi::xml_node parent = include.parent();
      for (const pugi::xml_node& child : children.children()) {
        parent.insert_copy_before(child, include);
      }
      parent.remove_child(include);
    }
  }

 private:
  const std::string& folder_;
  const std::string& name_;
  std::set<fs::path> seen_;
  std::size_t bytes_ = 0;  ///< of all of them
};

bool ReadsFiles(const pugi::xml_node& root) {
  for (const pugi::xml_node& assets : root.children("asset")) {
    for (const pugi::xml_node& asset : assets.children()) {
      for (const pugi::xml_attribute& attribute : asset.attributes()) {
        if (std::string_view(attribute.name()).substr(0, 4) == "file") return true;
      }
    }
  }
  return false;
}

/// Makes one kind of asset folder absolute, wherever the model sets it; sets it if nowhere.
void AnchorFolder(pugi::xml_node root, const char* kind, const std::string& folder) {
  bool set = false;
  for (pugi::xml_node compiler : root.children("compiler")) {
    for (const char* key : {kind, "assetdir"}) {
      if (pugi::xml_attribute attribute = compiler.attribute(key)) {
        attribute.set_value((fs::path(folder) / attribute.value()).c_str());
        set = true;
      }
    }
  }
  if (!set) root.append_child("compiler").append_attribute(kind).set_value(folder.c_str());
}

void Extend(pugi::xml_node key, const char* attribute_name, const std::string& more) {
  if (pugi::xml_attribute attribute = key.attribute(attribute_name)) {
    attribute.set_value((std::string(attribute.value()) + more).c_str());
  }
}

/// The inserted bodies come last in MuJoCo's order, so keyframes grow at the end.
void InsertProxy(pugi::xml_node root, const std::string& proxy_xml) {
  pugi::xml_document document;
  const pugi::xml_node proxy = ParseInto(document, proxy_xml, "models/proxy.xml");
  for (const pugi::xml_node& world : proxy.children("worldbody")) root.append_copy(world);
  for (const pugi::xml_node& keyframe : root.children("keyframe")) {
    for (const pugi::xml_node& key : keyframe.children("key")) {
      Extend(key, "qpos", " 0 0 0");
      Extend(key, "qvel", " 0 0 0");
      Extend(key, "mpos", " 0 0 0");
      Extend(key, "mquat", " 1 0 0 0");
    }
  }
}

}  // namespace

Mjcf PrepareMjcf(const std::string& xml, const std::string& folder, const std::string& name,
                 const std::string& proxy_xml) {
  pugi::xml_document document;
  pugi::xml_node root = ParseInto(document, xml, name);
  if (!IsElement(root, "mujoco")) {
    throw InputError(name + ": no MuJoCo model: it begins with <" + OneLine(root.name()) +
                     ">, not <mujoco>");
  }
  Includes(folder, name).Expand(root);
  RequireModestSizes(root, folder, name);
  if (!folder.empty() && ReadsFiles(root)) {
    AnchorFolder(root, "meshdir", folder);
    AnchorFolder(root, "texturedir", folder);
  }
  Mjcf mjcf;
  const auto is_proxy = [](const pugi::xml_node& node) {
    return IsElement(node, "body") &&
           std::string_view(node.attribute("name").value()) == "moontrace_proxy";
  };
  if (!root.find_node(is_proxy)) {
    InsertProxy(root, proxy_xml);
    mjcf.proxy_inserted = true;
  }
  std::ostringstream text;
  document.save(text, "", pugi::format_raw | pugi::format_no_declaration);
  mjcf.xml = text.str();
  return mjcf;
}

}  // namespace moontrace

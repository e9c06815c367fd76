#include "sim/physics/mjcf.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

constexpr std::ptrdiff_t kMostTags = 100'000;  ///< opening, closing, comments
constexpr double kMostElements = 10'000;       ///< MuJoCo takes the square of it in time
constexpr double kElementsOfPart = 5;          ///< body, joints, geom, tendons of a composed part
constexpr double kMostHeights = 1 << 24;       ///< of all height fields
constexpr double kMostTexels = 1 << 26;        ///< of all textures
constexpr double kMostOfAll = 1 << 22;         ///< keyframes or user numbers, times elements
constexpr double kMostFileBytes = 64 << 20;
constexpr double kMostFilesBytes = 256 << 20;  ///< together
constexpr double kMostMemory = 1 << 30;        ///< of an mjData's arena [bytes]

struct Cap {
  std::string_view element, attribute;
  double most;
};
/// A constraint row costs a row of two square matrices, so njmax is the lowest.
constexpr std::array<Cap, 19> kCaps = {{{"size", "njmax", 8000},
                                        {"size", "nconmax", 100'000},
                                        {"size", "nstack", 1 << 26},
                                        {"size", "nuserdata", 1 << 20},
                                        {"option", "iterations", 10'000},
                                        {"option", "ls_iterations", 10'000},
                                        {"option", "noslip_iterations", 10'000},
                                        {"option", "mpr_iterations", 10'000},
                                        {"option", "ccd_iterations", 10'000},
                                        {"option", "sdf_iterations", 10'000},
                                        {"option", "sdf_initpoints", 10'000},
                                        {"global", "offwidth", 8192},
                                        {"global", "offheight", 8192},
                                        {"quality", "shadowsize", 16'384},
                                        {"quality", "offsamples", 64},
                                        {"quality", "numslices", 1000},
                                        {"quality", "numstacks", 1000},
                                        {"quality", "numquads", 1000},
                                        {"user", "dim", 10'000}}};

/// The product of the numbers of an attribute such as count="8 8 1"; those below one do not count.
double Product(const pugi::xml_attribute& attribute) {
  std::istringstream text(attribute.value());
  text.imbue(std::locale::classic());
  double product = 1;
  for (double number = 0; text >> number;) product *= std::max(1.0, number);
  return text.eof() ? product : attribute.as_double(1) * product;  // "1e999" is read by the latter
}

/// Bytes of MuJoCo 3's memory="100M".
double MemoryOf(const pugi::xml_attribute& attribute) {
  const std::string_view text = attribute.value();
  const std::size_t unit =
      text.empty() ? std::string_view::npos : std::string_view("KMGTPE").find(text.back());
  double bytes = attribute.as_double();
  for (std::size_t i = 0; unit != std::string_view::npos && i <= unit; ++i) bytes *= 1024;
  return bytes;
}

/// Width and height of a PNG picture, from its first chunk (ISO/IEC 15948, 11.2.2).
struct PixelCounts {
  double width = 0, height = 0;
};
std::optional<PixelCounts> PixelsOf(const fs::path& path) {
  std::array<unsigned char, 24> head{};
  std::ifstream file(path, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(head.data()), head.size())) return std::nullopt;
  if (std::memcmp(head.data(), "\x89PNG\r\n\x1a\n", 8) != 0) return std::nullopt;
  const auto number = [&head](std::size_t at) {
    return double{16777216} * head[at] + 65536.0 * head[at + 1] + 256.0 * head[at + 2] +
           head[at + 3];
  };
  return PixelCounts{number(16), number(20)};
}

class SizeCheck : public pugi::xml_tree_walker {
 public:
  SizeCheck(const pugi::xml_node& root, const std::string& folder, const std::string& name)
      : name_(name), folders_{folder} {
    for (const pugi::xml_node& compiler : root.children("compiler")) {
      for (const char* key : {"meshdir", "texturedir", "assetdir"}) {
        const fs::path named = compiler.attribute(key).value();
        if (!named.empty()) folders_.push_back(fs::path(folder) / named);
      }
    }
  }

  bool for_each(pugi::xml_node& node) override {
    if (node.type() != pugi::node_element) return true;
    Count(node);
    CheckCaps(node);
    CheckGrid(node);
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      if (std::string_view(attribute.name()).substr(0, 4) == "file") CheckFile(node, attribute);
    }
    return true;
  }

  /// What is set aside for each element, once they are counted.
  bool end(pugi::xml_node& root) override {
    for (const pugi::xml_node& size : root.children("size")) {
      for (const pugi::xml_attribute& attribute : size.attributes()) {
        const std::string_view key = attribute.name();
        if (key == "nkey" || key.substr(0, 6) == "nuser_") {
          Require(size, key, attribute.as_double() * elements_, kMostOfAll,
                  "times the model's elements ");
        }
      }
    }
    return true;
  }

 private:
  void Require(const pugi::xml_node& node, std::string_view what, double is, double most,
               std::string_view of = "") const {
    if (is <= most) return;
    throw InputError(fmt::format("{}: <{}>: {} {}is {:.15g}, more than {:.15g}: make it smaller",
                                 name_, OneLine(node.name()), what, of, is, most));
  }

  /// How often an element is made: by all replicates around it.
  void Count(const pugi::xml_node& node) {
    const std::string_view tag = node.name();
    const auto level = static_cast<std::size_t>(depth());
    times_.resize(level + 1, 1);
    const double outside = level == 0 ? 1 : times_[level - 1];
    const bool composed = tag == "composite" || tag == "flexcomp";
    const double count = composed || tag == "replicate" ? Product(node.attribute("count")) : 1;
    times_[level] = tag == "replicate" ? outside * count : outside;
    elements_ += composed ? outside * count * kElementsOfPart : outside;
    if (!(elements_ <= kMostElements)) {
      throw InputError(fmt::format("{}: more than {} elements at <{}>: make the model smaller",
                                   name_, kMostElements, OneLine(tag)));
    }
  }

  void CheckCaps(const pugi::xml_node& node) const {
    for (const Cap& cap : kCaps) {
      if (cap.element != node.name()) continue;
      const pugi::xml_attribute attribute = node.attribute(cap.attribute.data());
      Require(node, cap.attribute, attribute.as_double(), cap.most);
    }
    if (std::string_view(node.name()) == "size") {
      Require(node, "memory", MemoryOf(node.attribute("memory")), kMostMemory);
    }
  }

  /// Height fields and textures that are given by their numbers of rows and columns.
  void CheckGrid(const pugi::xml_node& node) {
    const std::string_view tag = node.name();
    if (tag == "hfield") {
      const double rows = node.attribute("nrow").as_double();
      AddHeights(node, rows, node.attribute("ncol").as_double());
    } else if (tag == "texture") {
      const double faces = std::string_view(node.attribute("type").value()) == "2d" ? 1 : 6;
      const double width = node.attribute("width").as_double();
      AddTexels(node, width, node.attribute("height").as_double(width), faces);
    }
  }
  void AddHeights(const pugi::xml_node& node, double rows, double columns) {
    heights_ += std::max(0.0, rows) * std::max(0.0, columns);
    Require(node, "number of samples, all in all,", heights_, kMostHeights);
  }
  void AddTexels(const pugi::xml_node& node, double width, double height, double faces) {
    // a cube's faces are square, whatever is said of their height
    const double tall = faces > 1 ? std::max(width, height) : height;
    texels_ += faces * std::max(0.0, width) * std::max(0.0, tall);
    Require(node, "number of pixels, all in all,", texels_, kMostTexels);
  }

  /// A file wherever MuJoCo may look for it. One that is missing is MuJoCo's to name.
  void CheckFile(const pugi::xml_node& node, const pugi::xml_attribute& attribute) {
    const fs::path file = attribute.value();
    std::set<fs::path> places;
    for (const fs::path& folder : folders_) {
      places.insert((folder / file).lexically_normal());
      places.insert((folder / file.filename()).lexically_normal());  // with strippath
    }
    for (const fs::path& place : places) {
      std::error_code missing;
      if (file.empty() || !fs::exists(place, missing)) continue;
      RequireRegularFile(place.string());
      const auto bytes = static_cast<double>(fs::file_size(place, missing));
      if (missing) continue;
      Require(node, "size of its file [bytes]", bytes, kMostFileBytes);
      files_ += bytes;
      Require(node, "size of all files so far [bytes]", files_, kMostFilesBytes);
      if (const auto pixels = PixelsOf(place)) {
        if (std::string_view(node.name()) == "hfield") {
          AddHeights(node, pixels->height, pixels->width);
        } else {
          AddTexels(node, pixels->width, pixels->height, 1);
        }
      }
    }
  }

  const std::string& name_;
  std::vector<fs::path> folders_;
  std::vector<double> times_;  ///< how often what stands at each depth is made
  double elements_ = 0, heights_ = 0, texels_ = 0, files_ = 0;
};

/// Refuses XML of more tags than a model within RequireModestSizes can have, before it is parsed.
/// Throws InputError of one line that begins with `name`.
void RequireFewTags(std::string_view xml, const std::string& name) {
  if (std::count(xml.begin(), xml.end(), '<') <= kMostTags) return;
  throw InputError(fmt::format("{}: more than {} tags: make the model smaller", name, kMostTags));
}

/// Refuses a model for which MuJoCo would take more memory or time than a label on it needs: it
/// checks little itself before it takes them, and an overflow ends the program. Bounded (all ours,
/// each some hundred times what the shipped models ask for, together about 1 GB and 10 s of one
/// core): elements, replicated and composed ones counted as often as they will be made; samples of
/// height fields and textures, those of PNG files too; files that it names, which must be regular;
/// what `size`, `option` and `visual` set aside. `folder`: where the model lies. Includes are
/// expanded already. Throws InputError of one line that begins with `name`: element, attribute, the
/// bound.
void RequireModestSizes(const pugi::xml_node& root, const std::string& folder,
                        const std::string& name) {
  SizeCheck check(root, folder, name);
  pugi::xml_node walked = root;
  walked.traverse(check);
}

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

/// Whether something in the world can hang on a joint.
bool HasJoints(const pugi::xml_node& root) {
  const auto makes_one = [](const pugi::xml_node& node) {
    for (const char* name : {"joint", "freejoint", "composite", "flexcomp", "attach"}) {
      if (IsElement(node, name)) return true;
    }
    return false;
  };
  for (const pugi::xml_node& world : root.children("worldbody")) {
    if (world.find_node(makes_one)) return true;
  }
  return false;
}

/// A body without a shape that nothing moves. MuJoCo's solvers add up joints in groups of four:
/// with the proxy's three it makes one, before those of the model, which so are added as ever.
constexpr const char* kPad = R"(
<body name="moontrace_pad" pos="0 0 0" quat="1 0 0 0">
  <inertial pos="0 0 0" mass="0.05" diaginertia="1e-6 1e-6 1e-6"/>
  <joint name="moontrace_pad" type="slide" axis="1 0 0" pos="0 0 0" limited="false" damping="0"
         stiffness="0" armature="0" frictionloss="0" ref="0" springref="0"/>
</body>)";

void Extend(pugi::xml_node key, const char* attribute_name, const std::string& before,
            const std::string& behind) {
  if (pugi::xml_attribute attribute = key.attribute(attribute_name)) {
    attribute.set_value((before + attribute.value() + behind).c_str());
  }
}

/// The inserted bodies come first in MuJoCo's order where the model has joints of its own, so that
/// keyframes grow at their begin; otherwise last.
void InsertProxy(pugi::xml_node root, const std::string& proxy_xml) {
  pugi::xml_document document, pad;
  const pugi::xml_node proxy = ParseInto(document, proxy_xml, "models/proxy.xml");
  const bool first = HasJoints(root);
  for (pugi::xml_node world : proxy.children("worldbody")) {
    if (!first) {
      root.append_copy(world);
      continue;
    }
    world.append_copy(ParseInto(pad, kPad, "the pad"));
    root.prepend_copy(world);
  }
  for (const pugi::xml_node& keyframe : root.children("keyframe")) {
    for (const pugi::xml_node& key : keyframe.children("key")) {
      for (const char* of_joints : {"qpos", "qvel"}) {
        first ? Extend(key, of_joints, "0 0 0 0 ", "") : Extend(key, of_joints, "", " 0 0 0");
      }
      first ? Extend(key, "mpos", "0 0 0 ", "") : Extend(key, "mpos", "", " 0 0 0");
      first ? Extend(key, "mquat", "1 0 0 0 ", "") : Extend(key, "mquat", "", " 1 0 0 0");
    }
  }
}

/// Refuses what would change the masses of all bodies, the inserted ones among them: the model's
/// own would weigh less for them, and the proxy what nobody reckoned with.
void RequireOwnMasses(const pugi::xml_node& root, const std::string& name) {
  constexpr double kInserted = 0.05;  // least mass in proxy.xml and kPad [kg]
  for (const pugi::xml_node& compiler : root.children("compiler")) {
    if (compiler.attribute("settotalmass").as_double() > 0) {
      throw InputError(name +
                       ": compiler settotalmass would weigh the inserted proxy as well: "
                       "write the masses themselves, and take it out");
    }
    if (compiler.attribute("boundmass").as_double() > kInserted) {
      throw InputError(
          fmt::format("{}: compiler boundmass would make the inserted proxy heavier "
                      "than its {} kg: write the masses themselves, and take it out",
                      name, kInserted));
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
    RequireOwnMasses(root, name);
    InsertProxy(root, proxy_xml);
    mjcf.proxy_inserted = true;
  }
  std::ostringstream text;
  document.save(text, "", pugi::format_raw | pugi::format_no_declaration);
  mjcf.xml = text.str();
  return mjcf;
}

}  // namespace moontrace

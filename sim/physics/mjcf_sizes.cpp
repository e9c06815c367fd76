#include "sim/physics/mjcf_sizes.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
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
                                        {"size", "nstack", 1 << 25},
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

}  // namespace

void RequireFewTags(std::string_view xml, const std::string& name) {
  if (std::count(xml.begin(), xml.end(), '<') <= kMostTags) return;
  throw InputError(fmt::format("{}: more than {} tags: make the model smaller", name, kMostTags));
}

void RequireModestSizes(const pugi::xml_node& root, const std::string& folder,
                        const std::string& name) {
  SizeCheck check(root, folder, name);
  pugi::xml_node walked = root;
  walked.traverse(check);
}

}  // namespace moontrace

#include "textures/fonts/kanjivg.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/overload.h"
#include "textures/base/text_file.h"
#include "textures/fonts/arc_fit.h"
#include "textures/fonts/character_script.h"
#include "textures/fonts/svg_path.h"
#include "textures/fonts/svg_source.h"

namespace moontrace {

namespace fs = std::filesystem;

namespace {

constexpr double kBox = 109;          ///< side of a character [units]
constexpr double kTolerance = 0.001;  ///< [em]
constexpr std::size_t kMostBytes = std::size_t{1} << 20U;

/// Number at the end of an id, behind "-s"; the greatest where there is none.
unsigned StrokeNumber(const char* id) {
  const std::string_view text = id;
  const std::size_t dash = text.rfind("-s");
  unsigned number = std::numeric_limits<unsigned>::max();
  if (dash == std::string_view::npos) return number;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + dash + 2, end, number);
  return read.ec == std::errc() && read.ptr == end ? number : std::numeric_limits<unsigned>::max();
}

/// From the drawing (y down, from 0) to the em box (y up): mirrored arcs turn in the opposite
/// sense.
Piece InEm(const Piece& piece) {
  const auto point = [](glm::dvec2 p) { return glm::dvec2(p.x, kBox - p.y) / kBox; };
  return std::visit<Piece>(
      Overload{
          [&point](const Line& line) {
            return Line{point(line.from), point(line.to)};
          },
          [&point](const Arc& arc) {
            return Arc{point(arc.center), arc.radius / kBox, -arc.start, -arc.sweep};
          },
      },
      piece);
}

/// Code point of a file's name, 0 for others.
char32_t CharacterOf(const fs::path& path) {
  const std::string stem = path.stem().string();
  unsigned code = 0;
  const char* end = stem.data() + stem.size();
  const auto read = std::from_chars(stem.data(), end, code, 16);
  const bool whole = read.ec == std::errc() && read.ptr == end;
  const bool named = path.extension() == ".svg" && stem.size() >= 5 && stem.size() <= 6;
  return named && whole && code <= 0x10FFFF ? static_cast<char32_t>(code) : U'\0';
}

std::set<char32_t> CharactersIn(const std::string& folder) {
  std::set<char32_t> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const char32_t c = CharacterOf(it->path());
    if (c != 0) found.insert(c);
    if (found.size() > kMostCharacters) {
      throw InputError(folder + ": more than 20000 characters; take a smaller folder");
    }
  }
  return found;
}

}  // namespace

std::vector<Stroke> ParseKanjiVg(std::string_view svg, const std::string& file_name) {
  const SvgSource source(svg, file_name);
  if (std::strcmp(source.root().name(), "svg") != 0) {
    source.Fail(source.root(), "the document is not <svg>; give a character of KanjiVG");
  }
  std::vector<std::pair<unsigned, Stroke>> numbered;
  PathLimits limits;
  limits.tolerance = kTolerance * kBox;
  limits.greatest = 10 * kBox;
  source.root().find_node([&](pugi::xml_node node) {
    if (std::strcmp(node.name(), "path") != 0) return false;
    const pugi::xml_attribute path = node.attribute("d");
    try {
      for (const Subpath& subpath : ParseSvgPath(path.value(), limits)) {
        Stroke stroke;
        for (const Piece& piece : subpath.pieces) stroke.pieces.push_back(InEm(piece));
        numbered.emplace_back(StrokeNumber(node.attribute("id").value()), std::move(stroke));
      }
    } catch (const SvgPathError& error) {
      source.Fail(node, path, error.offset(), error.what());
    }
    return false;
  });
  if (numbered.empty()) source.Fail(source.root(), "no stroke is drawn; get the file again");
  std::stable_sort(numbered.begin(), numbered.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Stroke> strokes;
  strokes.reserve(numbered.size());
  for (auto& each : numbered) strokes.push_back(std::move(each.second));
  return strokes;
}

bool IsKanjiVgFolder(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (CharacterOf(it->path()) != 0) return true;
  }
  return false;
}

Script LoadKanjiVg(const std::string& folder, const std::set<char32_t>& needed) {
  Script script = CharacterScript(fs::path(folder).filename().string());
  script.title = "KanjiVG " + script.name;
  script.author = "Ulrich Apel and the KanjiVG project";
  script.licence = "CC-BY-SA-3.0";
  ReadCredits((fs::path(folder) / "script.toml").string(), script);
  for (const char32_t c : needed.empty() ? CharactersIn(folder) : needed) {
    const fs::path path = fs::path(folder) / fmt::format("{:05x}.svg", static_cast<unsigned>(c));
    std::error_code error;
    if (!fs::exists(path, error)) continue;
    const std::string svg = ReadTextFile(path.string(), kMostBytes);
    AddCharacter(c, ParseKanjiVg(svg, path.string()), script);
  }
  RequireCharacters(script, needed, folder);
  return script;
}

}  // namespace moontrace

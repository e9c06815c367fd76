#include "textures/fonts/hanzi.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"
#include "textures/fonts/character_script.h"
#include "textures/fonts/polyline.h"

namespace moontrace {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

constexpr double kBox = 1024;  ///< side of a character [units]
constexpr double kFoot = -124;
constexpr std::size_t kMostStrokes = 256, kMostPoints = 4096;
constexpr std::size_t kLongestLine = std::size_t{1} << 20U;
constexpr std::uintmax_t kLargestFile = std::uintmax_t{256} << 20U;

Json ParseJson(std::string_view json, const std::string& where) {
  try {
    return Json::parse(json);
  } catch (const Json::parse_error& error) {
    throw InputError(where + ":" + std::to_string(error.byte) +
                     ": broken JSON; get the file of medians again");
  } catch (const Json::exception&) {  // a number out of range
    throw InputError(where + ": JSON that cannot be read; get the file of medians again");
  }
}

glm::dvec2 PointOf(const Json& value, const std::string& where) {
  const bool pair =
      value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
  if (!pair) throw InputError(where + ": a median's point is not [x, y]; mend it");
  const glm::dvec2 p(value[0].get<double>(), value[1].get<double>());
  if (!(std::max(std::abs(p.x), std::abs(p.y)) <= 10 * kBox)) {
    throw InputError(where + ": a median's point lies beyond ten boxes of 1024; mend it");
  }
  return {p.x / kBox, (p.y - kFoot) / kBox};
}

std::vector<Stroke> StrokesOf(const Json& object, const std::string& where) {
  const auto medians = object.is_object() ? object.find("medians") : object.end();
  if (!object.is_object() || medians == object.end() || !medians->is_array()) {
    throw InputError(where + ": no \"medians\"; give graphics.txt or hanzi-writer-data");
  }
  if (medians->size() > kMostStrokes) throw InputError(where + ": more than 256 strokes; mend it");
  std::vector<Stroke> strokes;
  for (const Json& median : *medians) {
    if (!median.is_array() || median.size() > kMostPoints) {
      throw InputError(where + ": a median is no list of at most 4096 points; mend it");
    }
    std::vector<glm::dvec2> points;
    for (const Json& point : median) points.push_back(PointOf(point, where));
    Stroke stroke;
    stroke.pieces = RoundedPolyline(points, kPolylineTolerance);
    if (!stroke.pieces.empty()) strokes.push_back(std::move(stroke));
  }
  return strokes;
}

/// The text's only character, 0 for others.
char32_t OnlyCharacter(const std::string& utf8) {
  const std::u32string codes = ToCodePoints(utf8);
  return codes.size() == 1 && ToUtf8(codes[0]) == utf8 ? codes[0] : U'\0';
}

/// The character of a line without parsing it: Make Me a Hanzi writes it first. 0 if it is not
/// there.
char32_t CharacterAtFront(std::string_view line) {
  constexpr std::string_view kKey = "{\"character\":\"";
  if (line.substr(0, kKey.size()) != kKey) return 0;
  const std::size_t end = line.find('"', kKey.size());
  if (end == std::string_view::npos) return 0;
  return OnlyCharacter(std::string(line.substr(kKey.size(), end - kKey.size())));
}

/// RequireUtf8 for one line, whose number is in `where` already.
void RequireUtf8Line(std::string_view line, const std::string& where) {
  if (const std::optional<std::size_t> bad = FirstBadUtf8(line)) {
    throw InputError(fmt::format("{}:{}: this is not UTF-8; save it as UTF-8", where, *bad + 1));
  }
}

void ReadLine(std::string_view line, const std::string& where, const std::set<char32_t>& needed,
              Script& script) {
  const char32_t at_front = CharacterAtFront(line);
  if (at_front != 0 && !needed.empty() && needed.count(at_front) == 0) return;
  RequireUtf8Line(line, where);
  const Json object = ParseJson(line, where);
  const auto name = object.is_object() ? object.find("character") : object.end();
  if (!object.is_object() || name == object.end() || !name->is_string()) {
    throw InputError(where + ": no \"character\"; give one JSON object a line");
  }
  const char32_t c = OnlyCharacter(name->get<std::string>());
  if (c == 0) throw InputError(where + ": \"character\" is not one character; mend it");
  if ((!needed.empty() && needed.count(c) == 0) || script.signs.count(c) != 0) return;
  if (script.glyphs.size() == kMostCharacters) {
    throw InputError(where + ": more than 20000 characters; take a smaller file");
  }
  AddCharacter(c, StrokesOf(object, where), script);
}

/// Reads to the line's end, or until it is too long. False at the file's end.
bool NextLine(std::istream& stream, std::string& line, const std::string& where) {
  line.clear();
  std::string part(std::size_t{1} << 16U, '\0');
  while (true) {
    stream.getline(part.data(), static_cast<std::streamsize>(part.size()));
    line.append(part, 0, part.find('\0'));  // JSON has no zero byte
    if (line.size() > kLongestLine) {
      throw InputError(where + ": a line of more than 1 MB; give one character's JSON a line");
    }
    if (!stream.fail()) return true;
    if (stream.eof() || stream.gcount() == 0) return !line.empty();
    stream.clear();  // the line goes on
  }
}

Script EmptyScript(const std::string& name, const std::string& toml_path) {
  Script script = CharacterScript(name);
  script.title = "Hanzi medians " + name;
  script.author = "Shaunak Kishore (Make Me a Hanzi); Arphic Technology (fonts)";
  script.licence = "Arphic Public License; see where the file came from";
  ReadCredits(toml_path, script);
  return script;
}

}  // namespace

std::vector<Stroke> ParseMedians(std::string_view json, const std::string& where) {
  RequireUtf8(json, where);
  return StrokesOf(ParseJson(json, where), where);
}

Script LoadHanziFile(const std::string& path, const std::set<char32_t>& needed) {
  Script script = EmptyScript(fs::path(path).stem().string(),
                              fs::path(path).replace_extension(".toml").string());
  RequireRegularFile(path);
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > kLargestFile) {
    throw InputError(path + ": holds more than 256 MB; take a smaller file");
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream || fs::is_directory(path, error)) {
    throw InputError(path + ": cannot be read (" + std::strerror(errno) + "); correct the path");
  }
  std::string line;
  for (std::size_t number = 1;; ++number) {
    const std::string where = path + ":" + std::to_string(number);
    if (!NextLine(stream, line, where)) break;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty()) ReadLine(line, where, needed, script);
    if (!needed.empty() && script.glyphs.size() == needed.size()) break;
  }
  RequireCharacters(script, needed, path);
  return script;
}

bool IsHanziFolder(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const fs::path& path = it->path();
    if (path.extension() == ".json" && OnlyCharacter(path.stem().string()) != 0) return true;
  }
  return false;
}

Script LoadHanziFolder(const std::string& folder, const std::set<char32_t>& needed) {
  Script script = EmptyScript(fs::path(folder).filename().string(),
                              (fs::path(folder) / "script.toml").string());
  std::set<char32_t> wanted = needed;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; needed.empty() && !error && it != end;
       it.increment(error)) {
    const char32_t c = OnlyCharacter(it->path().stem().string());
    if (c != 0 && it->path().extension() == ".json") wanted.insert(c);
    if (wanted.size() > kMostCharacters) {
      throw InputError(folder + ": more than 20000 characters; take a smaller folder");
    }
  }
  for (const char32_t c : wanted) {
    const std::string path = (fs::path(folder) / (ToUtf8(c) + ".json")).string();
    if (c == U'/' || !fs::exists(path, error)) continue;
    AddCharacter(c, ParseMedians(ReadTextFile(path, kLongestLine), path), script);
  }
  RequireCharacters(script, needed, folder);
  return script;
}

}  // namespace moontrace

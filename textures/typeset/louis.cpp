#include "textures/typeset/louis.h"

#include "textures/base/error.h"
#include "textures/base/text_file.h"

#ifdef MOONTRACE_HAVE_LOUIS
#include <fmt/core.h>
#include <liblouis.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <mutex>
#include <system_error>

#include "textures/base/nearest_word.h"
#include "textures/base/utf8.h"
#include "textures/typeset/fold.h"
#endif

namespace moontrace {

#ifdef MOONTRACE_HAVE_LOUIS

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestName = 500;  // liblouis copies names into fixed buffers
constexpr std::size_t kMostFiles = 90;     // of one table; liblouis has room for 100
constexpr std::uintmax_t kLargestFile = std::uintmax_t{16} << 20U;  // [bytes]
constexpr std::size_t kLongestPart = std::size_t{1} << 16U;         // characters in one call
constexpr std::size_t kMostCells = 16;                              // of one character

// What the library keeps for the whole program, and what its call-backs leave here.
struct Library {
  std::mutex mutex;
  std::string first_error;  ///< liblouis' own words
  std::string refused;      ///< why Resolve found nothing, in ours
  std::size_t files = 0;
  std::vector<std::string> answer;  ///< of Resolve
  std::vector<char*> answer_pointers;
};

Library& State() {
  static Library library;
  return library;
}

// One line of ours about a table: what Resolve found, else the "file:3" of liblouis' own first
// line, which is "file:3: error: ...", else the table's name.
std::string WhatIsWrong(const std::string& name) {
  constexpr const char* kBroken = ": this Braille table is broken: mend it or use another";
  const std::string& line = State().first_error;
  if (!State().refused.empty()) return OneLine(name, 200) + ": " + State().refused;
  const std::size_t end = line.find(": error");
  const bool has_place = end != std::string::npos && end > 0 && line[end - 1] >= '0' &&
                         line[end - 1] <= '9' && line.rfind(':', end - 1) != std::string::npos;
  return (has_place ? line.substr(0, end) : OneLine(name, 200)) + kBroken;
}

// "file:3: error: opcode 'foo' not defined." is the first; those that follow only say that it
// failed.
void KeepError(logLevels level, const char* message) {
  if (level >= LOU_LOG_ERROR && State().first_error.empty()) {
    State().first_error = OneLine(message, 1000);
  }
}

// Where tables are looked for: LOUIS_TABLEPATH (parted by commas), then liblouis' own folder.
std::vector<fs::path> TableFolders() {
  std::vector<fs::path> folders;
  if (const char* given = std::getenv("LOUIS_TABLEPATH"); given != nullptr) {
    for (std::string_view rest = given; !rest.empty();) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      if (comma > 0) folders.emplace_back(std::string(rest.substr(0, comma)));
      rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
  }
  folders.emplace_back(MOONTRACE_LOUIS_TABLES);
  return folders;
}

// The file of one table: as given, beside the file that includes it, or in the folders. Empty when
// there is none of a fit size.
std::string FindTable(const std::string& name, const char* base) {
  std::vector<fs::path> candidates;
  if (base != nullptr) candidates.push_back(fs::path(base).parent_path() / name);
  candidates.emplace_back(name);
  if (fs::path(name).is_relative()) {
    for (const fs::path& folder : TableFolders()) candidates.push_back(folder / name);
  }
  for (const fs::path& candidate : candidates) {
    std::error_code error;
    if (!fs::is_regular_file(candidate, error)) continue;
    const std::uintmax_t size = fs::file_size(candidate, error);
    if (!error && size <= kLargestFile && candidate.string().size() <= kLongestName) {
      return candidate.string();
    }
  }
  return {};
}

std::vector<std::string> SplitNames(std::string_view list) {
  std::vector<std::string> names;
  while (true) {
    const std::size_t comma = std::min(list.find(','), list.size());
    names.emplace_back(list.substr(0, comma));
    if (comma == list.size()) return names;
    list.remove_prefix(comma + 1);
  }
}

// liblouis asks here for the files of a table list, and again for each `include`. Its own resolver
// follows a table that includes itself until the stack ends. It copies the
// answer at once, and frees only what its own resolver gave.
char** Resolve(const char* list, const char* base) {
  const std::vector<std::string> names = SplitNames(list);
  State().files += names.size();
  if (State().files > kMostFiles) {
    if (State().refused.empty()) {
      State().refused = fmt::format("includes itself, or more than {} files", kMostFiles);
    }
    return nullptr;
  }
  std::vector<std::string>& files = State().answer;
  files.clear();
  files.reserve(names.size());
  for (const std::string& name : names) {
    files.push_back(FindTable(name, base));
    if (!files.back().empty()) continue;
    if (State().refused.empty()) {
      State().refused = "cannot find '" + OneLine(name, 60) + "'";
    }
    return nullptr;
  }
  std::vector<char*>& pointers = State().answer_pointers;
  pointers.clear();
  pointers.reserve(files.size() + 1);
  for (std::string& file : files) pointers.push_back(file.data());
  pointers.push_back(nullptr);
  return pointers.data();
}

// Near by what stands before the ending, which most tables share: "xx.ctb" is near none.
std::string NearestTable(const std::string& name) {
  std::vector<std::string> known, stems;
  std::error_code error;
  for (const fs::path& folder : TableFolders()) {
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      const std::string ending = it->path().extension().string();
      if (ending == ".ctb" || ending == ".utb" || ending == ".tbl") {
        known.push_back(it->path().filename().string());
      }
    }
  }
  std::sort(known.begin(), known.end());
  stems.reserve(known.size());
  for (const std::string& table : known) stems.push_back(fs::path(table).stem().string());
  const std::string stem = NearestWord(fs::path(name).stem().string(), stems);
  const auto nearest = std::find(stems.begin(), stems.end(), stem);
  return nearest == stems.end() ? std::string()
                                : known[static_cast<std::size_t>(nearest - stems.begin())];
}

void CheckName(const std::string& name) {
  const bool fits = !name.empty() && name.size() <= kLongestName;
  const bool plain = std::none_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
  });
  if (!fits || !plain) {
    throw InputError("Braille table '" + OneLine(name, 40) +
                     "': give a liblouis table like en-ueb-g2.ctb, or a path");
  }
  for (const std::string& part : SplitNames(name)) {
    if (!FindTable(part, nullptr).empty()) continue;
    const std::string nearest = NearestTable(part);
    throw InputError("no Braille table '" + OneLine(part, 60) + "': " +
                     (nearest.empty() ? "give one of liblouis, like en-ueb-g2.ctb"
                                      : "did you mean " + nearest + "?"));
  }
}

// The characters as the library takes them; it may be built for two-byte characters.
std::vector<widechar> Widened(std::u32string_view text) {
  std::vector<widechar> wide;
  for (const char32_t c : text) {
    const bool fits = c <= std::numeric_limits<widechar>::max();
    wide.push_back(fits ? static_cast<widechar>(c) : widechar{0xFFFD});
  }
  return wide;
}

struct Translation {
  std::vector<widechar> cells;
  std::vector<int> from;  // index of the character that each cell was made of
};

// All of `text`. The library says by the count taken whether the room was enough.
Translation Translated(const std::string& table, std::u32string_view text) {
  const std::vector<widechar> input = Widened(text);
  const std::size_t most = kMostCells * input.size() + 64;
  const int mode = dotsIO | ucBrl | noUndefined;
  for (std::size_t room = std::min(2 * input.size() + 64, most);; room = std::min(2 * room, most)) {
    Translation result;
    result.cells.resize(room);
    result.from.resize(std::max(room, input.size()));
    std::vector<int> to(std::max(room, input.size()));
    int taken = static_cast<int>(input.size());
    int given = static_cast<int>(room);
    State().first_error.clear();
    State().refused.clear();
    const int good = lou_translate(table.c_str(), input.data(), &taken, result.cells.data(), &given,
                                   nullptr, nullptr, to.data(), result.from.data(), nullptr, mode);
    if (good == 0) {
      throw InputError(WhatIsWrong(table));
    }
    if (static_cast<std::size_t>(taken) == input.size()) {
      result.cells.resize(static_cast<std::size_t>(given));
      return result;
    }
    if (room == most) {
      throw InputError("Braille table '" + OneLine(table, 40) +
                       "' makes too many cells of one line: use another");
    }
  }
}

// Ranges of cells of `text`, which begins at `first`, by the index that each was made of; where a
// table swaps parts the index would run back, and is held. A letter that the index leaves to the
// blank before it (of a pair written as one, the first) belongs to the cell behind; a mark that is
// written with a blank behind it is its cell, not the blank.
void AppendCells(const Translation& part, std::u32string_view text, std::size_t first,
                 std::vector<BrailleCell>& cells) {
  const std::size_t length = text.size();
  const std::size_t base = cells.size();
  std::size_t begin = 0;
  for (std::size_t i = 0; i < part.cells.size(); ++i) {
    begin = std::clamp(static_cast<std::size_t>(std::max(part.from[i], 0)), begin, length);
    BrailleCell cell;
    cell.dots = static_cast<std::uint8_t>(part.cells[i] & 0xFFU);
    cell.begin = static_cast<std::uint32_t>(first + begin);
    cell.end = cell.begin;
    cells.push_back(cell);
  }
  for (std::size_t i = base; i < cells.size(); ++i) {
    const bool last = i + 1 == cells.size();
    cells[i].end = last ? static_cast<std::uint32_t>(first + length) : cells[i + 1].begin;
    if (cells[i].dots != 0 || cells[i].begin == cells[i].end) continue;
    const std::uint32_t behind = cells[i].begin + 1;
    if (text[cells[i].begin - first] != U' ') {
      const bool written = i > base && cells[i - 1].dots != 0 &&
                           cells[i - 1].end == cells[i].begin &&
                           cells[i - 1].begin == cells[i - 1].end;
      if (written) cells[i].begin = cells[i - 1].end = cells[i].end;
    } else if (!last && cells[i].end > behind && text[behind - first] != U' ') {
      cells[i].end = cells[i + 1].begin = behind;
    }
  }
}

// Where a part of a long line ends: behind the last space that is within reach.
std::size_t PartEnd(std::u32string_view line, std::size_t at) {
  if (line.size() - at <= kLongestPart) return line.size();
  const std::size_t space = line.rfind(U' ', at + kLongestPart - 1);
  return space == std::u32string_view::npos || space < at ? at + kLongestPart : space + 1;
}

}  // namespace

BrailleTable::BrailleTable(const std::string& name) : name_(name) {
  CheckName(name);
  const std::lock_guard<std::mutex> lock(State().mutex);
  lou_registerLogCallback(KeepError);
  lou_setLogLevel(LOU_LOG_ERROR);
  lou_registerTableResolver(Resolve);
  State().first_error.clear();
  State().refused.clear();
  State().files = 0;
  if (lou_checkTable(name.c_str()) != 0) return;
  throw InputError(WhatIsWrong(name));
}

bool BrailleTable::Has(char32_t c) const {
  if (c < 0x20 || c == 0x7F || c > std::numeric_limits<widechar>::max()) return false;
  const auto found = has_.find(c);
  if (found != has_.end()) return found->second;
  const std::lock_guard<std::mutex> lock(State().mutex);
  const bool has = !Translated(name_, std::u32string_view(&c, 1)).cells.empty();
  has_.emplace(c, has);
  return has;
}

std::vector<BrailleCell> BrailleTable::Translate(std::u32string_view line) const {
  const std::lock_guard<std::mutex> lock(State().mutex);
  std::vector<BrailleCell> cells;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = PartEnd(line, at);
    const std::u32string_view part = line.substr(at, end - at);
    AppendCells(Translated(name_, part), part, at, cells);
    at = end;
  }
  return cells;
}

std::string BrailleTable::ReadBack(const std::vector<std::uint8_t>& cells) const {
  const std::lock_guard<std::mutex> lock(State().mutex);
  std::vector<widechar> input;
  input.reserve(cells.size());
  for (const std::uint8_t dots : cells) input.push_back(0x8000U | dots);  // as dotsIO gives
  std::vector<widechar> output(kMostCells * input.size() + 64);
  int taken = static_cast<int>(input.size());
  int given = static_cast<int>(output.size());
  const int good = lou_backTranslateString(name_.c_str(), input.data(), &taken, output.data(),
                                           &given, nullptr, nullptr, dotsIO | noUndefined);
  std::string text;
  for (int i = 0; good != 0 && i < given; ++i) {
    text += ToUtf8(static_cast<char32_t>(output[static_cast<std::size_t>(i)]));
  }
  return text;
}

#else

BrailleTable::BrailleTable(const std::string&) {
  throw LackError("built without liblouis: install liblouis-dev and liblouis-data, build again");
}
bool BrailleTable::Has(char32_t) const { return false; }
std::vector<BrailleCell> BrailleTable::Translate(std::u32string_view) const { return {}; }
std::string BrailleTable::ReadBack(const std::vector<std::uint8_t>&) const { return {}; }

#endif

}  // namespace moontrace

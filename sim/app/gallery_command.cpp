#include "sim/app/commands.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "sim/app/messages.h"
#include "sim/html_report/gallery_page.h"
#include "sim/setup/help.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
#include "textures/base/output_file.h"
#include "textures/base/resources.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

/// A picture: the command line that draws it, without `--picture`.
struct Exhibit {
  const char* title;
  std::vector<std::string> args;
};

// The letters a to z, as cells.
constexpr const char* kCells =
    "\u2801\u2803\u2809\u2819\u2811\u280b\u281b\u2813\u280a\u281a\u2805\u2807\u280d\u281d\u2815"
    "\u280f"
    "\u281f\u2817\u280e\u281e\u2825\u2827\u283a\u282d\u283d\u2835";

/// A line of text on a strip, as large as most are shown, unless `more` says otherwise.
std::vector<std::string> PageArgs(const char* text, const std::vector<std::string>& more) {
  std::vector<std::string> args{"page", text};
  for (const auto& [option, value] : {std::pair{"--page", "210x50"}, std::pair{"--size-mm", "9"}}) {
    if (std::find(more.begin(), more.end(), option) != more.end()) continue;
    args.insert(args.end(), {option, value});
  }
  args.insert(args.end(), more.begin(), more.end());
  return args;
}

std::vector<Exhibit> Scripts() {
  return {
      {"The signs of Moon", {"script", "picture", "moon"}},
      {"The signs of Braille", {"script", "picture", "braille", "--only", kCells}},
      {"The shapes of the first lessons", {"script", "picture", "shapes"}},
      {"A line of Moon", PageArgs("Moon by touch", {"--letters"})},
      {"Moon without contractions", PageArgs("sun and moon", {"--grade", "0.5", "--letters"})},
      {"Moon of grade 1", PageArgs("sun and moon", {"--grade", "1", "--letters"})},
      {"Moon of grade 2", PageArgs("the children could do it very well",
                                   {"--page", "210x90", "--grade", "2", "--letters"})},
      {"Another form of H", PageArgs("hush", {"--h-form", "pocket"})},
      {"Braille, uncontracted",
       PageArgs("Moon and Braille", {"--script", "braille", "--size-mm", "5", "--letters"})},
      {"Braille, contracted", PageArgs("Moon and Braille", {"--script", "braille", "--size-mm", "5",
                                                            "--grade", "2", "--letters"})},
      {"Braille of raised dots",
       PageArgs("dots", {"--script", "braille", "--size-mm", "5", "--embossed"})},
      {"A Hershey font", PageArgs("Strokes of 1967", {"--script", "hershey:rowmans"})},
      {"Japanese characters in writing order",
       PageArgs("\u65e5\u6728\u4e09", {"--script", "sample-kanji", "--size-mm", "18"})},
      {"Chinese characters in writing order",
       PageArgs("\u6728\u4e00", {"--script", "sample-hanzi", "--size-mm", "18"})},
      {"A sign with no form, named", PageArgs("5 \u20ac", {"--size-mm", "8", "--letters"})},
  };
}

std::vector<Exhibit> Options() {
  return {
      {"Large letters, to begin with",
       PageArgs("Moon", {"--page", "210x60", "--size-mm", "24", "--letters"})},
      {"Ridges instead of grooves", PageArgs("Moon by touch", {"--embossed"})},
      {"Letters that lean", PageArgs("Moon by touch", {"--slant-deg", "15"})},
      {"Wide letters", PageArgs("Moon", {"--stretch", "1.5"})},
      {"More room between letters and words",
       PageArgs("room to move", {"--letter-gap-mm", "3", "--word-gap-mm", "6", "--letters"})},
      {"Words broken by the patterns of their language",
       PageArgs("hyphenation by patterns",
                {"--page", "90x150", "--hyphenate", "en_US", "--letters"})},
      {"A running head and page numbers",
       PageArgs("the first page", {"--page", "210x80", "--running-head", "Moonlight",
                                   "--page-numbers", "--letters"})},
      {"Lines that turn back, as in old Moon",
       PageArgs("lines come to an end and turn",
                {"--page", "160x60", "--lines", "alternate", "--size-mm", "8"})},
      {"Lines from right to left",
       PageArgs("right to left", {"--lines", "right-to-left", "--letters"})},
      {"Lines from top to bottom",
       PageArgs("down", {"--page", "80x120", "--lines", "vertical", "--letters"})},
      {"Links between the letters of a word",
       PageArgs("no sun, no moon", {"--size-mm", "8", "--links", "letters"})},
      {"Links across words too",
       PageArgs("no sun, no moon", {"--size-mm", "8", "--links", "words"})},
      {"Raised rules beside the lines",
       PageArgs("between the rules", {"--size-mm", "8", "--line-pitch-mm", "18", "--rules"})},
      {"A raised margin", PageArgs("inside", {"--margin-mm", "12", "--raised-margin"})},
      {"Paper of parallel waves", PageArgs("waves", {"--texture", "sine"})},
      {"Paper of waves both ways", PageArgs("grid", {"--texture", "grid"})},
      {"Rough paper", PageArgs("rough", {"--texture", "noise"})},
      {"Woven paper, from a picture",
       PageArgs("woven", {"--texture", ResourcePath("textures/tiles/weave.pgm"),
                          "--texture-wavelength-mm", "8"})},
      {"Two sizes: a heading, a quotation, a link",
       PageArgs("# News\nThe [moon](m) is up.\n> So bright!",
                {"--page", "160x110", "--size-mm", "8", "--structure", "--structure-texture", "yes",
                 "--letters"})},
      {"A heading of ridges above grooves",
       PageArgs("# Ridges\nand grooves", {"--page", "160x80", "--size-mm", "10", "--structure",
                                          "--heading-relief", "embossed"})},
  };
}

/// A word as it would be typed in a shell (bash); lines are parted as $'...' has them.
std::string Typed(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::strchr("-./:_", c) != nullptr;
  });
  if (plain) return word;
  std::string typed = word.find('\n') == std::string::npos ? "'" : "$'";
  const bool escapes = typed.size() > 1;
  for (const char c : word) {
    if (c == '\n') {
      typed += "\\n";
    } else if (c == '\'') {
      typed += escapes ? "\\'" : "'\\''";
    } else if (c == '\\' && escapes) {
      typed += "\\\\";
    } else {
      typed += c;
    }
  }
  return typed + "'";
}

/// The command that draws `file` where it is typed.
std::string Typed(const Exhibit& exhibit, const std::string& file) {
  std::string line = "moontrace";
  for (const std::string& arg : exhibit.args) line.append(" ").append(Typed(arg));
  return line.append(" --picture ").append(file);
}

std::string FileName(const std::string& title, std::size_t number) {
  std::string name = fmt::format("{:02}-", number);
  for (const char c : title) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (plain) name += c;
    if (c >= 'A' && c <= 'Z') name += static_cast<char>(c - 'A' + 'a');
    if (c == ' ') name += '-';
  }
  return name + ".svg";
}

/// The files and folders that a run adds: taken away again, unless it is kept.
class Additions {
 public:
  ~Additions() {
    std::error_code ignored;
    for (auto added = added_.rbegin(); added != added_.rend(); ++added) fs::remove(*added, ignored);
  }
  Additions() = default;
  Additions(const Additions&) = delete;
  Additions& operator=(const Additions&) = delete;

  /// Called before it is made; what is there already stays.
  void Expect(const fs::path& path) {
    std::error_code unknown;
    const fs::file_status status = fs::symlink_status(path, unknown);
    if (status.type() != fs::file_type::not_found) return;
    if (path.has_relative_path()) Expect(path.parent_path());
    added_.push_back(path);
  }
  void Keep() { added_.clear(); }

 private:
  std::vector<fs::path> added_;  ///< folders before what is in them
};

/// Runs the exhibit's command. Where the machine lacks something its line stands in place of a
/// picture; any other failure ends the work.
GalleryPicture Show(const Exhibit& exhibit, std::size_t number, const fs::path& folder,
                    const CommandLine& run, Additions& additions, Console& console) {
  const std::string file = FileName(exhibit.title, number);
  GalleryPicture shown{exhibit.title, Typed(exhibit, file), file, ""};
  const std::string path = (folder / file).string();
  additions.Expect(path);
  std::vector<std::string> args = exhibit.args;
  args.insert(args.end(), {"--picture", path});
  std::istringstream in;
  std::ostringstream out, err;
  Console inner(in, out, err, console.stop());
  const int code = run(args, inner);
  console.CheckStop();
  std::string refusal = err.str();
  if (!refusal.empty() && refusal.back() == '\n') refusal.pop_back();
  // an error that names the picture is about its folder, which all pictures share
  if (code == exit_code::kLack && refusal.find(file) != std::string::npos) throw LackError(refusal);
  if (code != exit_code::kGood && code != exit_code::kLack) {
    throw WorkFailed(say::ExhibitFailed(exhibit.title, refusal));
  }
  if (code == exit_code::kGood && !fs::exists(path)) {
    throw WorkFailed(say::ExhibitFailed(exhibit.title, "more than a page"));
  }
  shown.words = out.str();
  // the page says itself where its picture stands
  const std::size_t last = shown.words.find(std::string(say::PictureIn()) + "\n");
  if (last != std::string::npos) shown.words.resize(last);
  if (code == exit_code::kLack) {
    shown.words = refusal;
    shown.picture.clear();
  }
  return shown;
}

}  // namespace

void AddOptions(CLI::App& app, GalleryOptions& options) {
  AddPath(app, "--folder", "DIR", options.folder, say::help::kGalleryFolder);
  AddOptions(app, options.output);
}

int RunGallery(const GalleryOptions& options, const CommandLine& run, Console& console) {
  const fs::path folder = fs::absolute(options.folder / fs::path()).lexically_normal();
  const std::string page = (folder / "index.html").string();
  Additions additions;
  additions.Expect(page);
  MakeFolder(options.folder);
  RequireWritable(page);
  std::vector<GalleryPicture> pictures;
  std::size_t missing = 0;
  std::vector<Exhibit> exhibits = Scripts();
  for (Exhibit& exhibit : Options()) exhibits.push_back(std::move(exhibit));
  for (const Exhibit& exhibit : exhibits) {
    pictures.push_back(Show(exhibit, pictures.size() + 1, folder, run, additions, console));
    if (pictures.back().picture.empty()) {
      ++missing;
      console.Remark(say::ExhibitMissing(exhibit.title, pictures.back().words));
    }
  }
  WriteWhole(page, GalleryPage(pictures));
  additions.Keep();
  if (options.output.json) {
    Json list = Json::array();
    for (const GalleryPicture& shown : pictures) {
      list.push_back({{"title", shown.title},
                      {"command", shown.command},
                      {"picture", shown.picture},
                      {"words", shown.words}});
    }
    console.Json(Dump({{"page", page}, {"pictures", std::move(list)}}));
    return exit_code::kGood;
  }
  console.Result(say::GalleryOutcome(pictures.size() - missing, missing));
  console.Path(page);
  return exit_code::kGood;
}

}  // namespace moontrace

#pragma once

#include <string>
#include <vector>

#include "sim/setup/cli_app.h"

namespace moontrace {

/// An option as help tells it.
struct OptionSheet {
  std::string name;   ///< "--size-mm", "TEXT"
  std::string value;  ///< what follows it, "NUMBER"; empty: nothing
  std::string group;  ///< heading that it stands under
  std::string description;
  bool positional = false;
};

/// A command as help tells it.
struct CommandSheet {
  std::string name, purpose;
  std::vector<OptionSheet> options;  ///< in the order in which they were added
};

/// What an app was given.
CommandSheet SheetOf(const CLI::App& app);

/// Headings that options stand under.
namespace help_group {
inline constexpr const char* kText = "Text";
inline constexpr const char* kLetters = "Letters";
inline constexpr const char* kLinks = "Links between letters";
inline constexpr const char* kStructure = "Marks in the text";
inline constexpr const char* kPage = "Page and lines";
inline constexpr const char* kSheet = "Rules and rough paper";
inline constexpr const char* kFeel = "Force and model";
inline constexpr const char* kHand = "Simulated hand";
inline constexpr const char* kResults = "Pictures and records";
inline constexpr const char* kView = "Window and pictures of it";
inline constexpr const char* kDevice = "Device";
inline constexpr const char* kOutput = "What is said";
}  // namespace help_group

/// What each command and option is for, as --help prints it. Options of one subject stand in the
/// *messages.h of that subject.
namespace say::help {
inline constexpr const char* kPage = "says what stands on the page, sign by sign";
inline constexpr const char* kTrace = "a simulated stylus traces the text and is scored";
inline constexpr const char* kProbe =
    "surface and force at one point, in mm from the first letter's lower left corner";
inline constexpr const char* kReplay = "runs a recorded trace again and compares";
inline constexpr const char* kBench = "measures speed and accuracy against other methods";
inline constexpr const char* kDemo = "traces a word at four sizes and leaves pictures";

inline constexpr const char* kHelpWord = "moontrace help: tells all commands, or one of them.";
inline constexpr const char* kVersionWord =
    "moontrace version: says which Moontrace this is, and which MuJoCo. It takes nothing more.";
inline constexpr const char* kTestWord =
    "./moontrace test: in a clone, builds and runs the quick tests.";
inline constexpr const char* kPackagesWord =
    "./moontrace packages run, test or ci: in a clone, installs what is needed.";

inline constexpr const char* kGallery =
    "draws each kind of script and setting, gathered in one page with words";
inline constexpr const char* kDevices =
    "says which devices are there and what they can do, or tries one: devices test NAME";
inline constexpr const char* kDevicesWords = "nothing or list, or: test NAME.";
inline constexpr const char* kUdev = "print the udev rules that the device profiles make.";
inline constexpr const char* kText = "the text; - reads standard input.";
inline constexpr const char* kFile = "read the text from this file; - is standard input.";
inline constexpr const char* kJson = "write one JSON object instead of words.";
inline constexpr const char* kQuiet =
    "no remarks and nothing of what goes on; only results, answers, lost force and errors.";
inline constexpr const char* kSize =
    "height of the letters in mm, 1 to 1000; of Braille from dot 1 to dot 3. Default the script's: "
    "12, Braille 5.";
inline constexpr const char* kWidth =
    "width of the groove in mm. Default 0.1165 of the size, more below 8 mm.";
inline constexpr const char* kDepth =
    "depth of the groove in mm. Default half its width, less below 8 mm.";
inline constexpr const char* kRounding =
    "half width of the rounded spine and rims in mm, at most a quarter of the width. Default a "
    "fifth.";
inline constexpr const char* kEmbossed = "ridges instead of grooves.";
inline constexpr const char* kScript = "name of a script or path of its SVG font. Default moon.";
inline constexpr const char* kHForm = "form of H: crescent, arc, pocket or reverse-n.";
inline constexpr const char* kGrade =
    "Moon: 0.5 no contractions, 1 those of grade 1, 2 what is known of grade 2. Braille: 1 "
    "uncontracted, 2 contracted. Default 1.";
inline constexpr const char* kPaper =
    "a4, a5, workspace (160 by 120 mm) or width x height in mm like 120x80. Default a4. In a "
    "window a short text lies in the middle of it, by default of a square cut to the text.";
inline constexpr const char* kMargin =
    "margin on all sides in mm. Default 15 on a4 and a5, else 10.";
inline constexpr const char* kLetterGap = "added between letters in mm. Default 0.";
inline constexpr const char* kWordGap = "added between words in mm. Default 0.";
inline constexpr const char* kLinePitch =
    "from base line to base line in mm. Default 1.8 sizes, Braille 2; more where --rules need it.";
inline constexpr const char* kTilt =
    "raises the far edge of the page, in degrees from -60 to 60. Default 0.";
inline constexpr const char* kSeed = "of tremor and drift, a whole number. Default 1.";
inline constexpr const char* kRender = "proxy (quiet) or direct (the paper's). Default proxy.";
inline constexpr const char* kLaw = "potential (conserves energy) or paper. Default potential.";
inline constexpr const char* kModel =
    "an MJCF model whose first moontrace label carries the text; keys of the label count unless "
    "given here.";
inline constexpr const char* kLabel =
    "which label of the model carries the text: GEOM, GEOM:2 ..., by trace also all, one after "
    "another. Default: the first.";
inline constexpr const char* kUnlabelled =
    "what is felt of the model's geoms without a label: nothing, plain (a smooth surface) or "
    "contacts (MuJoCo's own). Default nothing.";
inline constexpr const char* kFriction =
    "Coulomb friction, from 0 to less than 0.9 over the steepest slope. Default 0.";
inline constexpr const char* kPress = "press of the hand in N. Default 1, embossed 0.2.";
inline constexpr const char* kSpeed = "greatest speed along a stroke in mm/s. Default 40.";
inline constexpr const char* kPicture =
    "write a picture, .svg, .png or .pdf; a PDF holds all pages, of others there are F-1, F-2 and "
    "so on.";
inline constexpr const char* kLetters = "small print below each sign of the picture.";
inline constexpr const char* kRecord =
    "record the trace to this folder for replay; several pages to DIR-1, DIR-2 and so on.";
inline constexpr const char* kCsv = "the record's samples as CSV too.";
inline constexpr const char* kDeviceProfile =
    "the simulated hand is on that device: a profile's name, such as woodenhaptics, or its file. "
    "Its "
    "readings, delay, coupling and peak force. Default: read exactly.";
inline constexpr const char* kBlank = "the same movements on paper without grooves.";
inline constexpr const char* kX = "mm along the line of text.";
inline constexpr const char* kY = "mm up the page.";
inline constexpr const char* kZ = "mm out of the paper, negative is into it.";
inline constexpr const char* kFolder = "a folder written by trace --record.";
inline constexpr const char* kCheck = "exit with 1 unless the replay is equal to the bit.";
inline constexpr const char* kStability =
    "instead: the stiffness that devices hold quiet, and the energy they put out.";
inline constexpr const char* kHeat =
    "instead: how warm motors become under a resting hand, page level and tilted.";
inline constexpr const char* kGalleryFolder =
    "where the page and its pictures go. Default moontrace-gallery.";
inline constexpr const char* kDemoFolder = "where the pictures go. Default moontrace-demo.";
inline constexpr const char* kGuide =
    "a push on the hand: off, attract, rail, bead, amplify or corridor. Default off.";
inline constexpr const char* kHelpLevel = "how much, 0 (none) to 10. Default 6.";
}  // namespace say::help

}  // namespace moontrace

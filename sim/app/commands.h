#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/core/mailbox.h"
#include "devices/hand/aimed_stylus.h"
#include "lessons/course/guidance_mode.h"
#include "sim/console/console.h"
#include "sim/learn/learn_options.h"
#include "sim/session/device_choice.h"
#include "sim/session/view_options.h"
#include "sim/setup/options.h"

/// What each command takes and runs, in the order of help. AddOptions binds a command's options to
/// its line; Run gives the exit code or throws (cli.h turns what is thrown into a line and a code).
namespace moontrace {

class Records;
class ViewFeed;
struct DeviceEntry;
struct LearnerEntry;

/// `demo`: a newcomer's first minute. Traces a word at four sizes and on blank paper, and leaves
/// pictures.
struct DemoOptions {
  OutputOptions output;
  std::uint64_t seed = 1;
  std::string folder = "moontrace-demo";
};
void AddOptions(CLI::App& app, DemoOptions& options);
int Run(const DemoOptions& options, Console& console);

/// `page`: what stands on the page and what was replaced; a picture if asked for.
struct PageOptions {
  OutputOptions output;
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  std::string picture;
  bool letters = false;
  bool read_back = false;
};
void AddOptions(CLI::App& app, PageOptions& options);
int Run(const PageOptions& options, Console& console);

/// `--guide`, `--help-level` of `trace`, as given.
struct GuideOptions {
  std::optional<GuidanceMode> mode;
  std::optional<double> help;  ///< 0-10
};

/// `read`: what a document holds; its text, or its pages for swell paper.
struct ReadOptions {
  OutputOptions output;
  std::string file;  ///< "-": standard input; a number of the list; empty: that list is told
  StyleOptions style;
  LayoutOptions layout;
  bool text = false;
  std::string print;                 ///< empty: none
  std::optional<double> most_bytes;  ///< of the document, see DocumentLimits
  std::string braille;               ///< table by which Braille is read; empty: the language's
  std::string learner, records;      ///< empty: the only one; the user's
  LiveOptions live;                  ///< device empty: the first one with motors
  std::optional<double> press;       ///< [N]
  std::uint64_t seed = 1;
  bool simulate = false;  ///< the simulated stylus reads on by itself
  bool turns = false;     ///< pages are turned behind their last letter
  bool moon = false;      ///< answers are laid under the hand, see BookOptions
  bool tutor = false;     ///< tutors may come in from other terminals
  bool known = false;     ///< only signs that the learner has been taught are set
  bool forget = false;    ///< what is kept of the file
};
void AddOptions(CLI::App& app, ReadOptions& options);
int Run(const ReadOptions& options, Console& console);

/// `trace`: the simulated stylus traces a text, page after page, and is scored; with `--device` a
/// person does, in real time.
struct TraceOptions {
  OutputOptions output;
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  FeelOptions feel;
  std::optional<double> press;  ///< [N]
  std::optional<double> speed;  ///< [m/s]
  GuideOptions guide;
  std::uint64_t seed = 1;
  bool seed_given = false;
  bool blank = false;
  std::string device_profile;  ///< of the simulated hand; empty: none
  std::string record;
  bool csv = false;
  std::string picture;

  ViewOptions view;
  LiveOptions live;  ///< device empty or "simulated": the rest counts for nothing and is refused
};
void AddOptions(CLI::App& app, TraceOptions& options);
int Run(const TraceOptions& options, Console& console);
/// With a device: a person's own trace, or an emulated device's, in real time, scored as the
/// simulated one is, off the tick. Ends by "quit" or after `seconds`. Throws UsageError for options
/// that belong to the simulated stylus, DeviceError.
int TraceWithDevice(const TraceOptions& options, Console& console);

/// `recognise`: a simulated reader that only feels reads the text's pages, and is scored.
struct RecogniseOptions {
  OutputOptions output;
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  FeelOptions feel;
  std::optional<double> press;  ///< [N]
  std::uint64_t seed = 1;
  std::string device;            ///< profile of the simulated hand; empty: none
  std::optional<double> unsure;  ///< rms error of the place [m]
  bool blank = false;
  std::string picture;
  ViewOptions view;
};
void AddOptions(CLI::App& app, RecogniseOptions& options);
int Run(const RecogniseOptions& options, Console& console);

/// `learn`: lessons.
void AddOptions(CLI::App& app, LearnOptions& options);
int Run(const LearnOptions& options, Console& console);

/// `loop`: a text is felt in real time, with any device.
struct LoopCommandOptions {
  OutputOptions output;
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  FeelOptions feel;
  LiveOptions live;
  std::optional<double> press;  ///< [N]
  std::uint64_t seed = 1;
  ViewOptions view;
};
void AddOptions(CLI::App& app, LoopCommandOptions& options);
int Run(const LoopCommandOptions& options, Console& console);
/// All but the view's.
void AddLoopOptions(CLI::App& app, LoopCommandOptions& options);
/// With a view that is there already, or null. `aims`: see SessionRequest.
int RunLoop(const LoopCommandOptions& options, ViewFeed* view,
            const std::shared_ptr<Mailbox<StylusAim>>& aims, Console& console);

/// `view`: a loop in a window, or one picture of it.
struct ViewCommandOptions : LoopCommandOptions {
  std::string picture;  ///< empty: none
};
void AddOptions(CLI::App& app, ViewCommandOptions& options);
int Run(const ViewCommandOptions& given, Console& console);

/// `probe`: what a tip meets at one point of the first page.
struct ProbeOptions {
  OutputOptions output;
  std::array<std::optional<double>, 3> point;  ///< from the first letter's lower left corner [m]
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  Surface surface;
};
void AddOptions(CLI::App& app, ProbeOptions& options);
int Run(const ProbeOptions& options, Console& console);

/// `script list|info|check|convert|picture`: which scripts there are, what one holds, what is hard
/// to trace in it; a script in any format as our SVG font; a table of its signs.
struct ScriptOptions {
  OutputOptions output;
  std::string action, script;
  std::string only;            ///< these characters; empty = all
  std::optional<double> size;  ///< [m]
  bool all = false;            ///< check: each finding, however many
  std::string to;              ///< convert: the SVG font; the TOML file goes beside it
  bool join = false;           ///< convert: strokes that follow each other become one
  std::string picture;         ///< picture: .svg, .png, .pdf
};
void AddOptions(CLI::App& app, ScriptOptions& options);
int Run(const ScriptOptions& options, Console& console);

/// `gallery`: a picture of each script and option with words beside it, in one page of HTML. The
/// pictures and words are those of the command that stands above them.
struct GalleryOptions {
  OutputOptions output;
  std::string folder = "moontrace-gallery";
};
void AddOptions(CLI::App& app, GalleryOptions& options);
/// Runs one command line, as RunCli.
using CommandLine = std::function<int(const std::vector<std::string>& args, Console& console)>;
int RunGallery(const GalleryOptions& options, const CommandLine& run, Console& console);

/// `replay`: runs a record again; everything comes from the record.
struct ReplayOptions {
  OutputOptions output;
  std::string folder;
  bool check = false;
  ViewOptions view;
};
void AddOptions(CLI::App& app, ReplayOptions& options);
int Run(const ReplayOptions& options, Console& console);

/// `tutor`: lines of the tutor to a running lesson, and its lines back. Ends when the lesson ends,
/// when the tutor says quit, and when standard input has ended and all is answered.
struct TutorOptions {
  std::string learner;  ///< empty: the only one whose lesson runs
  OutputOptions output;
};
void AddOptions(CLI::App& app, TutorOptions& options);
/// Throws LackError: no lesson runs, or several and none was chosen.
int Run(const TutorOptions& options, Console& console);

/// `sounds`: learn the sounds. One line each; played or written if asked for.
struct SoundsOptions {
  bool play = false;
  std::string wav;     ///< folder; empty: none are written
  std::string sounds;  ///< a file of the user's, see LoadSounds
  OutputOptions output;
};
void AddOptions(CLI::App& app, SoundsOptions& options);
/// Throws LackError where `play` finds no output; the list has been given then.
int Run(const SoundsOptions& options, Console& console);

/// `report NAME [--html F | --csv F]`: how a learner does, from the records.
struct ReportOptions {
  OutputOptions output;
  std::string learner;
  std::string learner_too;  ///< the same, by --learner
  std::string course, records, html, csv;
};
void AddOptions(CLI::App& app, ReportOptions& options);
int Run(const ReportOptions& options, Console& console);

/// `records list|export NAME|import FILE|erase NAME|consent NAME yes|no`: what the program knows of
/// learners, in their own hands.
struct RecordsOptions {
  OutputOptions output;
  std::string action;
  std::string subject;  ///< learner, or file of an import
  std::string answer;   ///< of consent
  std::string records;  ///< file; empty: the user's
  std::string to;       ///< file of an export; empty: standard output
  bool anonymous = false;
  bool yes = false;
};
void AddOptions(CLI::App& app, RecordsOptions& options);
int Run(const RecordsOptions& options, Console& console);
/// The records to look into: those named, otherwise the user's.
std::string RecordsPathOf(const std::string& given);
/// Throws InputError, naming the nearest, for a learner who is not in the records.
LearnerEntry KnownLearner(const Records& records, const std::string& name);

/// `course check PATH...|show [PATH]`: what is wrong with courses and lessons; what they teach.
struct CourseOptions {
  OutputOptions output;
  std::vector<std::string> words;  ///< the action, then courses
  std::string device;              ///< check: a profile's name; empty = no size is too small
};
void AddOptions(CLI::App& app, CourseOptions& options);
int Run(const CourseOptions& options, Console& console);

/// `devices`: what is there and what it can do; `devices test NAME`: tries one step by step.
struct DevicesOptions {
  OutputOptions output;
  std::vector<std::string> words;
  bool udev = false;  ///< print the udev file that the profiles make, for developers
};
void AddOptions(CLI::App& app, DevicesOptions& options);
int Run(const DevicesOptions& options, Console& console);
/// How to give the permission to open a device, where that is what it lacks.
void SayMending(const DeviceEntry& entry, Console& console);

/// `study FILE | merge A B ...`: simulated learners by a protocol.
struct StudyOptions {
  OutputOptions output;
  std::vector<std::string> words;  ///< a protocol, or "merge" and files
  std::string path;                ///< of the rows; empty: by the protocol's name
  std::optional<double> threads;   ///< whole; none: one a core
  std::string shard;               ///< "K/N"; empty: all
  std::string picture;             ///< of a study of reading; empty: none
};
void AddOptions(CLI::App& app, StudyOptions& options);
int Run(const StudyOptions& options, Console& console);

/// `bench`: measures what the design promises, each beside what it is compared with in the same
/// run. With `--stability` or `--heat` only what they name: what devices hold without buzzing, and
/// how warm their motors become.
struct BenchOptions {
  OutputOptions output;
  bool stability = false;
  bool heat = false;
};
void AddOptions(CLI::App& app, BenchOptions& options);
int Run(const BenchOptions& options, Console& console);

}  // namespace moontrace

#include "sim/app/cli.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <ostream>

#include "devices/core/device_error.h"
#include "sim/app/commands.h"
#include "sim/app/course_messages.h"
#include "sim/app/manual.h"
#include "sim/app/messages.h"
#include "sim/app/program_help.h"
#include "sim/app/script_messages.h"
#include "sim/audio/sound_messages.h"
#include "sim/book/document_messages.h"
#include "sim/html_report/records_messages.h"
#include "sim/html_report/report_messages.h"
#include "sim/learn/learn_messages.h"
#include "sim/physics/mujoco_compat.h"
#include "sim/recognise/recognise_messages.h"
#include "sim/session/loop_messages.h"
#include "sim/session/view_messages.h"
#include "sim/setup/help.h"
#include "sim/study/study_messages.h"
#include "sim/tutor/tutor_messages.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

using Args = std::vector<std::string>;

/// The option of a command that is meant by one that it lacks; empty where none is near.
std::string NearestOptionOf(const CLI::App& app, std::string_view given) {
  std::vector<std::string> names{"help"};
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back(name);
  }
  const std::string nearest = NearestOption(given, names);
  return nearest.empty() ? nearest : "--" + nearest;
}

bool TakesText(const CLI::App& app) {
  const auto options = app.get_options();
  return std::any_of(options.begin(), options.end(), [](const CLI::Option* option) {
    return option->get_positional() && option->get_single_name() == "TEXT";
  });
}

/// What CLI11 did not know: an option (named with its nearest) or an argument too many.
void RefuseSpare(const CLI::App& app) {
  bool options_ended = false;
  for (const std::string& given : app.remaining()) {
    if (given == "--" && !options_ended) {
      options_ended = true;
      continue;
    }
    if (options_ended || given.size() < 2 || given[0] != '-') {
      throw UsageError(say::SpareArgument(given, app.get_name(), TakesText(app)));
    }
    const std::string name = given.substr(0, given.find('='));
    throw UsageError(say::UnknownOption(name, app.get_name(), NearestOptionOf(app, name)));
  }
}

void Parse(CLI::App& app, Args args) {
  std::reverse(args.begin(), args.end());  // CLI11 takes them from the back
  try {
    app.parse(std::move(args));
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string what = error.what();
    throw UsageError(say::ValueMissing(what.substr(0, what.find(':'))));
  } catch (const CLI::ParseError& error) {
    throw UsageError(OneLine(error.what(), 200));
  }
  RefuseSpare(app);
}

enum class HelpAsked { kNo, kCommon, kAll };

HelpAsked AsksForHelp(const Args& args) {
  for (const std::string& arg : args) {
    if (arg == "--") return HelpAsked::kNo;
    if (arg == "--help-all") return HelpAsked::kAll;
    if (arg == "--help" || arg == "-h") return HelpAsked::kCommon;
  }
  return HelpAsked::kNo;
}

int Run(const GalleryOptions& options, Console& console) {
  return RunGallery(options, RunCli, console);
}

/// A command's line with its options bound.
template <typename Options>
std::unique_ptr<CLI::App> LineOf(const CommandCard& card, Options& options) {
  auto app = std::make_unique<CLI::App>(card.purpose, card.name);
  app->set_help_flag();
  app->allow_extras();
  AddOptions(*app, options);
  return app;
}

template <typename Options>
CommandSheet Sheet(const CommandCard& card) {
  Options options;
  return SheetOf(*LineOf(card, options));
}

/// Reads one command's options and runs it.
template <typename Options>
int RunCommand(const CommandCard& card, const Args& args, Console& console) {
  Options options;
  const std::unique_ptr<CLI::App> app = LineOf(card, options);
  const HelpAsked help = AsksForHelp(args);
  if (help != HelpAsked::kNo) {
    console.Help(CommandHelp(card, SheetOf(*app), help == HelpAsked::kAll));
    return exit_code::kGood;
  }
  Parse(*app, args);
  console.Set(options.output.json, options.output.quiet);
  return Run(options, console);
}

struct Command {
  CommandCard card;
  int (*run)(const CommandCard& card, const Args& args, Console& console);
  CommandSheet (*sheet)(const CommandCard& card);
};

template <typename Options>
constexpr Command Of(const CommandCard& card) {
  return {card, RunCommand<Options>, Sheet<Options>};
}

namespace help = say::help;
constexpr Command kCommands[] = {
    Of<DemoOptions>({"demo", help::kDemo, Audience::kLearner, "", "example try hello start begin"}),
    Of<LearnOptions>({"learn", help::kLearn, Audience::kLearner,
                      "--learner --device --tutor --speak --sound --keys --view --print",
                      "lesson lessons tutorial practise practice training"}),
    Of<LoopCommandOptions>({"loop", help::kLoop, Audience::kLearner,
                            "TEXT --file --device --size-mm --script --view --seconds",
                            "feel touch live run"}),
    Of<ViewCommandOptions>({"view", help::kViewCommand, Audience::kLearner,
                            "TEXT --file --size-mm --script --device --picture --large-text",
                            "window show see gui mouse open"}),
    Of<ReadOptions>({"read", help::kRead, Audience::kLearner,
                     "FILE --learner --device --size-mm --turn --simulate --text --print --json",
                     "book books epub html document open library"}),
    Of<SoundsOptions>({"sounds", help::kSounds, Audience::kLearner, "", "sound audio"}),
    Of<TutorOptions>({"tutor", help::kTutor, Audience::kTutor, "", "teacher teach"}),
    Of<ReportOptions>({"report", help::kReport, Audience::kTutor, "", "progress results"}),
    Of<RecordsOptions>({"records", help::kRecordsCommand, Audience::kTutor, "",
                        "learners export import erase consent"}),
    Of<CourseOptions>({"course", help::kCourseCommand, Audience::kTutor, "", "courses"}),
    Of<PageOptions>({"page", help::kPage, Audience::kWriter,
                     "TEXT --file --size-mm --script --embossed --page --picture --letters",
                     "pages print write text braille translate emboss draw"}),
    Of<ScriptOptions>({"script", help::kScriptCommand, Audience::kWriter, "",
                       "scripts font fonts alphabet list check convert"}),
    Of<GalleryOptions>({"gallery", help::kGallery, Audience::kWriter, "", "pictures examples"}),
    Of<TraceOptions>({"trace", help::kTrace, Audience::kResearcher,
                      "TEXT --file --size-mm --script --model --label --device --press-n --blank "
                      "--picture --record --view --seed --json",
                      "simulate score follow label labels model mujoco mjcf"}),
    Of<RecogniseOptions>(
        {"recognise", help::kRecognise, Audience::kResearcher,
         "TEXT --file --size-mm --script --press-n --blank --picture --seed --json",
         "recognize reader feel"}),
    Of<ReplayOptions>({"replay", help::kReplay, Audience::kResearcher, "", "play repeat"}),
    Of<StudyOptions>(
        {"study", help::kStudyCommand, Audience::kResearcher, "", "studies experiment merge"}),
    Of<ProbeOptions>({"probe", help::kProbe, Audience::kResearcher,
                      "X Y Z TEXT --file --size-mm --script --law --json", "point height"}),
    Of<BenchOptions>({"bench", help::kBench, Audience::kResearcher, "",
                      "benchmark speed measure stability heat"}),
    Of<DevicesOptions>({"devices", help::kDevices, Audience::kDeviceBuilder, "",
                        "device hardware usb hid joystick"}),
};

std::vector<CommandCard> Cards() {
  std::vector<CommandCard> cards;
  for (const Command& command : kCommands) cards.push_back(command.card);
  return cards;
}

/// A word that may stand first and is no command.
struct PlainWord {
  const char* name;
  const char* also;  ///< other words that mean it
  const char* help;
  bool launchers;  ///< the launcher takes it before the program starts
};
constexpr PlainWord kPlainWords[] = {
    {"help", "commands manual man usage", help::kHelpWord, false},
    {"version", "about -v -V", help::kVersionWord, false},
    {"test", "tests", help::kTestWord, true},
    {"packages", "package install", help::kPackagesWord, true},
};

const PlainWord* PlainWordNamed(const std::string& name) {
  for (const PlainWord& word : kPlainWords) {
    if (name == word.name) return &word;
  }
  return nullptr;
}

const Command* CommandNamed(const std::string& name) {
  for (const Command& command : kCommands) {
    if (name == command.card.name) return &command;
  }
  return nullptr;
}

/// Throws UsageError for a line that begins with no command.
[[noreturn]] void RefuseCommand(const Args& args) {
  const std::string& given = args.front();
  const PlainWord* plain = PlainWordNamed(given);
  if (plain != nullptr && plain->launchers) throw UsageError(plain->help);
  std::vector<CommandCard> cards = Cards();
  for (const PlainWord& word : kPlainWords) cards.push_back({word.name, "", {}, "", word.also});
  std::string nearest = NearestCommand(given, cards);
  if (nearest.empty()) nearest = TextAsPage(args);
  throw UsageError(say::UnknownCommand(given, nearest));
}

/// Behind what help is asked for stands nothing but a wish for all of it.
void CheckHelp(const Args& args) {
  for (std::size_t i = 1; i < args.size(); ++i) {
    if (AsksForHelp({args[i]}) == HelpAsked::kNo) throw UsageError(say::HelpTakesOne(args[i]));
  }
}

std::vector<CommandSheet> Sheets() {
  std::vector<CommandSheet> sheets;
  for (const Command& command : kCommands) sheets.push_back(command.sheet(command.card));
  return sheets;
}

/// `help --markdown` and the like, for files that are made of help; false: something else is asked.
bool HelpForFiles(const std::string& what, Console& console) {
  if (what == "--markdown") {
    console.out() << Reference(Cards(), Sheets());
  } else if (what == "--man") {
    console.out() << Manual(Cards(), Sheets(), MOONTRACE_VERSION);
  } else if (what == "--bash") {
    std::vector<std::string> words{"help", "version"};
    for (const Command& command : kCommands) words.emplace_back(command.card.name);
    console.out() << BashCompletion(words, Sheets());
  } else {
    return false;
  }
  return true;
}

/// `help`, `help COMMAND`, `help --markdown`.
int Help(const Args& args, Console& console) {
  CheckHelp(args);
  const std::string what = args.empty() ? "--help" : args.front();
  if (AsksForHelp({what}) != HelpAsked::kNo) {
    console.Help(ProgramHelp(Cards()));
  } else if (const PlainWord* word = PlainWordNamed(what)) {
    console.Result(word->help);
  } else if (!HelpForFiles(what, console)) {
    const Command* command = CommandNamed(what);
    if (command == nullptr) RefuseCommand(args);
    const bool all = AsksForHelp(args) == HelpAsked::kAll;
    console.Help(CommandHelp(command->card, command->sheet(command->card), all));
  }
  return exit_code::kGood;
}

int Dispatch(const Args& args, Console& console) {
  if (args.empty()) {
    console.Help(Introduction());
    return exit_code::kGood;
  }
  const std::string& first = args.front();
  const Args rest(args.begin() + 1, args.end());
  if (first == "help" || AsksForHelp({first}) != HelpAsked::kNo) return Help(rest, console);
  if (first == "version" || first == "--version") {
    if (!rest.empty()) throw UsageError(say::SpareArgument(rest.front(), "version", false));
    console.Result(say::Version(MOONTRACE_VERSION, mj_versionString()));
    return exit_code::kGood;
  }
  const Command* command = CommandNamed(first);
  if (command == nullptr) RefuseCommand(args);
  return command->run(command->card, rest, console);
}

}  // namespace

std::vector<std::string> TypedAfterName() {
  std::vector<std::string> words{"COMMAND"};
  for (const PlainWord& word : kPlainWords) words.emplace_back(word.name);
  for (const Command& command : kCommands) words.emplace_back(command.card.name);
  return words;
}

int RunCli(const std::vector<std::string>& args, Console& console) {
  const auto refuse = [&console](std::string_view line, int code) {
    console.out().flush();
    console.Error(line);
    return code;
  };
  try {
    const int code = Dispatch(args, console);
    console.out().flush();
    if (!console.out()) throw OutputLost();
    return code;
  } catch (const UsageError& error) {
    return refuse(error.what(), exit_code::kUsage);
  } catch (const InputError& error) {
    return refuse(error.what(), exit_code::kInput);
  } catch (const DeviceError& error) {
    return refuse(error.what(), exit_code::kLack);
  } catch (const LackError& error) {
    return refuse(error.what(), exit_code::kLack);
  } catch (const OutputLost&) {
    if (console.ReaderLeft()) return exit_code::kReaderLeft;
    return refuse(say::CannotWriteOutput(), exit_code::kLack);
  } catch (const Interrupted&) {
    return refuse(say::Stopped(), exit_code::kInterrupted);
  } catch (const WorkFailed& error) {
    return refuse(say::Failed(error.what()), exit_code::kFailed);
  } catch (const std::bad_alloc&) {
    return refuse(say::NoMemory(), exit_code::kLack);
  } catch (const std::exception& error) {
    return refuse(say::Failed(OneLine(error.what(), 400)), exit_code::kFailed);
  }
}

}  // namespace moontrace

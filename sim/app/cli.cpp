#include "sim/app/cli.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <exception>
#include <new>
#include <ostream>

#include "devices/core/device_error.h"
#include "sim/app/commands.h"
#include "sim/app/course_messages.h"
#include "sim/app/messages.h"
#include "sim/app/script_messages.h"
#include "sim/app/study_messages.h"
#include "sim/audio/sound_messages.h"
#include "sim/console/line_wrap.h"
#include "sim/html_report/records_messages.h"
#include "sim/html_report/report_messages.h"
#include "sim/learn/learn_messages.h"
#include "sim/physics/mujoco_compat.h"
#include "sim/session/loop_messages.h"
#include "sim/session/view_messages.h"
#include "sim/setup/help.h"
#include "sim/tutor/tutor_messages.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

using Args = std::vector<std::string>;

/// The option nearest to what was given; dashes do not count, they are the same in all.
std::string NearestOption(const CLI::App& app, std::string_view given) {
  std::vector<std::string> names{"help"};
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back(name);
  }
  given.remove_prefix(std::min(given.find_first_not_of('-'), given.size()));
  const std::string nearest = NearestWord(given, names);
  return nearest.empty() ? nearest : "--" + nearest;
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
      throw UsageError(say::SpareArgument(given, app.get_name()));
    }
    const std::string name = given.substr(0, given.find('='));
    throw UsageError(say::UnknownOption(name, app.get_name(), NearestOption(app, name)));
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

bool AsksForHelp(const Args& args) {
  for (const std::string& arg : args) {
    if (arg == "--") return false;
    if (arg == "--help" || arg == "-h") return true;
  }
  return false;
}

int Run(const GalleryOptions& options, Console& console) {
  return RunGallery(options, RunCli, console);
}

/// Reads one command's options and runs it.
template <typename Options>
int RunCommand(const char* name, const char* purpose, const Args& args, Console& console) {
  CLI::App app(purpose, name);
  app.set_help_flag();
  app.allow_extras();
  Options options;
  AddOptions(app, options);
  if (AsksForHelp(args)) {
    console.out() << HelpText(app);
    return exit_code::kGood;
  }
  Parse(app, args);
  console.Set(options.output.json, options.output.quiet);
  return Run(options, console);
}

struct Command {
  const char* name;
  const char* purpose;
  int (*run)(const char* name, const char* purpose, const Args& args, Console& console);
};

constexpr Command kCommands[] = {
    {"demo", say::help::kDemo, RunCommand<DemoOptions>},
    {"page", say::help::kPage, RunCommand<PageOptions>},
    {"trace", say::help::kTrace, RunCommand<TraceOptions>},
    {"learn", say::help::kLearn, RunCommand<LearnOptions>},
    {"loop", say::help::kLoop, RunCommand<LoopCommandOptions>},
    {"view", say::help::kViewCommand, RunCommand<ViewCommandOptions>},
    {"probe", say::help::kProbe, RunCommand<ProbeOptions>},
    {"script", say::help::kScriptCommand, RunCommand<ScriptOptions>},
    {"gallery", say::help::kGallery, RunCommand<GalleryOptions>},
    {"replay", say::help::kReplay, RunCommand<ReplayOptions>},
    {"tutor", say::help::kTutor, RunCommand<TutorOptions>},
    {"sounds", say::help::kSounds, RunCommand<SoundsOptions>},
    {"report", say::help::kReport, RunCommand<ReportOptions>},
    {"records", say::help::kRecordsCommand, RunCommand<RecordsOptions>},
    {"course", say::help::kCourseCommand, RunCommand<CourseOptions>},
    {"devices", say::help::kDevices, RunCommand<DevicesOptions>},
    {"study", say::help::kStudyCommand, RunCommand<StudyOptions>},
    {"bench", say::help::kBench, RunCommand<BenchOptions>},
};

int ProgramHelp(Console& console) {
  console.out() << Wrapped(say::help::kProgram)
                << Wrapped("Usage: moontrace COMMAND [TEXT] [--file F | -] [options]");
  for (const Command& command : kCommands) {
    console.out() << Wrapped(fmt::format("{}: {}.", command.name, command.purpose));
  }
  console.out() << Wrapped(say::help::kMore) << Wrapped(say::help::kExitCodes);
  return exit_code::kGood;
}

int Dispatch(const Args& args, Console& console) {
  if (args.empty()) throw UsageError(say::NoCommand());
  const std::string& first = args.front();
  if (first == "--help" || first == "-h") return ProgramHelp(console);
  if (first == "--version") {
    console.Result(say::Version(MOONTRACE_VERSION, mj_versionString()));
    return exit_code::kGood;
  }
  Args names;
  for (const Command& command : kCommands) {
    if (first == command.name) {
      return command.run(command.name, command.purpose, {args.begin() + 1, args.end()}, console);
    }
    names.emplace_back(command.name);
  }
  throw UsageError(say::UnknownCommand(first, NearestWord(first, names)));
}

}  // namespace

int RunCli(const std::vector<std::string>& args, Console& console) {
  const auto refuse = [&console](std::string_view line, int code) {
    console.out().flush();
    console.Error(line);
    return code;
  };
  try {
    const int code = Dispatch(args, console);
    console.out().flush();
    if (!console.out()) return refuse(say::CannotWriteOutput(), exit_code::kLack);
    return code;
  } catch (const UsageError& error) {
    return refuse(error.what(), exit_code::kUsage);
  } catch (const InputError& error) {
    return refuse(error.what(), exit_code::kInput);
  } catch (const DeviceError& error) {
    return refuse(error.what(), exit_code::kLack);
  } catch (const LackError& error) {
    return refuse(error.what(), exit_code::kLack);
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

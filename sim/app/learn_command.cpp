#include "sim/app/commands.h"

#include <fmt/core.h>
#include <unistd.h>

#include <CLI/App.hpp>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>

#include "lessons/course/course.h"
#include "lessons/course/lesson_items.h"
#include "lessons/course/spelling.h"
#include "sim/audio/sound_messages.h"
#include "sim/demonstration/demonstrate.h"
#include "sim/learn/key_wording.h"
#include "sim/learn/learn_drive.h"
#include "sim/learn/learn_keys.h"
#include "sim/learn/learn_learner.h"
#include "sim/learn/learn_messages.h"
#include "sim/learn/learn_print.h"
#include "sim/learn/learn_session.h"
#include "sim/learn/learn_simulated.h"
#include "sim/learn/learn_sound.h"
#include "sim/learn/learn_stage.h"
#include "sim/learn/learn_tutor.h"
#include "sim/learn/learn_view.h"
#include "sim/picture/picture_file.h"
#include "sim/session/loop_drive.h"
#include "sim/session/loop_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "sim/tutor/tutor_messages.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

/// A person sits at a terminal, and can be asked.
bool AtTerminal(Console& console) {
  return &console.in() == &std::cin && isatty(STDIN_FILENO) != 0;
}

void CheckTogether(const LearnOptions& options) {
  CheckTogether(options.view);
  AimsFor(options.live.device, options.view);  // refuses a mouse without a window
  if (options.days > 0 && !options.simulate) {
    throw UsageError(say::NeedsOther("--days", "--simulate"));
  }
  if (!options.sounds.empty() && !options.sound) {
    throw UsageError(say::NeedsOther("--sounds", "--sound"));
  }
  if (!options.print.empty() && options.simulate) {
    throw UsageError(say::PrintRunsNothing());
  }
  if (options.print.empty()) {
    if (!options.lesson.empty()) throw UsageError(say::OnlyWithPrint("--lesson"));
    if (options.size) throw UsageError(say::OnlyWithPrint("--size-mm"));
  } else if (!HasPictureEnding(options.print)) {
    throw UsageError(say::NotAPicture("--print", options.print));
  }
}

/// Who names a learner may still have wished for the demonstration: that is told the first time.
void SayProgramsHand(const LearnMemory& memory, bool tutor, LearnTeller& teller) {
  teller.Say(Priority::kText, say::ByProgramsHand());
  teller.Say(Priority::kText, say::WhatProgramsHandDoes(memory.remembers()));
  const bool tell = memory.trials() == 0 && !tutor;
  if (tell) teller.Say(Priority::kText, say::DemonstrationIsAlone());
}

/// How it presses, and what cannot be felt of it.
void SayDevice(const LearnParts& parts, LearnTeller& teller) {
  const LearnStage& stage = parts.stage;
  if (stage.session().device().mouse()) {
    teller.Say(Priority::kText, say::MousePresses());
    return teller.Say(Priority::kText, say::MouseCannotPush());
  }
  if (!stage.pushes()) teller.Say(Priority::kText, say::NotFelt());
  const bool fresh = parts.memory.trials() == 0;
  if (fresh && !stage.lifts()) teller.Say(Priority::kText, say::TipStaysDown());
}

void SayBeginning(const LearnParts& parts, const LearnOptions& options, bool keys) {
  LearnStage& stage = parts.stage;
  LearnTeller& teller = parts.teller;
  LoopSession& session = stage.session();
  const bool brief = parts.memory.brief() || options.brief;
  if (stage.simulated()) {
    SayProgramsHand(parts.memory, options.tutor, teller);
  } else {
    teller.Say(Priority::kText, say::WithDevice(options.live.device));
    SayDevice(parts, teller);
  }
  if (session.device().scale() != 1) teller.Say(Priority::kText, say::LearnScaled());
  if (session.device().felt() && !session.loop().not_realtime().empty()) {
    teller.Remark(say::NotRealtime(session.loop().not_realtime()));
  }
  if (options.tutor) teller.Happening(Priority::kText, say::TutorMayJoin());
  if (!brief) teller.Remark(keys ? say::LearnBeginsWithKeys() : say::LearnBegins());
  teller.EndTurn();
}

/// One that speaks and stops: the simulated hand has none, and a mouse's presses the tip.
bool HasButton(const LiveDevice& device) {
  return !device.simulated() && !device.mouse() && device.limits().buttons > 0;
}

/// For tutors at the door and for the one at the window.
std::unique_ptr<TutorDesk> DeskFor(const LearnOptions& options, const LearnParts& parts,
                                   RunningLesson& lesson, ViewFeed* feed) {
  if (!options.tutor && feed == nullptr) return nullptr;
  TutorDesk::Told window;
  if (feed != nullptr) window = [feed](std::string_view line) { feed->ShowLine(line); };
  return std::make_unique<TutorDesk>(parts, lesson, options.tutor, std::move(window));
}

/// Single keys without Enter; none: lines.
std::optional<KeyMap> KeysFor(const LearnOptions& options, bool at_terminal) {
  if (options.keys.empty()) return std::nullopt;
  if (!at_terminal) throw UsageError(say::KeysNeedTerminal());
  return options.keys == "true" ? UsualKeys() : LoadKeys(options.keys);
}

/// Who has no device has been told so: what is to begin, which is asked at a terminal. Throws
/// LackError, behind what works without one: nothing.
std::string WayWithoutDevice(Console& console) {
  std::string way;
  if (AtTerminal(console)) {
    LearnTeller teller(console, nullptr, nullptr);
    LineReader lines(console.in());
    way = AskWithoutDevice(lines, teller, console);
  }
  if (!way.empty()) return way;
  for (const std::string& line : say::LearningWithoutDevice(WindowMayOpen())) console.Result(line);
  throw LackError(say::NoDeviceGiven());
}

/// The first lesson's; nothing is written over.
std::string NewPrint() {
  std::string file = "lesson1.pdf";
  for (int copy = 1; std::filesystem::exists(file); ++copy) {
    file = fmt::format("lesson1-copy{}.pdf", copy);
  }
  return file;
}

/// Where none can open that is not needed: told before anything is asked.
void DropWindow(LearnOptions& options, Console& console) {
  if (!options.view.window || IsMouse(options.live.device) || WindowMayOpen()) return;
  console.Remark(say::NoWindowHere());
  options.view = {};
}

/// With the device that is named.
int Learn(const LearnOptions& options, const std::optional<KeyMap>& keys, Course course,
          Console& console) {
  const bool at_terminal = AtTerminal(console);
  const double smallest = SmallestFelt(options.live.device, options.press.value_or(1));
  const std::unique_ptr<Speech> speech = SpeechFor(options, course);
  const std::unique_ptr<Sound> sound = SoundFor(options);
  LearnTeller teller(console, speech.get(), sound.get());
  if (keys) teller.SetWording([&keys](std::string_view line) { return WithKeys(line, *keys); });
  LineReader lines(console.in());
  // a display that does not answer is told of before anything is asked
  const auto aims = AimsFor(options.live.device, options.view);
  const std::unique_ptr<ViewFeed> feed = ViewFeed::Open(options.view, aims, console);
  std::optional<LearnMemory> opened = OpenMemory(options, course, lines, teller, console);
  if (!opened) return exit_code::kGood;
  LearnMemory& memory = *opened;
  AddOwnName(course, memory.name());
  if (EndSizesAt(course, smallest)) {
    teller.Say(Priority::kText, say::SizesEndAt(course.sizes.back(), smallest));
  }
  teller.EndTurn();

  LearnStage stage({options.live, options.press, options.seed, aims, memory.keeps_tracks()},
                   console);
  const LearnParts parts{course, memory, stage, teller};
  const bool button = HasButton(stage.session().device());
  LearnSession session(
      parts, options.seed,
      keys ? say::KeysHelp(*keys, stage.lifts(), button) : say::LearnHelp(stage.lifts(), button));
  const std::unique_ptr<TutorDesk> tutor = DeskFor(options, parts, session, feed.get());
  SayBeginning(parts, options, keys.has_value());  // once nothing can be refused any more
  std::unique_ptr<LearnView> view;
  if (feed) view = std::make_unique<LearnView>(*feed, parts, session, *tutor, console);
  std::unique_ptr<PathListener> path;
  if (sound) path = std::make_unique<PathListener>(*sound, stage, teller, session);
  std::unique_ptr<LearnInput> input = InputFor(keys, lines, memory.name(), console);
  memory.Admit();
  memory.SetDevice(std::time(nullptr), options.live.device);
  if (options.brief) memory.SetBrief(std::time(nullptr), true);
  session.Begin();
  try {
    Drive(session, teller, *input, {tutor.get(), path.get(), view.get()}, options.live.seconds,
          console);
  } catch (const Interrupted&) {
    input.reset();  // the terminal first
    session.End();
    throw;
  }
  input.reset();
  const std::size_t lost = session.End();
  // who closed the window, or left by it, is not at the terminal
  const bool by_window = (feed && feed->closed()) || (view && view->left());
  const bool asks = at_terminal && session.over() && !stage.simulated() && !by_window;
  if (asks) AskConsent(memory, lines, teller, console);
  if (feed) EndView(*feed, options.view, console);
  if (lost > 0) throw LackError(say::NeverKept(lost));
  RequireDevice(stage.session());
  if (feed) RequireView(*feed, options.live.device);
  return exit_code::kGood;
}

/// What was chosen without a device, or behind the demonstration; empty: nothing.
int GoThatWay(const std::string& way, LearnOptions options, const std::optional<KeyMap>& keys,
              const Course& course, Console& console) {
  if (way == "device") return Run(DevicesOptions(), console);
  if (way == "paper") {
    options.print = NewPrint();
    return PrintLesson(options, course, console);
  }
  if (way != "mouse") return exit_code::kGood;
  options.view.window = options.sound = true;
  options.live.device = DeviceForLearning(way, console);
  return Learn(options, keys, course, console);
}

int LearnOrDemonstrate(LearnOptions options, const Course& course, Console& console) {
  const std::optional<KeyMap> keys = KeysFor(options, AtTerminal(console));
  DropWindow(options, console);
  std::string way = "demonstration";
  if (!IsDemonstration(options)) {
    options.live.device = DeviceForLearning(options.live.device, console);
    if (!options.live.device.empty()) return Learn(options, keys, course, console);
    way = WayWithoutDevice(console);
  }
  if (way == "demonstration") {
    if (options.tutor) console.Remark(say::DemonstrationTakesNoTutor());
    options.live.device = "simulated";
    way = Demonstrate(options, keys, course, console);
  }
  return GoThatWay(way, options, keys, course, console);
}

}  // namespace

void AddOptions(CLI::App& app, LearnOptions& options) {
  BeginGroup(app, "Learner and course");
  AddPath(app, "--learner", "NAME", options.learner, say::help::kLearner);
  AddPath(app, "--course", "FILE", options.course, say::help::kCourse);
  AddPath(app, "--records", "FILE", options.records, say::help::kRecords);
  AddSeed(app, options.seed);
  Redescribe(app, "--seed", say::help::kLearnSeed);
  AddOptions(app, options.live);
  Redescribe(app, "--device", say::help::kLearnDevice);
  Redescribe(app, "--seconds", say::help::kLearnSeconds);
  AddNumber(app, "--press-n", options.press, 0.01, 20, 1, say::help::kLoopPress);
  BeginGroup(app, "Speech, sound, keys, tutor");
  AddFlag(app, "--brief", options.brief, say::help::kBrief);
  AddFlag(app, "--speak", options.speak, say::help::kSpeak);
  AddFlag(app, "--sound", options.sound, say::help::kSound);
  AddPath(app, "--sounds", "FILE", options.sounds, say::help::kOwnSounds);
  AddFlag(app, "--tutor", options.tutor, say::help::kLetTutor);
  AddFlag(app, "--keys", options.keys, say::help::kKeys);
  AddFlag(app, "--quiet", options.output.quiet, say::help::kQuiet);
  AddOptions(app, options.view);
  BeginGroup(app, "In place of a lesson");
  AddFlag(app, "--simulate", options.simulate, say::help::kSimulate);
  std::function<void(const std::string&)> read_days = [&options](const std::string& given) {
    const double days = ReadNumber("--days", given, 1, 3650);
    if (days != std::floor(days)) throw UsageError(say::NotAWholeNumber("--days", given));
    options.days = static_cast<int>(days);
  };
  app.add_option_function("--days", read_days, say::help::kDays)->type_name("NUMBER");
  AddPath(app, "--print", "FILE", options.print, say::help::kPrint);
  AddPath(app, "--lesson", "ID", options.lesson, say::help::kPrintLesson);
  AddNumber(app, "--size-mm", options.size, 1, 200, 1e-3, say::help::kPrintSize);
}

int Run(const LearnOptions& options, Console& console) {
  CheckTogether(options);
  const Course course = LoadCourse(options.course);
  if (options.simulate) {
    LearnSimulatedOptions simulated;
    simulated.seed = options.seed;
    simulated.days = options.days;
    simulated.records = options.records;
    simulated.learner = options.learner;
    return LearnSimulated(simulated, course, console);
  }
  if (!options.print.empty()) return PrintLesson(options, course, console);
  return LearnOrDemonstrate(options, course, console);
}

}  // namespace moontrace

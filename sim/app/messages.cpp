#include "sim/app/messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "sim/picture/picture_messages.h"
#include "sim/session/loop_messages.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/writing_messages.h"
#include "sim/trial/metrics_json.h"
#include "textures/base/text_file.h"
#include "textures/typeset/character_name.h"

namespace moontrace::say {

std::string UnknownCommand(std::string_view given, std::string_view nearest) {
  const bool is_option = !given.empty() && given.front() == '-';
  const std::string mend = is_option && nearest.empty()
                               ? "write the command first, its options behind it; "
                               : DidYouMean(nearest);
  return fmt::format("unknown command {}: {}\"moontrace help\" lists the commands", Quoted(given),
                     mend);
}

std::string HelpTakesOne(std::string_view given) {
  return fmt::format(
      "one argument too many for help: {}; name one command, as in moontrace help page",
      Quoted(given));
}

std::string UnknownOption(std::string_view given, std::string_view command,
                          std::string_view nearest) {
  return fmt::format("unknown option {}: {}\"moontrace {} --help-all\" lists the options",
                     OneLine(given), DidYouMean(nearest), command);
}

std::string SpareArgument(std::string_view given, std::string_view command, bool takes_text) {
  const std::string mend = takes_text ? "put a text of several words in quotes"
                                      : fmt::format("\"moontrace help {}\" tells what it takes",
                                                    command.substr(0, command.find(' ')));
  return fmt::format("one argument too many for {}: {}; {}", command, Quoted(given), mend);
}

std::string ValueMissing(std::string_view option) {
  return fmt::format("{} lacks its value: write it after the option", option);
}

std::string NotAPng(std::string_view option, std::string_view given) {
  return fmt::format("{} needs an ending .png here: {}", option, OneLine(given, 200));
}

std::string NoFolder() { return "no folder: write moontrace replay FOLDER"; }

std::string CannotWriteOutput() {
  return "standard output: cannot be written; check the room on its disk";
}

std::string Stopped() { return "Stopped, as you asked. No file is left half written."; }

std::string Failed(std::string_view cause) { return fmt::format("failed: {}", cause); }

std::string NoMemory() { return "memory: there is not enough for this; give a shorter text"; }

std::string Version(std::string_view program, std::string_view mujoco) {
  return fmt::format("moontrace {}, MuJoCo {}", program, mujoco);
}

std::string PageOutcome(const PageCounts& counts) {
  return fmt::format("{}, {}, {}.", Counted(counts.pages, "page", "pages"),
                     Counted(counts.lines, "line", "lines"),
                     Counted(counts.signs, "sign", "signs"));
}

std::string LetterShape(const TypeStyle& style) {
  return fmt::format("Letters: {} mm high, {} {} mm wide, {} mm {}.",
                     Short(kMillimetres * style.size, 2), ReliefWord(style),
                     Short(kMillimetres * style.width, 2), Short(kMillimetres * style.depth, 2),
                     style.relief == Relief::kEngraved ? "deep" : "high");
}

std::string Paper(const PageSpec& page) {
  return fmt::format("Paper: {}, {} by {} mm, margin {} mm.", page.name,
                     Short(kMillimetres * page.width, 1), Short(kMillimetres * page.height, 1),
                     Short(kMillimetres * page.margin, 1));
}

std::string PageLine(std::size_t page, std::size_t pages, std::size_t line,
                     std::string_view signs) {
  const std::string place = pages == 1 ? "" : fmt::format("Page {}, ", page + 1);
  return fmt::format("{}{} {}: {}", place, pages == 1 ? "Line" : "line", line + 1, signs);
}

std::string LinesLeftOut(std::size_t count) {
  return fmt::format("And {}; --json lists all.", Counted(count, "more line", "more lines"));
}

std::string PageNext() { return "To see or print it, add --picture page.pdf."; }
std::string TraceNext() {
  return "To see the way, add --picture way.svg; to keep it for replay, --record DIR.";
}
std::string PictureIn() { return "Picture:"; }
std::string RecordIn() { return "Record:"; }

std::string TraceOutcome(const TrialResult& all, std::size_t letters, bool blank) {
  return fmt::format("{}: {} covered, {}.", blank ? "Blank page" : "Traced",
                     Percent(all.score.total.coverage), Counted(letters, "letter", "letters"));
}

std::string MeanError(const TraceMetrics& total, const TypeStyle& style, bool blank) {
  if (blank) {
    return fmt::format("Mean error: {} mm; there is no {}.",
                       Short(kMillimetres * total.mean_error, 3), ReliefWord(style));
  }
  return fmt::format("Mean error: {} mm; the {} is {} mm wide.",
                     Short(kMillimetres * total.mean_error, 3), ReliefWord(style),
                     Short(kMillimetres * style.width, 2));
}

std::string WorstError(const TraceMetrics& total) {
  return fmt::format("Worst error: {} mm.", Short(kMillimetres * total.max_error, 2));
}

std::string FollowedNothing() {
  return "No error to tell: no stroke was followed. Press less, or make the letters larger.";
}

std::string LeftGroove(const TraceMetrics& total, const TypeStyle& style, bool blank) {
  const std::string left = blank ? fmt::format("where a {} would be", ReliefWord(style))
                                 : fmt::format("the {}", ReliefWord(style));
  return fmt::format("Left {}: {}.", left, Times(total.excursions));
}

std::string Force(const TraceMetrics& total) {
  return fmt::format("Force: mean {} N, peak {} N.", Short(total.mean_force, 2),
                     Short(total.peak_force, 2));
}

/// Rounded up: a bound must not be given lower than it is.
std::string ForceBound(const TrialResult& all) {
  const auto up = [](double force) { return Short(std::ceil(100 * force) / 100, 2); };
  std::string line =
      fmt::format("Force bound: {} N for an evenly moving hand", up(all.force_bound));
  if (all.force_per_acceleration > 0) {
    line += fmt::format(", {} N more for each m/s2", up(all.force_per_acceleration));
  }
  return line + ".";
}

/// Rounded down: what is promised holds.
std::string CarriedPress(double carried) {
  return fmt::format("Carried press: {} N; pressed harder, the tip may go through the paper.",
                     Short(std::floor(100 * carried) / 100, 2));
}

std::string Through(const TrialResult& all) {
  const std::string first =
      all.first_through > 0 ? fmt::format(", first after {} s", Short(all.first_through, 1)) : "";
  return fmt::format("Through the paper: {}{}; it carries {} N.", Times(all.through), first,
                     Short(std::floor(100 * all.carried_press) / 100, 2));
}

std::string Time(const TrialResult& all) {
  constexpr double kQuicker = 1.5;
  if (all.real_time_factor < kQuicker) {
    return fmt::format("Time: {} s of hand time, computed in {} s.", Short(all.duration, 1),
                       Short(all.duration / all.real_time_factor, 1));
  }
  return fmt::format("Time: {} s of hand time, computed {} times faster.", Short(all.duration, 1),
                     Short(all.real_time_factor, 0));
}

std::string Energy(const TrialResult& all) {
  if (all.true_energy_out) {
    return fmt::format(
        "Energy put out: {} microjoules by the hand's true way, {} by the device's readings of it.",
        Short(1e6 * *all.true_energy_out, 2), Short(1e6 * all.energy_out, 2));
  }
  return fmt::format("Energy put out: {} microjoules.", Short(1e6 * all.energy_out, 2));
}

std::string ProfilePushesNothing(std::string_view name) {
  return fmt::format("device profile {}: it pushes nothing along the page; name one that does",
                     Quoted(name));
}

std::string WeakestLetter(std::string_view text, std::size_t number, double coverage) {
  return fmt::format("Weakest letter: {}, letter {}, {} covered.", Quoted(text), number,
                     Percent(coverage));
}

std::string DirectWillBuzz(const DirectBound& bound) {
  return fmt::format(
      "Direct rendering will buzz: a stiffness of {:.0f} N/m is felt, this hand and device hold "
      "{:.0f} N/m. The proxy (--render proxy) stays quiet.",
      bound.felt, bound.held);
}

std::string RidgesPushAside() {
  return "Ridges push a point aside, and the simulated hand cannot follow them: a poor trace is "
         "to be expected. Grooves, without --embossed, can be followed.";
}

/// Figures: "Sphinx of black quartz" (part of a pangram) at 12 mm, seed 1.
std::string FrictionHampers(double friction) {
  return fmt::format(
      "Friction {} makes tracing worse: a short text at 12 mm is covered to 100 percent at 0.05, "
      "96 at "
      "0.15, 73 at 0.3.",
      Short(friction, 3));
}

std::string PageGone(double time) {
  return fmt::format("After {} s the {}", Short(time, 1), kPageWentAway);
}

std::string Faults(const TrialResult& all) {
  if (all.held > 0) {
    return fmt::format(
        "something in the model besides page and coupling pushed moontrace_proxy at {} of {} "
        "ticks; "
        "the force was zero there: take it out of the model",
        all.held, all.ticks);
  }
  return fmt::format(
      "no force at {} of {} ticks: MuJoCo could not step the model, or the tip was 1000 m from its "
      "origin; bring the label near the origin, or make what it lies on heavier",
      all.faults, all.ticks);
}

std::string NoPoint() { return "no point: write moontrace probe X Y Z TEXT, X Y Z in mm"; }

std::string ProbeOutcome(double depth, double force) {
  if (depth <= 0) {
    return fmt::format("No contact: {} mm above the surface.", Short(-kMillimetres * depth, 4));
  }
  return fmt::format("Contact: {} mm deep, {} N.", Short(kMillimetres * depth, 4), Short(force, 4));
}

std::string NamedNumbers(std::string_view name, const double* values, std::size_t count) {
  std::string line(name);
  line += ':';
  for (std::size_t i = 0; i < count; ++i) {
    line += (i == 0 ? " " : ", ") + Short(values[i], 6);
  }
  return line;
}

std::string ReplayWhat(std::string_view text, double size, bool blank) {
  return fmt::format("Recorded: {}, letters {} mm high{}.", Quoted(text),
                     Short(kMillimetres * size, 2), blank ? ", blank page" : "");
}

std::string ReplayEqual(std::size_t ticks) {
  return fmt::format("Replay is bit-equal over {}.", Counted(ticks, "tick", "ticks"));
}

std::string ReplayDiffers(std::size_t tick, std::size_t ticks, std::string_view column) {
  return fmt::format("Replay differs first at tick {} of {}, in {}.", tick, ticks, column);
}

std::string RecordedTime(double duration, double letters_per_second) {
  return fmt::format("Time: {} s of hand time, {} letters per second.", Short(duration, 1),
                     Short(letters_per_second, 2));
}

std::string Altered(std::string_view altered, const ReplayResult& replay) {
  if (replay.first_difference >= replay.ticks) {
    return fmt::format("{}; what the scene computes from it is unchanged", altered);
  }
  return fmt::format("{}; replay differs first at tick {}: {}", altered, replay.first_difference,
                     replay.column);
}

std::string OtherField(std::string_view folder) {
  return fmt::format(
      "{}: the page built again is not the one recorded; restore the script's files, or the "
      "program, of then",
      folder);
}

std::string BenchBegins() { return "Measuring: this takes about a quarter of a minute."; }

std::string BenchLine(const BenchRow& row) {
  constexpr double kLeast = 1e-4;  // what is smaller is noise in all units used, and JSON has it
  const bool tiny = row.value > 0 && row.value < kLeast;
  const std::string value = tiny ? "below " + Plain(kLeast) : Plain(row.value);
  std::string figure = fmt::format("{}: {} {}", row.name, value, row.unit);
  if (!row.holds) return figure;
  return fmt::format("{}: {}, {}.", *row.holds ? "Holds" : "Missed", figure, row.bar);
}

std::string BenchOutcome(std::size_t bars, std::size_t missed) {
  if (missed == 0) return fmt::format("All {} bars hold.", bars);
  return fmt::format("{} of {} bars missed.", missed, bars);
}

std::string Guided(GuidanceMode mode, double help, double mean_force, double work) {
  return fmt::format("Push: {}, help {:g}; {:.2f} N on average, {:.1f} mJ done.", NameOf(mode),
                     help, mean_force, 1e3 * work);
}

std::string DemoWelcome(std::string_view word) {
  return fmt::format("Welcome to Moontrace. A simulated stylus will trace the word {}.", word);
}

std::string DemoWhatMoonIs() {
  return "Moon is a script of lines and curves, read by touch: here, as grooves.";
}

std::string DemoHand() {
  return "The simulated hand trembles and drifts; only the groove keeps it on the letters.";
}

std::string DemoCovered() {
  return "Covered is the share of all strokes that the stylus went along.";
}

std::string DemoSize(double size, const TrialResult& result) {
  const TraceMetrics& total = result.score.total;
  const std::string left = total.excursions == 0
                               ? "never left the groove"
                               : fmt::format("left the groove {}", Times(total.excursions));
  return fmt::format("{} mm letters: {} covered, mean error {} mm, {}.",
                     Short(kMillimetres * size, 1), Percent(total.coverage),
                     Short(kMillimetres * total.mean_error, 3), left);
}

std::string DemoBlank(double size, const TrialResult& result) {
  return fmt::format("Blank page: {} covered, mean error {} mm, same hand at {} mm.",
                     Percent(result.score.total.coverage),
                     Short(kMillimetres * result.score.total.mean_error, 2),
                     Short(kMillimetres * size, 1));
}

std::string DemoWhyBlank() { return "So it is the grooves that guide the hand."; }

std::string DemoPictures() { return "Pictures of all this are in the folder:"; }

std::string DemoNext() { return "Next, try your own text: moontrace trace \"your name\""; }

std::string DemoBelowBar(double size) {
  return fmt::format("the demo lost the {} mm letters: below 98 percent covered",
                     Short(kMillimetres * size, 1));
}

std::string GalleryOutcome(std::size_t drawn, std::size_t missing) {
  const std::string rest = missing == 0 ? "" : fmt::format(", {} missing on this machine", missing);
  return fmt::format("{} with words{}, gathered in:", Counted(drawn, "picture", "pictures"), rest);
}

std::string ExhibitMissing(std::string_view title, std::string_view why) {
  return fmt::format("Not shown: {}; {}.", title, OneLine(why, 200));
}

std::string ExhibitFailed(std::string_view title, std::string_view why) {
  return fmt::format("picture '{}': {}", title, OneLine(why, 200));
}

std::string TracePictureTitle(std::string_view script, const TypeStyle& style, bool blank) {
  return fmt::format("{} traced, letters {} mm high{}", script, Short(kMillimetres * style.size, 2),
                     blank ? ", on a blank page" : "");
}

std::string TracePictureWords(std::string_view text, const TraceMetrics& total) {
  const std::string line = OneLine(Unbroken(text));
  if (!(total.contact_share > 0)) return fmt::format("Text: {}. Never touched.", line);
  if (FollowedNothing(total)) return fmt::format("Text: {}. No stroke was followed.", line);
  return fmt::format("Text: {}. Covered: {}. Mean error: {} mm. Left: {}.", line,
                     Percent(total.coverage), Short(kMillimetres * total.mean_error, 3),
                     Times(total.excursions));
}

std::string TracePictureLegend(const TypeStyle& style, bool blank, bool rings) {
  const std::string_view relief = ReliefWord(style);
  const std::string ground = blank ? fmt::format("Dashed grey: where each {} would be.", relief)
                                   : fmt::format("Grey band: the {}, {} mm wide.", relief,
                                                 Short(kMillimetres * style.width, 2));
  return fmt::format("{} Blue line: the tip of the stylus.{}", ground,
                     rings ? " Orange rings: where it left." : "");
}

}  // namespace moontrace::say

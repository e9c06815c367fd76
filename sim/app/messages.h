#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lessons/course/guidance_mode.h"
#include "lessons/measure/scoring.h"
#include "sim/bench/row.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/record.h"
#include "sim/trial/trial.h"
#include "textures/typeset/typeset.h"

/// Sentences of the commands; those that a room below says stand in its own *messages.h. Plain
/// lines: the outcome first, numbers and paths last, no columns, no escape codes. Lines of
/// InputError and LackError mostly stand with the code that throws them.
namespace moontrace::say {

// The command line.
std::string UnknownCommand(std::string_view given, std::string_view nearest);
std::string HelpTakesOne(std::string_view given);
std::string UnknownOption(std::string_view given, std::string_view command,
                          std::string_view nearest);
/// `takes_text`: the command takes one, which quotes would keep together.
std::string SpareArgument(std::string_view given, std::string_view command, bool takes_text);
std::string ValueMissing(std::string_view option);
std::string NotAPng(std::string_view option, std::string_view given);
std::string NoFolder();
std::string CannotWriteOutput();
std::string Stopped();
std::string Failed(std::string_view cause);
std::string NoMemory();
std::string Version(std::string_view program, std::string_view mujoco);

// What a page holds.
std::string PageOutcome(const PageCounts& counts);
std::string LetterShape(const TypeStyle& style);
std::string Paper(const PageSpec& page);
std::string PageLine(std::size_t page, std::size_t pages, std::size_t line, std::string_view signs);
std::string LinesLeftOut(std::size_t count);
std::string PageNext();   ///< where no picture was asked for
std::string TraceNext();  ///< where neither picture nor record was
std::string PictureIn();
std::string RecordIn();

// A trace.
std::string TraceOutcome(const TrialResult& all, std::size_t letters, bool blank);
std::string MeanError(const TraceMetrics& total, const TypeStyle& style, bool blank);
std::string WorstError(const TraceMetrics& total);
std::string FollowedNothing();
std::string LeftGroove(const TraceMetrics& total, const TypeStyle& style, bool blank);
std::string Force(const TraceMetrics& total);
std::string ForceBound(const TrialResult& all);
std::string CarriedPress(double carried);  ///< [N]
std::string Through(const TrialResult& all);
std::string Time(const TrialResult& all);
std::string Energy(const TrialResult& all);
std::string ProfilePushesNothing(std::string_view name);
std::string WeakestLetter(std::string_view text, std::size_t number, double coverage);
std::string DirectWillBuzz(const DirectBound& bound);
std::string RidgesPushAside();
std::string FrictionHampers(double friction);
std::string PageGone(double time);
std::string Faults(const TrialResult& all);

// The bench.
std::string BenchBegins();
std::string BenchLine(const BenchRow& row);
std::string BenchOutcome(std::size_t bars, std::size_t missed);

// A probe.
std::string NoPoint();
std::string ProbeOutcome(double depth, double force);
std::string NamedNumbers(std::string_view name, const double* values, std::size_t count);

// A replay.
std::string ReplayWhat(std::string_view text, double size, bool blank);
std::string ReplayEqual(std::size_t ticks);
std::string ReplayDiffers(std::size_t tick, std::size_t ticks, std::string_view column);
/// [s], [1/s]
std::string RecordedTime(double duration, double letters_per_second);
std::string Altered(std::string_view altered, const ReplayResult& replay);
std::string OtherField(std::string_view folder);

/// How strong the guiding push of a trace was on average and what it did to the hand.
std::string Guided(GuidanceMode mode, double help, double mean_force, double work);

// The demo.
std::string DemoWelcome(std::string_view word);
std::string DemoWhatMoonIs();
std::string DemoHand();
std::string DemoCovered();
std::string DemoSize(double size, const TrialResult& result);
std::string DemoBlank(double size, const TrialResult& result);
std::string DemoWhyBlank();
std::string DemoPictures();
std::string DemoNext();
std::string DemoBelowBar(double size);

// The gallery.
std::string GalleryOutcome(std::size_t drawn, std::size_t missing);
std::string ExhibitMissing(std::string_view title, std::string_view why);
std::string ExhibitFailed(std::string_view title, std::string_view why);

/// What the picture of a trace says: title, description and legend.
std::string TracePictureTitle(std::string_view script, const TypeStyle& style, bool blank);
std::string TracePictureWords(std::string_view text, const TraceMetrics& total);
/// `rings`: there are some.
std::string TracePictureLegend(const TypeStyle& style, bool blank, bool rings);

}  // namespace moontrace::say

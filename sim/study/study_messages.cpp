#include "sim/study/study_messages.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string NoStudyNamed() {
  return "no protocol was named: moontrace study guidance, or a TOML file";
}

std::string NoSuchStudy(std::string_view given, const std::vector<std::string>& names,
                        std::string_view nearest) {
  return fmt::format("no study \"{}\": {}there is {}; or name a TOML file by its path",
                     OneLine(given, 40), DidYouMean(nearest), Joined(names, " and "));
}

std::string TooManyStudies(std::string_view first) {
  return fmt::format("one protocol at a time{}: run study again for the next",
                     NearestListed(first, "merge").empty() ? "" : ", or did you mean merge?");
}

std::string NothingToMerge() { return "no files to merge: name those that the shards wrote"; }

std::string MergeIntoItself(std::string_view path) {
  return fmt::format("--output {} is one of the files to merge: name another", Quoted(path));
}

std::string MergeNeedsOutput() { return "merge needs --output FILE for the rows of all shards"; }

std::string OnlyForStudies(std::string_view option) {
  return fmt::format("{} is for running a study, not for merge", option);
}

std::string WholeThreads() { return "--threads: give a whole number, 1 to 256"; }

std::string NotAShard(std::string_view given) {
  return fmt::format("--shard '{}': give K/N, as 2/4, K from 1 to N, N at most 100000", given);
}

std::string StudyBegins(std::string_view title, std::size_t learners, int threads) {
  return fmt::format("Study {}: {} simulated learners, {} at a time.", title, learners, threads);
}

std::string StudyDone(const StudySummary& summary) {
  return fmt::format("Study done: {} trials of {} learners.", summary.trials, summary.learners);
}

std::string StudyGoesOn(std::string_view path) {
  return fmt::format("Finished trials are kept in {}.parts; the same command goes on from there.",
                     OneLine(path, 300));
}

std::string StudyIsAShare(std::string_view shard) {
  return fmt::format("This is share {} of the study: compare once all shares are merged.",
                     OneLine(shard, 20));
}

std::string StudyMerged(const StudySummary& summary, std::size_t files) {
  return fmt::format("Merged {}: {} trials of {} learners.", Counted(files, "file", "files"),
                     summary.trials, summary.learners);
}

std::string StudyCellLine(const StudyCell& cell) {
  if (cell.learners < 2) {  // one value has no spread
    return fmt::format("{}, {}: {:.3f} mm, n {}", cell.phase, cell.condition, 1e3 * cell.mean,
                       cell.learners);
  }
  return fmt::format("{}, {}: {:.3f} mm, CI {:.3f} to {:.3f}, SD {:.3f}, n {}", cell.phase,
                     cell.condition, 1e3 * cell.mean, 1e3 * cell.low, 1e3 * cell.high,
                     1e3 * cell.deviation, cell.learners);
}

std::string StudyDifferenceLine(const StudyCell& cell, std::string_view reference) {
  return fmt::format("{}, {} less {}: {:+.3f} mm, CI {:+.3f} to {:+.3f}, pairs {}", cell.phase,
                     cell.condition, reference, 1e3 * cell.more, 1e3 * cell.more_low,
                     1e3 * cell.more_high, cell.pairs);
}

std::string StudyOrder(std::string_view phase, const std::vector<std::string>& conditions) {
  std::string list;
  for (const std::string& condition : conditions) list += (list.empty() ? "" : ", ") + condition;
  return fmt::format("{}, least first: {}.", phase, list);
}

std::string StudyExclusions(std::size_t count) {
  return count == 0 ? "Excluded: nothing." : fmt::format("Excluded: {} trials.", count);
}

std::string StudyExclusionLine(const StudyExclusion& exclusion) {
  return fmt::format("Trial {} of {}, seed {}, {}: {}.", exclusion.trial, exclusion.condition,
                     exclusion.seed, exclusion.phase, exclusion.why);
}

std::string StudyProves() {
  return "Mean tracing error of each learner; CI: 95 percent. Simulated learners: this shows "
         "that the program works, not how people learn.";
}

std::string ReadingBegins(std::string_view title, std::size_t pages, int threads) {
  return fmt::format("Study {}: {} by a simulated reader, {} at a time.", title,
                     Counted(pages, "page", "pages"), threads);
}

std::string ReadingDone(std::size_t pages, std::size_t combinations) {
  return fmt::format("Study done: {} of {} read.", Counted(pages, "page", "pages"),
                     Counted(combinations, "kind", "kinds"));
}

std::string ReadingCellLine(const ReadingStudyCell& cell) {
  if (cell.pages < 2) {  // one page has no spread
    return fmt::format("{}: {} right; {:.2f} s a sign", cell.condition,
                       Percent(cell.right.value, 2), cell.seconds.value);
  }
  // Its low end is rounded down as the share is, so that this never lies outside.
  return fmt::format("{}: {} right, CI {:.2f} to {:.2f}; {:.2f} s a sign, CI {:.2f} to {:.2f}",
                     cell.condition, Percent(cell.right.value, 2),
                     std::floor(1e4 * cell.right.low + 1e-9) / 100, 100 * cell.right.high,
                     cell.seconds.value, cell.seconds.low, cell.seconds.high);
}

std::string ReadingErrorsLine(const ReadingStudyCell& cell) {
  std::string line =
      fmt::format("  {} signs on {}: {} wrong, {} missed, {} too many, spaces counted", cell.signs,
                  Counted(cell.pages, "page", "pages"), cell.wrong, cell.missed, cell.extra);
  if (cell.through > 0) line += fmt::format("; pressed through {}", Times(cell.through));
  if (cell.unended > 0) line += fmt::format("; came to no end with {}", cell.unended);
  return line;
}

std::string ReadingBest(std::string_view condition) {
  return fmt::format("Surest, then quickest: {}.", condition);
}

std::string ReadingProves() {
  return "CI: 95 percent, by pages drawn anew. A simulated reader: this compares pages and "
         "devices, not people.";
}

namespace {

std::string SurestAndLeast(const std::vector<ReadingStudyCell>& cells,
                           const ReadingStudyCell& best) {
  std::string words = fmt::format(" Surest: {}, {} right, {:.2f} s a sign.", best.condition,
                                  Percent(best.right.value, 2), best.seconds.value);
  const auto [worst, most] = std::minmax_element(
      cells.begin(), cells.end(), [](const ReadingStudyCell& a, const ReadingStudyCell& b) {
        return a.right.value < b.right.value;
      });
  if (&*worst != &best && worst->right.value < most->right.value) {
    words += fmt::format(" Least right: {}, {}, {:.2f} s a sign.", worst->condition,
                         Percent(worst->right.value, 2), worst->seconds.value);
  }
  return words;
}

}  // namespace

std::string ReadingPlotWords(const ReadingSummary& summary, std::size_t shown) {
  if (summary.cells.empty()) return "No page was read.";
  const bool spread = std::any_of(summary.cells.begin(), summary.cells.end(),
                                  [](const ReadingStudyCell& cell) { return cell.pages > 1; });
  std::string words = spread ? "Dots: values; bars: their 95 percent intervals."
                             : "Dots: values; one page of a kind has no interval.";
  if (summary.best) words += SurestAndLeast(summary.cells, summary.cells[*summary.best]);
  if (shown < summary.cells.size()) {
    words +=
        fmt::format(" Of {} combinations the first {} are shown.", summary.cells.size(), shown);
  }
  return words;
}

std::string MergedReading() { return "Shares of a study of reading, put together"; }

std::string ReadingPlotRight() { return "signs right, percent"; }

std::string ReadingPlotSeconds() { return "seconds a sign"; }

std::string PictureOfReadingOnly() {
  return "--picture draws studies of reading; this one has learners: leave it out";
}

std::string StudyRowsIn() { return "Rows are in"; }

}  // namespace moontrace::say

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/study/reading_summary.h"
#include "sim/study/study_summary.h"

/// Sentences of `moontrace study`. What is wrong with a protocol or a study's file is said by the
/// code that reads it.
namespace moontrace::say {

std::string NoStudyNamed();
/// `names`: of the shipped ones; `nearest`: one of them, or empty.
std::string NoSuchStudy(std::string_view given, const std::vector<std::string>& names,
                        std::string_view nearest);
std::string TooManyStudies(std::string_view first);
std::string NothingToMerge();
std::string MergeIntoItself(std::string_view path);
std::string MergeNeedsOutput();
std::string OnlyForStudies(std::string_view option);
std::string WholeThreads();
std::string NotAShard(std::string_view given);
std::string StudyBegins(std::string_view title, std::size_t learners, int threads);
std::string StudyDone(const StudySummary& summary);
/// Stopped in the middle: what is kept, and where.
std::string StudyGoesOn(std::string_view path);
/// `shard`: K/N
std::string StudyIsAShare(std::string_view shard);
std::string StudyMerged(const StudySummary& summary, std::size_t files);
std::string StudyCellLine(const StudyCell& cell);
/// The same learners against the reference.
std::string StudyDifferenceLine(const StudyCell& cell, std::string_view reference);
/// Conditions of a phase, the least error first.
std::string StudyOrder(std::string_view phase, const std::vector<std::string>& conditions);
std::string StudyExclusions(std::size_t count);
std::string StudyExclusionLine(const StudyExclusion& exclusion);
std::string StudyProves();
std::string StudyRowsIn();
// Of studies of reading.
std::string ReadingBegins(std::string_view title, std::size_t pages, int threads);
std::string ReadingDone(std::size_t pages, std::size_t combinations);
std::string ReadingCellLine(const ReadingStudyCell& cell);
std::string ReadingErrorsLine(const ReadingStudyCell& cell);
std::string ReadingBest(std::string_view condition);
std::string ReadingProves();
/// The picture in words: its surest combination and that with least right, where these are to be
/// compared and differ; `shown`: of all, in its rows.
std::string ReadingPlotWords(const ReadingSummary& summary, std::size_t shown);
std::string MergedReading();
std::string ReadingPlotRight();
std::string ReadingPlotSeconds();
/// A picture of a study of learners was asked for.
std::string PictureOfReadingOnly();

namespace help {
inline constexpr const char* kStudyPicture =
    "of a study of reading: a picture, .svg, .png or .pdf, with a row for each combination.";
inline constexpr const char* kStudyCommand =
    "runs a study of simulated learners, or of pages read by touch, from a protocol file";
inline constexpr const char* kStudyWords =
    "a protocol (TOML), by path or by the name of a shipped one: guidance, reading, "
    "figure2, defaults, arms, joysticks. Or merge, then files of shards.";
inline constexpr const char* kStudyOutput =
    "rows as CSV, one a trial; a run that was ended goes on where it was. Default: the protocol's "
    "name with .csv, of a shard with -K-of-N.csv, in this folder. Of merge it must be given.";
inline constexpr const char* kStudyThreads =
    "learners or pages at the same time, 1 to 256; the bytes do not depend on it. Default: one a "
    "core.";
inline constexpr const char* kStudyShard =
    "only every Nth learner or page, beginning with the Kth, for one of N machines. Default 1/1.";
}  // namespace help

}  // namespace moontrace::say

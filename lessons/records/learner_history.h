#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/trial.h"
#include "lessons/records/readings.h"

namespace moontrace {

/// A learner in the records. Known by a pseudonym; no other name is kept.
struct LearnerEntry {
  std::string pseudonym;
  std::int64_t since = 0;     ///< Unix time [s]
  bool keeps_tracks = false;  ///< consented to raw tracks being kept
  std::string consent;        ///< version of the question that was answered; empty: none
  bool simulated = false;
};

/// Other events of a session, in words: the tutor's commands, breaks, stops.
struct RecordedEvent {
  std::int64_t time = 0;  ///< Unix time [s]
  std::string kind, text;
};

/// The kind of an event whose text is the learner's own, for the word `my text`: the newest counts.
inline constexpr std::string_view kOwnTextEvent = "text";

/// A trial with what the records keep besides it.
struct RecordedTrial {
  std::string course;  ///< id
  Trial trial;
  std::vector<double> track;  ///< raw samples; empty: none were kept
};

/// All that the records know of one learner.
struct LearnerHistory {
  LearnerEntry learner;
  std::vector<RecordedTrial> trials;   ///< in the order in which they were added
  std::vector<RecordedEvent> events;   ///< likewise
  std::vector<ReadDocument> readings;  ///< the newest first; an export has no ids
};

/// Throws InputError unless it is 1 to 60 printable characters without slashes, not only blanks.
void RequirePseudonym(std::string_view pseudonym);

/// A pseudonym as it may stand in a line for people. AddLearner takes none with control characters,
/// but a file from elsewhere may hold one: each shows as "?"; a longer one is cut.
std::string ShownPseudonym(std::string_view pseudonym);

/// As JSON (UTF-8, a line for each trial, event and document that is read): "format":
/// "moontrace-learner", "version".
std::string HistoryToJson(const LearnerHistory& history);

/// The same read back, equal to the bit. Throws InputError (name, place, cause, cure); time and
/// memory are bounded by the text's size, which may be 256 MB at most.
LearnerHistory HistoryFromJson(std::string_view text, const std::string& name);

/// For research: "format": "moontrace-research", the fields it holds, trials and events without
/// pseudonym, dates, words, documents and tracks. Answers that were never shown to the learner as
/// an item become "other": they may hold anything that was typed.
std::string ResearchJson(const LearnerHistory& history);

}  // namespace moontrace

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lessons/records/records.h"

/// The sentences of `moontrace records`.
namespace moontrace::say {

/// Whose command is another.
std::string ReportsItself();
std::string NoSubject(std::string_view action);
std::string NoConsentAnswer();
std::string OnlyWith(std::string_view option, std::string_view action);
std::string NoSuchLearner(std::string_view given, std::string_view nearest);
std::string NobodyHasLearnt();
std::string LearnersOutcome(std::size_t count);
std::string LearnerLine(const LearnerEntry& learner, std::size_t trials);
std::string Exported(bool anonymous);
std::string Imported(std::string_view name, std::size_t trials);
std::string EraseNeedsYes(std::string_view name);
std::string AskErase(std::string_view name);
std::string NotErased(std::string_view name);
std::string Erased(std::string_view name);
std::string ConsentNow(std::string_view name, bool yes);

namespace help {
inline constexpr const char* kRecordsCommand =
    "says who has learnt here; gives out, takes in or erases all that is known of one of them";
inline constexpr const char* kRecordsAction =
    "list; export NAME; import FILE; erase NAME; consent NAME yes or no: whether raw tracks of the "
    "hand may be kept.";
inline constexpr const char* kRecordsSubject =
    "the learner, or of import the file; - is standard input.";
inline constexpr const char* kRecordsAnswer = "of consent: yes or no.";
inline constexpr const char* kRecordsOutput =
    "of export: write to this file. Default standard output.";
inline constexpr const char* kAnonymous =
    "of export: for research, without name, dates, words and tracks; cannot be imported.";
inline constexpr const char* kEraseYes = "of erase: do not ask.";
}  // namespace help

}  // namespace moontrace::say

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace moontrace {

class Database;

/// In the head of the file, so that no other database is taken for one: "MOON".
inline constexpr std::int64_t kRecordsApplication = 0x4d4f4f4e;

/// SQL that makes version N of the records from version N - 1; the first step starts from an empty
/// file. A released step is never changed: a new one is appended.
const std::vector<std::string>& RecordsSteps();

/// The version that this program writes: the number of steps.
std::int64_t RecordsVersion();

/// Tables and indices of a file, each by its SQL without spaces that mean nothing, in the order of
/// their names.
std::vector<std::string> SchemaOf(const Database& file);
/// The same of version `version` of the records.
std::vector<std::string> RecordsSchema(std::int64_t version);

/// "INSERT INTO trial ..." with two values before those of TrialFields: learner, course.
std::string InsertTrial();
/// "SELECT ... FROM trial": two columns before those of TrialFields: id, course.
std::string SelectTrials();

}  // namespace moontrace

#include "lessons/records/trial_csv.h"

#include <fmt/core.h>

#include "lessons/records/trial_fields.h"

namespace moontrace {

namespace {

std::string Cell(std::string_view text) {
  if (text.find_first_of("\",\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell.append(c == '"' ? "\"\"" : std::string(1, c));
  return cell + "\"";
}

std::string Cell(const TrialField::Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  return Cell(std::string_view(std::get<std::string>(value)));
}

}  // namespace

std::string TrialsToCsv(std::string_view learner, std::string_view course,
                        const std::vector<Trial>& trials) {
  std::string csv = "learner,course";
  for (const TrialField& field : TrialFields()) csv.append(",").append(field.name);
  csv += "\r\n";
  for (const Trial& trial : trials) {
    if (trial.item.empty()) continue;
    csv.append(Cell(learner)).append(",").append(Cell(course));
    for (const TrialField& field : TrialFields()) csv.append(",").append(Cell(field.get(trial)));
    csv += "\r\n";
  }
  return csv;
}

}  // namespace moontrace

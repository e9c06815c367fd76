#include "lessons/records/trial_fields.h"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "lessons/course/course.h"
#include "textures/base/overload.h"

namespace moontrace {

namespace {

using Value = TrialField::Value;
using Kind = TrialField::Kind;

template <auto kMember>
Value Get(const Trial& trial) {
  const auto& member = trial.*kMember;
  using Type = std::decay_t<decltype(member)>;
  if constexpr (std::is_enum_v<Type>) {
    return std::string(NameOf(member));
  } else if constexpr (std::is_integral_v<Type>) {
    return static_cast<std::int64_t>(member);
  } else {
    return member;
  }
}

template <auto kMember>
bool Set(Trial& trial, const Value& value) {
  auto& member = trial.*kMember;
  using Type = std::decay_t<decltype(member)>;
  if constexpr (std::is_integral_v<Type>) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    if (whole == nullptr) return false;
    if constexpr (std::is_same_v<Type, bool>) {
      if (*whole != 0 && *whole != 1) return false;
    } else {
      if (!std::in_range<Type>(*whole)) return false;
    }
    member = static_cast<Type>(*whole);
    return true;
  } else if constexpr (std::is_same_v<Type, double>) {
    const auto* real = std::get_if<double>(&value);
    if (real == nullptr || !std::isfinite(*real)) return false;
    member = *real;
    return true;
  } else {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) return false;
    if constexpr (std::is_same_v<Type, std::string>) {
      member = *text;
    } else {
      std::optional<Type> named;
      if constexpr (std::is_same_v<Type, StepKind>) {
        named = StepKindOf(*text);
      } else {
        named = GuidanceModeOf(*text);
      }
      if (!named) return false;
      member = *named;
    }
    return true;
  }
}

template <typename Type>
constexpr Kind KindOf() {
  if (std::is_same_v<Type, bool>) return Kind::kFlag;
  if (std::is_integral_v<Type>) return Kind::kWhole;
  return std::is_same_v<Type, double> ? Kind::kReal : Kind::kText;
}

template <auto kMember>
TrialField Field(const char* name) {
  using Type = std::decay_t<decltype(Trial().*kMember)>;
  return {name, KindOf<Type>(), Get<kMember>, Set<kMember>};
}

/// A text that a spreadsheet would take for a formula gets an apostrophe before it, which makes it
/// a text there (OWASP, CSV injection).
std::string Cell(std::string_view text) {
  const bool formula =
      !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos;
  std::string cell = formula ? "'" : "";
  if (text.find_first_of("\",\r\n") == std::string_view::npos) return cell.append(text);
  cell.insert(0, "\"");
  for (const char c : text) cell.append(c == '"' ? "\"\"" : std::string(1, c));
  return cell + "\"";
}

std::string Cell(const TrialField::Value& value) {
  return std::visit(Overload{
                        [](std::int64_t whole) { return std::to_string(whole); },
                        [](double real) { return fmt::format("{}", real); },
                        [](const std::string& text) { return Cell(std::string_view(text)); },
                    },
                    value);
}

}  // namespace

const std::vector<TrialField>& TrialFields() {
  static const std::vector<TrialField> fields{
      Field<&Trial::time>("time_unix_s"),
      Field<&Trial::lesson>("lesson"),
      Field<&Trial::step>("step"),
      Field<&Trial::kind>("kind"),
      Field<&Trial::item>("item"),
      Field<&Trial::size>("size_m"),
      Field<&Trial::guidance>("guidance"),
      Field<&Trial::help>("help"),
      Field<&Trial::probe>("probe"),
      Field<&Trial::scaled>("scaled"),
      Field<&Trial::simulated>("simulated"),
      Field<&Trial::answer>("answer"),
      Field<&Trial::right>("right_answer"),
      Field<&Trial::latency>("latency_s"),
      Field<&Trial::coverage>("coverage"),
      Field<&Trial::mean_error>("mean_error_m"),
      Field<&Trial::rms_error>("rms_error_m"),
      Field<&Trial::error_widths>("error_widths"),
      Field<&Trial::wander_offs>("wander_offs"),
      Field<&Trial::duration>("duration_s"),
      Field<&Trial::log_jerk>("log_jerk"),
      Field<&Trial::spectral_arc>("spectral_arc"),
      Field<&Trial::mean_force>("mean_force_N"),
      Field<&Trial::mean_guidance>("mean_guidance_N"),
      Field<&Trial::guidance_work>("guidance_work_J"),
  };
  return fields;
}

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

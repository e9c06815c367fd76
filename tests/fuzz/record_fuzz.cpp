#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "sim/trial/record_columns.h"
#include "sim/trial/trial_sheet.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

/// What was taken must be written again and read as the same.
void CheckSheet(const TrialSheet& sheet) {
  std::string text;
  try {
    text = FormatTrial(sheet);
  } catch (const InputError&) {
    return;  // parameters nested deeper than a writer may
  }
  const TrialSheet again = ParseTrial(text, "again");
  const bool same =
      again.digest_holds && again.head.parameters_json == sheet.head.parameters_json &&
      again.result_json == sheet.result_json && again.ticks == sheet.ticks &&
      again.state.size() == sheet.state.size() &&
      std::memcmp(again.state.data(), sheet.state.data(), sheet.state.size() * sizeof(double)) == 0;
  if (!same) std::abort();
}

/// A row that was taken must go back to the same bytes.
void CheckRows(std::string_view bytes) {
  for (std::size_t tick = 0; (tick + 1) * kRowBytes <= bytes.size(); ++tick) {
    RecordColumns columns{};
    std::memcpy(columns.data(), bytes.data() + tick * kRowBytes, kRowBytes);
    const RecordColumns again = ToColumns(FromColumns(columns, "samples", tick));
    if (std::memcmp(again.data(), columns.data(), kRowBytes) != 0) std::abort();
  }
}

}  // namespace
}  // namespace moontrace

/// The text of a trial.json, a zero byte, the bytes of a samples.f64.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), input.size());
  try {
    moontrace::CheckSheet(moontrace::ParseTrial(input.substr(0, end), "trial.json"));
  } catch (const moontrace::InputError&) {
  }
  try {
    moontrace::CheckRows(input.substr(std::min(end + 1, input.size())));
  } catch (const moontrace::InputError&) {
  }
  return 0;
}

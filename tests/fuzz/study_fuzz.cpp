// Any bytes either are a study's protocol, or its rows, or are refused by an InputError of one
// line.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/study/study_protocol.h"
#include "sim/study/study_row.h"
#include "sim/study/study_run.h"
#include "sim/study/study_summary.h"
#include "textures/base/error.h"

namespace {

void MustBeOneLine(const moontrace::InputError& error) {
  const std::string_view line = error.what();
  if (line.empty() || line.find('\n') != std::string_view::npos) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const moontrace::StudyProtocol protocol = moontrace::ParseStudy(text, "fuzz.toml");
    if (moontrace::RowsOf(protocol, {0, protocol.first_seed}) > 10000000) std::abort();
  } catch (const moontrace::InputError& error) {
    MustBeOneLine(error);
  }
  try {
    moontrace::Summarise(moontrace::ParseRows(text, "fuzz.csv"));
  } catch (const moontrace::InputError& error) {
    MustBeOneLine(error);
  }
  return 0;
}

// Any bytes are an export of a learner or are refused by one line; what was taken is written and
// read again as the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "lessons/records/learner_history.h"
#include "textures/base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  moontrace::LearnerHistory history;
  try {
    history = moontrace::HistoryFromJson(text, "fuzz.json");
  } catch (const moontrace::InputError& error) {
    const std::string_view line = error.what();
    if (line.empty() || line.find('\n') != std::string_view::npos) std::abort();
    return 0;
  }
  moontrace::ResearchJson(history);
  const std::string written = moontrace::HistoryToJson(history);
  if (moontrace::HistoryToJson(moontrace::HistoryFromJson(written, "again")) != written) {
    std::abort();
  }
  return 0;
}

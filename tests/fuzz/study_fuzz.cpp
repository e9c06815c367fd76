// Any bytes either are a study's protocol, or its rows, or are refused by an InputError of one
// line. Rows up to the first zero byte and those behind it are two shards of a study.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/study/study_files.h"
#include "sim/study/study_protocol.h"
#include "sim/study/study_row.h"
#include "sim/study/study_run.h"
#include "sim/study/study_summary.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/one_line.h"
#include "textures/base/error.h"

namespace {

using namespace moontrace;

template <class Reader>
void ReadOrRefused(const Reader& read) {
  try {
    read();
  } catch (const InputError& error) {
    MustBeOneLine(error.what());
  }
}

void ReadProtocol(std::string_view text) {
  const StudyProtocol protocol = ParseStudy(text, "fuzz.toml");
  if (RowsOf(protocol, {0, protocol.first_seed}) > 10000000) std::abort();
  if (PlacesOf(protocol, 1, 1).size() > 100000) std::abort();
}

void Merge(std::string_view text) {
  const std::size_t zero = text.find('\0');
  const MemoryFile first(text.substr(0, zero));
  const MemoryFile second(zero == std::string_view::npos ? "" : text.substr(zero + 1));
  const std::vector<StudyRow> rows = MergeStudies({first.path(), second.path()});
  Summarise(rows);
  if (ParseRows(StudyText(rows), "again").size() != rows.size()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  ReadOrRefused([text] { ReadProtocol(text); });
  ReadOrRefused([text] { Summarise(ParseRows(text, "fuzz.csv")); });
  ReadOrRefused([text] { Merge(text); });
  return 0;
}

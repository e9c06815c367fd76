#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "sim/trial/record.h"
#include "sim/trial/record_columns.h"
#include "sim/trial/trial_sheet.h"
#include "textures/base/digest.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

/// 24 characters hold any double of 17 digits, one the comma after it.
constexpr std::uintmax_t kGreatestCsvRowBytes = 25 * kRecordColumns.size();

/// Size of a file of the record. Anything but a plain file is refused: a pipe would never end.
std::uintmax_t SizeOf(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw InputError(path + ": missing; use a complete copy of the record");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError(path + ": not a readable file; use a complete copy of the record");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw InputError(path + ": cannot be read; check the permissions");
  return size;
}

std::ifstream Open(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be opened; check the permissions");
  return file;
}

[[noreturn]] void FailAltered(const std::string& path) {
  throw InputError(path + ": altered since it was recorded; use an unaltered copy");
}

/// Digest of a file that need not be held whole.
std::uint64_t DigestOfFile(const std::string& path, std::uintmax_t greatest_bytes) {
  if (SizeOf(path) > greatest_bytes) FailAltered(path);
  std::ifstream file = Open(path);
  std::vector<char> block(1 << 16);
  Digest digest;
  do {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    digest.Add(block.data(), static_cast<std::size_t>(file.gcount()));
  } while (file);
  return digest.value();
}

TrialSheet ReadSheet(const std::string& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw InputError(folder + ": no such folder; name one that was written by --record");
  }
  const std::string path = folder + "/trial.json";
  SizeOf(path);
  TrialSheet sheet = ParseTrial(ReadTextFile(path, kGreatestTextBytes), path);
  if (!sheet.digest_holds) FailAltered(path);
  return sheet;
}

/// Checks that the file is as long as the sheet says before anything is allocated by its counts.
void CheckSampleSize(const std::string& path, const TrialSheet& sheet) {
  const std::uintmax_t size = SizeOf(path);
  const std::uintmax_t expected = std::uintmax_t{sheet.ticks} * kRowBytes;
  if (size < expected) {
    throw InputError(fmt::format("{}: cut short: {} whole ticks of {}; use a complete copy", path,
                                 size / kRowBytes, sheet.ticks));
  }
  if (size > expected) {
    throw InputError(fmt::format("{}: {} bytes beyond its {} ticks; use an unaltered copy", path,
                                 size - expected, sheet.ticks));
  }
}

/// Reads the rows block by block, each checked against the running digest before its rows count.
void ReadSamples(const std::string& path, const TrialSheet& sheet, bool tolerant, Record& record) {
  CheckSampleSize(path, sheet);
  std::ifstream file = Open(path);
  std::vector<RecordColumns> block(kDigestEvery);
  Digest digest;
  for (std::size_t first = 0; first < sheet.ticks; first += kDigestEvery) {
    const std::size_t count = std::min(kDigestEvery, sheet.ticks - first);
    const std::size_t bytes = count * kRowBytes;
    file.read(reinterpret_cast<char*>(block.data()), static_cast<std::streamsize>(bytes));
    if (!file) throw InputError(path + ": cannot be read to its end; use a complete copy");
    digest.Add(block.data(), bytes);
    if (digest.value() != sheet.sample_digests[first / kDigestEvery] && record.altered.empty()) {
      record.altered = fmt::format("{}: altered within ticks {} to {}; use an unaltered copy", path,
                                   first, first + count - 1);
      if (!tolerant) throw InputError(record.altered);
    }
    for (std::size_t i = 0; i < count; ++i) {
      record.rows.push_back(FromColumns(block[i], path, first + i));
    }
  }
}

}  // namespace

Record ReadRecord(const std::string& folder, bool tolerant) {
  TrialSheet sheet = ReadSheet(folder);
  Record record;
  const std::string model_path = folder + "/model.xml";
  SizeOf(model_path);
  record.model_xml = ReadTextFile(model_path, kGreatestTextBytes);
  if (DigestOf(record.model_xml) != sheet.model_digest) FailAltered(model_path);
  const std::string events_path = folder + "/events.jsonl";
  if (DigestOfFile(events_path, kGreatestEventBytes) != sheet.events_digest) {
    FailAltered(events_path);
  }
  // The text copy of the samples is for other programs; who does not need it may remove it.
  const std::string csv_path = folder + "/samples.csv";
  std::error_code error;
  if (sheet.has_csv && std::filesystem::exists(csv_path, error)) {
    const std::uintmax_t greatest = kGreatestCsvRowBytes * (sheet.ticks + 1);
    if (DigestOfFile(csv_path, greatest) != sheet.csv_digest) FailAltered(csv_path);
  }
  ReadSamples(folder + "/samples.f64", sheet, tolerant, record);
  record.head = std::move(sheet.head);
  record.options = sheet.options;
  record.state = std::move(sheet.state);
  record.result_json = std::move(sheet.result_json);
  record.made_by = MadeBy(sheet.build);
  return record;
}

}  // namespace moontrace

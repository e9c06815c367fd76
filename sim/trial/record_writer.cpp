#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "sim/physics/build_info.h"
#include "sim/trial/file_sink.h"
#include "sim/trial/record.h"
#include "sim/trial/record_columns.h"
#include "sim/trial/trial_sheet.h"
#include "textures/base/error.h"
#include "textures/base/file_descriptor.h"
#include "textures/base/file_writing.h"

namespace moontrace {
namespace {

static_assert(std::endian::native == std::endian::little, "samples.f64 is little-endian");

std::string NowUtc() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32] = "";
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

[[noreturn]] void FailUnwritable(const std::string& path, int error) {
  throw LackError(fmt::format("{}: cannot be made ({}); name a folder that can be written", path,
                              std::strerror(error)));
}

[[noreturn]] void FailTaken(const std::string& folder) {
  throw InputError(folder + ": exists and is not an empty folder; name another one");
}

[[noreturn]] void FailLive(const std::string& folder) {
  throw InputError(folder + ".partial: another recording runs; let it end or name another folder");
}

[[noreturn]] void FailForeign(const std::string& folder) {
  throw InputError(folder +
                   ".partial: exists and is no recording's; move it or name another folder");
}

/// The folder's whole path, if nothing is in it.
std::filesystem::path FreePath(const std::string& folder) {
  std::error_code error;
  std::filesystem::path path = std::filesystem::absolute(folder, error).lexically_normal();
  if (folder.empty() || error) throw InputError("record: no folder is named; name one");
  if (!path.has_filename()) path = path.parent_path();
  const std::filesystem::file_status status = std::filesystem::symlink_status(path, error);
  if (std::filesystem::exists(status)) {
    if (!std::filesystem::is_directory(status)) FailTaken(folder);
    const bool empty = std::filesystem::is_empty(path, error);
    if (error) FailUnwritable(folder, error.value());
    if (!empty) FailTaken(folder);
  }
  return path;
}

constexpr std::array<std::string_view, 5> kRecordFiles{"trial.json", "model.xml", "samples.f64",
                                                       "events.jsonl", "samples.csv"};

/// The files of a folder, if it holds nothing but what a recording writes; what may be somebody's
/// own is never removed. None: it holds something else, or cannot be read.
std::optional<std::vector<std::filesystem::path>> LeftByARecording(const std::string& partial) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(partial, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const bool ours =
        std::find(kRecordFiles.begin(), kRecordFiles.end(), name) != kRecordFiles.end();
    if (!ours || !std::filesystem::is_regular_file(entry->symlink_status(error)))
      return std::nullopt;
    files.push_back(entry->path());
  }
  if (error) return std::nullopt;
  return files;
}

/// Opens `DIR.partial` and locks it for as long as the file that is returned lives: so one that a
/// killed program left behind is told from one that is being written. `fresh`: it was made just
/// now. Where a file system knows no locks only that is certain to be nobody's.
FileDescriptor Locked(const std::string& folder, const std::string& partial, bool fresh) {
  FileDescriptor opened(::open(partial.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!opened) {
    if (errno == ENOTDIR || errno == ELOOP) FailForeign(folder);
    FailUnwritable(folder + ".partial", errno);
  }
  const bool locked = ::flock(opened.get(), LOCK_EX | LOCK_NB) == 0;
  if (!locked && (!fresh || errno == EWOULDBLOCK)) FailLive(folder);
  return opened;
}

/// Whether a path still leads to an open folder: its recording may have ended meanwhile.
bool LeadsTo(const std::string& path, const FileDescriptor& opened) {
  struct stat there {};
  struct stat held {};
  return ::lstat(path.c_str(), &there) == 0 && ::fstat(opened.get(), &held) == 0 &&
         there.st_dev == held.st_dev && there.st_ino == held.st_ino;
}

/// `DIR.partial`: removed with all it holds unless it became `DIR`.
class PartialFolder {
 public:
  explicit PartialFolder(const std::string& folder)
      : folder_(folder), final_(FreePath(folder).string()), partial_(final_ + ".partial") {
    const bool made = ::mkdir(partial_.c_str(), 0777) == 0;
    if (!made && errno != EEXIST) FailUnwritable(folder + ".partial", errno);
    try {
      lock_ = Locked(folder, partial_, made);
    } catch (const LackError&) {
      if (made) ::rmdir(partial_.c_str());
      throw;
    }
    if (!LeadsTo(partial_, lock_)) FailLive(folder);
    if (!made) Clear();
  }
  ~PartialFolder() { Remove(); }
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;

  std::string PathOf(const char* file) const { return partial_ + "/" + file; }

  void Remove() noexcept {
    if (partial_.empty()) return;
    try {
      std::error_code ignored;
      std::filesystem::remove_all(partial_, ignored);
    } catch (...) {  // out of memory: nothing better can be done in a destructor
    }
    partial_.clear();
  }

  /// The whole record under its name, on disk when this returns.
  void Publish() {
    if (!SyncFile(lock_.get())) FailUnwritable(folder_ + ".partial", errno);
    if (std::rename(partial_.c_str(), final_.c_str()) != 0) {
      if (errno == EEXIST || errno == ENOTEMPTY || errno == ENOTDIR) FailTaken(folder_);
      FailUnwritable(folder_, errno);
    }
    partial_.clear();
    if (!SyncFolder(FolderOf(final_))) FailUnwritable(folder_, errno);
  }

 private:
  /// Takes away what a recording that was killed had written.
  void Clear() const {
    const auto left = LeftByARecording(partial_);
    if (!left) FailForeign(folder_);
    std::error_code error;
    for (const std::filesystem::path& file : *left) {
      if (!std::filesystem::remove(file, error) && error) {
        FailUnwritable(folder_ + ".partial", error.value());
      }
    }
  }

  std::string folder_;  ///< as the caller named it, for messages
  std::string final_;
  std::string partial_;  ///< empty once there is nothing to remove
  FileDescriptor lock_;
};

void WriteWhole(const std::string& path, std::string_view text) {
  FileSink sink(path);
  sink.Write(text);
  sink.Close();
}

/// Writes the samples again as text: units in the names, 17 digits, so that every number reads back
/// equal to the bit.
std::uint64_t WriteCsv(const std::string& samples_path, const std::string& csv_path) {
  std::ifstream samples(samples_path, std::ios::binary);
  FileSink sink(csv_path);
  std::string line;
  for (const std::string_view name : kRecordColumns) line.append(name).append(",");
  line.back() = '\n';
  sink.Write(line);
  RecordColumns columns{};
  while (samples.read(reinterpret_cast<char*>(columns.data()), kRowBytes)) {
    line.clear();
    for (const double value : columns) line += fmt::format("{:.17g},", value);
    line.back() = '\n';
    sink.Write(line);
  }
  if (samples.bad() || samples.gcount() != 0) {
    throw LackError(samples_path + ": cannot be read back; check the disk");
  }
  sink.Close();
  return sink.digest().value();
}

}  // namespace

void CheckRecordFolder(const std::string& folder) {
  std::error_code error;
  const std::string partial = FreePath(folder).string() + ".partial";
  if (!std::filesystem::exists(std::filesystem::symlink_status(partial, error))) return;
  const FileDescriptor unused = Locked(folder, partial, false);
  if (!LeftByARecording(partial)) FailForeign(folder);
}

struct Recorder::Impl {
  PartialFolder folder;
  TrialSheet sheet;
  FileSink samples;
  FileSink events;
  std::size_t event_bytes = 0;
  std::string failure;  ///< the line with which recording ended early
  bool finished = false;

  Impl(const std::string& name, const RecordHead& head, const Scene& scene)
      : folder(name), samples(folder.PathOf("samples.f64")), events(folder.PathOf("events.jsonl")) {
    sheet.head = head;
    sheet.options = scene.options();
    sheet.state = scene.State();
    sheet.build = ThisBuild();
    sheet.start_time_utc = NowUtc();
    FormatTrial(sheet);  // what cannot be written is refused now, not after the work
    const std::string& model = scene.model_xml();
    if (model.size() > kGreatestTextBytes) {
      throw InputError(fmt::format("record: the model takes {} bytes; at most {} can be read",
                                   model.size(), kGreatestTextBytes));
    }
    sheet.model_digest = DigestOf(model);
    WriteWhole(folder.PathOf("model.xml"), model);
  }

  /// Runs one step of recording; a failure ends the recording and leaves nothing behind.
  template <typename Step>
  void Guarded(Step step) {
    if (finished) throw std::logic_error("Recorder: used after Finish");
    if (!failure.empty()) throw LackError(failure);
    try {
      step();
    } catch (const std::exception& error) {
      folder.Remove();
      failure = error.what();
      throw;
    }
  }

  void Add(const RecordRow& row) {
    if (sheet.ticks == kGreatestTicks) {
      throw LackError(fmt::format("{}: {} ticks are the most one record holds; record in parts",
                                  samples.path(), kGreatestTicks));
    }
    const RecordColumns columns = ToColumns(row);
    samples.Write({reinterpret_cast<const char*>(columns.data()), kRowBytes});
    if (++sheet.ticks % kDigestEvery == 0) KeepDigest();
  }

  void AddEvent(double time, const std::string& what, const std::string& detail) {
    const std::string line = FormatEvent(time, what, detail);
    event_bytes += line.size();
    if (event_bytes > kGreatestEventBytes) {
      throw LackError(fmt::format("{}: {} bytes are the most one record holds; record in parts",
                                  events.path(), kGreatestEventBytes));
    }
    events.Write(line);
  }

  void KeepDigest() { sheet.sample_digests.push_back(samples.digest().value()); }

  void Finish(const std::string& result_json, bool also_csv) {
    if (sheet.ticks % kDigestEvery != 0) KeepDigest();
    samples.Close();
    events.Close();
    sheet.events_digest = events.digest().value();
    if (also_csv) {
      sheet.csv_digest = WriteCsv(samples.path(), folder.PathOf("samples.csv"));
      sheet.has_csv = true;
    }
    sheet.result_json = result_json;
    WriteWhole(folder.PathOf("trial.json"), FormatTrial(sheet));
    folder.Publish();
    finished = true;
  }
};

Recorder::Recorder(const std::string& folder, const RecordHead& head, const Scene& scene)
    : impl_(std::make_unique<Impl>(folder, head, scene)) {}

Recorder::~Recorder() = default;

void Recorder::Add(const RecordRow& row) {
  impl_->Guarded([&] { impl_->Add(row); });
}

void Recorder::AddEvent(double time, const std::string& what, const std::string& detail) {
  impl_->Guarded([&] { impl_->AddEvent(time, what, detail); });
}

void Recorder::Finish(const std::string& result_json, bool also_csv) {
  impl_->Guarded([&] { impl_->Finish(result_json, also_csv); });
}

}  // namespace moontrace

#include "sim/study/study_files.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/file_descriptor.h"
#include "textures/base/file_writing.h"
#include "textures/base/output_file.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 30;
constexpr auto kGlance = std::chrono::milliseconds(50);

[[noreturn]] void CannotWrite(const std::string& path, int error) {
  throw LackError(fmt::format("cannot write {}: {}", path, std::strerror(error)));
}

FileDescriptor Opened(const std::string& path, int flags) {
  constexpr mode_t kRights = 0644;
  for (;;) {
    FileDescriptor file(::open(path.c_str(), flags | O_WRONLY | O_CREAT | O_CLOEXEC, kRights));
    if (file) return file;
    if (errno != EINTR) CannotWrite(path, errno);
  }
}

/// How many bytes of a part are whole lines. After a power cut the last write may have left the
/// length of what it added without the bytes: zeros, which no row holds.
std::size_t WholeLines(std::string_view text) {
  return text.substr(0, text.find('\0')).rfind('\n') + 1;  // 0 where there is none
}

/// The rows of one learner while they grow.
class Part {
 public:
  Part(const std::string& folder, const StudyProtocol& protocol, const StudyPlace& place)
      : path_(fmt::format("{}/{}-{}.csv", folder, protocol.conditions[place.condition].name,
                          place.seed)),
        kind_(protocol.kind()) {
    std::error_code error;
    const bool there = fs::exists(path_, error);
    if (error) CannotWrite(path_, error.value());
    if (!there) return;
    const std::string text = ReadTextFile(path_, kMostBytes);
    const std::size_t whole = WholeLines(text);
    if (whole < text.size()) fs::resize_file(path_, whole, error);
    if (error) CannotWrite(path_, error.value());
    rows_ = ParseRows(std::string_view(text).substr(0, whole), path_);
    begun_ = whole > 0;
    for (const StudyRow& row : rows_) {
      if (row.study != protocol.digest) {
        throw InputError(fmt::format(
            "{}: was made by another protocol: give another --output, or take it away", path_));
      }
    }
  }
  const std::string& path() const { return path_; }
  const std::vector<StudyRow>& rows() const { return rows_; }
  void Open() {
    file_ = Opened(path_, O_APPEND);
    if (!SyncFolder(FolderOf(path_))) CannotWrite(path_, errno);
    if (!begun_) Append(StudyHeader(kind_));
  }
  /// The row is on disk when this returns.
  void Add(StudyRow row) {
    row.line = FormatRow(row);
    Append(row.line);
    rows_.push_back(std::move(row));
  }
  void Close() { file_.Close(); }

 private:
  /// A line that was cut short is dropped when the file is read again.
  void Append(const std::string& line) const {
    if (!WriteAll(file_.get(), line) || !SyncFile(file_.get())) CannotWrite(path_, errno);
  }

  std::string path_;
  StudyKind kind_;
  std::vector<StudyRow> rows_;
  bool begun_ = false;
  FileDescriptor file_;
};

/// What another study or share left there would be lost when this one is done.
void CheckNoOthers(const std::string& folder, const std::vector<Part>& parts) {
  std::set<std::string> own;
  for (const Part& part : parts) own.insert(fs::path(part.path()).filename().string());
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (it->path().extension() == ".csv" && own.count(name) == 0) {
      throw InputError(fmt::format(
          "{}/{}: is another study's or share's: give another --output, or take it away", folder,
          name));
    }
  }
  if (error) CannotWrite(folder, error.value());
}

/// Ends all threads' work at the next trial.
struct Halted {};

/// Learners one by one by several threads.
class Workers {
 public:
  Workers(const StudyProtocol& protocol, const std::vector<StudyPlace>& places,
          std::vector<Part>& parts)
      : protocol_(protocol), places_(places), parts_(parts) {}

  void Run(const StudyOutput& output) {
    std::vector<std::thread> threads;
    threads.reserve(static_cast<std::size_t>(output.threads));
    for (int i = 0; i < output.threads; ++i) threads.emplace_back([this] { Work(); });
    std::exception_ptr stopped;
    while (running_ < output.threads) std::this_thread::yield();
    while (finished_ < output.threads && !stopped) {
      std::this_thread::sleep_for(kGlance);
      try {
        if (output.check) output.check();
        if (output.progress) output.progress(done_, places_.size());
      } catch (...) {
        stopped = std::current_exception();
      }
    }
    halt_ = halt_ || stopped != nullptr;
    for (std::thread& thread : threads) thread.join();
    if (stopped) std::rethrow_exception(stopped);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void Work() {
    ++running_;
    try {
      for (std::size_t i = next_++; i < places_.size() && !halt_; i = next_++) {
        Part& part = parts_[i];
        if (part.rows().size() < RowsOf(protocol_, places_[i])) {
          const std::vector<StudyRow> before = part.rows();
          part.Open();
          const auto check = [this] {
            if (halt_) throw Halted();
          };
          const auto each = [&](const StudyRow& row) {
            part.Add(row);
            check();
          };
          RunStudyLearner(protocol_, places_[i], before, each, check);
          part.Close();
        }
        ++done_;
      }
    } catch (const Halted&) {
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      halt_ = true;
    }
    ++finished_;
  }

  const StudyProtocol& protocol_;
  const std::vector<StudyPlace>& places_;
  std::vector<Part>& parts_;
  std::atomic<std::size_t> next_{0}, done_{0};
  std::atomic<int> running_{0}, finished_{0};
  std::atomic<bool> halt_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

/// The rows of a study that is done; empty where there is no such file.
std::vector<StudyRow> DoneRows(const StudyProtocol& protocol, const StudyOutput& output,
                               const std::vector<StudyPlace>& places) {
  if (!fs::exists(output.path)) return {};
  std::vector<StudyRow> rows = ParseRows(ReadTextFile(output.path, kMostBytes), output.path);
  std::size_t expected = 0;
  for (const StudyPlace& place : places) expected += RowsOf(protocol, place);
  const bool same = std::all_of(rows.begin(), rows.end(), [&protocol](const StudyRow& row) {
    return row.study == protocol.digest;
  });
  if (!same || rows.size() != expected) {
    throw InputError(fmt::format(
        "{}: holds another study or another share of it: give another --output", output.path));
  }
  return rows;
}

using Learner = std::pair<std::string, std::uint64_t>;  // condition, seed
struct Turn {
  std::size_t shard = 0;  // from 1, as given
  std::vector<StudyRow> rows;
};
using Learners = std::map<Learner, Turn>;

/// All conditions have the same learners, with seeds one after the other.
void CheckNoneMissing(const Learners& learners) {
  std::map<std::string, std::set<std::uint64_t>> seeds;
  std::set<std::uint64_t> all;
  for (const auto& learner : learners) {
    seeds[learner.first.first].insert(learner.first.second);
    all.insert(learner.first.second);
  }
  for (const auto& condition : seeds) {
    if (!all.empty() && *all.rbegin() - *all.begin() + 1 != condition.second.size()) {
      throw InputError(
          fmt::format("{}: {} learners of {} are there: a shard is missing, name it too",
                      condition.first, condition.second.size(), *all.rbegin() - *all.begin() + 1));
    }
  }
}

}  // namespace

std::string StudyText(const std::vector<StudyRow>& rows) {
  const bool pages = !rows.empty() && rows.front().page;
  std::string text = StudyHeader(pages ? StudyKind::kReading : StudyKind::kTracing);
  for (const StudyRow& row : rows) text += row.line;
  return text;
}

std::vector<StudyRow> RunStudy(const StudyProtocol& protocol, const StudyOutput& output) {
  const std::vector<StudyPlace> places = PlacesOf(protocol, output.shard, output.shards);
  std::vector<StudyRow> rows = DoneRows(protocol, output, places);
  if (!rows.empty()) return rows;
  const fs::path home = fs::path(output.path).parent_path();
  if (!home.empty() && !fs::is_directory(home)) {
    throw LackError(fmt::format("{}: its folder is not there: make it first", output.path));
  }
  const std::string folder = output.path + ".parts";
  MakeFolder(folder);
  {
    const FileDescriptor lock = Opened(folder + "/lock", 0);
    if (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
      throw LackError(fmt::format(
          "{}: another run writes it: wait for it, or give another --output", output.path));
    }
    std::vector<Part> parts;
    parts.reserve(places.size());
    for (const StudyPlace& place : places) parts.emplace_back(folder, protocol, place);
    CheckNoOthers(folder, parts);
    if (output.begins) output.begins();
    Workers(protocol, places, parts).Run(output);
    for (const Part& part : parts) {
      rows.insert(rows.end(), part.rows().begin(), part.rows().end());
    }
    const std::string text = StudyText(rows);
    WriteWhole(output.path, text);
    // a length written in mm may come back with another last bit: what is told is of the file
    rows = ParseRows(text, output.path);
  }
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  return rows;
}

std::vector<StudyRow> MergeStudies(const std::vector<std::string>& paths) {
  Learners learners;
  std::vector<Learner> order;
  std::vector<std::vector<Learner>> by_shard;
  std::uint64_t study = 0;
  for (const std::string& path : paths) {
    by_shard.emplace_back();
    for (StudyRow& row : ParseRows(ReadTextFile(path, kMostBytes), path)) {
      if (learners.empty()) study = row.study;
      if (row.study != study) {
        throw InputError(fmt::format("{}: is of another study than {}", path, paths.front()));
      }
      const Learner learner{row.condition, row.seed};
      Turn& turn = learners[learner];
      if (turn.rows.empty()) {
        turn.shard = by_shard.size();
        by_shard.back().push_back(learner);
      }
      if (turn.shard != by_shard.size() || row.trial != turn.rows.size() + 1) {
        throw InputError(fmt::format("{}: trial {} of {}, seed {}, is there twice or out of order",
                                     path, row.trial, row.condition, row.seed));
      }
      turn.rows.push_back(std::move(row));
    }
  }
  // One run takes them condition by condition and seed by seed: the conditions' order is that in
  // which the shards, by turns, come to them.
  for (std::size_t i = 0; order.size() < learners.size(); ++i) {
    for (const std::vector<Learner>& shard : by_shard) {
      if (i < shard.size()) order.push_back(shard[i]);
    }
  }
  std::vector<std::string> conditions;
  for (const Learner& learner : order) {
    if (std::find(conditions.begin(), conditions.end(), learner.first) == conditions.end()) {
      conditions.push_back(learner.first);
    }
  }
  std::vector<StudyRow> rows;
  std::size_t expected = 0;
  CheckNoneMissing(learners);
  for (const std::string& condition : conditions) {
    for (auto& learner : learners) {
      if (learner.first.first != condition) continue;
      if (expected == 0) expected = learner.second.rows.size();
      if (learner.second.rows.size() != expected) {
        throw InputError(fmt::format("{}, seed {}, has {} trials and others {}: run its shard on",
                                     condition, learner.first.second, learner.second.rows.size(),
                                     expected));
      }
      rows.insert(rows.end(), learner.second.rows.begin(), learner.second.rows.end());
    }
  }
  return rows;
}

}  // namespace moontrace

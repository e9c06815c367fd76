#pragma once

// Every way by which the program changes files in one folder comes past here: it can be logged, so
// that any power cut can be simulated afterwards, or made to fail. For executables of their own
// (alone/), since it replaces functions of the C library for the whole process, SQLite included.
//
// The model of a disk is the strictest that POSIX allows. Of what was written to a file since its
// last fsync any sectors of 512 bytes may be there or not; of the names that were made, changed or
// removed in a folder since the folder's last fsync any may be so or not, each change for itself (a
// rename is one). An fsync of a file does not bring its name to the disk.
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace moontrace::test {

/// A file or a folder by number: numbers stay when names change, and are never used again.
using Node = int;
inline constexpr Node kNobody = -1;

struct DiskNode {
  bool folder = false;
  std::string bytes;
  std::map<std::string, Node> names;
};

/// What a disk holds; node 0 is the watched folder.
using DiskState = std::map<Node, DiskNode>;

struct DiskEvent {
  enum class Kind { kWrite, kTruncate, kSync, kNames, kMark };
  Kind kind = Kind::kWrite;
  Node node = kNobody;  ///< the file, or the folder whose names change
  std::size_t offset = 0;
  std::string bytes;
  /// Of one folder or, in a move, of two: folder, name, what it leads to then.
  std::vector<std::tuple<Node, std::string, Node>> names;
  bool makes_folder = false;
  int mark = 0;
  std::set<Node> unsynced{};                ///< what has to be synced before this is certain
  std::size_t certain = std::string::npos;  ///< the event from which on it is
};

/// Watches a folder while it lives; there is one at a time. Threads may write meanwhile.
class WatchedDisk {
 public:
  explicit WatchedDisk(std::string folder) : root_(std::move(folder)) {
    state_[0].folder = true;
    Load(root_, 0);
    begin_ = state_;
    active_ = this;
  }
  ~WatchedDisk() { active_ = nullptr; }
  WatchedDisk(const WatchedDisk&) = delete;
  WatchedDisk& operator=(const WatchedDisk&) = delete;

  /// The `call`th call from now on (1: the next) that the folder sees fails with `error`, 0: writes
  /// one byte less than it should, or nothing happens where it is no write.
  void Fail(int call, int error) {
    fail_ = calls_ + call;
    error_ = error;
  }
  int calls() const { return calls_; }
  bool failed() const { return fail_ > 0 && calls_ >= fail_; }
  const std::string& failed_call() const { return failed_call_; }
  /// Something was told to the user: it has to be true after any later cut.
  void Mark(int number) {
    DiskEvent event;
    event.kind = DiskEvent::Kind::kMark;
    event.mark = number;
    Log(std::move(event));
  }
  std::size_t events() const { return log_.size(); }
  /// The last mark before a cut; 0: none.
  int MarkAt(std::size_t cut) const {
    int mark = 0;
    for (std::size_t i = 0; i < cut; ++i) {
      if (log_[i].kind == DiskEvent::Kind::kMark) mark = log_[i].mark;
    }
    return mark;
  }
  /// What the disk holds if the power goes before event `cut`.
  template <typename Random>
  DiskState After(std::size_t cut, Random& random) const {
    // now and then all or nothing of what was not synced, which are cuts as well
    const double share = std::uniform_int_distribution<int>(0, 4)(random) / 4.0;
    std::bernoulli_distribution kept(share);
    DiskState disk = begin_;
    for (std::size_t i = 0; i < cut; ++i) {
      const DiskEvent& event = log_[i];
      if (event.kind == DiskEvent::Kind::kWrite) {
        const bool certain = event.certain < cut;
        Write(disk[event.node].bytes, event, [&] { return certain || kept(random); });
      } else if (event.kind == DiskEvent::Kind::kTruncate) {
        if (event.certain < cut || kept(random)) {
          disk[event.node].bytes.resize(event.offset);
        }
      } else if (event.kind == DiskEvent::Kind::kNames) {
        if (event.makes_folder) disk[std::get<2>(event.names.front())].folder = true;
        if (event.certain < cut || kept(random)) Rename(disk, event);
      }
    }
    return disk;
  }

  /// Makes `folder` hold this, and nothing else.
  static void Put(const DiskState& disk, const std::string& folder) {
    std::filesystem::remove_all(folder);
    PutNode(disk, 0, folder);
  }

  // What follows is for the functions below.
  static WatchedDisk* active() { return active_; }
  /// Whether this call has to fail now; errno is set then.
  bool Fails(const char* name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (++calls_ != fail_) return false;
    failed_call_ = name;
    if (error_ == 0) return false;
    errno = error_;
    return true;
  }
  bool Shortens() const { return error_ == 0 && fail_ == calls_; }
  /// The path as one inside of the watched folder, "" for itself; none: elsewhere.
  std::optional<std::string> Inside(int folder, const char* path) const {
    std::string whole = path;
    if (whole.empty() || whole[0] != '/') {
      char link[64], at[4096];
      std::snprintf(link, sizeof link, folder == AT_FDCWD ? "/proc/self/cwd" : "/proc/self/fd/%d",
                    folder);
      const ssize_t size = ::readlink(link, at, sizeof at);
      if (size <= 0) return std::nullopt;
      whole = std::string(at, static_cast<std::size_t>(size)) + "/" + whole;
    }
    whole = std::filesystem::path(whole).lexically_normal().string();
    if (whole.size() > 1 && whole.back() == '/') whole.pop_back();
    if (whole == root_) return std::string();
    if (whole.compare(0, root_.size() + 1, root_ + "/") != 0) return std::nullopt;
    return whole.substr(root_.size() + 1);
  }
  bool Watches(int file) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return files_.count(file) > 0;
  }
  void Opened(int file, const std::string& path, bool made, bool emptied) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Node node = NodeOf(path);
    if (made || node == kNobody) {
      node = Make(path, false);
    } else if (emptied) {
      DiskEvent event;
      event.kind = DiskEvent::Kind::kTruncate;
      event.node = node;
      state_[node].bytes.clear();
      Append(std::move(event));
    }
    files_[file] = node;
  }
  void Closed(int file) {
    const std::lock_guard<std::mutex> lock(mutex_);
    files_.erase(file);
  }
  void Wrote(int file, std::size_t offset, const void* bytes, std::size_t count) {
    const std::lock_guard<std::mutex> lock(mutex_);
    DiskEvent event;
    event.node = files_[file];
    event.offset = offset;
    event.bytes.assign(static_cast<const char*>(bytes), count);
    Write(state_[event.node].bytes, event, [] { return true; });
    Append(std::move(event));
  }
  void Truncated(Node node, std::size_t size) {
    DiskEvent event;
    event.kind = DiskEvent::Kind::kTruncate;
    event.node = node;
    event.offset = size;
    state_[node].bytes.resize(size);
    Log(std::move(event));
  }
  void Synced(int file) {
    DiskEvent event;
    event.kind = DiskEvent::Kind::kSync;
    event.node = files_[file];
    Log(std::move(event));
  }
  void Made(const std::string& path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Make(path, true);
  }
  void Removed(const std::string& path) { Named({{path, kNobody}}); }
  void Moved(const std::string& from, const std::string& to) {
    Named({{from, kNobody}, {to, NodeOf(from)}});
  }
  Node NodeOf(const std::string& path) const {
    Node node = 0;
    for (const auto& part : std::filesystem::path(path)) {
      const auto& names = state_.at(node).names;
      const auto found = names.find(part.string());
      if (found == names.end()) return kNobody;
      node = found->second;
    }
    return node;
  }
  Node Open(int file) { return files_[file]; }

 private:
  static constexpr std::size_t kSector = 512;

  template <typename Keeps>
  static void Write(std::string& file, const DiskEvent& event, const Keeps& keeps) {
    for (std::size_t done = 0; done < event.bytes.size();) {
      const std::size_t at = event.offset + done;
      const std::size_t count = std::min(event.bytes.size() - done, kSector - at % kSector);
      if (keeps()) {
        if (file.size() < at + count) file.resize(at + count);
        file.replace(at, count, event.bytes, done, count);
      }
      done += count;
    }
  }
  static void Rename(DiskState& disk, const DiskEvent& event) {
    for (const auto& [folder, name, node] : event.names) {
      if (node == kNobody) {
        disk[folder].names.erase(name);
      } else {
        disk[folder].names[name] = node;
      }
    }
  }
  static void PutNode(const DiskState& disk, Node node, const std::string& path) {
    const auto found = disk.find(node);
    if (found != disk.end() && found->second.folder) {
      std::filesystem::create_directory(path);
      for (const auto& name : found->second.names)
        PutNode(disk, name.second, path + "/" + name.first);
      return;
    }
    std::ofstream file(path, std::ios::binary);
    if (found != disk.end()) file << found->second.bytes;
  }
  void Load(const std::string& path, Node folder) {
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      const Node node = next_++;
      state_[folder].names[entry.path().filename().string()] = node;
      state_[node].folder = entry.is_directory();
      if (entry.is_directory()) {
        Load(entry.path().string(), node);
      } else {
        std::ifstream file(entry.path(), std::ios::binary);
        state_[node].bytes = {std::istreambuf_iterator<char>(file),
                              std::istreambuf_iterator<char>()};
      }
    }
  }
  Node Make(const std::string& path, bool folder) {
    const std::filesystem::path whole(path);
    const Node parent = NodeOf(whole.parent_path().string());
    const Node node = next_++;
    state_[node].folder = folder;
    DiskEvent event;
    event.kind = DiskEvent::Kind::kNames;
    event.makes_folder = folder;
    event.names.emplace_back(parent, whole.filename().string(), node);
    Rename(state_, event);
    Append(std::move(event));
    return node;
  }
  void Named(const std::vector<std::pair<std::string, Node>>& changes) {
    DiskEvent event;
    event.kind = DiskEvent::Kind::kNames;
    for (const auto& [path, node] : changes) {
      const std::filesystem::path whole(path);
      event.names.emplace_back(NodeOf(whole.parent_path().string()), whole.filename().string(),
                               node);
    }
    Rename(state_, event);
    Log(std::move(event));
  }
  void Log(DiskEvent event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Append(std::move(event));
  }
  void Append(DiskEvent event) {
    if (event.kind == DiskEvent::Kind::kSync) {
      for (DiskEvent& earlier : log_) {
        if (earlier.unsynced.erase(event.node) > 0 && earlier.unsynced.empty()) {
          earlier.certain = log_.size();
        }
      }
    } else if (event.kind == DiskEvent::Kind::kNames) {
      for (const auto& change : event.names) event.unsynced.insert(std::get<0>(change));
    } else if (event.kind != DiskEvent::Kind::kMark) {
      event.unsynced.insert(event.node);
    }
    log_.push_back(std::move(event));
  }

  inline static WatchedDisk* active_ = nullptr;
  std::string root_;
  std::mutex mutex_;
  DiskState begin_, state_;
  Node next_ = 1;
  std::map<int, Node> files_;  ///< by descriptor
  std::vector<DiskEvent> log_;
  int calls_ = 0, fail_ = 0, error_ = 0;
  std::string failed_call_;
};

/// A folder of the test's own in memory, where the machine has such a place: thousands of small
/// files are made in it. Removed behind it.
class QuickFolder {
 public:
  QuickFolder() {
    const std::filesystem::path memory("/dev/shm");
    std::string name =
        (access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path()) /
        "moontrace-XXXXXX";
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~QuickFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  QuickFolder(const QuickFolder&) = delete;
  QuickFolder& operator=(const QuickFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// The functions of the C library, by the kernel's own calls.

inline int OpenWatched(int folder, const char* path, int flags, mode_t mode) {
  const auto open = [&] {
    return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
  };
  WatchedDisk* const disk = WatchedDisk::active();
  const std::optional<std::string> inside =
      disk == nullptr ? std::nullopt : disk->Inside(folder, path);
  if (!inside) {
    const int file = open();
    if (disk != nullptr && file >= 0) disk->Closed(file);  // closed by a way that is not seen
    return file;
  }
  if (disk->Fails("open")) return -1;
  struct stat found {};
  const bool there = fstatat(folder, path, &found, AT_SYMLINK_NOFOLLOW) == 0;
  const int file = open();
  if (file >= 0) disk->Opened(file, *inside, !there, (flags & O_TRUNC) != 0 && found.st_size > 0);
  return file;
}

inline ssize_t WriteWatched(int file, const void* bytes, std::size_t count, const off_t* at) {
  WatchedDisk* const disk = WatchedDisk::active();
  const bool watched = disk != nullptr && disk->Watches(file);
  if (watched && disk->Fails("write")) return -1;
  if (watched && disk->Shortens() && count > 1) --count;
  off_t offset = at != nullptr ? *at : 0;
  if (watched && at == nullptr) {
    struct stat found {};
    const bool appends = (fcntl(file, F_GETFL) & O_APPEND) != 0;
    offset = appends && fstat(file, &found) == 0 ? found.st_size : lseek(file, 0, SEEK_CUR);
  }
  const auto written = at != nullptr
                           ? static_cast<ssize_t>(syscall(SYS_pwrite64, file, bytes, count, *at))
                           : static_cast<ssize_t>(syscall(SYS_write, file, bytes, count));
  if (watched && written > 0) {
    disk->Wrote(file, static_cast<std::size_t>(offset), bytes, static_cast<std::size_t>(written));
  }
  return written;
}

/// Without the real one: the model does not need it, and thousands would take minutes.
inline int SyncWatched(int file) {
  WatchedDisk* const disk = WatchedDisk::active();
  if (disk == nullptr || !disk->Watches(file)) return 0;
  if (disk->Fails("fsync")) return -1;
  disk->Synced(file);
  return 0;
}

inline int TruncateWatched(int file, off_t size) {
  WatchedDisk* const disk = WatchedDisk::active();
  const bool watched = disk != nullptr && disk->Watches(file);
  if (watched && disk->Fails("ftruncate")) return -1;
  const int result = static_cast<int>(syscall(SYS_ftruncate, file, size));
  if (watched && result == 0) disk->Truncated(disk->Open(file), static_cast<std::size_t>(size));
  return result;
}

inline int RemoveWatched(int folder, const char* path, int flags) {
  WatchedDisk* const disk = WatchedDisk::active();
  const std::optional<std::string> inside =
      disk == nullptr ? std::nullopt : disk->Inside(folder, path);
  if (inside && disk->Fails("unlink")) return -1;
  const int result = static_cast<int>(syscall(SYS_unlinkat, folder, path, flags));
  if (inside && result == 0) disk->Removed(*inside);
  return result;
}

inline int MakeFolderWatched(const char* path, mode_t mode) {
  WatchedDisk* const disk = WatchedDisk::active();
  const std::optional<std::string> inside =
      disk == nullptr ? std::nullopt : disk->Inside(AT_FDCWD, path);
  if (inside && disk->Fails("mkdir")) return -1;
  const int result = static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
  if (inside && result == 0) disk->Made(*inside);
  return result;
}

inline int RenameWatched(const char* from, const char* to) {
  WatchedDisk* const disk = WatchedDisk::active();
  const std::optional<std::string> old =
      disk == nullptr ? std::nullopt : disk->Inside(AT_FDCWD, from);
  const std::optional<std::string> fresh =
      disk == nullptr ? std::nullopt : disk->Inside(AT_FDCWD, to);
  if (old && fresh && disk->Fails("rename")) return -1;
  const int result = static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
  if (old && fresh && result == 0) disk->Moved(*old, *fresh);
  return result;
}

}  // namespace moontrace::test

extern "C" {

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return moontrace::test::OpenWatched(AT_FDCWD, path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return moontrace::test::OpenWatched(AT_FDCWD, path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return moontrace::test::OpenWatched(folder, path, flags, mode);
}
int close(int file) {
  if (auto* disk = moontrace::test::WatchedDisk::active()) disk->Closed(file);
  return static_cast<int>(syscall(SYS_close, file));
}
ssize_t write(int file, const void* bytes, std::size_t count) {
  return moontrace::test::WriteWatched(file, bytes, count, nullptr);
}
ssize_t pwrite(int file, const void* bytes, std::size_t count, off_t at) {
  return moontrace::test::WriteWatched(file, bytes, count, &at);
}
ssize_t pwrite64(int file, const void* bytes, std::size_t count, off_t at) {
  return moontrace::test::WriteWatched(file, bytes, count, &at);
}
int fsync(int file) { return moontrace::test::SyncWatched(file); }
int fdatasync(int file) { return moontrace::test::SyncWatched(file); }
int ftruncate(int file, off_t size) noexcept {
  return moontrace::test::TruncateWatched(file, size);
}
int ftruncate64(int file, off_t size) noexcept {
  return moontrace::test::TruncateWatched(file, size);
}
int truncate(const char* path, off_t size) noexcept {
  const int file = open(path, O_WRONLY | O_CLOEXEC);
  if (file < 0) return -1;
  const int result = moontrace::test::TruncateWatched(file, size);
  const int error = errno;
  close(file);
  errno = error;
  return result;
}
int unlink(const char* path) noexcept { return moontrace::test::RemoveWatched(AT_FDCWD, path, 0); }
int unlinkat(int folder, const char* path, int flags) noexcept {
  return moontrace::test::RemoveWatched(folder, path, flags);
}
int rmdir(const char* path) noexcept {
  return moontrace::test::RemoveWatched(AT_FDCWD, path, AT_REMOVEDIR);
}
int remove(const char* path) noexcept {
  struct stat found {};
  const bool folder = lstat(path, &found) == 0 && S_ISDIR(found.st_mode);
  return moontrace::test::RemoveWatched(AT_FDCWD, path, folder ? AT_REMOVEDIR : 0);
}
int mkdir(const char* path, mode_t mode) noexcept {
  return moontrace::test::MakeFolderWatched(path, mode);
}
int rename(const char* from, const char* to) noexcept {
  return moontrace::test::RenameWatched(from, to);
}
}

#include "lessons/documents/zip_archive.h"

#include <algorithm>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

#ifdef MOONTRACE_HAVE_LIBZIP
#include <zip.h>
#endif

namespace moontrace {

#ifdef MOONTRACE_HAVE_LIBZIP

namespace {

constexpr zip_int64_t kMostEntries = 100'000;

class ErrorOf {
 public:
  ErrorOf() { zip_error_init(&error_); }
  ErrorOf(const ErrorOf&) = delete;
  ErrorOf& operator=(const ErrorOf&) = delete;
  ~ErrorOf() { zip_error_fini(&error_); }
  zip_error_t* get() { return &error_; }
  std::string words() { return OneLine(zip_error_strerror(&error_), 100); }

 private:
  zip_error_t error_{};
};

}  // namespace

struct ZipArchive::State {
  std::string name;      // in messages
  std::string bytes;     // of an archive that is in memory
  std::size_t left = 0;  // bytes that may still be unpacked
  zip_t* zip = nullptr;

  State(std::string its_name, std::string its_bytes, std::size_t most_bytes)
      : name(std::move(its_name)), bytes(std::move(its_bytes)), left(most_bytes) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (zip != nullptr) zip_discard(zip);
  }
};

namespace {

/// Books are stored or deflated; of one that is packed otherwise nothing may be shown (EPUB reading
/// systems 3.3, 4.2.2).
void RequireUsualPacking(zip_t* zip, const std::string& name) {
  const zip_int64_t count = zip_get_num_entries(zip, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(zip, static_cast<zip_uint64_t>(i), 0, &stat) != 0 ||
        (stat.valid & ZIP_STAT_COMP_METHOD) == 0 || stat.comp_method == ZIP_CM_STORE ||
        stat.comp_method == ZIP_CM_DEFLATE) {
      continue;
    }
    const std::string entry =
        (stat.valid & ZIP_STAT_NAME) != 0 ? OneLine(stat.name, 60) : std::string("a file");
    zip_discard(zip);
    std::string line = name + ": is packed in a way that no book is (";
    line.append(entry).append(" in it, method ").append(std::to_string(stat.comp_method));
    throw InputError(line.append("); unpack it and pack it again as zip with deflate"));
  }
}

zip_t* Opened(zip_source_t* source, const std::string& name, ErrorOf& error) {
  zip_t* zip = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, error.get());
  if (zip == nullptr) {
    const std::string words = error.words();
    if (source != nullptr) zip_source_free(source);
    throw InputError(name + ": is a damaged zip archive (" + words + "); get it again");
  }
  if (zip_get_num_entries(zip, 0) > kMostEntries) {
    zip_discard(zip);
    throw InputError(name + ": holds more than " + std::to_string(kMostEntries) +
                     " files; no book does");
  }
  RequireUsualPacking(zip, name);
  return zip;
}

}  // namespace

ZipArchive::ZipArchive(const std::string& path, std::size_t most_bytes)
    : state_(std::make_unique<State>(path, std::string(), most_bytes)) {
  RequireRegularFile(path);
  ErrorOf error;
  state_->zip = Opened(zip_source_file_create(path.c_str(), 0, -1, error.get()), path, error);
}

ZipArchive::ZipArchive(std::string bytes, const std::string& name, std::size_t most_bytes)
    : state_(std::make_unique<State>(name, std::move(bytes), most_bytes)) {
  ErrorOf error;
  const std::string& held = state_->bytes;
  state_->zip =
      Opened(zip_source_buffer_create(held.data(), held.size(), 0, error.get()), name, error);
}

ZipArchive::~ZipArchive() = default;

bool ZipArchive::Has(std::string_view entry) const {
  return zip_name_locate(state_->zip, std::string(entry).c_str(), 0) >= 0;
}

std::optional<std::string> ZipArchive::Read(std::string_view entry) {
  const zip_int64_t index = zip_name_locate(state_->zip, std::string(entry).c_str(), 0);
  if (index < 0) return std::nullopt;
  zip_stat_t stat;
  zip_stat_init(&stat);
  const auto at = static_cast<zip_uint64_t>(index);
  if (zip_stat_index(state_->zip, at, 0, &stat) == 0 &&
      (stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE) {
    return std::nullopt;
  }
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen_index(state_->zip, at, 0),
                                                               zip_fclose);
  const auto damaged = [&](const char* words) {
    return InputError(state_->name + ": " + OneLine(entry) + " in it cannot be unpacked (" +
                      OneLine(words, 100) + "); get it again");
  };
  if (file == nullptr) throw damaged(zip_strerror(state_->zip));
  // What the archive says of sizes may be wrong: bytes are counted as they come.
  std::string text;
  char block[65536];
  for (;;) {
    const zip_int64_t count = zip_fread(file.get(), block, sizeof block);
    if (count < 0) throw damaged(zip_file_strerror(file.get()));
    if (count == 0) return text;
    const auto taken = static_cast<std::size_t>(count);
    if (taken > state_->left) {
      throw InputError(state_->name + ": unpacks to more than is taken, with " + OneLine(entry) +
                       "; raise --most-mb if you trust it");
    }
    state_->left -= taken;
    text.append(block, taken);
  }
}

bool CanReadZip() { return true; }

#else

struct ZipArchive::State {};

namespace {
[[noreturn]] void ThrowLack() {
  throw LackError(
      "EPUB books cannot be read: the program was built without libzip; install libzip-dev and "
      "build "
      "it again");
}
}  // namespace

ZipArchive::ZipArchive(const std::string& /*path*/, std::size_t /*most_bytes*/) { ThrowLack(); }
ZipArchive::ZipArchive(std::string /*bytes*/, const std::string& /*name*/,
                       std::size_t /*most_bytes*/) {
  ThrowLack();
}
ZipArchive::~ZipArchive() = default;
bool ZipArchive::Has(std::string_view /*entry*/) const { return false; }
std::optional<std::string> ZipArchive::Read(std::string_view /*entry*/) { return std::nullopt; }
bool CanReadZip() { return false; }

#endif

}  // namespace moontrace

#include "lessons/records/database.h"

#include <fmt/core.h>

#include <exception>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

#ifdef MOONTRACE_HAVE_SQLITE
#include <sqlite3.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <new>
#include <utility>
#endif

namespace moontrace {

namespace {

constexpr const char* kDamaged =
    ": the records are damaged; put a copy in their place, or import an export";

}  // namespace

#ifdef MOONTRACE_HAVE_SQLITE

namespace {

// A report waits for a trial that is being written, and the other way round; both take
// milliseconds.
constexpr int kBusyMilliseconds = 2000;
constexpr int kLongestText = 1 << 20;  // [bytes]

/// errno of the last failure; SQLite's own copy may come from a later call of its clean-up.
int SystemError(sqlite3* file) {
  int error = 0;
  if (file == nullptr) return 0;
  sqlite3_file_control(file, "main", SQLITE_FCNTL_LAST_ERRNO, &error);
  return error != 0 ? error : sqlite3_system_errno(file);
}

[[noreturn]] void Fail(const std::string& path, sqlite3* file, int code) {
  const int system = SystemError(file);
  const bool full = system == ENOSPC || system == EDQUOT || system == EFBIG;
  const auto lack = [&](const char* what) { throw LackError(path + ": " + what); };
  switch (code & 0xff) {
    case SQLITE_FULL:
      lack("no room left for the records; make room on the disk and go on");
      break;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      lack("another program uses these records; close it and try again");
      break;
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      lack("these records can only be read; give write permission to file and folder");
      break;
    case SQLITE_CANTOPEN:
      lack("the records cannot be opened; give read and write permission to file and folder");
      break;
    case SQLITE_NOTADB:
      throw InputError(path + ": not a records file; name another by --records");
    case SQLITE_CORRUPT:
    case SQLITE_MISMATCH:
    case SQLITE_TOOBIG:
      throw InputError(path + kDamaged);
    case SQLITE_NOMEM:
      throw std::bad_alloc();
    default:
      break;
  }
  if (full) lack("no room left for the records; make room on the disk and go on");
  const std::string cause = system != 0 ? std::strerror(system) : sqlite3_errstr(code);
  throw LackError(fmt::format("{}: the records cannot be used: {}; mend that and try again", path,
                              OneLine(cause, 100)));
}

void Require(const std::string& path, sqlite3* file, int code) {
  if (code != SQLITE_OK) Fail(path, file, code);
}

}  // namespace

void Statement::Finish::operator()(sqlite3_stmt* statement) const noexcept {
  sqlite3_finalize(statement);
}

Statement::Statement(const std::string& path, sqlite3* file, const std::string& sql)
    : path_(&path), file_(file) {
  sqlite3_stmt* made = nullptr;
  const int code =
      sqlite3_prepare_v2(file, sql.data(), static_cast<int>(sql.size()), &made, nullptr);
  statement_.reset(made);
  // our SQL is right: a missing table or column means that the file was changed
  if (code == SQLITE_ERROR) Fail(path, file, SQLITE_CORRUPT);
  Require(path, file, code);
}

Statement& Statement::Bind(int index, std::int64_t value) {
  Require(*path_, file_, sqlite3_bind_int64(statement_.get(), index, value));
  return *this;
}

Statement& Statement::Bind(int index, double value) {
  Require(*path_, file_, sqlite3_bind_double(statement_.get(), index, value));
  return *this;
}

Statement& Statement::Bind(int index, std::string_view text) {
  Require(*path_, file_,
          sqlite3_bind_text64(statement_.get(), index, text.data() == nullptr ? "" : text.data(),
                              text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}

Statement& Statement::Bind(int index, const std::vector<double>& numbers) {
  Require(*path_, file_,
          sqlite3_bind_blob64(statement_.get(), index, numbers.data(),
                              numbers.size() * sizeof(double), SQLITE_STATIC));
  return *this;
}

bool Statement::Step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  sqlite3_reset(statement_.get());
  if (code != SQLITE_DONE) Fail(*path_, file_, code);
  return false;
}

bool Statement::IsNull(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::Integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::Real(int column) const {
  const double value = sqlite3_column_double(statement_.get(), column);
  return std::isfinite(value) ? value : 0;
}

std::string Statement::Text(int column) const {
  const unsigned char* text = sqlite3_column_text(statement_.get(), column);
  const int bytes = sqlite3_column_bytes(statement_.get(), column);
  if (bytes > kLongestText) throw InputError(*path_ + kDamaged);
  return text == nullptr
             ? std::string()
             : std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(bytes));
}

std::vector<double> Statement::Numbers(int column) const {
  const void* bytes = sqlite3_column_blob(statement_.get(), column);
  const auto count = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  std::vector<double> numbers(count / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes, numbers.size() * sizeof(double));
  return numbers;
}

void Database::Close::operator()(sqlite3* file) const noexcept { sqlite3_close_v2(file); }

Database::Database(std::unique_ptr<const std::string> path, int flags) : path_(std::move(path)) {
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(path_->c_str(), &opened, flags, nullptr);
  file_.reset(opened);
  Require(*path_, opened, code);
  sqlite3_extended_result_codes(opened, 1);
  sqlite3_busy_timeout(opened, kBusyMilliseconds);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
}

Database::Database(const std::string& path, bool write)
    // absolute, so that no path is taken for SQLite's own names such as ":memory:". Also for
    // reading it is opened to be written where that is allowed: what a killed program left
    // half-done must be taken back before anything can be read.
    : Database(std::make_unique<const std::string>(std::filesystem::absolute(path).string()),
               SQLITE_OPEN_READWRITE | (write ? SQLITE_OPEN_CREATE : 0)) {
  // EXTRA: a commit in a journal's mode is its journal's removal, and only this has the folder
  // synced after it; with FULL a power cut could bring the journal, and what was before, back.
  // temp_store: data being rearranged must not reach a folder for temporary files
  Run("PRAGMA synchronous = EXTRA; PRAGMA secure_delete = ON; PRAGMA foreign_keys = ON;"
      "PRAGMA temp_store = MEMORY; PRAGMA cell_size_check = ON");
  if (write && sqlite3_db_readonly(file_.get(), "main") == 1) {
    Fail(*path_, file_.get(), SQLITE_READONLY);
  }
  // A rollback journal, not a log: then one file holds all, and can be read where nothing may be
  // written.
  Run(write ? "PRAGMA journal_mode = DELETE" : "PRAGMA query_only = ON");
}

Database Database::InMemory() {
  return {std::make_unique<const std::string>(":memory:"),
          SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE};
}

void Database::Run(const std::string& sql) const {
  const int code = sqlite3_exec(file_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code == SQLITE_ERROR) Fail(*path_, file_.get(), SQLITE_CORRUPT);
  Require(*path_, file_.get(), code);
}

std::int64_t Database::LastRow() const { return sqlite3_last_insert_rowid(file_.get()); }

bool Database::Available() { return true; }

#else  // nothing below can be reached but the constructor, which throws

void Statement::Finish::operator()(sqlite3_stmt*) const noexcept {}
Statement::Statement(const std::string& path, sqlite3* file, const std::string&)
    : path_(&path), file_(file) {}
Statement& Statement::Bind(int, std::int64_t) { return *this; }
Statement& Statement::Bind(int, double) { return *this; }
Statement& Statement::Bind(int, std::string_view) { return *this; }
Statement& Statement::Bind(int, const std::vector<double>&) { return *this; }
bool Statement::Step() { return false; }
bool Statement::IsNull(int) const { return true; }
std::int64_t Statement::Integer(int) const { return 0; }
double Statement::Real(int) const { return 0; }
std::string Statement::Text(int) const { return {}; }
std::vector<double> Statement::Numbers(int) const { return {}; }

void Database::Close::operator()(sqlite3*) const noexcept {}
Database::Database(std::unique_ptr<const std::string> path, int) { RequireAvailable(*path); }
Database::Database(const std::string& path, bool) { RequireAvailable(path); }
Database Database::InMemory() { return {std::make_unique<const std::string>(), 0}; }
void Database::Run(const std::string&) const {}
std::int64_t Database::LastRow() const { return 0; }
bool Database::Available() { return false; }

#endif

void Database::RequireAvailable(const std::string& path) {
  if (Available()) return;
  throw LackError(path + ": built without SQLite; install libsqlite3-dev and build again");
}

Statement Database::Prepare(const std::string& sql) const { return {*path_, file_.get(), sql}; }

std::int64_t Database::Number(const std::string& sql) const {
  Statement statement = Prepare(sql);
  return statement.Step() ? statement.Integer(0) : 0;
}

std::vector<std::string> Database::Columns(const std::string& table) const {
  std::vector<std::string> names;
  Statement statement = Prepare("SELECT name FROM pragma_table_info(?)");
  statement.Bind(1, std::string_view(table));
  while (statement.Step()) names.push_back(statement.Text(0));
  return names;
}

void Database::Check(const std::string& table) const {
  Statement statement = Prepare("PRAGMA quick_check(" + (table.empty() ? "1" : table) + ")");
  if (statement.Step() && statement.Text(0) == "ok") return;
  throw InputError(*path_ + kDamaged);
}

std::int64_t Database::Bytes() const {
  return Number("PRAGMA page_count") * Number("PRAGMA page_size");
}

Transaction::Transaction(const Database& database) : database_(database) {
  database.Run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.Run("ROLLBACK");
  } catch (const std::exception&) {  // SQLite has rolled back by itself
  }
}

void Transaction::Commit() {
  database_.Run("COMMIT");
  open_ = false;
}

}  // namespace moontrace

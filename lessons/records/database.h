#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace moontrace {

/// One SQL statement with its values. Columns count from 0, values to be bound from 1.
class Statement {
 public:
  Statement& Bind(int index, std::int64_t value);
  Statement& Bind(int index, double value);
  Statement& Bind(int index, std::string_view text);
  /// As bytes; the array must outlive the last Step.
  Statement& Bind(int index, const std::vector<double>& numbers);
  /// Goes to the next row; false: there is none, and the statement can be bound and run anew.
  bool Step();

  bool IsNull(int column) const;
  std::int64_t Integer(int column) const;
  double Real(int column) const;  ///< 0 for what is not finite
  /// Throws InputError where it is longer than 1 MiB: no text of ours is.
  std::string Text(int column) const;
  std::vector<double> Numbers(int column) const;

 private:
  friend class Database;
  Statement(const std::string& path, sqlite3* file, const std::string& sql);
  struct Finish {
    void operator()(sqlite3_stmt* statement) const noexcept;
  };
  [[maybe_unused]] const std::string* path_;  // without SQLite nobody asks
  [[maybe_unused]] sqlite3* file_;
  std::unique_ptr<sqlite3_stmt, Finish> statement_;
};

/// A SQLite file; database.cpp is the only source that uses SQLite. Every error is thrown as one
/// line that begins with the path: InputError for what is wrong with the file (not a database,
/// damaged), LackError for what is wrong with the machine (no permission, no room, in use, built
/// without SQLite). What is deleted is overwritten by zeros; a commit returns when the disk has it,
/// so that a power cut takes nothing back. Views and triggers of the file do nothing.
class Database {
 public:
  /// An empty one that is no file and goes with this.
  static Database InMemory();
  /// `write`: makes the file where there is none. Otherwise only a transaction that a killed
  /// program left unfinished is undone.
  Database(const std::string& path, bool write);

  /// False: built without SQLite.
  static bool Available();
  static void RequireAvailable(const std::string& path);

  Statement Prepare(const std::string& sql) const;
  /// Statements without values and results.
  void Run(const std::string& sql) const;
  /// First number of the first row; 0 where there is none.
  std::int64_t Number(const std::string& sql) const;
  std::int64_t LastRow() const;
  /// Names of a table's columns.
  std::vector<std::string> Columns(const std::string& table) const;
  /// Throws InputError where the structure of the file is damaged, or only of a table and its
  /// indices if one is named.
  void Check(const std::string& table = {}) const;
  std::int64_t Bytes() const;  ///< of the file

 private:
  struct Close {
    void operator()(sqlite3* file) const noexcept;
  };
  Database(std::unique_ptr<const std::string> path, int flags);

  std::unique_ptr<const std::string> path_;  // at an address that statements may keep
  std::unique_ptr<sqlite3, Close> file_;
};

/// Rolls back what was not committed.
class Transaction {
 public:
  explicit Transaction(const Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void Commit();

 private:
  const Database& database_;
  bool open_ = true;
};

}  // namespace moontrace

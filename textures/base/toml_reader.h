#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "textures/base/text_file.h"

namespace moontrace {

/// A table of a TOML document, read by typed getters. Every error is an InputError of one line:
/// file:line:column, what is wrong, how to mend it. A getter without `otherwise` demands the key.
/// Each getter remembers its key as known; call `FailUnknown` once all have been asked for, and a
/// misspelt key is reported with its nearest known neighbour. Copies share that memory.
///
///     const TomlTable hand = TomlTable::Read(path);
///     const double mass = hand.Number("mass_kg");
///     const double press = hand.Number("press_n", 1.0);
///     hand.FailUnknown();
class TomlTable {
 public:
  /// Parses a document; `file_name` stands in messages. Throws InputError when it is broken, holds
  /// more than 1 MB nests too deep or has a key of more than 16 parts.
  static TomlTable Parse(std::string_view text, const std::string& file_name);

  /// Reads and parses a file.
  static TomlTable Read(const std::string& path);

  /// Parses one inline table alone, braces included: `{text='MUG', size_mm=10}`.
  static TomlTable ParseInline(std::string_view text, const std::string& name);

  bool Has(const std::string& key) const;
  /// All keys, sorted by name; a table with free keys (a map) is walked with these.
  std::vector<std::string> Keys() const;

  /// A finite number, integer or not. Infinite and NaN are errors.
  double Number(const std::string& key) const;
  double Number(const std::string& key, double otherwise) const;
  std::int64_t Integer(const std::string& key) const;
  std::int64_t Integer(const std::string& key, std::int64_t otherwise) const;
  bool Bool(const std::string& key) const;
  bool Bool(const std::string& key, bool otherwise) const;
  std::string String(const std::string& key) const;
  std::string String(const std::string& key, const std::string& otherwise) const;
  std::vector<double> Numbers(const std::string& key) const;
  std::vector<std::string> Strings(const std::string& key) const;
  TomlTable Table(const std::string& key) const;
  /// An array of tables (`[[key]]`); empty when the key is absent.
  std::vector<TomlTable> Tables(const std::string& key) const;

  /// Throws for the first key of this table (not of its sub-tables) that no getter has asked for.
  void FailUnknown() const;

  /// The same for all of them, each as the error's line; empty where all are known.
  std::vector<std::string> Unknown() const;

  /// Place of a key's value, of an element of its array, or of the table when the key is absent or
  /// empty. Columns count characters.
  TextPlace PlaceOf(const std::string& key = "", std::size_t element = kWhole) const;
  static constexpr std::size_t kWhole = static_cast<std::size_t>(-1);

  /// "file:line:column" of a key's value, or of the table when the key is absent or empty.
  std::string Where(const std::string& key = "") const;
  /// Throws InputError "Where(key): key: problem", for a value the caller finds wrong. `problem`
  /// says cause and cure.
  [[noreturn]] void Fail(const std::string& key, const std::string& problem) const;

 private:
  struct View;
  explicit TomlTable(std::shared_ptr<View> view);
  std::shared_ptr<View> view_;
};

/// The value that stands at `key`, which must lie from `low` to `high`. Throws InputError
/// (file:line:column, the range) for others, NaN among them.
double InRange(const TomlTable& table, const std::string& key, double value, double low,
               double high);

}  // namespace moontrace

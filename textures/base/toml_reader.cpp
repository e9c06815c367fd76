#include "textures/base/toml_reader.h"

#include <fmt/core.h>

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr std::size_t kMaxBytes = 1U << 20U;
constexpr std::size_t kMaxDots = 16;
constexpr const char* kInlineKey = "t=";  ///< written before a lone inline table

struct Document {
  std::string file;
  std::size_t shift = 0;  ///< columns that our own prefix takes up in line 1
  toml::table root;
};

/// Offset behind the string that opens at `i` (all four kinds of TOML strings), or the text's end.
std::size_t EndOfString(std::string_view text, std::size_t i) {
  const char quote = text[i];
  const bool multiline = text.substr(i, 3) == std::string(3, quote);
  i += multiline ? 3 : 1;
  for (; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (text[i] == quote && !multiline) {
      return i + 1;
    } else if (text[i] == quote && text.substr(i, 3) == std::string(3, quote)) {
      i += 3;  // up to two more quotes belong to the text
      for (int extra = 0; extra < 2 && i < text.size() && text[i] == quote; ++extra) ++i;
      return i;
    } else if (text[i] == '\n' && !multiline) {
      return i;
    }
  }
  return text.size();
}

/// toml++ 3.3 bounds nested brackets but not dotted keys: `a.a.a...` makes its destructors recurse
/// until the stack ends. So keys of very many parts are refused first.
void CheckKeys(std::string_view text, const std::string& file) {
  std::size_t dots = 0;
  std::size_t i = 0;
  while (i < text.size()) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = EndOfString(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '\n' || c == ',' || c == '=') dots = 0;
    if (c == '.' && ++dots > kMaxDots) {
      const TextPlace place = PlaceOf(text, i);
      throw InputError(file + ":" + std::to_string(place.line) + ":" +
                       std::to_string(place.column) + ": a key of more than " +
                       std::to_string(kMaxDots) + " parts; nest less");
    }
    ++i;
  }
}

TextPlace PlaceIn(const Document& document, const toml::source_position& position) {
  const std::size_t line = position.line;
  std::size_t column = position.column;
  if (line == 1 && column > document.shift) column -= document.shift;
  return {std::max<std::size_t>(line, 1), std::max<std::size_t>(column, 1)};
}

std::string At(const Document& document, const toml::source_position& position) {
  const TextPlace place = PlaceIn(document, position);
  return document.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

const char* KindOf(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a string";
  if (node.is_integer()) return "an integer";
  if (node.is_floating_point()) return "a number";
  if (node.is_boolean()) return "a boolean";
  return "a date or time";
}

}  // namespace

struct TomlTable::View {
  std::shared_ptr<const Document> document;
  const toml::table* table = nullptr;
  std::set<std::string> asked;

  const toml::node* Find(const std::string& key) {
    asked.insert(key);
    return table->get(key);
  }
  const toml::node& Demand(const std::string& key, const char* kind) {
    if (const toml::node* node = Find(key)) return *node;
    throw InputError(Place(nullptr) + ": no key '" + OneLine(key) + "'; add it (" + kind + ")");
  }
  std::string Place(const toml::node* node) const {
    return At(*document, node != nullptr ? node->source().begin : table->source().begin);
  }
  [[noreturn]] void FailKind(const toml::node& node, const std::string& key,
                             const char* wanted) const {
    throw InputError(Place(&node) + ": " + OneLine(key) + " is " + KindOf(node) + "; give " +
                     wanted);
  }
  double ToNumber(const toml::node& node, const std::string& key) const {
    if (!node.is_number()) FailKind(node, key, "a number");
    const double number = *node.value<double>();
    if (!std::isfinite(number)) {
      throw InputError(Place(&node) + ": " + OneLine(key) + " is not finite; give a finite number");
    }
    return number;
  }
  std::string ToString(const toml::node& node, const std::string& key) const {
    if (!node.is_string()) FailKind(node, key, "a string");
    return node.as_string()->get();
  }
  const toml::array& ToArray(const std::string& key, const char* wanted) {
    const toml::node& node = Demand(key, wanted);
    if (!node.is_array()) FailKind(node, key, wanted);
    return *node.as_array();
  }
};

TomlTable::TomlTable(std::shared_ptr<View> view) : view_(std::move(view)) {}

namespace {

std::shared_ptr<const Document> ParseDocument(std::string_view text, const std::string& file_name,
                                              std::size_t shift) {
  if (text.size() > kMaxBytes) {
    throw InputError(file_name + ": holds more than 1 MB; name a shorter file");
  }
  CheckKeys(text, file_name);
  auto document = std::make_shared<Document>();
  document->file = file_name;
  document->shift = shift;
  try {
    document->root = toml::parse(text, std::string_view{});
  } catch (const toml::parse_error& error) {
    throw InputError(At(*document, error.source().begin) +
                     ": broken TOML: " + OneLine(error.description(), 160) + "; correct the line");
  }
  return document;
}

}  // namespace

TomlTable TomlTable::Parse(std::string_view text, const std::string& file_name) {
  auto view = std::make_shared<View>();
  view->document = ParseDocument(text, file_name, 0);
  view->table = &view->document->root;
  return TomlTable(std::move(view));
}

TomlTable TomlTable::Read(const std::string& path) {
  return Parse(ReadTextFile(path, kMaxBytes), path);
}

TomlTable TomlTable::ParseInline(std::string_view text, const std::string& name) {
  const std::string prefix = kInlineKey;
  auto view = std::make_shared<View>();
  view->document = ParseDocument(prefix + std::string(text), name, prefix.size());
  const toml::table& root = view->document->root;
  view->table = root.size() == 1 ? root.begin()->second.as_table() : nullptr;
  if (view->table == nullptr) {
    throw InputError(name + ":1:1: not one inline table; write {key = value, ...}");
  }
  return TomlTable(std::move(view));
}

bool TomlTable::Has(const std::string& key) const { return view_->Find(key) != nullptr; }

std::vector<std::string> TomlTable::Keys() const {
  std::vector<std::string> keys;
  for (const auto& entry : *view_->table) keys.emplace_back(entry.first.str());
  return keys;
}

double TomlTable::Number(const std::string& key) const {
  return view_->ToNumber(view_->Demand(key, "a number"), key);
}

double TomlTable::Number(const std::string& key, double otherwise) const {
  return Has(key) ? Number(key) : otherwise;
}

std::int64_t TomlTable::Integer(const std::string& key) const {
  const toml::node& node = view_->Demand(key, "an integer");
  if (!node.is_integer()) view_->FailKind(node, key, "an integer");
  return node.as_integer()->get();
}

std::int64_t TomlTable::Integer(const std::string& key, std::int64_t otherwise) const {
  return Has(key) ? Integer(key) : otherwise;
}

bool TomlTable::Bool(const std::string& key) const {
  const toml::node& node = view_->Demand(key, "true or false");
  if (!node.is_boolean()) view_->FailKind(node, key, "true or false");
  return node.as_boolean()->get();
}

bool TomlTable::Bool(const std::string& key, bool otherwise) const {
  return Has(key) ? Bool(key) : otherwise;
}

std::string TomlTable::String(const std::string& key) const {
  return view_->ToString(view_->Demand(key, "a string"), key);
}

std::string TomlTable::String(const std::string& key, const std::string& otherwise) const {
  return Has(key) ? String(key) : otherwise;
}

std::vector<double> TomlTable::Numbers(const std::string& key) const {
  std::vector<double> numbers;
  for (const toml::node& node : view_->ToArray(key, "an array of numbers")) {
    numbers.push_back(view_->ToNumber(node, key));
  }
  return numbers;
}

std::vector<std::string> TomlTable::Strings(const std::string& key) const {
  std::vector<std::string> strings;
  for (const toml::node& node : view_->ToArray(key, "an array of strings")) {
    strings.push_back(view_->ToString(node, key));
  }
  return strings;
}

TomlTable TomlTable::Table(const std::string& key) const {
  const toml::node& node = view_->Demand(key, "a table");
  if (!node.is_table()) view_->FailKind(node, key, "a table");
  auto view = std::make_shared<View>();
  view->document = view_->document;
  view->table = node.as_table();
  return TomlTable(std::move(view));
}

std::vector<TomlTable> TomlTable::Tables(const std::string& key) const {
  std::vector<TomlTable> tables;
  if (!Has(key)) return tables;
  for (const toml::node& node : view_->ToArray(key, "an array of tables")) {
    if (!node.is_table()) view_->FailKind(node, key, "an array of tables");
    auto view = std::make_shared<View>();
    view->document = view_->document;
    view->table = node.as_table();
    tables.push_back(TomlTable(std::move(view)));
  }
  return tables;
}

std::vector<std::string> TomlTable::Unknown() const {
  std::vector<std::string> lines;
  for (const auto& entry : *view_->table) {
    const std::string key(entry.first.str());
    if (view_->asked.count(key) != 0) continue;
    const std::vector<std::string> known(view_->asked.begin(), view_->asked.end());
    const std::string nearest = NearestWord(key, known);
    lines.push_back(At(*view_->document, entry.first.source().begin) + ": unknown key '" +
                    OneLine(key) + "'; " +
                    (nearest.empty() ? "remove it" : "did you mean '" + nearest + "'?"));
  }
  return lines;
}

void TomlTable::FailUnknown() const {
  const std::vector<std::string> lines = Unknown();
  if (!lines.empty()) throw InputError(lines.front());
}

TextPlace TomlTable::PlaceOf(const std::string& key, std::size_t element) const {
  const toml::node* node = view_->table->get(key);
  if (node != nullptr && element != kWhole && node->is_array()) {
    const toml::node* part = node->as_array()->get(element);
    if (part != nullptr) node = part;
  }
  return PlaceIn(*view_->document,
                 node != nullptr ? node->source().begin : view_->table->source().begin);
}

std::string TomlTable::Where(const std::string& key) const {
  return view_->Place(view_->table->get(key));
}

void TomlTable::Fail(const std::string& key, const std::string& problem) const {
  throw InputError(Where(key) + ": " + (key.empty() ? "" : OneLine(key) + ": ") + problem);
}

double InRange(const TomlTable& table, const std::string& key, double value, double low,
               double high) {
  if (!(value >= low && value <= high)) {
    table.Fail(key, fmt::format("{:.6g} is out of range: give {:.6g} to {:.6g}", value, low, high));
  }
  return value;
}

}  // namespace moontrace

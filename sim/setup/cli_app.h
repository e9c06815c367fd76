#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// CLI11's command line, only declared here: its header takes seconds to compile.
namespace CLI {  // NOLINT(readability-identifier-naming): its own name
class App;
}

/// How commands add options to it. Reading one throws UsageError.
namespace moontrace {

/// Options that are added from here on stand under this heading of help.
void BeginGroup(CLI::App& app, const char* heading);

/// An option with one value, read by `read`; the last one given counts.
void AddValue(CLI::App& app, const std::string& name, const std::string& type,
              const std::function<void(const std::string&)>& read, const std::string& description);
void AddFlag(CLI::App& app, const std::string& name, bool& flag, const std::string& description);
/// A flag that may take a value, as in `--keys=FILE`; "true" without one.
void AddFlag(CLI::App& app, const std::string& name, std::string& value,
             const std::string& description);
/// All arguments without a name.
void AddWords(CLI::App& app, std::vector<std::string>& words, const std::string& description);
/// Gives an option that was added before another description.
void Redescribe(CLI::App& app, const std::string& name, const std::string& description);
/// A number option in the user's unit, times `scale`, from `low` to `high` in the user's unit.
void AddNumber(CLI::App& app, const std::string& name, std::optional<double>& value, double low,
               double high, double scale, const std::string& description);
/// A file or folder. An empty one is a UsageError: it would read as not given.
void AddPath(CLI::App& app, const std::string& name, const std::string& type, std::string& path,
             const std::string& description);

/// Reads a finite number from `low` to `high`. Throws UsageError.
double ReadNumber(const std::string& option, const std::string& given, double low, double high);
/// Whether all of `text` is a number.
bool ParseNumber(std::string_view text, double& value);

}  // namespace moontrace

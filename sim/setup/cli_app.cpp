#include "sim/setup/cli_app.h"

#include <CLI/App.hpp>
#include <charconv>
#include <cmath>

#include "sim/console/console.h"
#include "sim/setup/setup_messages.h"

namespace moontrace {

bool ParseNumber(std::string_view text, double& value) {
  const std::from_chars_result read =
      std::from_chars(text.data(), text.data() + text.size(), value);
  return !text.empty() && read.ec == std::errc() && read.ptr == text.data() + text.size();
}

double ReadNumber(const std::string& option, const std::string& given, double low, double high) {
  double value = 0;
  if (!ParseNumber(given, value)) throw UsageError(say::NotANumber(option, given));
  if (!std::isfinite(value) || value < low || value > high) {
    throw UsageError(say::OutOfRange(option, given, low, high));
  }
  return value;
}

void BeginGroup(CLI::App& app, const char* heading) { app.option_defaults()->group(heading); }

void AddValue(CLI::App& app, const std::string& name, const std::string& type,
              const std::function<void(const std::string&)>& read, const std::string& description) {
  app.add_option_function<std::string>(name, read, description)
      ->type_name(type)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

void AddFlag(CLI::App& app, const std::string& name, bool& flag, const std::string& description) {
  app.add_flag(name, flag, description);
}

void AddFlag(CLI::App& app, const std::string& name, std::string& value,
             const std::string& description) {
  app.add_flag(name, value, description);
}

void AddWords(CLI::App& app, std::vector<std::string>& words, const std::string& description) {
  app.add_option("WORDS", words, description);
}

void Redescribe(CLI::App& app, const std::string& name, const std::string& description) {
  app.get_option(name)->description(description);
}

void AddNumber(CLI::App& app, const std::string& name, std::optional<double>& value, double low,
               double high, double scale, const std::string& description) {
  AddValue(
      app, name, "NUMBER",
      [=, &value](const std::string& given) { value = scale * ReadNumber(name, given, low, high); },
      description);
}

void AddPath(CLI::App& app, const std::string& name, const std::string& type, std::string& path,
             const std::string& description) {
  AddValue(
      app, name, type,
      [name, &path](const std::string& given) {
        if (given.empty()) throw UsageError(say::ValueEmpty(name));
        path = given;
      },
      description);
}

}  // namespace moontrace

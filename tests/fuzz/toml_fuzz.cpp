// Any bytes either parse as TOML or are refused by an InputError of one line.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "textures/base/error.h"
#include "textures/base/toml_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using moontrace::InputError;
  using moontrace::TomlTable;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto must_be_one_line = [](const InputError& error) {
    const std::string_view line = error.what();
    if (line.empty() || line.find('\n') != std::string_view::npos) std::abort();
  };
  try {
    const TomlTable table = TomlTable::Parse(text, "fuzz.toml");
    for (const auto& key : table.Keys()) {
      try {
        table.Number(key);
      } catch (const InputError& error) {
        must_be_one_line(error);
      }
    }
  } catch (const InputError& error) {
    must_be_one_line(error);
  }
  try {
    TomlTable::ParseInline(text, "fuzz label");
  } catch (const InputError& error) {
    must_be_one_line(error);
  }
  return 0;
}

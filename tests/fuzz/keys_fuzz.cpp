// Any bytes either are keys for words or are refused by an InputError of one line; Escape stops
// whatever they say, and every key gives a line that is read, asked or not. Bytes behind the first
// zero byte are what is typed then.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/console/line_editor.h"
#include "sim/console/terminal_keys.h"
#include "sim/learn/learn_keys.h"
#include "textures/base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace moontrace;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t zero = bytes.find('\0');
  KeyMap keys = UsualKeys();
  try {
    keys = ParseKeys(bytes.substr(0, zero), "fuzz.toml");
  } catch (const InputError& error) {
    const std::string_view line = error.what();
    if (line.empty() || line.find('\n') != std::string_view::npos) std::abort();
  }
  const auto escape = keys.find("Escape");
  if (escape == keys.end() || escape->second != "stop") std::abort();
  KeyLines lines(keys);
  bool asked = false;
  const std::string_view typed = zero == std::string_view::npos ? bytes : bytes.substr(zero + 1);
  for (const std::string& key : ReadKeys(typed)) {
    asked = !asked;
    const KeyLines::Result result = lines.Take(key, asked);
    if (result.line && result.line->find('\n') != std::string::npos) std::abort();
    if (result.echo.find('\x1b') != std::string::npos) std::abort();
  }
  LineEditor editor(100);
  for (const std::string_view part :
       {typed.substr(0, typed.size() / 2), typed.substr(typed.size() / 2)}) {
    const LineEditor::Typed line = editor.Take(part);
    if (line.echo.find('\x1b') != std::string::npos) std::abort();
    for (const std::string& one : line.lines) {
      if (one.size() > 100 || one.find('\n') != std::string::npos) std::abort();
    }
  }
  return 0;
}

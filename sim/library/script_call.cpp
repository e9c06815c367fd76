// The C interface: versions, messages, scripts.
#include <string>

#include "sim/library/call.h"
#include "sim/library/moontrace.h"
#include "sim/library/values.h"
#include "textures/fonts/script_library.h"

using namespace moontrace;

int moontrace_check(uint32_t interface_version) {
  return Answer([&] {
    if (interface_version == 0 || interface_version > MOONTRACE_INTERFACE) {
      throw UsageError("the program was made for interface " + std::to_string(interface_version) +
                       ", the library has " + std::to_string(MOONTRACE_INTERFACE));
    }
  });
}

const char* moontrace_version(void) { return MOONTRACE_VERSION; }

const char* moontrace_message(void) { return LastMessage(); }

int moontrace_script_open(const char* name_or_path, const char* text, moontrace_script** script) {
  return Answer([&] {
    RequireNotNull(name_or_path, "name_or_path");
    RequireNotNull(script, "script");
    auto value =
        std::make_unique<ScriptValue>(FindScript(name_or_path, text != nullptr ? text : ""));
    OpenHandle<ScriptTable>(std::move(value), script);
  });
}

int moontrace_script_describe(const moontrace_script* script, moontrace_script_facts* facts) {
  return Answer([&] {
    const InUse<ScriptTable> value(script, kScript);
    const Script& known = *value->script;
    moontrace_script_facts given{};
    given.name = known.name.c_str();
    given.title = known.title.c_str();
    given.author = known.author.c_str();
    given.licence = known.licence.c_str();
    given.signs = known.glyphs.size();
    given.letter_size = known.size;
    Give(given, sizeof given, "facts", facts);
  });
}

int moontrace_script_close(moontrace_script* script) {
  return Answer([&] { CloseHandle<ScriptTable>(script, kScript); });
}

// The text of a trial.json, a zero byte, the bytes of a samples.f64, as a record that is whole: all
// sizes and digests are made to fit, as somebody who means harm would. It is replayed, or refused
// by one line.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sim/app/commands.h"
#include "sim/physics/page_field.h"
#include "sim/setup/trial_parameters.h"
#include "sim/trial/record_columns.h"
#include "sim/trial/trial_sheet.h"
#include "tests/fuzz/one_line.h"
#include "tests/sim/record_fixture.h"
#include "textures/base/digest.h"
#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/reshape.h"
#include "textures/typeset/typeset.h"

namespace {

using namespace moontrace;

constexpr std::size_t kMostTicks = 50;

/// The model that a record of the shipped page has.
const std::string& ModelXml() {
  static const std::string xml = Scene::Load("", {}).model_xml();
  return xml;
}

/// The page that the parameters say, where there is one: a record of another is refused at once.
std::uint64_t FieldHashOf(const TrialSheet& sheet) {
  try {
    const TrialParameters parameters = ReadParameters(sheet.head.parameters_json, "record");
    const Script script = Reshaped(FindScript(parameters.script), parameters.style.form);
    const Typeset set = SetText(parameters.text, script, parameters.style, parameters.paper);
    return PageField(set.pages.at(parameters.page), script, set.style, parameters.blank).Hash();
  } catch (const InputError&) {
  } catch (const std::out_of_range&) {
  }
  return sheet.head.field_hash;
}

void WriteFitting(const test::TempFolder& folder, TrialSheet sheet, std::string_view samples) {
  sheet.ticks = std::min(samples.size() / kRowBytes, kMostTicks);
  samples = samples.substr(0, sheet.ticks * kRowBytes);
  sheet.sample_digests.assign(sheet.ticks > 0 ? 1 : 0, DigestOf(samples));
  sheet.model_digest = DigestOf(ModelXml());
  sheet.events_digest = DigestOf("");
  sheet.has_csv = false;
  sheet.head.field_hash = FieldHashOf(sheet);
  test::WriteBytes(folder / "trial.json", FormatTrial(sheet));
  test::WriteBytes(folder / "samples.f64", std::string(samples));
  test::WriteBytes(folder / "model.xml", ModelXml());
  test::WriteBytes(folder / "events.jsonl", "");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), size);
  const test::TempFolder folder;
  std::istringstream in;
  std::ostringstream out, err;
  Console console(in, out, err);
  ReplayOptions options;
  options.folder = folder.path();
  try {
    WriteFitting(folder, ParseTrial(input.substr(0, end), "trial.json"),
                 input.substr(std::min(end + 1, size)));
    Run(options, console);
  } catch (const InputError& error) {
    MustBeOneLine(error.what());
  }
  return 0;
}

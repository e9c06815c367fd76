#include "sim/study/page_reading.h"

#include <fmt/core.h>

#include <memory>
#include <optional>

#include "devices/catalogue/catalogue.h"
#include "sim/physics/page_field.h"
#include "sim/reading/reading_setup.h"
#include "sim/trial/trial.h"
#include "textures/base/error.h"
#include "textures/base/resources.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

TypeStyle StyleOf(const ReadingCell& cell, const Script& script) {
  constexpr double kNoContractions = 0.5, kUncontracted = 1;  // of Moon, of Braille
  TypeStyle style = DefaultStyle(cell.size, cell.relief, script);
  style.grade = script.braille_tables.empty() ? kNoContractions : kUncontracted;
  style.width *= cell.width_share;
  style.depth *= cell.depth_share;
  style.rounding *= cell.rounding_share;
  return style;
}

std::optional<DeviceProfile> DeviceOf(const ReadingCell& cell) {
  if (cell.device.empty()) return std::nullopt;
  return FindProfile(cell.device, ProfilesFolder());
}

PageSpec PaperOf(const ReadingCell& cell) {
  if (!cell.paper.empty()) return FindPage(cell.paper);
  const auto device = DeviceOf(cell);
  return device ? SheetWithin(device->limits) : FindPage("a4");
}

ReadingSetup SetupOf(const ReadingCell& cell, const TextPage& page, const TextureField& field) {
  ReadingSetup setup;
  setup.page = &page;
  setup.field = &field;
  setup.scene.friction = cell.friction;
  setup.device = DeviceOf(cell);
  setup.senses.unsure = cell.unsure;
  setup.hand = ShippedHand();
  setup.hand.press = cell.press;
  setup.hand.drift *= cell.drift_share;
  return setup;
}

void CheckCell(const ReadingCell& cell) {
  const Script script = FindScript(cell.script);
  const TypeStyle style = StyleOf(cell, script);
  CheckStyle(style, script);
  PaperOf(cell);
  const auto device = DeviceOf(cell);
  if (device && !CanBeReadOn(device->limits, IsFollowed(style, script))) {
    throw InputError(
        fmt::format("{} does not measure and push all that it takes: name another", cell.device));
  }
}

}  // namespace

PageReading ReadPage(const ReadingCell& cell, const std::string& text, std::uint64_t seed,
                     const std::function<void()>& check) {
  const Script script = FindScript(cell.script);
  const TypeStyle style = StyleOf(cell, script);
  const Typeset set = SetText(text, script, style, PaperOf(cell));
  const auto shapes = KnownShapes(script, set.pages);
  PageReading read;
  read.ended = true;
  std::uint64_t sheet_seed = seed;
  for (const TextPage& page : set.pages) {
    const TextureField field = PageField(page, script, style, false);
    ReadingSetup setup = SetupOf(cell, page, field);
    CompleteSetup(setup, shapes, script, style, sheet_seed);
    setup.alive = check;
    const ReadingResult result = RunReading(setup);
    const ReadingScore score = Compare(MarksOf(page, script), MarksOf(result.tokens, script));
    read.signs += score.signs;
    read.signs_right += score.signs_right;
    read.wrong += score.wrong;
    read.missed += score.missed;
    read.extra += score.extra;
    read.duration += result.duration;
    read.through += result.through;
    read.ended = read.ended && result.ended;
    sheet_seed = Random(sheet_seed).Bits();
  }
  return read;
}

void CompleteSweep(ReadingSweep& sweep, const std::string& file) {
  for (ReadingCell& cell : sweep.cells) {
    try {
      CheckCell(cell);
      if (!(cell.press > 0)) {
        const Script script = FindScript(cell.script);
        cell.press = ReadingPress(ShippedHand(), StyleOf(cell, script), script);
      }
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: reading, {}: {}", file, cell.name, error.what()));
    }
  }
}

}  // namespace moontrace

#include "tests/devices/fake/pid_descriptors.h"

#include "tests/devices/fake/descriptor_writer.h"

namespace moontrace::fake {
namespace {

using W = DescriptorWriter;
constexpr std::uint32_t kPhysical = 0x0f;  // the page of force feedback
constexpr std::uint32_t kLogical = 2;      // kind of collection
constexpr int kWord = 0x7fff;

/// One number of `bits`.
void Value(W& w, std::uint32_t usage, int least, int most, std::uint32_t bits, W::Main main) {
  w.Usage(usage).Range(least, most).Size(bits, 1).Field(main, W::kVariable);
}

/// One number that chooses among `usages`; `least` chooses the first.
void Choice(W& w, std::uint32_t usage, const std::vector<std::uint32_t>& usages, int least,
            W::Main main) {
  w.Usage(usage).Begin(kLogical);
  for (const std::uint32_t u : usages) w.Usage(u);
  w.Range(least, least + static_cast<int>(usages.size()) - 1).Size(8, 1).Field(main, W::kArray);
  w.End();
}

void Padding(W& w, std::uint32_t bits, W::Main main) {
  w.Size(bits, 1).Field(main, W::kConstant | W::kVariable);
}

const std::vector<std::uint32_t> kTypes = {0x26, 0x27, 0x30, 0x31, 0x32, 0x33,
                                           0x34, 0x40, 0x41, 0x42, 0x43};
const std::vector<std::uint32_t> kOperations = {0x79, 0x7a, 0x7b};
const std::vector<std::uint32_t> kControls = {0x97, 0x98, 0x99, 0x9a, 0x9b, 0x9c};

void Axes(W& w, std::uint32_t id, std::uint32_t buttons) {
  w.Id(id).Page(9).UsageRange(1, buttons).Range(0, 1).Size(1, buttons);
  w.Field(W::kInput, W::kVariable).Page(1);
  for (std::uint32_t usage = 0x30; usage <= 0x37; ++usage) w.Usage(usage);
  w.Range(-kWord, kWord).Size(16, 8).Field(W::kInput, W::kVariable).Page(kPhysical);
}

void AxesEnable(W& w) {
  w.Usage(0x55).Begin(kLogical).Page(1).Usage(0x30).Usage(0x31).Range(0, 1).Size(1, 2);
  w.Field(W::kOutput, W::kVariable).End().Page(kPhysical);
  w.Usage(0x56).Size(1, 1).Field(W::kOutput, W::kVariable);
  Padding(w, 5, W::kOutput);
}

void Direction(W& w, int most, std::uint32_t bits) {
  w.Usage(0x57).Begin(kLogical).FullUsage(0x0a, 1).FullUsage(0x0a, 2).Range(0, most);
  w.Size(bits, 2).Field(W::kOutput, W::kVariable).End();
}

void FeatureReports(W& w, std::uint32_t create, std::uint32_t load, std::uint32_t pool) {
  w.Usage(0xab).Begin(kLogical).Id(create);
  Choice(w, 0x25, kTypes, 1, W::kFeature);
  w.Page(1);
  Value(w, 0x3b, 0, 511, 16, W::kFeature);
  w.End().Page(kPhysical);
  w.Usage(0x89).Begin(kLogical).Id(load);
  Value(w, 0x22, 1, 40, 8, W::kFeature);
  Choice(w, 0x8b, {0x8c, 0x8d, 0x8e}, 1, W::kFeature);
  Value(w, 0xac, 0, 0xffff, 16, W::kFeature);
  w.End();
  w.Usage(0x7f).Begin(kLogical).Id(pool);
  Value(w, 0x80, 0, 0xffff, 16, W::kFeature);
  Value(w, 0x83, 0, 40, 8, W::kFeature);
  w.Usage(0xa9).Usage(0xaa).Range(0, 1).Size(1, 2).Field(W::kFeature, W::kVariable);
  Padding(w, 6, W::kFeature);
  w.End();
}

void ConstantForce(W& w, std::uint32_t id, int most) {
  w.Usage(0x73).Begin(kLogical).Id(id);
  Value(w, 0x22, 1, 40, 8, W::kOutput);
  Value(w, 0x70, -most, most, 16, W::kOutput);
  w.End();
}

void Operation(W& w, std::uint32_t operation, std::uint32_t free) {
  w.Usage(0x77).Begin(kLogical).Id(operation);
  Value(w, 0x22, 1, 40, 8, W::kOutput);
  Choice(w, 0x78, kOperations, 1, W::kOutput);
  Value(w, 0x7c, 0, 255, 8, W::kOutput);
  w.End();
  w.Usage(0x90).Begin(kLogical).Id(free);
  Value(w, 0x22, 1, 40, 8, W::kOutput);
  w.End();
}

void Gain(W& w, std::uint32_t id) {
  w.Usage(0x7d).Begin(kLogical).Id(id);
  Value(w, 0x7e, 0, 255, 8, W::kOutput);
  w.End();
}

}  // namespace

std::vector<std::uint8_t> OpenFfBoardDescriptor() {
  W w;
  w.Page(1).Usage(4).Begin(1);
  Axes(w, 0x01, 64);
  w.Usage(0x92).Begin(kLogical).Id(0x02);
  for (const std::uint32_t usage : {0x9fu, 0xa0u, 0xa4u, 0xa6u, 0x94u}) w.Usage(usage);
  w.Range(0, 1).Size(1, 5).Field(W::kInput, W::kVariable);
  Padding(w, 3, W::kInput);
  w.End();
  w.Usage(0x21).Begin(kLogical).Id(0x01);
  Value(w, 0x22, 1, 40, 8, W::kOutput);
  Choice(w, 0x25, kTypes, 1, W::kOutput);
  for (const std::uint32_t usage : {0x50u, 0x54u, 0x51u, 0xa7u}) {
    Value(w, usage, 0, kWord, 16, W::kOutput);
  }
  Value(w, 0x52, 0, 255, 8, W::kOutput);
  Value(w, 0x53, 1, 8, 8, W::kOutput);
  AxesEnable(w);
  Direction(w, 36000, 16);
  w.Usage(0x58).Begin(kLogical).FullUsage(0x0a, 1).FullUsage(0x0a, 2).Range(0, kWord);
  w.Size(16, 2).Field(W::kOutput, W::kVariable).End().End();
  w.Usage(0x5a).Begin(kLogical).Id(0x02);  // envelope: an output of the state's number
  Value(w, 0x22, 1, 40, 8, W::kOutput);
  for (const std::uint32_t usage : {0x5bu, 0x5du, 0x5cu, 0x5eu}) {
    Value(w, usage, 0, kWord, 16, W::kOutput);
  }
  w.End();
  ConstantForce(w, 0x05, kWord);
  Operation(w, 0x0a, 0x0b);
  // One bit for each command, with the odd range that the board declares for them.
  w.Usage(0x95).Begin(kLogical).Id(0x0c).Usage(0x96).Begin(kLogical);
  for (const std::uint32_t usage : kControls) w.Usage(usage);
  w.Range(1, 6).Size(1, 6).Field(W::kOutput, W::kVariable).End();
  Padding(w, 2, W::kOutput);
  w.End();
  Gain(w, 0x0d);
  FeatureReports(w, 0x11, 0x12, 0x13);
  w.End();
  w.Page(0xff00).Usage(1).Begin(1).Id(0xa1).Range(0, 255).Size(8, 24);  // vendor channel
  w.Usage(2).Field(W::kInput, W::kVariable).Usage(3).Field(W::kOutput, W::kVariable).End();
  return w.bytes();
}

std::vector<std::uint8_t> RhinoDescriptor() {
  W w;
  w.Page(1).Usage(4).Begin(1);
  Axes(w, 1, 32);
  w.Usage(0x92).Begin(kLogical).Id(2);
  for (const std::uint32_t usage : {0x9fu, 0xa0u, 0xa4u, 0xa5u, 0xa6u}) w.Usage(usage);
  w.Range(0, 1).Size(1, 5).Field(W::kInput, W::kVariable);
  Padding(w, 3, W::kInput);
  w.Usage(0x94).Size(1, 1).Field(W::kInput, W::kVariable);
  w.Usage(0x22).Range(1, 40).Size(7, 1).Field(W::kInput, W::kVariable).End();
  w.Usage(0x21).Begin(kLogical).Id(101);
  Value(w, 0x22, 1, 40, 8, W::kOutput);
  Choice(w, 0x25, kTypes, 1, W::kOutput);
  Value(w, 0x50, 0, kWord, 16, W::kOutput);
  Value(w, 0x52, 0, 255, 8, W::kOutput);
  AxesEnable(w);
  Direction(w, 255, 8);
  w.End();
  ConstantForce(w, 105, 4096);
  Operation(w, 110, 111);
  w.Usage(0x95).Begin(kLogical).Id(112);
  Choice(w, 0x96, {0x98, 0x97, 0x99, 0x9a, 0x9b, 0x9c}, 1, W::kOutput);  // disable comes first
  w.End();
  Gain(w, 113);
  FeatureReports(w, 5, 6, 7);
  w.End();
  return w.bytes();
}

}  // namespace moontrace::fake

#include "sim/app/script_findings.h"

namespace moontrace {

FindingTally::FindingTally(std::size_t most_of_a_kind, std::size_t most)
    : most_of_a_kind_(most_of_a_kind), most_(most) {}

void FindingTally::Add(const ScriptFinding& finding) {
  const auto kind = static_cast<std::size_t>(finding.kind);
  OfKind& of = kinds_[kind];
  ++total_;
  ++of.findings;
  if (last_glyph_[kind] != finding.glyph + 1) {
    last_glyph_[kind] = finding.glyph + 1;
    ++of.glyphs;
    if (of.examples.size() < kExamples) of.examples.push_back(finding.glyph);
  }
  if (of.findings <= most_of_a_kind_ && kept_.size() < most_) kept_.push_back(finding);
}

}  // namespace moontrace

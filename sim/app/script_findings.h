#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "textures/fonts/script_check.h"

namespace moontrace {

/// Findings about a script's signs, counted by kind, so that those of thousands of signs can be
/// told in a few lines.
class FindingTally {
 public:
  static constexpr std::size_t kKinds = static_cast<std::size_t>(ScriptFinding::Kind::kTooMany) + 1;
  static constexpr std::size_t kExamples = 3;

  /// Of one kind. `examples` are the first glyphs.
  struct OfKind {
    std::size_t findings = 0, glyphs = 0;
    std::vector<std::size_t> examples;
  };

  /// Keeps the findings themselves as far as neither number is reached.
  FindingTally(std::size_t most_of_a_kind, std::size_t most);

  /// Findings come glyph by glyph.
  void Add(const ScriptFinding& finding);

  std::size_t total() const { return total_; }
  const OfKind& of(ScriptFinding::Kind kind) const {
    return kinds_[static_cast<std::size_t>(kind)];
  }
  /// In the order of adding.
  const std::vector<ScriptFinding>& kept() const { return kept_; }
  /// Whether all findings of a kind are kept, but for `most`.
  bool Keeps(ScriptFinding::Kind kind) const { return of(kind).findings <= most_of_a_kind_; }

 private:
  std::size_t most_of_a_kind_ = 0, most_ = 0, total_ = 0;
  std::array<OfKind, kKinds> kinds_;
  std::array<std::size_t, kKinds> last_glyph_{};  ///< one past its index; 0 = none yet
  std::vector<ScriptFinding> kept_;
};

}  // namespace moontrace

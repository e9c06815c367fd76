#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/measure/felt_shape.h"

namespace moontrace {

/// How felt shapes are compared and forgotten; from `lessons/learner.toml`, ours.
struct RecogniserRule {
  double place_weight = 1;     ///< of a difference in height, squared
  double spread_weight = 1;    ///< of a difference in size or width, squared
  double newest_share = 0.2;   ///< of a shape felt again in what is remembered, at least
  double memory_days = 200;    ///< time constant with which a shape fades to what all share
  double same_at_least = 0.7;  ///< likeness from which two signs are held to be the same
  double word_margin = 0.03;   ///< a word taught whole is preferred to one spelt out by this much
};

/// What the learner believes it felt.
struct Naming {
  std::string label;      ///< empty: it knows nothing yet
  double confidence = 0;  ///< 0-1: how much nearer than the next best; 0: a guess
};

/// Remembers how named things felt, and names what is felt by the nearest of them. It is given felt
/// shapes and names only: no page, no script, no size.
class Recogniser {
 public:
  explicit Recogniser(RecogniserRule rule = {}) : rule_(rule) {}

  /// The learner is taught, on this day, how `label` feels. What gave no shape teaches nothing.
  void Remember(const std::string& label, const FeltShape& shape, double day);
  /// The nearest of what was taught; several signs are also read one by one, by the single signs
  /// that were taught. Where nothing was felt, one of them by `guess`; never what was not taught.
  Naming Name(const FeltShape& shape, double day, std::uint64_t guess) const;
  /// The same among whole taught items only: nothing is spelt out sign by sign.
  Naming NameTaught(const FeltShape& shape, double day, std::uint64_t guess) const;
  /// The nearer of two that were taught; the one that was if only one was.
  Naming Pick(const FeltShape& shape, const std::string& a, const std::string& b, double day,
              std::uint64_t guess) const;
  /// Whether the first half of the signs felt is like the second, and nearest to the same of what
  /// was taught; by `guess` where nothing was felt.
  bool AreSame(const FeltShape& shape, double day, std::uint64_t guess) const;

  bool Knows(const std::string& label) const { return memories_.count(label) > 0; }
  std::size_t size() const { return memories_.size(); }
  /// Distance of what was felt to what is remembered of `label`, 0-1 and more; none: cannot be it.
  std::optional<double> Distance(const FeltShape& shape, const std::string& label,
                                 double day) const;

 private:
  struct Memory {
    FeltShape shape;
    int times = 0;
    double day = 0;
  };
  /// How one item felt, by the number of signs that were felt: a hand may take two for one.
  using Variants = std::map<std::size_t, Memory>;
  double SignDistance(const FeltSign& felt, const FeltSign& known, double strength) const;
  double ShapeDistance(const FeltShape& felt, const Variants& variants, double day) const;
  std::string Guess(std::uint64_t guess) const;
  Naming Nearest(const FeltShape& shape, double day, double& best) const;
  Naming SpellOut(const FeltShape& shape, double day, double& distance) const;

  RecogniserRule rule_;
  std::map<std::string, Variants> memories_;
};

}  // namespace moontrace

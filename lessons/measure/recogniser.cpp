#include "lessons/measure/recogniser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moontrace {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double Likeness(const FeltSign& a, const FeltSign& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.picture.size(); ++i) {
    sum += static_cast<double>(a.picture[i]) * static_cast<double>(b.picture[i]);
  }
  return sum;
}

/// A share of the new one mixed into what was remembered.
void Mix(FeltSign& known, const FeltSign& felt, double share) {
  double length = 0;
  for (std::size_t i = 0; i < known.picture.size(); ++i) {
    const double mixed = (1 - share) * static_cast<double>(known.picture[i]) +
                         share * static_cast<double>(felt.picture[i]);
    known.picture[i] = static_cast<float>(mixed);
    length += mixed * mixed;
  }
  length = std::sqrt(std::max(length, 1e-300));
  for (float& value : known.picture)
    value = static_cast<float>(static_cast<double>(value) / length);
  known.height += share * (felt.height - known.height);
  known.spread += share * (felt.spread - known.spread);
  known.width += share * (felt.width - known.width);
}

double Confidence(double best, double next) {
  if (!std::isfinite(next)) return 1;
  return std::clamp((next - best) / std::max(next, 1e-12), 0.0, 1.0);
}

}  // namespace

void Recogniser::Remember(const std::string& label, const FeltShape& shape, double day) {
  if (shape.empty()) return;
  Memory& memory = memories_[label][shape.size()];
  if (memory.times == 0) {
    memory = {shape, 1, day};
    return;
  }
  const double share = std::max(rule_.newest_share, 1.0 / (memory.times + 1));
  for (std::size_t i = 0; i < shape.size(); ++i) Mix(memory.shape[i], shape[i], share);
  ++memory.times;
  memory.day = day;
}

double Recogniser::SignDistance(const FeltSign& felt, const FeltSign& known,
                                double strength) const {
  const double place = felt.height - known.height, spread = felt.spread - known.spread;
  const double width = felt.width - known.width;
  const double distance = 1 - Likeness(felt, known) + rule_.place_weight * place * place +
                          rule_.spread_weight * (spread * spread + width * width);
  // What has faded feels like anything a little: no distance, however wrong, counts in full.
  return strength * distance + (1 - strength) * 0.5;
}

double Recogniser::ShapeDistance(const FeltShape& felt, const Variants& variants,
                                 double day) const {
  const auto variant = variants.find(felt.size());
  if (variant == variants.end()) return kNever;
  const Memory& memory = variant->second;
  const double strength =
      std::exp(-std::max(0.0, day - memory.day) / (rule_.memory_days * memory.times));
  double sum = 0;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    sum += SignDistance(felt[i], memory.shape[i], strength);
  }
  return sum / static_cast<double>(felt.size());
}

std::optional<double> Recogniser::Distance(const FeltShape& shape, const std::string& label,
                                           double day) const {
  const auto memory = memories_.find(label);
  if (memory == memories_.end()) return std::nullopt;
  const double distance = ShapeDistance(shape, memory->second, day);
  return std::isfinite(distance) ? std::optional<double>(distance) : std::nullopt;
}

std::string Recogniser::Guess(std::uint64_t guess) const {
  if (memories_.empty()) return {};
  return std::next(memories_.begin(), static_cast<std::ptrdiff_t>(guess % memories_.size()))->first;
}

Naming Recogniser::Nearest(const FeltShape& shape, double day, double& best) const {
  double next = kNever;
  Naming naming;
  best = kNever;
  for (const auto& known : memories_) {
    const double d = ShapeDistance(shape, known.second, day);
    if (d < best) {
      next = best;
      best = d;
      naming.label = known.first;
    } else {
      next = std::min(next, d);
    }
  }
  naming.confidence = std::isfinite(best) ? Confidence(best, next) : 0;
  return naming;
}

Naming Recogniser::SpellOut(const FeltShape& shape, double day, double& distance) const {
  Naming naming;
  naming.confidence = 1;
  distance = 0;
  for (const FeltSign& sign : shape) {
    double best = kNever;
    const Naming letter = Nearest({sign}, day, best);
    if (!std::isfinite(best)) {
      distance = kNever;
      return {};
    }
    naming.label += letter.label;
    naming.confidence = std::min(naming.confidence, letter.confidence);
    distance += best / static_cast<double>(shape.size());
  }
  return naming;
}

Naming Recogniser::NameTaught(const FeltShape& shape, double day, std::uint64_t guess) const {
  double best = kNever;
  const Naming naming = Nearest(shape, day, best);
  return std::isfinite(best) ? naming : Naming{Guess(guess), 0};
}

Naming Recogniser::Name(const FeltShape& shape, double day, std::uint64_t guess) const {
  double best = kNever;
  const Naming taught = Nearest(shape, day, best);
  if (shape.size() > 1) {
    double spelt = kNever;
    Naming letters = SpellOut(shape, day, spelt);
    if (spelt + rule_.word_margin < best) return letters;
  }
  return std::isfinite(best) ? taught : Naming{Guess(guess), 0};
}

Naming Recogniser::Pick(const FeltShape& shape, const std::string& a, const std::string& b,
                        double day, std::uint64_t guess) const {
  if (!Knows(a) && !Knows(b)) return {};
  if (!Knows(a) || !Knows(b)) return {Knows(a) ? a : b, 0};
  const std::optional<double> to_a = Distance(shape, a, day), to_b = Distance(shape, b, day);
  if (!to_a && !to_b) return {guess % 2 == 0 ? a : b, 0};
  const double d_a = to_a.value_or(kNever), d_b = to_b.value_or(kNever);
  return {d_a <= d_b ? a : b, Confidence(std::min(d_a, d_b), std::max(d_a, d_b))};
}

bool Recogniser::AreSame(const FeltShape& shape, double day, std::uint64_t guess) const {
  if (shape.empty()) return guess % 2 == 0;
  if (shape.size() % 2 != 0) return false;
  const auto half = static_cast<std::ptrdiff_t>(shape.size() / 2);
  const FeltShape first(shape.begin(), shape.begin() + half);
  const FeltShape second(shape.begin() + half, shape.end());
  double to_first = kNever, to_second = kNever;
  const Naming a = Nearest(first, day, to_first), b = Nearest(second, day, to_second);
  if (a.label != b.label) return false;
  double likeness = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    likeness += Likeness(first[i], second[i]) / static_cast<double>(first.size());
  }
  return likeness >= rule_.same_at_least;
}

}  // namespace moontrace

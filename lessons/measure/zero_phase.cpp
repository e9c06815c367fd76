#include "lessons/measure/zero_phase.h"

#include <algorithm>
#include <cmath>

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// y(n) = b (x(n) + 2 x(n-1) + x(n-2)) - a1 y(n-1) - a2 y(n-2), by the bilinear transform.
struct Biquad {
  double b = 0, a1 = 0, a2 = 0;
};

Biquad Butterworth(double rate, double cutoff) {
  const double k = std::tan(kPi * cutoff / rate);
  const double scale = 1 / (1 + std::sqrt(2.0) * k + k * k);
  return {k * k * scale, 2 * (k * k - 1) * scale, (1 - std::sqrt(2.0) * k + k * k) * scale};
}

/// In place; begins as if the first value had always been there.
void Run(const Biquad& filter, std::vector<double>& values) {
  const double rest = values.front();
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  for (double& value : values) {
    const double x = value - rest;
    const double y = filter.b * (x + 2 * x1 + x2) - filter.a1 * y1 - filter.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    value = y + rest;
  }
}

}  // namespace

std::vector<double> ZeroPhaseLowPass(const std::vector<double>& values, double rate,
                                     double cutoff) {
  if (values.size() < 2 || !(cutoff < rate / 2)) return values;
  // Three periods of the cut-off: what is left of the start has faded by then.
  const auto wanted = static_cast<std::size_t>(std::ceil(3 * rate / cutoff));
  const std::size_t pad = std::min(wanted, values.size() - 1);
  std::vector<double> padded;
  padded.reserve(values.size() + 2 * pad);
  for (std::size_t i = pad; i > 0; --i) padded.push_back(2 * values.front() - values[i]);
  padded.insert(padded.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= pad; ++i) {
    padded.push_back(2 * values.back() - values[values.size() - 1 - i]);
  }
  const Biquad filter = Butterworth(rate, cutoff);
  for (int pass = 0; pass < 2; ++pass) {
    Run(filter, padded);
    std::reverse(padded.begin(), padded.end());
  }
  const auto begin = padded.begin() + static_cast<std::ptrdiff_t>(pad);
  return {begin, begin + static_cast<std::ptrdiff_t>(values.size())};
}

}  // namespace moontrace

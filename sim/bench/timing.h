#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace moontrace {

inline double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Seconds that `work` takes.
template <class Work>
double SecondsOf(Work&& work) {
  const double begin = Now();
  work();
  return Now() - begin;
}

/// Median time of `runs` goes [s].
template <class Work>
double MedianSecondsOf(int runs, Work&& work) {
  std::vector<double> times(static_cast<std::size_t>(runs));
  for (double& time : times) time = SecondsOf(work);
  return Median(times);
}

/// Times of two pieces of work, done by turns so that a busy machine slows both.
struct Turns {
  double first = 0;   ///< median [s]
  double second = 0;  ///< median [s]
  double ratio = 0;   ///< median of first / second, turn by turn
};
template <class First, class Second>
Turns ByTurns(int turns, First&& first, Second&& second) {
  std::vector<double> a, b, ratios;
  first();  // warms caches
  second();
  for (int i = 0; i < turns; ++i) {
    a.push_back(SecondsOf(first));
    b.push_back(SecondsOf(second));
    ratios.push_back(a.back() / b.back());
  }
  return {Median(a), Median(b), Median(ratios)};
}

/// Keeps a result alive, so that the compiler cannot leave out the work.
inline void Keep(double value) {
  volatile double kept = value;
  static_cast<void>(kept);
}

}  // namespace moontrace

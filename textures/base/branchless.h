#pragma once

#if defined(__x86_64__) && defined(__GNUC__)
#include <emmintrin.h>
#endif

namespace moontrace {

/// Choices between numbers in single instructions. Where the same is written as a comparison, GCC
/// follows both outcomes and often makes a branch of it, which at random points is mispredicted
/// every second time.
#if defined(__x86_64__) && defined(__GNUC__)

/// The larger of two numbers; `b` if one is none.
inline double Larger(double a, double b) noexcept {
  __asm__("maxsd %1, %0" : "+x"(a) : "x"(b));
  return a;
}
/// The smaller of two numbers; `b` if one is none.
inline double Smaller(double a, double b) noexcept {
  __asm__("minsd %1, %0" : "+x"(a) : "x"(b));
  return a;
}
/// `value`, or zero if `gate` is below zero or no number.
inline double IfNotBelowZero(double gate, double value) noexcept {
  double mask = 0;
  __asm__("cmplesd %1, %0\n\tandpd %2, %0" : "+&x"(mask) : "x"(gate), "x"(value));
  return mask;
}
/// `a < b ? then : otherwise`.
inline double IfLess(double a, double b, double then, double otherwise) noexcept {
  const __m128d mask = _mm_cmplt_sd(_mm_set_sd(a), _mm_set_sd(b));
  return _mm_cvtsd_f64(
      _mm_or_pd(_mm_and_pd(mask, _mm_set_sd(then)), _mm_andnot_pd(mask, _mm_set_sd(otherwise))));
}
/// Whether two numbers that stand side by side lie between two others each, ends included; false if
/// one is none.
inline bool BothBetween(const double* low, double x, double y, const double* high) noexcept {
  const __m128d both = _mm_set_pd(y, x);
  const __m128d in =
      _mm_and_pd(_mm_cmple_pd(_mm_loadu_pd(low), both), _mm_cmple_pd(both, _mm_loadu_pd(high)));
  return _mm_movemask_pd(in) == 3;
}

#else

inline double Larger(double a, double b) noexcept { return a > b ? a : b; }
inline double Smaller(double a, double b) noexcept { return a < b ? a : b; }
inline double IfNotBelowZero(double gate, double value) noexcept { return gate >= 0 ? value : 0; }
inline double IfLess(double a, double b, double then, double otherwise) noexcept {
  return a < b ? then : otherwise;
}
inline bool BothBetween(const double* low, double x, double y, const double* high) noexcept {
  return (x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1]);
}

#endif

}  // namespace moontrace

#pragma once

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

#else

inline double Larger(double a, double b) noexcept { return a > b ? a : b; }
inline double Smaller(double a, double b) noexcept { return a < b ? a : b; }
inline double IfNotBelowZero(double gate, double value) noexcept { return gate >= 0 ? value : 0; }

#endif

}  // namespace moontrace

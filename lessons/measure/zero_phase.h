#pragma once

#include <vector>

namespace moontrace {

/// Low-pass without delay: a Butterworth filter of second order run forwards and backwards (fourth
/// order in all, gain 1 at rest and 1/2 at `cutoff`), the ends continued by point reflection.
/// `rate` and `cutoff` in [Hz]; at or above half the rate the values are given back as they are.
std::vector<double> ZeroPhaseLowPass(const std::vector<double>& values, double rate, double cutoff);

}  // namespace moontrace

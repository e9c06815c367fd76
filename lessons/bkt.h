#pragma once

#include <vector>

namespace moontrace {

/// Bayesian knowledge tracing (Corbett and Anderson 1995): one thing to know, known or not.
struct KnowledgeTracing {
  double known = 0.2;     ///< chance that it is known before the first answer
  double learned = 0.15;  ///< chance of learning it at each answer
  double guess = 0.2;     ///< chance of a right answer without knowing it
  double slip = 0.1;      ///< chance of a wrong one with knowing it
};

/// Chance that it is known after these answers, the oldest first. All parameters between 0 and 1.
/// 0.95 is what is commonly called mastered.
double Mastery(const std::vector<bool>& answers, const KnowledgeTracing& tracing = {});

}  // namespace moontrace

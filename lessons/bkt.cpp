#include "lessons/bkt.h"

namespace moontrace {

double Mastery(const std::vector<bool>& answers, const KnowledgeTracing& tracing) {
  double known = tracing.known;
  for (const bool right : answers) {
    const double knowing = known * (right ? 1 - tracing.slip : tracing.slip);
    const double guessing = (1 - known) * (right ? tracing.guess : 1 - tracing.guess);
    const double chance = knowing + guessing;
    if (chance > 0) known = knowing / chance;
    known += (1 - known) * tracing.learned;
  }
  return known;
}

}  // namespace moontrace

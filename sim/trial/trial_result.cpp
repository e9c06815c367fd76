#include "sim/trial/trial_result.h"

#include <algorithm>

#include "lessons/measure/merged_metrics.h"

namespace moontrace {

namespace {

void AddLeft(TrialResult& all, const TrialResult& page) {
  if (!page.links_left) return;
  if (!all.links_left) all.links_left.emplace();
  all.links_left->insert(all.links_left->end(), page.links_left->begin(), page.links_left->end());
}

}  // namespace

TrialResult Merged(const std::vector<TrialResult>& pages) {
  TrialResult all;
  std::vector<PageMetrics> metrics;
  double elapsed = 0, guidance = 0;
  double letters = 0;
  for (const TrialResult& page : pages) {
    metrics.push_back({page.score.total, page.stroke_length});
    all.stroke_length += page.stroke_length;
    all.duration += page.duration;
    all.ticks += page.ticks;
    all.faults += page.faults;
    if (!all.page_gone) all.page_gone = page.page_gone;
    all.lifts_within_lines += page.lifts_within_lines;
    all.lines += page.lines;
    AddLeft(all, page);
    guidance += page.mean_guidance * page.duration;
    all.guidance_work += page.guidance_work;
    all.energy_out = std::max(all.energy_out, page.energy_out);
    if (page.true_energy_out) {
      all.true_energy_out = std::max(all.true_energy_out.value_or(0), *page.true_energy_out);
    }
    all.force_bound = std::max(all.force_bound, page.force_bound);
    all.force_per_acceleration = std::max(all.force_per_acceleration, page.force_per_acceleration);
    all.carried_press = &page == &pages.front() ? page.carried_press
                                                : std::min(all.carried_press, page.carried_press);
    if (all.through == 0) all.first_through = page.first_through;
    all.through += page.through;
    all.held += page.held;
    elapsed += page.duration / page.real_time_factor;
    letters += page.score.letters_per_second * page.score.total.duration;
  }
  all.score.total = MergedMetrics(metrics);
  if (letters > 0) all.score.letters_per_second = letters / all.score.total.duration;
  all.mean_guidance = guidance / std::max(all.duration, 1e-300);
  all.real_time_factor = all.duration / std::max(elapsed, 1e-9);
  return all;
}

}  // namespace moontrace

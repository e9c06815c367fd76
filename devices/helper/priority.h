#pragma once

namespace moontrace {

/// Runs the calling thread ahead of ordinary ones (SCHED_FIFO of that priority), where it is
/// allowed; else as far ahead as is (nice). Its sleeps end at their time. What is refused only
/// costs time on a busy machine.
void RunAhead(int priority) noexcept;

/// Of threads that carry forces to a device: just below the loop's, 40 (sim/loop/realtime.cpp).
inline constexpr int kCarriesForces = 39;
/// Of what lets go of a device: above the loop's, below the kernel's own threads for interrupts
/// (50).
inline constexpr int kLetsGo = 45;

}  // namespace moontrace

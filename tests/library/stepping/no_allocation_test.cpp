// A step of the library allocates nothing: every way to the heap is counted. A program of its own,
// since it replaces malloc for the whole process.
#include <atomic>
#include <cmath>

#include "tests/counted_memory.h"
#include "tests/library/stepping/scene_fixture.h"

#ifdef MOONTRACE_COUNTED_MEMORY

namespace {
std::atomic<long> allocations{0};
}

void OnAllocation() noexcept { ++allocations; }

namespace moontrace {
namespace {

TEST(SceneStep, AllocatesNothing) {
  for (const char* model : {"page.xml", "mug.xml"}) {
    const OwnModel own(model);
    const OpenScene open(own, SceneOptionsOf("moon"));
    auto felt = Sized<moontrace_scene_answer>();
    // a place within the text, from a trace of it
    moontrace_trace* trace = nullptr;
    ASSERT_EQ(moontrace_trace_open(open.scene, own.m, own.d, nullptr, &trace), MOONTRACE_DONE);
    double above[3];
    auto samples = Sized<moontrace_trace_samples>();
    samples.first = 1000;
    samples.count = 1;
    samples.tip = above;
    ASSERT_EQ(moontrace_trace_read(trace, &samples), MOONTRACE_DONE);
    EXPECT_EQ(moontrace_trace_close(trace), MOONTRACE_DONE);
    above[2] = 0.001;
    ASSERT_EQ(moontrace_scene_reset(open.scene, own.m, own.d, above), MOONTRACE_DONE);
    const long before = allocations.load();
    int refused = 0, touched = 0;
    for (int i = 0; i < 2000; ++i) {
      const double place[3] = {above[0] + 0.002 * std::sin(0.01 * i), above[1],
                               0.001 * std::sin(0.02 * i)};
      double world[3];
      refused += moontrace_scene_place(open.scene, own.m, own.d, place, world);
      const moontrace_scene_input input = HandAt(world[0], world[1], world[2]);
      refused += moontrace_scene_step(open.scene, own.m, own.d, &input, &felt);
      touched += static_cast<int>(felt.in_contact);
    }
    EXPECT_EQ(allocations.load() - before, 0) << model;
    EXPECT_EQ(refused, 0) << moontrace_scene_message();
    EXPECT_GT(touched, 0) << model;
  }
}

}  // namespace
}  // namespace moontrace

#endif

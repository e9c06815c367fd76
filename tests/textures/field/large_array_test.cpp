#include "textures/field/large_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace moontrace {
namespace {

std::uintptr_t PlaceOf(const LargeArray<double>& array) {
  return reinterpret_cast<std::uintptr_t>(array.data());
}

TEST(LargeArray, BeginsAtACacheLine) {
  const LargeArray<double> array(3, 1.0);
  EXPECT_EQ(PlaceOf(array) % 64, 0u);
}

TEST(LargeArray, OfMegabytesBeginsAtALargePage) {
  const LargeArray<double> array(std::size_t{3} << 17, 1.0);
  EXPECT_EQ(PlaceOf(array) % (std::uintptr_t{2} << 20), 0u);
}

TEST(LargeArray, KeepsItsValuesAsItGrowsPastALargePage) {
  LargeArray<std::uint32_t> array;
  for (std::uint32_t i = 0; i < 1'000'000; ++i) array.push_back(i);
  array.shrink_to_fit();
  for (std::uint32_t i = 0; i < 1'000'000; ++i) ASSERT_EQ(array[i], i);
}

TEST(LargeArray, RefusesASizeThatNoMemoryHas) {
  LargeAllocator<double> allocator;
  EXPECT_THROW(static_cast<void>(allocator.allocate(std::numeric_limits<std::size_t>::max() / 4)),
               std::bad_array_new_length);
}

}  // namespace
}  // namespace moontrace

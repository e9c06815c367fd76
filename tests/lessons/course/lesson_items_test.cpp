#include "lessons/course/lesson_items.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

Course WithSizes() {
  Course course;
  course.sizes = {0.040, 0.016, 0.006};
  course.lessons.resize(1);
  course.lessons[0].steps.resize(3);
  course.lessons[0].steps[0].size = 0.025;
  course.lessons[0].steps[1].size = 0.006;
  return course;
}

TEST(EndSizes, TakesAwayWhatADeviceCannotRender) {
  Course course = WithSizes();
  EXPECT_TRUE(EndSizesAt(course, 0.0134));
  EXPECT_EQ(course.sizes, (std::vector<double>{0.040, 0.016}));
  EXPECT_EQ(course.lessons[0].steps[0].size, 0.025);
  EXPECT_EQ(course.lessons[0].steps[1].size, 0.016);
  EXPECT_FALSE(course.lessons[0].steps[2].size) << "the learner's own";
}

TEST(EndSizes, LeavesWhatIsLargeEnoughAndTheLargestInAnyCase) {
  for (const double smallest : {0.0, 0.002, 0.006}) {
    Course course = WithSizes();
    EXPECT_FALSE(EndSizesAt(course, smallest));
    EXPECT_EQ(course.sizes, WithSizes().sizes);
  }
  Course course = WithSizes();
  EXPECT_TRUE(EndSizesAt(course, 0.1));
  EXPECT_EQ(course.sizes, std::vector<double>{0.040});
  EXPECT_EQ(course.lessons[0].steps[1].size, 0.040);
}

}  // namespace
}  // namespace moontrace

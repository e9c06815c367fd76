#include "lessons/course_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "textures/error.h"

namespace moontrace {
namespace {

TEST(LoadCourse, TakesAShippedNameAFolderAndAFile) {
  const std::string folder = MOONTRACE_SOURCE_DIR "/lessons/courses/learn-moon";
  for (const std::string& name : {std::string("learn-moon"), folder, folder + "/course.toml"}) {
    const Course course = LoadCourse(name);
    EXPECT_EQ(course.id, "learn-moon");
    EXPECT_EQ(course.title, "Learn Moon");
    EXPECT_DOUBLE_EQ(course.sizes.front(), 0.040);
    EXPECT_DOUBLE_EQ(course.sizes.back(), 0.006);
    EXPECT_DOUBLE_EQ(course.break_after, 1500);
    ASSERT_FALSE(course.lessons.empty());
    EXPECT_EQ(course.lessons.front().id, "00-device");
  }
}

}  // namespace
}  // namespace moontrace

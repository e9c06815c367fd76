#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/course.h"

/// Sentences of `moontrace course`. What is wrong with a course's files is said by the code that
/// reads them (lessons/course/course.h).
namespace moontrace::say {

std::string NoCourseNamed();
std::string TooManyCourses();
std::string DeviceOnlyForCheck();
std::string UnknownProfile(std::string_view given, std::string_view nearest);

// check
std::string CourseSound(std::string_view name, std::size_t lessons, std::size_t items,
                        std::size_t steps);
std::string LessonSound(std::string_view name, std::size_t items, std::size_t steps);
std::string CourseFaulty(std::string_view name, std::size_t faults);
/// Some files could not be read; what is taught when has not been looked at.
std::string MendFirst();
/// A file of lessons beside a course that does not list it.
std::string LessonUnlisted(std::string_view id);

// show
std::string CourseOutcome(const Course& course, std::size_t items);
std::string CourseSizes(const Course& course);
std::string LessonLine(const Course& course, const Lesson& lesson);
std::string LessonNeeds(const Lesson& lesson);
std::string HintLine(const Course& course, const std::string& item, std::string_view hint);
std::string StepLine(const Course& course, const Step& step, std::size_t number);
/// Letters end at `size` [m] on the device asked for, above the smallest of the course.
std::string CourseEndsAt(double size);
std::string StepSays(std::string_view text);
std::string StepSaysHeld(std::string_view text);

namespace help {
inline constexpr const char* kCourseCommand =
    "says what is wrong with a course of lessons, or what it teaches";
inline constexpr const char* kCourseWords =
    "check, then courses: names, folders, course files or single lessons; or show, then one, or "
    "a lesson by its number or name, of learn-moon or of a course named before it. Default of show "
    "learn-moon.";
inline constexpr const char* kCourseDevice =
    "of check: a device's profile; letters smaller than it renders are told. Default none.";
}  // namespace help

}  // namespace moontrace::say

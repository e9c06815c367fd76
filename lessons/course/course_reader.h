#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/course.h"

namespace moontrace {

/// A course as far as it could be read, and what is wrong with the rest.
struct CourseReading {
  Course course;
  std::vector<CourseFault> faults;
  std::vector<std::string> unlisted;  ///< lessons' files beside it that the course does not list
};

/// Reads a course and its lessons like LoadCourse, but continues after a fault: a lesson with one
/// keeps what could be read of it, a lesson without a file is left out. Throws InputError where
/// there is no course at all: an unknown name (with the nearest shipped one), no such file.
CourseReading ReadCourse(const std::string& name_or_path);

/// What is wrong with the files that the course does not list, each read as one of its lessons:
/// they may be lessons still being written.
std::vector<CourseFault> FaultsOfUnlisted(const CourseReading& reading);

/// Path of the course's file: of a shipped course's name, a folder, a file.
std::string CoursePath(const std::string& name_or_path);

/// Names of the courses that come with the program.
std::vector<std::string> ShippedCourses();

/// Reads a course's file; `lessons` gets the ids that it lists, course.lessons stays empty.
Course ParseCourse(std::string_view toml, const std::string& file,
                   std::vector<std::string>& lessons, std::vector<CourseFault>& faults);

/// Reads one lesson; script and grade are the course's where the lesson gives none.
Lesson ParseLesson(std::string_view toml, const std::string& file, const Course& course,
                   std::vector<CourseFault>& faults);

}  // namespace moontrace

#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "lessons/course/course_reader.h"
#include "textures/base/error.h"

namespace moontrace {

/// A folder with a course of the test's own: sound, until a test breaks it.
class CourseFixture : public testing::Test {
 protected:
  CourseFixture() {
    std::string name =
        (std::filesystem::temp_directory_path() / "moontrace-course-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    Write("course", kCourse);
    Write("one", kOne);
    Write("two", kTwo);
  }
  ~CourseFixture() override { std::filesystem::remove_all(folder_); }

  std::string File(const std::string& stem) const { return (folder_ / (stem + ".toml")).string(); }
  void Write(const std::string& stem, const std::string& toml) const {
    std::ofstream(File(stem), std::ios::binary) << toml;
  }
  /// Replaces the first `what` of a text; it must be there.
  static std::string Replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
  }
  /// What LoadCourse says.
  std::string LoadError() const {
    try {
      LoadCourse(folder_.string());
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  /// All lines of reading, or of checking where all could be read, without the folder in front.
  std::string Faults(double smallest = 0) const {
    CourseReading reading = ReadCourse(folder_.string());
    std::vector<CourseFault> faults = reading.faults;
    if (faults.empty()) faults = CheckCourse(reading.course, smallest);
    std::string lines;
    for (const CourseFault& fault : faults) {
      const std::string line = LineOf(fault);
      const std::string folder = folder_.string() + "/";
      lines += line.rfind(folder, 0) == 0 ? line.substr(folder.size()) : line;
      lines += "\n";
    }
    return lines;
  }

  static constexpr const char* kCourse =
      "title = \"Little\"\n"
      "language = \"en\"\n"
      "script = \"moon\"\n"
      "sizes_mm = [20, 10]\n"
      "lessons = [\"one\", \"two\"]\n"
      "[mates]\n"
      "t = \"i\"\n";
  static constexpr const char* kOne =
      "title = \"I and T\"\n"
      "new = [\"i\", \"t\"]\n"
      "[hints]\n"
      "i = \"upright\"\n"
      "[[steps]]\n"
      "kind = \"recognise\"\n"
      "[[steps]]\n"
      "kind = \"read\"\n"
      "text = \"it\"\n";
  static constexpr const char* kTwo =
      "title = \"A\"\n"
      "needs = [\"one\"]\n"
      "new = [\"a\"]\n"
      "[[steps]]\n"
      "kind = \"recognise\"\n"
      "question = \"pick\"\n"
      "items = [\"t\"]\n"
      "size_mm = 15\n"
      "[[steps]]\n"
      "kind = \"trace\"\n"
      "items = [\"a\", \"tait\"]\n";

  std::filesystem::path folder_;
};

}  // namespace moontrace

// Any bytes as they come from a tutor's socket and from a learner's keyboard: cut into lines, each
// a word that keeps its bounds or a refusal of one line. Letters of the forms that were asked for
// are set, or refused by an InputError of one line.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>

#include "lessons/course/course.h"
#include "sim/console/line_buffer.h"
#include "sim/learn/learn_words.h"
#include "sim/setup/text_setup.h"
#include "sim/tutor/page_words.h"
#include "sim/tutor/tutor_command.h"
#include "sim/tutor/tutor_messages.h"
#include "tests/fuzz/one_line.h"
#include "textures/base/error.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"

namespace {

using namespace moontrace;

constexpr std::size_t kLongestLine = 1000;  // as the server takes them

void Require(bool holds) {
  if (!holds) std::abort();
}

/// What a lesson may be told, whoever typed it.
void CheckBounds(const TutorCommand& command) {
  Require(command.help >= 0 && command.help <= 10);
  Require(command.text.size() <= kLongestLine);
  if (!command.page) return;
  Require(std::isfinite(command.page->value) && std::abs(command.page->value) <= 3);
  const bool size = command.page->word == PageWord::kSize;
  Require(!size || (command.page->value > 0.0009 && command.page->value < 1.001));
}

void Hear(std::string_view line, PageForm& form) {
  const auto read = ReadTutorCommand(line);
  if (const auto* refusal = std::get_if<TutorRefusal>(&read)) return MustBeOneLine(refusal->line);
  const auto& command = std::get<TutorCommand>(read);
  CheckBounds(command);
  Require(say::TutorDoes(command).find('\n') == std::string::npos);  // empty: told elsewhere
  if (command.page) form = Changed(form, *command.page);
}

/// A word in letters of that form, or why there is none.
void SetWith(const PageForm& form) {
  std::istringstream in;
  std::ostringstream out, err;
  Console console(in, out, err);
  TextRequest request;
  request.text.text = "moon";
  request.form = form;
  try {
    Require(!SetUpText(request, console).set.pages.empty());
  } catch (const InputError& error) {
    MustBeOneLine(error.what());
  }
}

void HearLearner(std::string_view line) {
  static const Course course = LoadCourse(ResourcePath("lessons/courses/learn-moon"));
  for (const Asked asked : {Asked::kNothing, Asked::kName, Asked::kNumber, Asked::kSame}) {
    const LearnLine read = ReadLearnLine(line, asked, course);
    Require(static_cast<std::size_t>(read.word) < LearnWords().size());
    const bool speaks =
        read.kind == LearnLine::Kind::kAnswer || read.kind == LearnLine::Kind::kRefused;
    Require(!speaks || !read.answer.empty());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  LineBuffer buffer(kLongestLine);
  PageForm form;
  for (std::size_t at = 0; at < bytes.size(); at += 64) {
    buffer.Feed(bytes.substr(at, 64));
    while (const auto line = buffer.Next()) {
      const std::string clean = OneLine(*line, kLongestLine);
      Hear(clean, form);
      HearLearner(clean);
    }
  }
  if (form != PageForm{}) SetWith(form);
  return 0;
}

#include "lessons/course/spelling.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lessons/course/lesson_items.h"
#include "lessons/course/taught_signs.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/fonts/script_library.h"

namespace moontrace {

namespace {

using Items = std::vector<std::string>;

/// A longer name has no room in letters of the sizes at which a word is first asked: 8 letters of
/// 16 mm are as wide as a desk-top device reaches.
constexpr std::size_t kLongestName = 8;

/// Scripts as a course's pages are set; none: it cannot be had, which CheckCourse tells.
std::optional<Script> ScriptOf(const Course& course) {
  std::string text;
  for (const std::string& item : AllItems(course)) text += item + "\n";
  try {
    return FindScript(course.script, text);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool IsOwn(const Course& course, const Lesson& lesson) { return lesson.script == course.script; }

std::optional<SignUse> UseOf(std::string_view text, const Script& script, double grade,
                             const std::set<std::string>* taught = nullptr) {
  try {
    return SignsOf(text, script, grade, taught);
  } catch (const InputError&) {
    return std::nullopt;  // no such grade
  }
}

/// Which taught item stands for a sign, by the sign's name; a digit's second sign is a letter's
/// too, and is found by its text.
class Teachers {
 public:
  Teachers(const Course& course, const Script& script) {
    for (const Lesson& lesson : course.lessons) {
      for (const std::string& item : IsOwn(course, lesson) ? lesson.items : Items{}) {
        const std::optional<SignUse> use = UseOf(item, script, lesson.grade);
        if (!use || !TeachesSigns(item, *use)) continue;
        by_text_[LowerCase(item)] = {item, use->signs.back()};
        if (use->signs.size() == 1) by_sign_.emplace(use->signs.front(), item);
      }
    }
  }

  /// The taught items with whose signs a text is written, each once.
  Items SpellingOf(const SignUse& use) const {
    Items spelling;
    for (std::size_t i = 0; i < use.signs.size(); ++i) {
      const auto text = by_text_.find(LowerCase(use.pieces[i]));
      const auto sign = by_sign_.find(use.signs[i]);
      std::string item;
      if (text != by_text_.end() && text->second.sign == use.signs[i]) {
        item = text->second.item;
      } else if (sign != by_sign_.end()) {
        item = sign->second;
      }
      const bool listed = std::find(spelling.begin(), spelling.end(), item) != spelling.end();
      if (!item.empty() && !listed) spelling.push_back(item);
    }
    return spelling;
  }

 private:
  struct Teacher {
    std::string item, sign;
  };
  std::map<std::string, Teacher> by_text_;
  std::map<std::string, std::string> by_sign_;
};

}  // namespace

void AddSpellings(Course& course) {
  const std::optional<Script> script = ScriptOf(course);
  if (!script) return;
  const Teachers teachers(course, *script);
  for (Lesson& lesson : course.lessons) {
    if (!IsOwn(course, lesson)) continue;
    for (const Step& step : lesson.steps) {
      for (const std::string& item : step.items) {
        if (IsTaught(course, item)) continue;
        const std::optional<SignUse> use = UseOf(item, *script, lesson.grade);
        if (use) lesson.spellings[item] = teachers.SpellingOf(*use);
      }
    }
  }
}

void AddOwnName(Course& course, std::string_view name) {
  const std::string item(name);
  const bool word = !item.empty() && CountCharacters(item) <= kLongestName &&
                    item.find_first_of(" \t0123456789") == std::string::npos;
  const std::optional<Script> script = word ? ScriptOf(course) : std::nullopt;
  if (!script || HasItem(course, item) || HasItem(course, LowerCase(item))) return;
  std::set<std::string> taught;
  for (Lesson& lesson : course.lessons) {
    if (!IsOwn(course, lesson)) continue;
    for (const std::string& sign : lesson.items) {
      const std::optional<SignUse> use = UseOf(sign, *script, lesson.grade);
      if (use && TeachesSigns(sign, *use)) taught.insert(use->signs.begin(), use->signs.end());
    }
    const std::optional<SignUse> use = UseOf(item, *script, lesson.grade, &taught);
    if (!use || !use->missing.empty() || !use->untaught.empty()) continue;
    for (Step& step : lesson.steps) {
      if (step.own_name) step.items.push_back(item);
    }
  }
  AddSpellings(course);
}

}  // namespace moontrace

#include "lessons/course/lesson_order.h"

#include <algorithm>
#include <set>
#include <string>
#include <unordered_map>

namespace moontrace {
namespace {

using Places = std::unordered_map<std::string, std::size_t>;

Places PlacesOf(const Course& course) {
  Places places;
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    places.emplace(course.lessons[i].id, i);
  }
  return places;
}

}  // namespace

LessonOrder OrderOf(const Course& course) {
  const std::size_t count = course.lessons.size();
  const Places places = PlacesOf(course);
  std::vector<std::size_t> unmet(count, 0);
  std::vector<std::vector<std::size_t>> needed_by(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<std::string>& needs = course.lessons[i].needs;
    for (const std::string& need : std::set<std::string>(needs.begin(), needs.end())) {
      ++unmet[i];
      const auto found = places.find(need);
      if (found != places.end()) needed_by[found->second].push_back(i);
    }
  }
  LessonOrder order;
  std::vector<bool> done(count, false);
  std::size_t from = 0;
  for (std::size_t looked = 0; looked < count;) {
    const std::size_t i = from;
    from = (from + 1) % count;
    if (done[i] || unmet[i] > 0) {
      ++looked;
      continue;
    }
    done[i] = true;
    order.walk.push_back(i);
    for (const std::size_t next : needed_by[i]) --unmet[next];
    looked = 0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!done[i]) order.unreachable.push_back(i);
  }
  return order;
}

std::vector<std::size_t> CircleOf(const Course& course, std::size_t lesson) {
  const Places places = PlacesOf(course);
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  // Breadth first along the needs: the shortest path back to the lesson.
  std::vector<std::size_t> came_from(course.lessons.size(), kNone);
  std::vector<std::size_t> reached{lesson};
  for (std::size_t at = 0; at < reached.size(); ++at) {
    for (const std::string& need : course.lessons[reached[at]].needs) {
      const auto found = places.find(need);
      if (found == places.end()) continue;
      if (found->second == lesson) {
        std::vector<std::size_t> circle;
        for (std::size_t back = reached[at]; back != lesson; back = came_from[back]) {
          circle.push_back(back);
        }
        circle.push_back(lesson);
        std::reverse(circle.begin(), circle.end());
        return circle;
      }
      if (came_from[found->second] != kNone) continue;
      came_from[found->second] = reached[at];
      reached.push_back(found->second);
    }
  }
  return {};
}

}  // namespace moontrace

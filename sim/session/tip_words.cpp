#include "sim/session/tip_words.h"

#include <glm/geometric.hpp>

#include "sim/session/loop_messages.h"

namespace moontrace {

std::string Where(const FeltPage& page, bool pushes, const LoopSnapshot& now) {
  const say::Feeling feeling{now.depth > 0, pushes, now.stopped, glm::length(now.force_P)};
  const std::optional<NearLetter> letter = LetterNear(page, now.tip_P);
  const std::size_t pages = page.text->set.pages.size();
  if (!letter) return say::Where("", 0, page.index, pages, feeling);
  return say::Where(letter->near ? letter->name : "", letter->line, page.index, pages, feeling);
}

std::string WayToMark(LoopSession& session, const std::optional<LetterPlace>& mark,
                      const LoopSnapshot& now) {
  std::optional<FoundPlace> found;
  if (mark) found = Find(session.text(), *mark);
  if (!found) return say::NoMark();
  const bool turned = found->page != session.felt().index;
  if (turned) session.TurnTo(found->page);
  return say::WayToMark(
      found->letter, found->page, session.text().set.pages.size(),
      turned ? std::nullopt : std::optional<glm::dvec2>(found->p_P - glm::dvec2(now.tip_P)));
}

}  // namespace moontrace

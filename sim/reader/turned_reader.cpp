#include "sim/reader/turned_reader.h"

#include <utility>

#include "textures/base/units.h"

namespace moontrace {

TurnedReader::TurnedReader(const ReaderKnowledge& knowledge, const Make& make)
    : lines_(knowledge.lines), shapes_(knowledge.shapes) {
  ReaderKnowledge told = knowledge;
  told.lines = LinesRun::kRight;
  told.shapes = std::make_shared<const SignShapes>(shapes_->AlongLines(lines_));
  told.links = nullptr;
  if (told.face) {
    told.face->middle = ToLine(told.face->middle);
    told.face->turn = lines_ == LinesRun::kLeft ? -told.face->turn : told.face->turn + 90 * kDegree;
  }
  reader_ = make(told);
}

glm::dvec2 TurnedReader::ToLine(glm::dvec2 v) const noexcept {
  return lines_ == LinesRun::kLeft ? glm::dvec2(-v.x, v.y) : glm::dvec2(-v.y, v.x);
}

glm::dvec2 TurnedReader::FromLine(glm::dvec2 v) const noexcept {
  return lines_ == LinesRun::kLeft ? glm::dvec2(-v.x, v.y) : glm::dvec2(v.y, -v.x);
}

ReaderAction TurnedReader::Step(const ReaderInput& input) {
  ReaderInput turned = input;
  turned.tip = {ToLine(glm::dvec2(input.tip)), input.tip.z};
  turned.force = {ToLine(glm::dvec2(input.force)), input.force.z};
  ReaderAction action = reader_->Step(turned);
  action.aim = {FromLine(glm::dvec2(action.aim)), action.aim.z};
  return action;
}

/// `origin`: of the sign on the paper, as the reader within has it [em].
SignPlace TurnedReader::FromLine(const SignPlace& place, glm::dvec2 origin) const noexcept {
  return {FromLine(FromEm(place, origin)), place.size,
          lines_ == LinesRun::kLeft ? -place.turn : place.turn};
}

std::vector<ReadToken> TurnedReader::FromLine(std::vector<ReadToken> tokens) const {
  for (ReadToken& token : tokens) {
    glm::dvec2 origin{0, 0};
    for (std::size_t sign = 0; token.kind == ReadToken::Kind::kSign && sign < shapes_->size();
         ++sign) {
      if (shapes_->GlyphOf(sign) == token.glyph) origin = shapes_->OriginAlongLines(sign, lines_);
    }
    token.place = FromLine(token.place, origin);
  }
  return tokens;
}

std::vector<ReadToken> TurnedReader::tokens() const { return FromLine(reader_->tokens()); }

std::vector<ReadToken> TurnedReader::Pending() const { return FromLine(reader_->Pending()); }

std::vector<SignGuess> TurnedReader::belief() const {
  std::vector<SignGuess> belief = reader_->belief();
  for (SignGuess& guess : belief) {
    const bool known = guess.sign != SignGuess::kUnknown;
    guess.place = FromLine(
        guess.place, known ? shapes_->OriginAlongLines(guess.sign, lines_) : glm::dvec2(0, 0));
  }
  return belief;
}

}  // namespace moontrace

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sim/reader/page_reader.h"

namespace moontrace {

/// Reads lines that run leftwards or down. To the reader within, paper, hand and signs are mirrored
/// or turned, so that they run to the right; what it wants and what it read are turned back. Links
/// are known only as they lie in lines that run to the right, so that it is told of none.
class TurnedReader final : public PageReader {
 public:
  using Make = std::function<std::unique_ptr<PageReader>(const ReaderKnowledge&)>;
  /// `make` gives the reader within for what that is told.
  TurnedReader(const ReaderKnowledge& knowledge, const Make& make);

  ReaderAction Step(const ReaderInput& input) override;
  bool done() const override { return reader_->done(); }
  std::vector<ReadToken> tokens() const override;
  std::vector<ReadToken> Pending() const override;
  std::vector<SignGuess> belief() const override;
  ReaderActivity activity() const override { return reader_->activity(); }

 private:
  glm::dvec2 ToLine(glm::dvec2 v) const noexcept;
  glm::dvec2 FromLine(glm::dvec2 v) const noexcept;
  SignPlace FromLine(const SignPlace& place, glm::dvec2 origin) const noexcept;
  std::vector<ReadToken> FromLine(std::vector<ReadToken> tokens) const;

  LinesRun lines_;
  std::shared_ptr<const SignShapes> shapes_;  ///< as they are on the paper
  std::unique_ptr<PageReader> reader_;
};

}  // namespace moontrace

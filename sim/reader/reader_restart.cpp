// How a reader begins a page again, where what it took for signs leads nowhere.
#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/reader/reader.h"

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 20.
constexpr int kMostRestarts = 3;  ///< in the first line
constexpr std::size_t kLost = 2;  ///< unknown signs in a row
constexpr std::size_t kFew = 3;   ///< signs, behind which a first line is no longer begun again
constexpr std::size_t kFewOnPage = 6;
constexpr double kAgree = 0.12;  ///< logarithm of the ratio of two sizes

}  // namespace

void Reader::ForgetPage() {
  line_.clear();
  tokens_.clear();
  line_starts_.clear();
  signs_ = unknowns_ = 0;
  ForgetSign();
  skips_ = rounds_ = far_ = widest_gap_ = gaps_ = 0;
  skipped_ = Skipped::kUnknown;
  first_skipped_.reset();
  wider_ = straight_ = leftwards_ = guided_ = line_size_new_ = false;
  guide_gap_ = 0;
  farthest_ = -HUGE_VAL;
  gap_bias_ = turn_ = across_ = along_ = 0;
  size_logs_.clear();
}

/// What was felt of a sign.
void Reader::ForgetSign() {
  evidence_.grooves.clear();
  evidence_.flats.clear();
  crossings_ = tries_ = circles_ = 0;
}

void Reader::ForgetSize() {
  felt_sizes_.clear();
  sizes_ = AllSizes(knowledge_);
  size_ = std::sqrt(knowledge_.least_size * knowledge_.greatest_size);
}

/// What it took for signs leads nowhere: a first line is begun again a little lower. Behind a first
/// line of a sign or two these may have told a wrong size, with which no other line can be read:
/// then the second line tells it, and the page is begun again with that.
bool Reader::StartAnew() {
  if (top_ && SizesAgree()) {
    BeginAtTop();
    return true;
  }
  if (unknowns_ < kLost) return false;
  if (line_starts_.empty()) {
    if (signs_ > kFew || restarts_ >= kMostRestarts) return false;
    ++restarts_;
    start_.y -= (0.1 + 0.2 * random_.Uniform()) * knowledge_.least_size;
  } else {
    if (!MayHaveWrongSize()) return false;
    looked_below_ = true;
    top_ = start_;
    read_above_ = tokens_;
    start_ = FromEm(line_starts_.front(), {0, -kTopOfNext});
    if (!knowledge_.face) start_.y -= kAboveHand * knowledge_.least_size;
  }
  ForgetPage();
  ForgetSize();
  SearchFirstLine();
  return true;
}

bool Reader::MayHaveWrongSize() const {
  const bool told = knowledge_.least_size == knowledge_.greatest_size;
  return !told && !looked_below_ && !guided_ && knowledge_.heading_scale == 1 &&
         signs_ <= kFewOnPage;
}

/// Whether two of the first signs were felt to be as large as each other.
bool Reader::SizesAgree() const {
  for (std::size_t i = 0; i < felt_sizes_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(std::log(felt_sizes_[i] / felt_sizes_[j])) < kAgree) return true;
    }
  }
  return false;
}

/// The size is known, from below.
void Reader::BeginAtTop() {
  start_ = *std::exchange(top_, std::nullopt);
  ForgetPage();
  SearchFirstLine();
}

}  // namespace moontrace

#include "sim/reader/line_belief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace moontrace {
namespace {

// In em and nats; ours, chosen on seeds 1 to 20.
constexpr double kSpread = 0.06;        ///< of ink about a sign's lines
constexpr double kSpreadWidths = 0.15;  ///< the same, in widths
constexpr double kInk = 5;              ///< cost of ink on flat paper
constexpr double kFlat = 4;             ///< cost of flat paper on a line
constexpr double kInner = 0.6;          ///< of half a width, where no flat is felt
constexpr double kWeight = 0.6;         ///< of a point; what is felt side by side errs together
constexpr double kUnknownWide = 0.6;
constexpr double kUnknownCost = 2;    ///< of each point of ink, for what is no sign
constexpr double kUnknownPrior = 12;  ///< before anything was felt
constexpr double kUnknownLinks = 25;  ///< more, among linked letters: those pay for links, too
constexpr double kSpacePrior = 1.6;
constexpr int kMostSpaces = 3;  ///< in a row
constexpr double kEndPrior = 4;
constexpr double kSlack = 0.05;   ///< of a sign's beginning about where it is expected
constexpr double kMostSlack = 3;  ///< the same at most, in standard deviations
constexpr int kFineCells = 2, kCoarseCells = 4;  ///< of the signs' tables, from step to step
constexpr double kNever = -1e9;
// of links
constexpr double kLeastOwn = 20;       ///< of what is felt of a sign, else it has no link
constexpr double kUnlikelier = 30;     ///< than the likeliest sign: not looked at
constexpr double kWithoutLinks = 120;  ///< than it, both told without links: its links are not

/// The first of points by x that lies right of `x` [em].
std::vector<glm::dvec2>::const_iterator FirstFrom(const std::vector<glm::dvec2>& points, double x) {
  return std::lower_bound(points.begin(), points.end(), x,
                          [](glm::dvec2 p, double from) { return p.x < from; });
}

double LogSum(double a, double b) {
  const double most = std::max(a, b);
  return most <= kNever ? kNever : most + std::log1p(std::exp(std::min(a, b) - most));
}

}  // namespace

LineBelief::LineBelief(const SignShapes& shapes, double width, double space)
    : shapes_(&shapes),
      fine_(shapes, kFineCells),
      coarse_(shapes, kCoarseCells),
      width_(width),
      space_(space) {
  double clear = 0, left = 0;
  for (std::size_t sign = 0; sign < shapes.size(); ++sign) {
    const Box& box = shapes.Bounds(sign);
    Include(bounds_, box);
    widest_ = std::max(widest_, shapes.Advance(sign));
    clear += shapes.Advance(sign) - (box.max.x - box.min.x);
    left += box.min.x;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, shapes.size()));
  window_ = (left - 0.5 * clear) / count;
}

LineBelief::Line LineBelief::Prepared(const std::vector<HatchPoint>& points, const LinePrior& prior,
                                      Steps steps) const {
  const StepGains& gains = steps == Steps::kFine ? fine_ : coarse_;
  Line line;
  line.step = gains.step();
  line.from = -prior.before - kMostSlack * kSlack;
  line.half_width = 0.5 * width_ / prior.next.size;
  const double low = bounds_.min.y - line.half_width, high = bounds_.max.y + line.half_width;
  double last = line.from;
  std::vector<glm::dvec2> of_links;
  const EmFrame frame(prior.next);
  for (const HatchPoint& point : points) {
    const glm::dvec2 p = frame.To(point.p);
    if (p.x < line.from + window_ || p.x > prior.felt_to || p.y < low || p.y > high) continue;
    (point.of_link ? of_links : point.ink ? line.ink : line.flat).push_back(p);
    last = std::max(last, p.x);
  }
  for (std::vector<glm::dvec2>* felt : {&line.ink, &line.flat, &of_links}) {
    std::sort(felt->begin(), felt->end(),
              [](glm::dvec2 a, glm::dvec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  }
  line.steps = std::max(1, static_cast<int>(std::ceil((last - line.from) / line.step)));
  const double sure = std::hypot(kSpread, 2 * kSpreadWidths * line.half_width);
  line.spread = std::hypot(sure, prior.unsure / prior.next.size);
  line.flat_cost = kFlat * sure / line.spread;
  for (int k = 0; k <= line.steps; ++k) {
    const auto left = FirstFrom(line.ink, line.XOf(k) + window_) - line.ink.begin();
    line.worth.push_back(kWeight * kInk * static_cast<double>(left));
  }
  SteppedLine stepped;
  stepped.from = line.from;
  stepped.steps = line.steps;
  stepped.window = window_;
  stepped.weight = kWeight;
  stepped.worth = kInk;
  stepped.spread = line.spread;
  stepped.cost = line.flat_cost;
  stepped.inner = kInner * line.half_width;
  line.gains = gains.Of(line.ink, line.flat, stepped);
  if (prior.links != nullptr)
    line.of_links.emplace(*shapes_, stepped, line.ink, line.flat, of_links);
  return line;
}

int LineBelief::Line::StepOf(double em) const {
  return static_cast<int>(std::lround((em - from) / step));
}

int LineBelief::Line::StepsIn(double em) const {
  return std::max(1, static_cast<int>(std::lround(em / step)));
}

double LineBelief::Line::WorthBetween(int a, int b) const {
  const auto at = [this](int k) {
    return worth[static_cast<std::size_t>(std::clamp(k, 0, steps))];
  };
  return b > a ? at(b) - at(a) : 0;
}

/// What the points of a sign's share of the line say for it.
double LineBelief::Gain(const Line& line, std::size_t sign, glm::dvec2 at) const {
  const double from = at.x + window_, to = from + shapes_->Advance(sign);
  const double ink_fall = 0.5 / (line.spread * line.spread);
  double gain = 0;
  for (auto ink = FirstFrom(line.ink, from); ink != line.ink.end() && ink->x < to; ++ink) {
    gain += InkWorth(std::max(0.0, shapes_->Distance(sign, *ink - at)), kInk, ink_fall);
  }
  const double flat_fall = 2 / (kInner * line.half_width);
  double flat = 0;
  for (auto p = FirstFrom(line.flat, from); p != line.flat.end() && p->x < to; ++p) {
    flat += FlatShare(shapes_->Distance(sign, *p - at), flat_fall);
  }
  return kWeight * (gain - line.flat_cost * flat);
}

/// With its own links.
double LineBelief::OwnGain(const Line& line, const LinePrior& prior, std::size_t sign,
                           int k) const {
  const double gain = line.gains[sign][static_cast<std::size_t>(k)], x = line.XOf(k);
  if (prior.links == nullptr) return gain;
  const double from = x + window_, to = from + shapes_->Advance(sign);
  return gain + line.of_links->Of(prior.links->Within(sign), {sign, sign, x, x, from, to, to});
}

SignPair LineBelief::PairOf(std::size_t a, std::size_t b, double x_a, double x_b) const {
  const double split = x_b + window_;
  return {a, b, x_a, x_b, x_a + window_, split, split + shapes_->Advance(b)};
}

/// By the link from the sign before, which is known, over so many spaces.
double LineBelief::FromLeft(const Line& line, const LinePrior& prior, std::size_t sign, double x,
                            int spaces) const {
  if (prior.links == nullptr || !prior.left || spaces > 1) return 0;
  if (spaces == 1 && !prior.links->LinksWords()) return 0;
  const double way = shapes_->Advance(*prior.left) + prior.gap + spaces * (space_ + prior.gap);
  const LinkShapes::Link& link =
      spaces == 0 ? prior.links->Next(*prior.left, sign) : prior.links->Across(*prior.left, sign);
  return line.of_links->Of(link, PairOf(*prior.left, sign, x - way, x));
}

double LineBelief::UnknownGain(const Line& line, double x) const {
  const double to = x + window_ + kUnknownWide;
  const auto first = FirstFrom(line.ink, x + window_), last = FirstFrom(line.ink, to);
  const double gain =
      static_cast<double>(std::max<std::ptrdiff_t>(0, last - first)) * (kInk - kUnknownCost);
  return kWeight * gain - kUnknownPrior - (line.of_links ? kUnknownLinks : 0);
}

/// What a line says from a sign on that begins at one step, if the next is expected at another.
double LineBelief::From(const Line& line, const LinePrior& prior, const Backward& back,
                        const Begins& begins, int then) const {
  const auto expected = [&](int k) {
    return k > line.steps ? 0.0 : back.expected[static_cast<std::size_t>(k)];
  };
  const double x = line.XOf(begins.step), own = begins.own;
  const std::size_t sign = begins.sign;
  if (prior.links == nullptr || then > line.steps) return own + expected(then);
  const auto linked = [&](int k, bool across) {
    const std::vector<double>& signs = back.sign_expected[static_cast<std::size_t>(k)];
    const double most = *std::max_element(signs.begin(), signs.end());
    const double x_b = x + shapes_->Advance(sign) + prior.gap + (across ? space_ + prior.gap : 0);
    double sum = back.unlinked[static_cast<std::size_t>(k)];
    for (std::size_t b = 0; b < signs.size(); ++b) {
      if (signs[b] < most - kUnlikelier) continue;
      const LinkShapes::Link& link =
          across ? prior.links->Across(sign, b) : prior.links->Next(sign, b);
      sum = LogSum(
          sum, signs[b] + (own > kLeastOwn ? line.of_links->Of(link, PairOf(sign, b, x, x_b)) : 0));
    }
    return sum;
  };
  const int behind = then + line.StepsIn(space_ + prior.gap);
  double space = expected(behind);
  if (prior.links->LinksWords() && behind <= line.steps) space = linked(behind, true);
  return own + LogSum(linked(then, false), space - kSpacePrior);
}

/// What a line says if something is expected about a step, from what begins about there.
void LineBelief::Expect(const Line& line, const LinePrior& prior, int k, Backward& back) const {
  const double slack = std::hypot(kSlack, prior.unsure / prior.next.size);
  const int reach = static_cast<int>(std::lround(kMostSlack * slack / line.step));
  const int space = line.StepsIn(space_ + prior.gap), unknown = line.StepsIn(kUnknownWide);
  const double prior_of_a_sign = -std::log(static_cast<double>(shapes_->size()));
  const auto expected = [&](int at) {
    return at > line.steps ? 0.0 : back.expected[static_cast<std::size_t>(at)];
  };
  const auto at = static_cast<std::size_t>(k);
  double sum = -kEndPrior, unlinked = -kEndPrior;
  for (int off = -reach; off <= reach; ++off) {
    const int j = k + off;
    if (j < 0) continue;
    const double spread = off * line.step / slack;
    const double place =
        -0.5 * spread * spread - std::log(slack / line.step * 2.5066) - line.WorthBetween(j, k);
    const bool beyond = j > line.steps;
    const auto begins = static_cast<std::size_t>(j);
    sum = LogSum(sum, place + (beyond ? 0 : back.begins[begins]));
    if (prior.links == nullptr) continue;
    if (beyond) {
      unlinked = LogSum(unlinked, place);
      continue;
    }
    const double what_is_no_sign =
        UnknownGain(line, line.XOf(j)) + expected(std::max(j + reach + 1, j + unknown));
    unlinked = LogSum(unlinked, place + what_is_no_sign);
    for (std::size_t sign = 0; sign < shapes_->size(); ++sign) {
      double& of = back.sign_expected[at][sign];
      of = LogSum(of, place + prior_of_a_sign + back.sign_begins[begins][sign]);
    }
  }
  back.expected[at] = LogSum(sum, expected(k + space) - kSpacePrior);
  if (prior.links != nullptr) back.unlinked[at] = unlinked;
}

LineBelief::Backward LineBelief::LookBack(const Line& line, const LinePrior& prior) const {
  const double slack = std::hypot(kSlack, prior.unsure / prior.next.size);
  const int reach = static_cast<int>(std::lround(kMostSlack * slack / line.step));
  const double prior_of_a_sign = -std::log(static_cast<double>(shapes_->size()));
  const int unknown = line.StepsIn(kUnknownWide);
  const std::size_t count = static_cast<std::size_t>(line.steps) + 1;
  Backward back;
  back.begins.assign(count, kNever);
  back.expected = back.begins;
  if (prior.links != nullptr) {
    back.unlinked = back.begins;
    back.sign_begins.assign(count, std::vector<double>(shapes_->size(), kNever));
    back.sign_expected = back.sign_begins;
  }
  const auto expected = [&](int at) {
    return at > line.steps ? 0.0 : back.expected[static_cast<std::size_t>(at)];
  };
  std::vector<double> own(shapes_->size());
  std::vector<int> then(shapes_->size());
  // signs begin before they are expected, too: those steps are done first
  for (int k = line.steps + reach; k >= 0; --k) {
    if (const int j = k - reach; j >= 0) {
      double sum = kNever;
      const double x = line.XOf(j);
      double most = kNever;
      for (std::size_t sign = 0; sign < shapes_->size(); ++sign) {
        const int next = j + line.StepsIn(shapes_->Advance(sign) + prior.gap);
        // what comes behind one that is narrower than the slack is not known yet
        then[sign] = std::max(next, k + 1);
        own[sign] = OwnGain(line, prior, sign, j);
        most = std::max(most, own[sign] + expected(then[sign]));
      }
      for (std::size_t sign = 0; sign < shapes_->size(); ++sign) {
        double log = own[sign] + expected(then[sign]);
        if (prior.links != nullptr && log > most - kWithoutLinks) {
          log = From(line, prior, back, {sign, j, own[sign]}, then[sign]);
        }
        if (prior.links != nullptr) back.sign_begins[static_cast<std::size_t>(j)][sign] = log;
        sum = LogSum(sum, prior_of_a_sign + log);
      }
      const double rest = expected(std::max(k + 1, j + unknown));
      back.begins[static_cast<std::size_t>(j)] = LogSum(sum, UnknownGain(line, x) + rest);
    }
    if (k <= line.steps) Expect(line, prior, k, back);
  }
  return back;
}

double LineBelief::Fit(const std::vector<HatchPoint>& points, const LinePrior& prior,
                       Steps steps) const {
  const Line line = Prepared(points, prior, steps);
  const Backward back = LookBack(line, prior);
  double sum = kNever;
  int count = 0;
  for (int k = 0; k <= line.steps; ++k) {
    const double x = line.XOf(k);
    if (x < -prior.before || x > prior.behind) continue;
    sum = LogSum(sum, back.begins[static_cast<std::size_t>(k)]);
    ++count;
  }
  return count > 0 ? sum - std::log(count) : 0;
}

double LineBelief::CostOfInk(const std::vector<HatchPoint>& points, const SignPlace& line) const {
  constexpr double kOnLine = 0.5;                 // share
  constexpr double kClear = 0.35;                 // below a line there is no ink for so long [em]
  const double edge = 0.25 * width_ / line.size;  // slopes tell roughly
  const EmFrame frame(line);
  double cost = 0;
  for (const HatchPoint& point : points) {
    const double y = frame.To(point.p).y;
    if (!point.ink || point.of_link || y < bounds_.min.y - edge - kClear) continue;
    const bool on_line = y > bounds_.min.y - edge && y < bounds_.max.y + edge;
    cost += kWeight * kInk * (on_line ? kOnLine : 1);
  }
  return cost;
}

namespace {

/// How likely a sign begins so far from where it is expected; none: not there.
std::optional<double> LogOfPlace(const LinePrior& prior, double off, double slack, double step) {
  if (prior.anywhere) {
    if (off < -prior.before || off > prior.behind) return std::nullopt;
    return 0;
  }
  if (std::abs(off) > kMostSlack * slack + 1e-9) return std::nullopt;
  return -0.5 * off * off / (slack * slack) - std::log(slack / step * 2.5066);
}

}  // namespace

NextOnLine LineBelief::Next(const std::vector<HatchPoint>& points, const LinePrior& prior) const {
  const Line line = Prepared(points, prior, Steps::kFine);
  const Backward back = LookBack(line, prior);
  const double slack = std::hypot(kSlack, prior.unsure / prior.next.size);
  struct Answer {
    double log = kNever, best = kNever, x = 0;
    bool space = false;
  };
  std::vector<Answer> answers(shapes_->size() + 1);  // the last: unknown
  const auto add = [&](std::size_t which, double log, double x, bool space) {
    Answer& answer = answers[which];
    answer.log = LogSum(answer.log, log);
    if (log > answer.best) {
      answer.best = log;
      answer.x = x;
      answer.space = space;
    }
  };
  const auto expected = [&](double x) {
    const int k = line.StepOf(x);
    return k > line.steps ? 0.0 : back.expected[static_cast<std::size_t>(std::max(0, k))];
  };
  for (int j = 0; j <= line.steps; ++j) {
    const double x = line.XOf(j);
    for (int spaces = 0; spaces <= (prior.anywhere ? 0 : kMostSpaces); ++spaces) {
      const double off = x - spaces * (space_ + prior.gap);
      const std::optional<double> place = LogOfPlace(prior, off, slack, line.step);
      if (!place) continue;
      double log = *place - spaces * kSpacePrior;
      if (spaces == 0) log -= prior.claimed * line.WorthBetween(j, line.StepOf(0));
      for (std::size_t sign = 0; sign < shapes_->size(); ++sign) {
        const double says = prior.links != nullptr
                                ? back.sign_begins[static_cast<std::size_t>(j)][sign]
                                : line.gains[sign][static_cast<std::size_t>(j)] +
                                      expected(x + shapes_->Advance(sign) + prior.gap);
        add(sign,
            log - std::log(static_cast<double>(shapes_->size())) + says +
                FromLeft(line, prior, sign, x, spaces),
            x, spaces > 0);
      }
      add(shapes_->size(), log + UnknownGain(line, x) + expected(x + kUnknownWide), x, spaces > 0);
    }
  }
  double all = kNever;
  std::size_t best = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    all = LogSum(all, answers[i].log);
    if (answers[i].log > answers[best].log) best = i;
  }
  NextOnLine next;
  const bool inked = !line.ink.empty() && line.ink.back().x > window_;
  next.end = !inked || all < -kEndPrior;
  const Answer& answer = answers[best];
  next.space = answer.space;
  next.sign.probability = std::exp(answer.log - all);
  next.sign.log_likelihood = answer.log;
  next.sign.place = prior.next;
  if (best < shapes_->size()) {
    next.sign.sign = best;
    next.sign.place = Placed(line, best, answer.x, prior);
  } else {
    next.sign.place.origin = FromEm(prior.next, {answer.x, 0});
  }
  return next;
}

/// Where a sign lies by its own points.
SignPlace LineBelief::Placed(const Line& line, std::size_t sign, double x,
                             const LinePrior& prior) const {
  constexpr double kAlong = 0.04, kAcross = 0.16, kStep = 0.02, kOff = 0.08;
  glm::dvec2 best{x, 0};
  double most = -std::numeric_limits<double>::infinity();
  for (double dx = -kAlong; dx < kAlong + 1e-9; dx += kStep) {
    for (double dy = -kAcross; dy < kAcross + 1e-9; dy += kStep) {
      const double gain =
          Gain(line, sign, {x + dx, dy}) - 0.5 * (dy * dy + dx * dx) / (kOff * kOff);
      if (gain <= most) continue;
      most = gain;
      best = {x + dx, dy};
    }
  }
  SignPlace place = prior.next;
  place.origin = FromEm(prior.next, best);
  return place;
}

}  // namespace moontrace

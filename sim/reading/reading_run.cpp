#include "sim/reading/reading_run.h"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <map>
#include <memory>

#include "sim/console/console.h"
#include "sim/reader/hatch_reader.h"
#include "sim/reader/reader.h"
#include "sim/reader/turned_reader.h"
#include "textures/typeset/layout.h"

namespace moontrace {
namespace {

/// How a path is drawn where the reader was at this.
TracePhase PhaseOf(ReaderActivity activity) {
  switch (activity) {
    case ReaderActivity::kSearching:
    case ReaderActivity::kCrossing:
    case ReaderActivity::kHatching:
      return TracePhase::kTravel;
    case ReaderActivity::kFollowing:
    case ReaderActivity::kTurning:
      return TracePhase::kStroke;
    default:
      return TracePhase::kAir;
  }
}

void Keep(std::vector<PathPoint>& path, const TickResult& felt, ReaderActivity activity,
          double spacing) {
  if (spacing <= 0) return;
  PathPoint point;
  point.tip_P = felt.proxy_P;
  point.in_contact = felt.depth > 0;
  point.phase = PhaseOf(activity);
  if (!path.empty() && path.back().in_contact == point.in_contact &&
      path.back().phase == point.phase && glm::distance(path.back().tip_P, point.tip_P) < spacing) {
    return;
  }
  path.push_back(point);
}

std::unique_ptr<PageReader> ReaderFor(const ReaderKnowledge& knowledge, double tick,
                                      std::uint64_t seed) {
  if (knowledge.lines != LinesRun::kRight) {
    return std::make_unique<TurnedReader>(
        knowledge, [&](const ReaderKnowledge& told) { return ReaderFor(told, tick, seed); });
  }
  if (knowledge.followed) return std::make_unique<Reader>(knowledge, tick, seed);
  return std::make_unique<HatchReader>(knowledge, tick);
}

}  // namespace

ReadingResult RunReading(const ReadingSetup& setup) {
  LedHand hand(setup);
  const double tick = hand.tick();
  const std::unique_ptr<PageReader> made = ReaderFor(hand.knowledge(), tick, setup.reader_seed);
  PageReader& reader = *made;

  ReadingResult result;
  const auto begin = std::chrono::steady_clock::now();
  const auto most = static_cast<std::size_t>(setup.longest / tick);
  bool through = false;
  std::size_t n = 0;
  for (; n < most && !reader.done(); ++n) {
    if (setup.stop != nullptr && setup.stop->load(std::memory_order_relaxed)) throw Interrupted();
    if (setup.alive && n % 1000 == 0) setup.alive();
    const ReaderInput input = hand.Feel();
    const TickResult& felt = hand.felt();
    if (felt.through && !through) ++result.through;
    through = felt.through;
    const ReaderAction action = reader.Step(input);
    result.seconds[static_cast<std::size_t>(reader.activity())] += tick;
    if (setup.watch) {
      setup.watch({static_cast<double>(n) * tick, input, reader, felt, hand.scene()});
    }
    hand.Lead(action);
    Keep(result.path, felt, reader.activity(), setup.path_spacing);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  result.tokens = reader.tokens();
  for (ReadToken& token : result.tokens) {
    token.place.origin = hand.ToPage(token.place.origin);
    token.place.turn -= setup.page_turn;
  }
  result.ended = reader.done();
  result.duration = static_cast<double>(n) * tick;
  result.real_time_factor = result.duration / std::max(elapsed.count(), 1e-9);
  return result;
}

namespace {

/// Forms of a sign count as that sign: of each glyph its own number or that of its plain form.
std::vector<int> PlainForms(const Script& script) {
  std::vector<int> plain(script.glyphs.size());
  for (std::size_t i = 0; i < plain.size(); ++i) plain[i] = static_cast<int>(i);
  for (const auto& [name, forms] : script.forms) {
    const std::size_t whole = script.Find(name);
    if (whole == Script::npos) continue;
    for (const auto& [form, glyph] : forms) {
      const std::size_t index = script.Find(glyph);
      if (index != Script::npos) plain[index] = static_cast<int>(whole);
    }
  }
  return plain;
}

}  // namespace

std::vector<int> MarksOf(const TextPage& page, const Script& script) {
  const std::vector<int> plain = PlainForms(script);
  std::vector<int> marks;
  const PlacedGlyph* before = nullptr;
  for (const PlacedGlyph& glyph : page.glyphs) {
    if (IsGuide(script.glyphs[glyph.glyph])) continue;
    if (before != nullptr) {
      if (glyph.line != before->line) {
        marks.push_back(kLineEndMark);
      } else if (glyph.word != before->word) {
        marks.push_back(kSpaceMark);
      }
    }
    marks.push_back(plain[glyph.glyph]);
    before = &glyph;
  }
  if (!marks.empty()) marks.push_back(kLineEndMark);
  return marks;
}

std::vector<int> MarksOf(const std::vector<ReadToken>& tokens, const Script& script) {
  const std::vector<int> plain = PlainForms(script);
  std::vector<int> marks;
  for (const ReadToken& token : tokens) {
    switch (token.kind) {
      case ReadToken::Kind::kSign:
        marks.push_back(plain[token.glyph]);
        break;
      case ReadToken::Kind::kUnknown:
        marks.push_back(kUnknownMark);
        break;
      case ReadToken::Kind::kSpace:
        marks.push_back(kSpaceMark);
        break;
      case ReadToken::Kind::kLineEnd:
        marks.push_back(kLineEndMark);
        break;
    }
  }
  return marks;
}

}  // namespace moontrace

#include <cmath>
#include <string>

#include "sim/bench/bench_page.h"
#include "sim/bench/row.h"
#include "sim/bench/sampled_maps.h"
#include "sim/bench/timing.h"
#include "textures/relief/glyph_group.h"
#include "textures/relief/groove_links.h"

namespace moontrace {

namespace {

constexpr int kTurns = 7;
constexpr std::size_t kPoints = 400000;

/// Each query waits for the one before, as in a loop that needs each answer.
template <class Map>
double Chain(const Map& map, const std::vector<glm::dvec2>& points) {
  double last = 0;
  for (const glm::dvec2 p : points) {
    const double nothing = last * 1e-300;
    const Sample sample = map.SampleAt({p.x + nothing, p.y + nothing});
    last = sample.displacement + sample.gradient.x + sample.gradient.y;
  }
  return last;
}

template <class Map>
double Independent(const Map& map, const std::vector<glm::dvec2>& points) {
  double sum = 0;
  for (const glm::dvec2 p : points) {
    const Sample sample = map.SampleAt(p);
    sum += sample.displacement + sample.gradient.x + sample.gradient.y;
  }
  return sum;
}

double Nanoseconds(double seconds, std::size_t count) {
  return 1e9 * seconds / static_cast<double>(count);
}

void AddQueries(const BenchPage& page, const TextureField& field, BenchRows& rows) {
  // the grid of the bar: 8000 x 5156 floats
  const HeightGrid grid(field, page.size, 8000, 5156);
  const std::vector<glm::dvec2> points = PointsInLetters(page, kPoints, 21);
  const Turns chain = ByTurns(
      kTurns, [&] { Keep(Chain(field, points)); }, [&] { Keep(Chain(grid, points)); });
  rows.push_back(
      AtMost("query, each waiting for the last, against the grid", chain.ratio, "times", 0.4));
  rows.push_back(Shown("that query", Nanoseconds(chain.first, kPoints), "ns"));
  rows.push_back(Shown("that query in the grid", Nanoseconds(chain.second, kPoints), "ns"));
  const Turns free = ByTurns(
      kTurns, [&] { Keep(Independent(field, points)); }, [&] { Keep(Independent(grid, points)); });
  rows.push_back(AtMost("independent queries against the grid", free.ratio, "times", 0.8));
  rows.push_back(Shown("independent query", Nanoseconds(free.first, kPoints), "ns"));
  rows.push_back(Shown("independent query in the grid", Nanoseconds(free.second, kPoints), "ns"));
  rows.push_back(
      AtMost("memory against the grid",
             static_cast<double>(field.memory_bytes()) / static_cast<double>(grid.memory_bytes()),
             "times", 0.01));
  const std::vector<glm::dvec2> path = SlidingPoints(page, kPoints);
  const Turns slide = ByTurns(
      kTurns, [&] { Keep(Independent(field, path)); }, [&] { Keep(Independent(grid, path)); });
  rows.push_back(AtMost("sliding query", Nanoseconds(slide.first, path.size()), "ns", 30));
  rows.push_back(Shown("sliding query in the grid", Nanoseconds(slide.second, path.size()), "ns"));

  double own_error = 0, grid_error = 0;
  for (std::size_t i = 0; i < kPoints / 4; ++i) {
    const double exact = SampleTree(page.texture, points[i]).displacement;
    own_error = std::max(own_error, std::abs(field.SampleAt(points[i]).displacement - exact));
    grid_error = std::max(grid_error, std::abs(grid.SampleAt(points[i]).displacement - exact));
  }
  // rounding: a few units in the last place of the page's coordinates, times the slope
  rows.push_back(AtMost("error against the tree", 1e15 * own_error, "fm", 1));
  rows.push_back(Shown("error of the grid", 1e6 * grid_error, "um"));
}

void AddGrowth(const BenchPage& page, const TextureField& field, BenchRows& rows) {
  constexpr std::size_t kPageCount = 521;  // of 1920 signs and spaces: a million
  const BenchPage book = MakeBenchPage(kPageCount, 5);
  const TextureField whole(book.texture);
  const std::vector<glm::dvec2> points = PointsInLetters(page, kPoints, 22);
  const std::vector<glm::dvec2> path = SlidingPoints(page, kPoints);

  // page by page: the book's pages one after the other, each its own field, as a reader turns them
  std::vector<TextureField> pages;
  std::vector<std::vector<glm::dvec2>> page_points;
  constexpr std::size_t kFew = 8;
  for (std::size_t i = 0; i < kFew; ++i) {
    const BenchPage one = MakeBenchPage(1, 100 + i);
    pages.emplace_back(one.texture);
    page_points.push_back(PointsInLetters(one, kPoints / kFew, 200 + i));
  }
  const Turns paged = ByTurns(
      kTurns,
      [&] {
        for (std::size_t i = 0; i < kFew; ++i) Keep(Chain(pages[i], page_points[i]));
      },
      [&] { Keep(Chain(field, points)); });
  rows.push_back(AtMost("book of a million letters, page by page, against one page", paged.ratio,
                        "times", 1.05));

  // as many points as the page has: the two are compared point by point
  const std::vector<glm::dvec2> book_path = SlidingPoints(book, path.size());
  const Turns slid = ByTurns(
      kTurns, [&] { Keep(Chain(whole, book_path)); }, [&] { Keep(Chain(field, path)); });
  rows.push_back(AtMost("book as one field, read along its lines, against one page", slid.ratio,
                        "times", 1.5));
  const std::vector<glm::dvec2> book_points = PointsInLetters(book, kPoints, 23);
  const Turns leapt = ByTurns(
      kTurns, [&] { Keep(Chain(whole, book_points)); }, [&] { Keep(Chain(field, points)); });
  rows.push_back(
      AtMost("book as one field, leaping anywhere, against one page", leapt.ratio, "times", 1.5));
  rows.push_back(
      Shown("memory of the book", 1e-6 * static_cast<double>(whole.memory_bytes()), "MB"));
}

/// The page as a glyph atlas, 53 um from height to height: what a careful programmer would write in
/// place of the grid.
void AddAtlas(const BenchPage& page, const TextureField& field, BenchRows& rows) {
  const GlyphAtlas atlas(page, 53e-6);
  const std::vector<glm::dvec2> points = PointsInLetters(page, kPoints, 25);
  const Turns chain = ByTurns(
      kTurns, [&] { Keep(Chain(field, points)); }, [&] { Keep(Chain(atlas, points)); });
  rows.push_back(
      AtMost("query, each waiting for the last, against a glyph atlas", chain.ratio, "times", 0.7));
  const Turns free = ByTurns(
      kTurns, [&] { Keep(Independent(field, points)); }, [&] { Keep(Independent(atlas, points)); });
  rows.push_back(AtMost("independent queries against a glyph atlas", free.ratio, "times", 1.0));
  rows.push_back(Shown("independent query in the atlas", Nanoseconds(free.second, kPoints), "ns"));
  double error = 0;
  for (std::size_t i = 0; i < kPoints / 4; ++i) {
    error = std::max(error, std::abs(atlas.SampleAt(points[i]).displacement -
                                     field.SampleAt(points[i]).displacement));
  }
  rows.push_back(Shown("error of the atlas", 1e6 * error, "um"));
  rows.push_back(
      Shown("memory of the atlas", 1e-6 * static_cast<double>(atlas.memory_bytes()), "MB"));
}

/// Rows of a height map over the whole sheet, 20 points a millimetre, and a finger's path.
void AddMany(const BenchPage& page, const TextureField& field, BenchRows& rows) {
  std::vector<glm::dvec2> map;
  for (double y = 0.05e-3; y < page.size.y && map.size() < kPoints; y += 1.7e-3) {
    for (double x = 0.05e-3; x < page.size.x; x += 0.05e-3) map.emplace_back(x, y);
  }
  const auto add = [&](const char* what, const std::vector<glm::dvec2>& points) {
    std::vector<Sample> samples(points.size());
    const Turns turns = ByTurns(
        kTurns,
        [&] {
          for (std::size_t i = 0; i < points.size(); ++i) samples[i] = field.SampleAt(points[i]);
          Keep(samples[samples.size() / 2].displacement);
        },
        [&] {
          field.SamplesAt(points, samples);
          Keep(samples[samples.size() / 2].displacement);
        });
    rows.push_back(
        AtLeast(std::string(what) + " at once against one by one", turns.ratio, "times faster", 3));
    rows.push_back(
        Shown(std::string("point of ") + what, Nanoseconds(turns.second, points.size()), "ns"));
  };
  add("a height map", map);
  add("a finger's path", SlidingPoints(page, kPoints));
}

/// Everything that a page may have, against the plain one.
void AddRich(const BenchPage& page, const TextureField& field, BenchRows& rows) {
  const BenchPage rich = MakeRichBenchPage(4);
  const TextureField rich_field(rich.texture);
  const std::vector<glm::dvec2> points = PointsInLetters(page, kPoints, 24);
  const std::vector<glm::dvec2> rich_points = PointsInLetters(rich, kPoints, 24);
  const Turns turns = ByTurns(
      kTurns, [&] { Keep(Independent(rich_field, rich_points)); },
      [&] { Keep(Independent(field, points)); });
  rows.push_back(AtMost("page with links, rules, rough paper and two sizes, against the plain page",
                        turns.ratio, "times", 2));
  rows.push_back(Shown("independent query there", Nanoseconds(turns.first, kPoints), "ns"));
  rows.push_back(
      Shown("memory of that page", 1e-6 * static_cast<double>(rich_field.memory_bytes()), "MB"));
}

void AddBuilding(const BenchPage& page, BenchRows& rows) {
  const double time = MedianSecondsOf(15, [&] {
    const TextureField field(BuildTexture(page.sheet, page.script, page.style));
    Keep(field.greatest_slope());
  });
  rows.push_back(AtMost("new page of 64 x 30 letters built", 1e3 * time, "ms", 2));
}

/// Nothing is known from the time before: each go looks for all links anew.
void AddLinks(BenchRows& rows) {
  const BenchPage page = MakeLinkBenchPage(4);
  const double time = MedianSecondsOf(15, [&] {
    Keep(static_cast<double>(LinkPage(page.sheet, page.script, page.style).missing));
  });
  rows.push_back(AtMost("links of a page of 480 signs found", 1e3 * time, "ms", 5));
}

}  // namespace

BenchRows BenchField() {
  BenchRows rows;
  const BenchPage page = MakeBenchPage(1, 4);
  const TextureField field(page.texture);
  AddQueries(page, field, rows);
  AddAtlas(page, field, rows);
  AddMany(page, field, rows);
  AddRich(page, field, rows);
  AddGrowth(page, field, rows);
  AddBuilding(page, rows);
  AddLinks(rows);
  return rows;
}

}  // namespace moontrace

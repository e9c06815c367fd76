// What the C interface adds to sampling, against the call of C++ on arrays.
#include <string>
#include <vector>

#include "sim/bench/row.h"
#include "sim/bench/timing.h"
#include "sim/library/moontrace.h"
#include "textures/base/error.h"
#include "textures/field/field.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

constexpr double kLetters = 0.006;  ///< [m]
constexpr std::size_t kPoints = 1'000'000;
constexpr int kTurns = 15;

std::string FullPageText() {
  std::string text;
  for (int i = 0; i < 60; ++i) text += "the moon rises over the quiet hills and the river runs ";
  return text;
}

void Require(int answer) {
  if (answer != MOONTRACE_DONE) throw LackError(moontrace_message());
}

/// The same page by C and by C++.
class Pages {
 public:
  Pages() {
    moontrace_style given{};
    given.size = sizeof given;
    given.letter_size = kLetters;
    Require(moontrace_script_open("moon", nullptr, &script_));
    Require(moontrace_text_open(script_, FullPageText().c_str(), &given, &text_));
    Require(moontrace_page_open(text_, 0, &page));
    const Script script = FindScript("moon");
    const TypeStyle style = DefaultStyle(kLetters, Relief::kEngraved, script);
    const Typeset set = SetText(FullPageText(), script, style, FindPage("a4"));
    field = TextureField(BuildTexture(set.pages.front(), script, style));
  }
  ~Pages() {
    moontrace_page_close(page);
    moontrace_text_close(text_);
    moontrace_script_close(script_);
  }
  Pages(const Pages&) = delete;
  Pages& operator=(const Pages&) = delete;

  moontrace_page* page = nullptr;
  TextureField field;

 private:
  moontrace_script* script_ = nullptr;
  moontrace_text* text_ = nullptr;
};

/// A million points in rows over the whole sheet.
std::vector<glm::dvec2> Raster() {
  constexpr std::size_t kColumns = 1000;
  std::vector<glm::dvec2> points(kPoints);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto column = static_cast<double>(i % kColumns);
    const std::size_t row = i / kColumns;
    points[i] = {0.210 * (column + 0.5) / kColumns,
                 0.297 * (static_cast<double>(row) + 0.5) * kColumns / kPoints};
  }
  return points;
}

moontrace_samples ArraysOf(const std::vector<glm::dvec2>& points, std::vector<Sample>& samples) {
  constexpr auto kPair = static_cast<std::ptrdiff_t>(sizeof(glm::dvec2));
  constexpr auto kThree = static_cast<std::ptrdiff_t>(sizeof(Sample));
  Sample& first = samples.front();
  return {sizeof(moontrace_samples),
          0,
          points.size(),
          &points.front().x,
          kPair,
          &points.front().y,
          kPair,
          &first.displacement,
          kThree,
          &first.gradient.x,
          kThree,
          &first.gradient.y,
          kThree};
}

/// The same numbers in five arrays.
struct Columns {
  explicit Columns(const std::vector<glm::dvec2>& points)
      : x(points.size()),
        y(points.size()),
        height(points.size()),
        slope_x(points.size()),
        slope_y(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      x[i] = points[i].x;
      y[i] = points[i].y;
    }
  }
  moontrace_samples Arrays() {
    constexpr auto kNumber = static_cast<std::ptrdiff_t>(sizeof(double));
    return {sizeof(moontrace_samples),
            0,
            x.size(),
            x.data(),
            kNumber,
            y.data(),
            kNumber,
            height.data(),
            kNumber,
            slope_x.data(),
            kNumber,
            slope_y.data(),
            kNumber};
  }
  std::vector<double> x, y, height, slope_x, slope_y;
};

}  // namespace

BenchRows BenchLibrary() {
  BenchRows rows;
  const Pages pages;
  const std::vector<glm::dvec2> points = Raster();
  std::vector<Sample> samples(points.size());
  Columns columns(points);
  const moontrace_samples side_by_side = ArraysOf(points, samples);
  const moontrace_samples in_columns = columns.Arrays();
  const auto by_cpp = [&] { pages.field.SamplesAt(points, samples); };
  const auto by_c = [&] { Require(moontrace_sample_many(pages.page, &side_by_side)); };
  const auto by_columns = [&] { Require(moontrace_sample_many(pages.page, &in_columns)); };
  const auto one_by_one = [&] {
    double sum = 0, sample[3];
    for (const glm::dvec2 point : points) {
      Require(moontrace_sample(pages.page, point.x, point.y, sample));
      sum += sample[0];
    }
    Keep(sum);
  };
  const Turns c = ByTurns(kTurns, by_c, by_cpp);
  rows.push_back(AtMost("a million points by C against C++", c.ratio, "times", 1.1));
  rows.push_back(Shown("a million points by C++", 1e3 * c.second, "ms"));
  const Turns apart = ByTurns(kTurns, by_columns, by_cpp);
  rows.push_back(AtMost("a million points by C, an array for each number, against C++", apart.ratio,
                        "times", 1.1));
  const Turns single = ByTurns(kTurns, one_by_one, by_c);
  rows.push_back(
      AtLeast("a million points by C at once against one by one", single.ratio, "times faster", 3));
  return rows;
}

}  // namespace moontrace

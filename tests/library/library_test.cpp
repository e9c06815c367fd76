// The C interface against the rooms that it is made of: the same numbers, letters and pictures.
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

#include "sim/picture/page_picture.h"
#include "sim/picture/svg_writer.h"
#include "tests/library/library_fixture.h"
#include "textures/field/surface.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWords = "the moon rises, 12 times";

/// The same page by the rooms of C++.
struct Reference {
  Script script = FindScript("moon");
  Typeset set =
      SetText(kWords, script, DefaultStyle(script.size, Relief::kEngraved, script), FindPage("a4"));
  TextureField field{BuildTexture(set.pages.front(), script, set.style)};
};

/// Points all over the first lines, on and off letters.
std::vector<glm::dvec2> Points(std::size_t count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(0.010, 0.200), y(0.230, 0.290);
  std::vector<glm::dvec2> points(count);
  for (glm::dvec2& point : points) point = {x(random), y(random)};
  return points;
}

TEST(LibraryScript, IsDescribed) {
  const OpenPage open(kWords);
  auto facts = Sized<moontrace_script_facts>();
  ASSERT_EQ(moontrace_script_describe(open.script, &facts), MOONTRACE_DONE);
  const Script script = FindScript("moon");
  EXPECT_EQ(facts.name, script.name);
  EXPECT_EQ(facts.licence, script.licence);
  EXPECT_EQ(facts.signs, script.glyphs.size());
  EXPECT_EQ(facts.letter_size, 0.012);  // the design's default
}

TEST(LibraryPage, HasTheLettersOfTheText) {
  const Reference reference;
  const OpenPage open(kWords);
  auto facts = Sized<moontrace_page_facts>();
  ASSERT_EQ(moontrace_page_describe(open.page, &facts), MOONTRACE_DONE);
  const std::vector<PlacedGlyph>& glyphs = reference.set.pages.front().glyphs;
  ASSERT_EQ(facts.letters, glyphs.size());
  EXPECT_EQ(facts.width, 0.210);  // of A4
  EXPECT_EQ(facts.height, 0.297);
  EXPECT_EQ(facts.greatest_rise, 0);
  std::string numeral;
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    auto letter = Sized<moontrace_letter>();
    ASSERT_EQ(moontrace_page_letter(open.page, i, &letter), MOONTRACE_DONE);
    EXPECT_EQ(letter.sign, reference.script.glyphs[glyphs[i].glyph].name);
    EXPECT_EQ(letter.x, glyphs[i].origin_P.x);
    EXPECT_EQ(letter.y, glyphs[i].origin_P.y);
    EXPECT_EQ(letter.source_begin, glyphs[i].source_begin);
    EXPECT_EQ(letter.source_end, glyphs[i].source_end);
    if (letter.source_begin == letter.source_end) numeral += letter.sign;
  }
  EXPECT_EQ(numeral, "numeral");
}

TEST(LibraryText, SaysWhatBecameOfIt) {
  auto style = Sized<moontrace_style>();
  style.sheet = "60x50";
  style.letter_size = 0.010;
  const OpenPage open("caf\xC3\xA9 and a long walk home", &style);
  auto facts = Sized<moontrace_text_facts>();
  ASSERT_EQ(moontrace_text_describe(open.text, &facts), MOONTRACE_DONE);
  EXPECT_GT(facts.pages, 1u);
  EXPECT_EQ(facts.folded, 1u);  // e with its accent
  EXPECT_EQ(facts.missing, 0u);
  EXPECT_EQ(facts.letter_size, 0.010);
  EXPECT_DOUBLE_EQ(facts.width, 0.1165 * 0.010);      // the design's width of a groove
  EXPECT_DOUBLE_EQ(facts.depth, 0.1165 * 0.010 / 2);  // and depth
  moontrace_page* last = nullptr;
  ASSERT_EQ(moontrace_page_open(open.text, facts.pages - 1, &last), MOONTRACE_DONE);
  EXPECT_EQ(moontrace_page_close(last), MOONTRACE_DONE);
}

TEST(LibraryText, TakesDepthAndRoundingWithTheWidth) {
  auto style = Sized<moontrace_style>();
  style.width = 2 * 0.1165 * 0.012;  // twice what is usual at 12 mm
  const OpenPage open("moon", &style);
  auto facts = Sized<moontrace_text_facts>();
  ASSERT_EQ(moontrace_text_describe(open.text, &facts), MOONTRACE_DONE);
  EXPECT_DOUBLE_EQ(facts.depth, 0.1165 * 0.012);  // twice what is usual
}

TEST(LibraryText, HasEveryFormOfTheStyle) {
  auto style = Sized<moontrace_style>();
  style.embossed = style.rules = style.raised_margin = style.structure = 1;
  style.lines = "alternate";
  style.links = "letters";
  style.only = "abc+th";
  style.h_form = "arc";
  style.grade = 1;
  style.margin = 0.02;
  const OpenPage open("# the cab\nabc abc", &style);
  auto facts = Sized<moontrace_page_facts>();
  ASSERT_EQ(moontrace_page_describe(open.page, &facts), MOONTRACE_DONE);
  EXPECT_GT(facts.greatest_rise, 0);
}

TEST(LibrarySample, IsThatOfTheRoomsToTheLastBit) {
  const Reference reference;
  const OpenPage open(kWords);
  std::size_t touched = 0;
  for (const glm::dvec2 p : Points(20000)) {
    double sample[3] = {9, 9, 9};
    ASSERT_EQ(moontrace_sample(open.page, p.x, p.y, sample), MOONTRACE_DONE);
    const Sample expected = reference.field.SampleAt(p);
    ASSERT_EQ(sample[0], expected.displacement);
    ASSERT_EQ(sample[1], expected.gradient.x);
    ASSERT_EQ(sample[2], expected.gradient.y);
    touched += sample[0] < 0;
  }
  EXPECT_GT(touched, 500u);
}

/// Samples by the array call, wherever their numbers lie.
void ExpectSamples(const moontrace_page* page, moontrace_samples given) {
  given.size = sizeof given;
  ASSERT_EQ(moontrace_sample_many(page, &given), MOONTRACE_DONE) << moontrace_message();
  const auto at = [](const void* first, std::ptrdiff_t step, std::size_t i) {
    double value = 0;
    std::memcpy(&value, static_cast<const char*>(first) + static_cast<std::ptrdiff_t>(i) * step,
                sizeof value);
    return value;
  };
  for (std::size_t i = 0; i < given.count; ++i) {
    double sample[3];
    const double x = at(given.x, given.x_step, i), y = at(given.y, given.y_step, i);
    ASSERT_EQ(moontrace_sample(page, x, y, sample), MOONTRACE_DONE);
    if (given.displacement) {
      ASSERT_EQ(at(given.displacement, given.displacement_step, i), sample[0]) << i;
    }
    if (given.gradient_x) {
      ASSERT_EQ(at(given.gradient_x, given.gradient_x_step, i), sample[1]) << i;
    }
    if (given.gradient_y) {
      ASSERT_EQ(at(given.gradient_y, given.gradient_y_step, i), sample[2]) << i;
    }
  }
}

constexpr std::ptrdiff_t kWide = sizeof(double);

TEST(LibrarySampleMany, AgreesWithSinglePointsSideBySide) {
  const OpenPage open(kWords);
  const std::vector<glm::dvec2> points = Points(10000);  // more than are done at a time
  std::vector<double> out(3 * points.size(), 9);
  moontrace_samples given{};
  given.count = points.size();
  given.x = &points[0].x;
  given.y = &points[0].y;
  given.x_step = given.y_step = 2 * kWide;
  given.displacement = out.data();
  given.gradient_x = out.data() + 1;
  given.gradient_y = out.data() + 2;
  given.displacement_step = given.gradient_x_step = given.gradient_y_step = 3 * kWide;
  ExpectSamples(open.page, given);
}

TEST(LibrarySampleMany, AgreesInArraysOfTheirOwn) {
  const OpenPage open(kWords);
  constexpr std::size_t kCount = 10000;  // more than are done at a time
  std::vector<double> x, y, height(kCount, 9), slope_x(kCount, 9), slope_y(kCount, 9);
  for (const glm::dvec2 p : Points(kCount)) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  moontrace_samples given{};
  given.count = kCount;
  given.x = x.data();
  given.y = y.data();
  given.displacement = height.data();
  given.gradient_x = slope_x.data();
  given.gradient_y = slope_y.data();
  given.x_step = given.y_step = kWide;
  given.displacement_step = given.gradient_x_step = given.gradient_y_step = kWide;
  ExpectSamples(open.page, given);
}

TEST(LibrarySampleMany, AgreesInArraysOfTheirOwnThatRunBack) {
  const OpenPage open(kWords);
  std::vector<double> x, y, height(3000, 9), slope(3000, 9);
  for (const glm::dvec2 p : Points(height.size())) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  moontrace_samples given{};
  given.count = x.size();
  given.x = &x.back();
  given.x_step = -kWide;
  given.y = y.data();
  given.y_step = kWide;
  given.displacement = &height.back();
  given.displacement_step = -kWide;
  given.gradient_y = slope.data();  // and no gradient_x
  given.gradient_y_step = kWide;
  ExpectSamples(open.page, given);
}

TEST(LibrarySampleMany, TakesOneHeightForAllAndAnyAddress) {
  const OpenPage open(kWords);
  const std::size_t count = 2000;
  std::vector<char> bytes(count * 9 + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 0.015 + 0.00009 * static_cast<double>(i);
    std::memcpy(bytes.data() + 1 + 9 * i, &x, sizeof x);
  }
  const double y = 0.272;  // through the first line's letters
  std::vector<char> out(count * 11 + 3);
  moontrace_samples given{};
  given.count = count;
  given.x = reinterpret_cast<const double*>(bytes.data() + 1);
  given.x_step = 9;
  given.y = &y;
  given.displacement = reinterpret_cast<double*>(out.data() + 3);
  given.displacement_step = 11;
  ExpectSamples(open.page, given);
}

TEST(LibraryForce, IsThatOfASpringOnFlatPaper) {
  const OpenPage open(kWords);
  double force[3];
  ASSERT_EQ(moontrace_force(open.page, nullptr, 0.005, 0.005, -0.0007, force), MOONTRACE_DONE);
  EXPECT_EQ(force[0], 0);
  EXPECT_EQ(force[1], 0);
  EXPECT_NEAR(force[2], 0.7, 1e-15);  // 1000 N/m times 0.7 mm
  ASSERT_EQ(moontrace_force(open.page, nullptr, 0.005, 0.005, 0.0001, force), MOONTRACE_DONE);
  EXPECT_EQ(force[2], 0);
  auto surface = Sized<moontrace_surface>();
  surface.law = 1;
  surface.stiffness = 500;
  surface.force_cap = 0.2;
  ASSERT_EQ(moontrace_force(open.page, &surface, 0.005, 0.005, -0.0007, force), MOONTRACE_DONE);
  EXPECT_EQ(force[2], 0.2);  // cut off: 500 N/m would give 0.35 N
}

TEST(LibraryForceMany, AgreesWithSinglePointsAndWithTheRooms) {
  const Reference reference;
  const OpenPage open(kWords);
  const std::vector<glm::dvec2> points = Points(5000);
  std::vector<double> z, force(3 * points.size(), 9);
  for (std::size_t i = 0; i < points.size(); ++i) {
    z.push_back(1e-6 * (static_cast<double>(i % 1500) - 1200));
  }
  auto given = Sized<moontrace_forces>();
  given.count = points.size();
  given.x = &points[0].x;
  given.y = &points[0].y;
  given.x_step = given.y_step = 2 * kWide;
  given.z = z.data();
  given.z_step = kWide;
  given.force_x = force.data();
  given.force_y = force.data() + 1;
  given.force_z = force.data() + 2;
  given.force_x_step = given.force_y_step = given.force_z_step = 3 * kWide;
  for (const std::uint32_t law : {0u, 1u}) {
    auto surface = Sized<moontrace_surface>();
    surface.law = law;
    ASSERT_EQ(moontrace_force_many(open.page, &surface, &given), MOONTRACE_DONE);
    const SurfaceLaw same =
        LawOf({.law = law == 1 ? ForceLaw::kPaper : ForceLaw::kPotential}, reference.field);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double one[3];
      ASSERT_EQ(moontrace_force(open.page, &surface, points[i].x, points[i].y, z[i], one),
                MOONTRACE_DONE);
      const glm::dvec3 expected =
          Touch(same, reference.field, {points[i].x, points[i].y, z[i]}).force_P;
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(one[k], expected[k]);
        ASSERT_EQ(force[3 * i + static_cast<std::size_t>(k)], expected[k]);
      }
    }
  }
}

std::string BytesOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(LibraryPicture, IsThatOfTheProgram) {
  const Reference reference;
  const OpenPage open(kWords);
  const fs::path folder =
      fs::temp_directory_path() / ("moontrace-library-" + std::to_string(getpid()));
  fs::create_directories(folder);
  for (const bool print : {false, true}) {
    const fs::path svg = folder / "page.svg";
    ASSERT_EQ(moontrace_page_draw(open.page, svg.c_str(), print ? MOONTRACE_PRINT : 0),
              MOONTRACE_DONE)
        << moontrace_message();
    EXPECT_EQ(BytesOf(svg), ToSvg(PagePicture(reference.set.pages.front(), {}, reference.set,
                                              reference.script, kWords, print)));
  }
  for (const char* name : {"page.pdf", "page.png"}) {
    const int answer = moontrace_page_draw(open.page, (folder / name).c_str(), 0);
    if (answer == MOONTRACE_LACKING) continue;  // built without cairo
    ASSERT_EQ(answer, MOONTRACE_DONE) << moontrace_message();
    EXPECT_EQ(BytesOf(folder / name).substr(1, 3), std::string(name) == "page.pdf" ? "PDF" : "PNG");
  }
  fs::remove_all(folder);
}

TEST(LibraryHandles, OutliveWhatTheyWereMadeOf) {
  OpenPage open(kWords);
  double before[3], after[3];
  ASSERT_EQ(moontrace_sample(open.page, 0.02, 0.275, before), MOONTRACE_DONE);
  ASSERT_EQ(moontrace_script_close(open.script), MOONTRACE_DONE);
  ASSERT_EQ(moontrace_text_close(open.text), MOONTRACE_DONE);
  ASSERT_EQ(moontrace_sample(open.page, 0.02, 0.275, after), MOONTRACE_DONE);
  EXPECT_EQ(std::memcmp(before, after, sizeof before), 0);
  auto letter = Sized<moontrace_letter>();
  ASSERT_EQ(moontrace_page_letter(open.page, 0, &letter), MOONTRACE_DONE);
  EXPECT_STREQ(letter.sign, "th");  // alone for "the", at grade 1
}

TEST(LibraryVersion, IsServedByThisLibrary) {
  EXPECT_EQ(moontrace_check(MOONTRACE_INTERFACE), MOONTRACE_DONE);
  EXPECT_EQ(moontrace_check(1), MOONTRACE_DONE);  // the first, as long as the soname is 0
  EXPECT_STRNE(moontrace_version(), "");
}

}  // namespace
}  // namespace moontrace

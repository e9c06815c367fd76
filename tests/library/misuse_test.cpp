// What callers do wrong is answered by a code and a sentence, never by a crash.
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "tests/library/library_fixture.h"

namespace moontrace {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The answer and that the message has these words.
void ExpectRefused(int answer, int code, const char* words) {
  EXPECT_EQ(answer, code) << words;
  EXPECT_NE(std::string(moontrace_message()).find(words), std::string::npos) << moontrace_message();
}
void ExpectBadCall(int answer, const char* words) {
  ExpectRefused(answer, MOONTRACE_BAD_CALL, words);
}

TEST(LibraryMisuse, NullIsRefusedEverywhere) {
  const OpenPage open("moon");
  moontrace_script* script = nullptr;
  moontrace_text* text = nullptr;
  moontrace_page* page = nullptr;
  double three[3];
  ExpectBadCall(moontrace_script_open(nullptr, nullptr, &script), "name_or_path is NULL");
  ExpectBadCall(moontrace_script_open("moon", nullptr, nullptr), "script is NULL");
  ExpectBadCall(moontrace_script_describe(open.script, nullptr), "facts is NULL");
  auto script_facts = Sized<moontrace_script_facts>();
  ExpectBadCall(moontrace_script_describe(nullptr, &script_facts), "script is NULL");
  ExpectBadCall(moontrace_text_open(nullptr, "moon", nullptr, &text), "script is NULL");
  ExpectBadCall(moontrace_text_open(open.script, nullptr, nullptr, &text), "text is NULL");
  ExpectBadCall(moontrace_text_open(open.script, "moon", nullptr, nullptr), "set is NULL");
  auto text_facts = Sized<moontrace_text_facts>();
  ExpectBadCall(moontrace_text_describe(nullptr, &text_facts), "text is NULL");
  ExpectBadCall(moontrace_text_describe(open.text, nullptr), "facts is NULL");
  ExpectBadCall(moontrace_page_open(nullptr, 0, &page), "text is NULL");
  ExpectBadCall(moontrace_page_open(open.text, 0, nullptr), "page is NULL");
  auto page_facts = Sized<moontrace_page_facts>();
  ExpectBadCall(moontrace_page_describe(nullptr, &page_facts), "page is NULL");
  ExpectBadCall(moontrace_page_describe(open.page, nullptr), "facts is NULL");
  auto letter = Sized<moontrace_letter>();
  ExpectBadCall(moontrace_page_letter(nullptr, 0, &letter), "page is NULL");
  ExpectBadCall(moontrace_page_letter(open.page, 0, nullptr), "letter is NULL");
  ExpectBadCall(moontrace_page_draw(nullptr, "a.svg", 0), "page is NULL");
  ExpectBadCall(moontrace_page_draw(open.page, nullptr, 0), "path is NULL");
  ExpectBadCall(moontrace_sample(nullptr, 0, 0, three), "page is NULL");
  ExpectBadCall(moontrace_sample(open.page, 0, 0, nullptr), "sample is NULL");
  ExpectBadCall(moontrace_force(nullptr, nullptr, 0, 0, 0, three), "page is NULL");
  ExpectBadCall(moontrace_force(open.page, nullptr, 0, 0, 0, nullptr), "force is NULL");
  ExpectBadCall(moontrace_sample_many(open.page, nullptr), "samples is NULL");
  ExpectBadCall(moontrace_force_many(open.page, nullptr, nullptr), "forces is NULL");
  auto samples = Sized<moontrace_samples>();
  ExpectBadCall(moontrace_sample_many(nullptr, &samples), "page is NULL");
  EXPECT_EQ(moontrace_sample_many(open.page, &samples), MOONTRACE_DONE);  // of no points
  samples.count = 1;
  ExpectBadCall(moontrace_sample_many(open.page, &samples), " is NULL");
  auto forces = Sized<moontrace_forces>();
  ExpectBadCall(moontrace_force_many(nullptr, nullptr, &forces), "page is NULL");
  forces.count = 1;
  forces.x = forces.y = three;
  ExpectBadCall(moontrace_force_many(open.page, nullptr, &forces), "forces.z is NULL");
  EXPECT_EQ(moontrace_script_close(nullptr), MOONTRACE_DONE);
  EXPECT_EQ(moontrace_text_close(nullptr), MOONTRACE_DONE);
  EXPECT_EQ(moontrace_page_close(nullptr), MOONTRACE_DONE);
}

TEST(LibraryMisuse, ANumberThatIsNoneIsRefused) {
  const OpenPage open("moon");
  for (const double bad : {kNan, kInfinite, -kInfinite}) {
    double three[3] = {9, 9, 9};
    ExpectBadCall(moontrace_sample(open.page, bad, 0, three), "x is not a finite number");
    EXPECT_EQ(three[0] + three[1] + three[2], 0);
    ExpectBadCall(moontrace_sample(open.page, 0, bad, three), "y is not a finite number");
    ExpectBadCall(moontrace_force(open.page, nullptr, 0, 0, bad, three),
                  "z is not a finite number");
    auto surface = Sized<moontrace_surface>();
    surface.stiffness = bad;
    ExpectBadCall(moontrace_force(open.page, &surface, 0, 0, 0, three), "surface.stiffness is");
    auto style = Sized<moontrace_style>();
    double* const lengths[] = {&style.margin,     &style.letter_size, &style.width,
                               &style.depth,      &style.rounding,    &style.letter_gap,
                               &style.line_pitch, &style.word_gap,    &style.grade};
    for (double* length : lengths) {
      *length = bad;
      moontrace_text* text = nullptr;
      ExpectBadCall(moontrace_text_open(open.script, "moon", &style, &text), "style.");
      EXPECT_EQ(text, nullptr);
      *length = 0;
    }
  }
}

TEST(LibraryMisuse, OneBadPointOfManyIsNamedAndTheOthersAreDone) {
  const OpenPage open("moon");
  std::vector<double> xy(2 * 1500, 0.1), out(1500, 9);
  xy[2 * 700 + 1] = kNan;
  xy[2 * 1400] = kInfinite;
  auto samples = Sized<moontrace_samples>();
  samples.count = out.size();
  samples.x = xy.data();
  samples.y = xy.data() + 1;
  samples.x_step = samples.y_step = 2 * sizeof(double);
  samples.displacement = out.data();
  samples.displacement_step = sizeof(double);
  ExpectBadCall(moontrace_sample_many(open.page, &samples), "point 700 is not finite");
  for (const double height : out) EXPECT_EQ(height, 0);  // (0.1, 0.1) lies off the letters

  std::vector<double> z(1500, -0.001);
  z[3] = kNan;
  auto forces = Sized<moontrace_forces>();
  forces.count = out.size();
  forces.x = xy.data();
  forces.y = xy.data() + 1;
  forces.x_step = forces.y_step = 2 * sizeof(double);
  forces.z = z.data();
  forces.z_step = sizeof(double);
  forces.force_z = out.data();
  forces.force_z_step = sizeof(double);
  ExpectBadCall(moontrace_force_many(open.page, nullptr, &forces), "point 3 is not finite");
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(out[i], i == 3 || i == 700 || i == 1400 ? 0 : 1) << i;  // 1000 N/m times 1 mm
  }
}

// Points are done some thousand at a time.
TEST(LibraryMisuse, ABadPointFarOnIsNamedByItsNumber) {
  const OpenPage open("moon");
  std::vector<double> x(10000, 0.1), y = x, height(x.size(), 9), slope_x = height, slope_y = height;
  y[9000] = kNan;
  auto samples = Sized<moontrace_samples>();
  samples.count = x.size();
  samples.x = x.data();
  samples.y = y.data();
  samples.displacement = height.data();
  samples.gradient_x = slope_x.data();
  samples.gradient_y = slope_y.data();
  samples.x_step = samples.y_step = sizeof(double);
  samples.displacement_step = samples.gradient_x_step = samples.gradient_y_step = sizeof(double);
  ExpectBadCall(moontrace_sample_many(open.page, &samples), "point 9000 is not finite");
  for (const double value : height) EXPECT_EQ(value, 0);
}

TEST(LibraryMisuse, PointsAsFarAsNumbersGoAreNone) {
  const OpenPage open("moon");
  const std::vector<double> far(32, std::numeric_limits<double>::max());  // their sum is infinite
  std::vector<double> out(far.size(), 9);
  auto samples = Sized<moontrace_samples>();
  samples.count = far.size();
  samples.x = samples.y = far.data();
  samples.x_step = samples.y_step = sizeof(double);
  samples.displacement = out.data();
  samples.displacement_step = sizeof(double);
  EXPECT_EQ(moontrace_sample_many(open.page, &samples), MOONTRACE_DONE);
  for (const double height : out) EXPECT_EQ(height, 0);
}

TEST(LibraryMisuse, ArraysThatCannotBeAreRefused) {
  const OpenPage open("moon");
  double number = 0, out[2] = {};
  auto samples = Sized<moontrace_samples>();
  samples.count = std::numeric_limits<std::size_t>::max() / 4;
  samples.x = samples.y = &number;
  samples.x_step = 16;
  ExpectBadCall(moontrace_sample_many(open.page, &samples), "longer than any memory");
  samples.x_step = std::numeric_limits<std::ptrdiff_t>::min();
  samples.count = 2;
  ExpectBadCall(moontrace_sample_many(open.page, &samples), "longer than any memory");
  samples.x_step = 0;
  samples.displacement = out;
  samples.displacement_step = 4;
  ExpectBadCall(moontrace_sample_many(open.page, &samples), "less than a number's width");
}

/// Sizes that no struct can have that is `whole` long.
std::vector<std::uint32_t> WrongSizes(std::size_t whole) {
  return {0, 4, static_cast<std::uint32_t>(whole) - 1, std::numeric_limits<std::uint32_t>::max()};
}

TEST(LibraryMisuse, AStructOfAWrongSizeIsRefused) {
  const OpenPage open("moon");
  moontrace_text* text = nullptr;
  moontrace_style style{};
  for (const std::uint32_t size : WrongSizes(sizeof style)) {
    style.size = size;
    ExpectBadCall(moontrace_text_open(open.script, "moon", &style, &text), "style.size is");
  }
  moontrace_letter letter{};
  for (const std::uint32_t size : WrongSizes(sizeof letter)) {
    letter.size = size;
    ExpectBadCall(moontrace_page_letter(open.page, 0, &letter), "letter.size is");
    EXPECT_EQ(letter.sign, nullptr);
  }
  moontrace_samples samples{};
  for (const std::uint32_t size : WrongSizes(sizeof samples)) {
    samples.size = size;
    ExpectBadCall(moontrace_sample_many(open.page, &samples), "samples.size is");
  }
}

// A program made for a later version, whose structs are longer: it is served as long as it asks for
// nothing that this library does not know.
TEST(LibraryMisuse, ALongerStructIsTakenIfItsEndIsZero) {
  const OpenPage open("moon");
  struct Later {
    moontrace_style style;
    double more[4];
  } later{};
  later.style.size = sizeof later;
  moontrace_text* text = nullptr;
  ASSERT_EQ(moontrace_text_open(open.script, "moon", &later.style, &text), MOONTRACE_DONE);
  EXPECT_EQ(moontrace_text_close(text), MOONTRACE_DONE);
  later.more[3] = 1;
  ExpectBadCall(moontrace_text_open(open.script, "moon", &later.style, &text), "does not know");
}

TEST(LibraryMisuse, AnotherVersionIsRefused) {
  ExpectBadCall(moontrace_check(0), "made for interface 0");
  ExpectBadCall(moontrace_check(MOONTRACE_INTERFACE + 1), "the library has");
}

TEST(LibraryMisuse, AHandleThatIsClosedOrOfAnotherKindIsRefused) {
  moontrace_page* page = nullptr;
  double three[3];
  {
    const OpenPage open("moon");
    page = open.page;
    auto* as_page = reinterpret_cast<moontrace_page*>(open.text);
    ExpectBadCall(moontrace_sample(as_page, 0, 0, three), "no page that is open");
    ExpectBadCall(moontrace_page_close(as_page), "no page that is open");
  }
  ExpectBadCall(moontrace_sample(page, 0, 0, three), "no page that is open");
  ExpectBadCall(moontrace_page_close(page), "no page that is open");
  const OpenPage next("moon");  // takes the place, not the handle
  ExpectBadCall(moontrace_sample(page, 0, 0, three), "no page that is open");
  // what never was one: addresses, and any bits of a place that is not taken
  int there = 0;
  ExpectBadCall(moontrace_sample(reinterpret_cast<moontrace_page*>(&there), 0, 0, three),
                "no page");
  for (int shift = 0; shift < 64; ++shift) {
    auto* any = reinterpret_cast<moontrace_page*>(std::uintptr_t{1} << shift | 0x3FF3);
    ExpectBadCall(moontrace_sample(any, 0, 0, three), "no page");
  }
}

TEST(LibraryMisuse, NumbersAndWordsOutOfRangeAreRefused) {
  const OpenPage open("moon");
  moontrace_page* page = nullptr;
  ExpectBadCall(moontrace_page_open(open.text, 1, &page), "no page 1, the text has 1");
  auto letter = Sized<moontrace_letter>();
  ExpectBadCall(moontrace_page_letter(open.page, 4, &letter), "no letter 4, the page has 4");
  ExpectBadCall(moontrace_page_draw(open.page, "page.svg", 2), "flags");
  moontrace_text* text = nullptr;
  auto style = Sized<moontrace_style>();
  style.lines = "sideways";
  ExpectBadCall(moontrace_text_open(open.script, "moon", &style, &text), "left-to-right");
  style.lines = nullptr;
  style.embossed = 2;
  ExpectBadCall(moontrace_text_open(open.script, "moon", &style, &text), "neither 0 nor 1");
  style.embossed = 0;
  style.width = -0.001;
  ExpectBadCall(moontrace_text_open(open.script, "moon", &style, &text), "style.width is below 0");
}

TEST(LibraryMisuse, BadInputIsToldFromABadCall) {
  const OpenPage open("moon");
  moontrace_script* script = nullptr;
  moontrace_text* text = nullptr;
  ExpectRefused(moontrace_script_open("mooon", nullptr, &script), MOONTRACE_BAD_INPUT, "moon");
  ExpectRefused(moontrace_text_open(open.script, "", nullptr, &text), MOONTRACE_BAD_INPUT, "");
  ExpectRefused(moontrace_text_open(open.script, "\xFF", nullptr, &text), MOONTRACE_BAD_INPUT, "");
  auto style = Sized<moontrace_style>();
  style.width = 0.011;  // of letters 12 mm high
  ExpectRefused(moontrace_text_open(open.script, "moon", &style, &text), MOONTRACE_BAD_INPUT, "");
  style = Sized<moontrace_style>();
  style.sheet = "letter";
  ExpectRefused(moontrace_text_open(open.script, "moon", &style, &text), MOONTRACE_BAD_INPUT,
                "letter");
  ExpectRefused(moontrace_page_draw(open.page, "page.gif", 0), MOONTRACE_BAD_INPUT, ".svg");
  ExpectRefused(moontrace_page_draw(open.page, "/no/such/folder/page.svg", 0), MOONTRACE_LACKING,
                "/no/such/folder");
}

TEST(LibraryMessages, AreOneThreadsOwn) {
  ExpectBadCall(moontrace_check(0), "interface 0");
  std::thread([] {
    EXPECT_STREQ(moontrace_message(), "");
    ExpectBadCall(moontrace_check(77), "interface 77");
  }).join();
  EXPECT_NE(std::string(moontrace_message()).find("interface 0"), std::string::npos);
}

TEST(LibraryThreads, OfTwoThatCloseAHandleOneIsRefused) {
  const OpenPage open("moon");
  for (int turn = 0; turn < 200; ++turn) {
    moontrace_page* page = nullptr;
    ASSERT_EQ(moontrace_page_open(open.text, 0, &page), MOONTRACE_DONE);
    std::atomic<int> ready{0}, closed{0}, refused{0};
    const auto close = [&] {
      ++ready;
      while (ready < 2) std::this_thread::yield();
      ++(moontrace_page_close(page) == MOONTRACE_DONE ? closed : refused);
    };
    std::thread other(close);
    close();
    other.join();
    ASSERT_EQ(closed, 1);
    ASSERT_EQ(refused, 1);
  }
}

// Closed under the other thread's hands: what it asks is answered rightly or refused.
TEST(LibraryThreads, APageMayBeClosedWhileItIsSampled) {
  const OpenPage open("moon");
  for (int turn = 0; turn < 50; ++turn) {
    moontrace_page* page = nullptr;
    ASSERT_EQ(moontrace_page_open(open.text, 0, &page), MOONTRACE_DONE);
    std::atomic<bool> begun{false};
    std::thread other([&] {
      double force[3];
      int answer = MOONTRACE_DONE;
      while (answer == MOONTRACE_DONE) {
        answer = moontrace_force(page, nullptr, 0.005, 0.005, -0.001, force);
        if (answer == MOONTRACE_DONE) {
          EXPECT_EQ(force[2], 1);
        }
        begun = true;
      }
      EXPECT_EQ(answer, MOONTRACE_BAD_CALL);
    });
    while (!begun) std::this_thread::yield();
    EXPECT_EQ(moontrace_page_close(page), MOONTRACE_DONE);
    other.join();
  }
}

}  // namespace
}  // namespace moontrace

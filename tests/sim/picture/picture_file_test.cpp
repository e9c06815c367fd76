#include "sim/picture/picture_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/picture/cairo_writer.h"
#include "sim/picture/svg_writer.h"
#include "tests/sim/cli_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

Drawing Sample() {
  Drawing drawing;
  drawing.width = 100;
  drawing.height = 50;
  drawing.title = "A & B <C>";
  drawing.description = "Words.";
  PathMark path;
  path.subpaths = {
      {Line{{10, 10}, {20, 10}}, Arc{{20, 15}, 5, -std::numbers::pi / 2, std::numbers::pi}}};
  path.stroke = Color{1, 0, 0};
  path.width = 2;
  drawing.marks.emplace_back(path);
  return drawing;
}

TEST(ToSvg, TurnsYOverAndKeepsArcs) {
  const std::string svg = ToSvg(Sample());
  // (10, 10) above the lower edge is 40 below the upper; half a circle up to (20, 20).
  EXPECT_NE(svg.find("M10 40L20 40A5 5 0 0 0 20 30"), std::string::npos) << svg;
  EXPECT_NE(svg.find("stroke=\"#ff0000\" stroke-width=\"2\" stroke-linecap=\"round\""),
            std::string::npos);
}

TEST(ToSvg, EscapesWords) {
  const std::string svg = ToSvg(Sample());
  EXPECT_NE(svg.find("<title>A &amp; B &lt;C&gt;</title>"), std::string::npos);
  EXPECT_NE(svg.find("<desc>Words.</desc>"), std::string::npos);
}

TEST(ToSvg, DrawsAWholeCircleInTwoHalves) {
  Drawing drawing;
  drawing.width = drawing.height = 20;
  PathMark ring;
  ring.subpaths = {{Arc{{10, 10}, 5, 0, 2 * std::numbers::pi}}};
  ring.fill = Color{};
  drawing.marks.emplace_back(ring);
  EXPECT_NE(ToSvg(drawing).find("M15 10A5 5 0 0 0 5 10A5 5 0 0 0 15 10Z"), std::string::npos)
      << ToSvg(drawing);
}

TEST(TextBlock, BreaksWordsToTheWidth) {
  // 0.75 heights a character: 15 mm hold 10 characters of 2 mm.
  const std::vector<TextMark> lines = TextBlock("aaaa bbbb cccc", {1, 40}, 15, 2, {});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].text, "aaaa bbbb");
  EXPECT_DOUBLE_EQ(lines[0].at.y, 38.0);
  EXPECT_DOUBLE_EQ(lines[1].at.y, 38.0 - 1.7 * 2);
}

class PictureFile : public CliTest {};

TEST_F(PictureFile, PngHasThreeHundredDotsAnInch) {
  if (!HaveCairo()) GTEST_SKIP() << "built without cairo";
  WritePicture(In("p.png"), Sample());
  const std::string png = ReadAll(In("p.png"));
  ASSERT_GT(png.size(), 24U);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  const auto big_endian = [&png](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = 256 * value + static_cast<unsigned char>(png[at + i]);
    return value;
  };
  EXPECT_EQ(big_endian(16), 1181U);  // 100 mm / 25.4 x 300
  EXPECT_EQ(big_endian(20), 591U);
  ExpectOnly({"p.png"});
}

TEST_F(PictureFile, PngOfASheetHasItsTrueSize) {
  if (!HaveCairo()) GTEST_SKIP() << "built without cairo";
  Drawing sheet;
  sheet.width = 210;
  sheet.height = 297;
  WritePicture(In("a4.png"), sheet);
  const std::string png = ReadAll(In("a4.png"));
  const auto number = [&png](std::size_t at) {
    double value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = 256 * value + static_cast<unsigned char>(png.at(at + i));
    return value;
  };
  const std::size_t chunk = png.find("pHYs");
  ASSERT_NE(chunk, std::string::npos);
  EXPECT_LT(chunk, png.find("IDAT"));
  const double pixel_mm = 1000 / number(chunk + 4);
  EXPECT_EQ(number(chunk + 8), number(chunk + 4));
  EXPECT_EQ(png.at(chunk + 12), 1);  // of a metre
  EXPECT_NEAR(number(16) * pixel_mm, 210, pixel_mm / 2);
  EXPECT_NEAR(number(20) * pixel_mm, 297, pixel_mm / 2);
  // the check of these nine bytes at 300 dots an inch, by zlib's crc32
  EXPECT_EQ(number(chunk + 4), 11811);
  EXPECT_EQ(number(chunk + 13), 0x78A53F76);
}

TEST_F(PictureFile, PdfHasTheTrueSize) {
  if (!HaveCairo()) GTEST_SKIP() << "built without cairo";
  WritePicture(In("p.pdf"), Sample());
  const std::string pdf = ReadAll(In("p.pdf"));
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_NE(pdf.find("283.46"), std::string::npos);  // 100 mm in points
}

TEST_F(PictureFile, WithoutCairoOneSentenceSaysSo) {
  if (HaveCairo()) GTEST_SKIP() << "built with cairo";
  EXPECT_THROW(CheckPicturePath(In("p.png")), LackError);
  EXPECT_NO_THROW(CheckPicturePath(In("p.svg")));
}

TEST_F(PictureFile, RefusesOtherEndingsAndUnwritablePlaces) {
  EXPECT_THROW(CheckPicturePath(In("p.gif")), InputError);
  EXPECT_THROW(CheckPicturePath(In("p")), InputError);
  EXPECT_THROW(CheckPicturePath(In("no/such/folder/p.svg")), LackError);
  EXPECT_THROW(WritePicture(In("no/such/folder/p.svg"), Sample()), LackError);
  std::filesystem::create_directory(In("folder.svg"));
  EXPECT_THROW(CheckPicturePath(In("folder.svg")), LackError);
  EXPECT_THROW(WritePicture(In("folder.svg"), Sample()), LackError);
  ExpectOnly({"folder.svg"});
}

TEST_F(PictureFile, FullDiskLeavesNothing) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  WriteAll(In("p.svg"), "kept");
  std::filesystem::create_symlink("/dev/full", In("p.svg.partial"));
  EXPECT_THROW(WritePicture(In("p.svg"), Sample()), LackError);
  EXPECT_EQ(ReadAll(In("p.svg")), "kept");
  ExpectOnly({"p.svg"});
}

TEST_F(PictureFile, CheckLeavesNothingBehind) {
  CheckPicturePath(In("p.svg"));
  ExpectOnly({});
}

TEST_F(PictureFile, NumbersOnlySeveralFiles) {
  PagePictures one(In("a.svg"), 1);
  one.Add(Sample());
  EXPECT_EQ(one.Finish(), std::vector<std::string>{In("a.svg")});
  PagePictures two(In("b.c.svg"), 2);
  two.Add(Sample());
  two.Add(Sample());
  EXPECT_EQ(two.Finish(), (std::vector<std::string>{In("b.c-1.svg"), In("b.c-2.svg")}));
  EXPECT_THROW(PagePictures(In("p.svg"), 101), InputError);
  ExpectOnly({"a.svg", "b.c-1.svg", "b.c-2.svg"});
}

std::size_t PagesOf(const std::string& pdf) {
  std::size_t pages = 0;
  for (std::size_t at = 0; (at = pdf.find("/Type /Page", at)) != std::string::npos; ++at) {
    pages += pdf[at + 11] != 's' ? 1 : 0;  // "/Pages" is their tree
  }
  return pages;
}

TEST_F(PictureFile, APdfHoldsAllPagesEachOfItsSize) {
  if (!HaveCairo()) GTEST_SKIP() << "built without cairo";
  PagePictures pages(In("p.pdf"), 300);
  Drawing wide = Sample();
  wide.width = 400;
  for (int i = 0; i < 300; ++i) pages.Add(i == 7 ? wide : Sample());
  ExpectOnly({"p.pdf.partial"});
  EXPECT_EQ(pages.Finish(), std::vector<std::string>{In("p.pdf")});
  ExpectOnly({"p.pdf"});
  const std::string pdf = ReadAll(In("p.pdf"));
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_EQ(PagesOf(pdf), 300U);
  EXPECT_NE(pdf.find("283.46"), std::string::npos);   // 100 mm in points
  EXPECT_NE(pdf.find("1133.85"), std::string::npos);  // 400 mm
}

TEST_F(PictureFile, APdfThatIsNotFinishedLeavesNothing) {
  if (!HaveCairo()) GTEST_SKIP() << "built without cairo";
  {
    PagePictures pages(In("p.pdf"), 2);
    pages.Add(Sample());
  }
  ExpectOnly({});
}

}  // namespace
}  // namespace moontrace

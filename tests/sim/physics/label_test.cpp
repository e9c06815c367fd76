#include "sim/physics/label.h"

#include <glm/vec2.hpp>

#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

Label Parse(const std::string& data) { return ParseLabel("moontrace:page", data, "m.xml"); }
std::string Failure(const std::string& data) {
  return ErrorOf([&] { Parse(data); });
}

TEST(Label, ReadsEveryKeyInTheUnitsOfItsName) {
  const Label label = Parse(
      "{text='MUG', size_mm=10, at_mm=[5, -2.5], width_mm=1.2, depth_mm=0.5, rounding_mm=0.2, "
      "embossed=true, script='moon', h_form='arc', grade=0.5, table='de-g2.ctb', "
      "punctuation='older'}");
  EXPECT_EQ(label.geom, "page");
  EXPECT_EQ(label.text, "MUG");
  EXPECT_EQ(label.at, glm::dvec2(5 * 0.001, -2.5 * 0.001));
  EXPECT_DOUBLE_EQ(label.size.value(), 0.010);
  EXPECT_DOUBLE_EQ(label.width.value(), 0.0012);
  EXPECT_DOUBLE_EQ(label.depth.value(), 0.0005);
  EXPECT_DOUBLE_EQ(label.rounding.value(), 0.0002);
  EXPECT_TRUE(label.embossed.value());
  EXPECT_EQ(label.script.value(), "moon");
  EXPECT_EQ(label.h_form.value(), "arc");
  EXPECT_EQ(label.older_punctuation, true);
  EXPECT_EQ(label.grade.value(), 0.5);
  EXPECT_EQ(label.table.value(), "de-g2.ctb");
}

TEST(Label, ReadsFormAndStructure) {
  const Label label = Parse(
      "{text='# A', slant_deg=-15, stretch=1.2, structure=true, heading_scale=2, "
      "heading_embossed=true, structure_texture=false}");
  EXPECT_NEAR(label.slant.value(), -0.2617993877991494, 1e-15);  // 15 degrees in radians
  EXPECT_EQ(label.stretch.value(), 1.2);
  EXPECT_TRUE(label.structure.value());
  EXPECT_EQ(label.heading_scale.value(), 2);
  EXPECT_TRUE(label.heading_embossed.value());
  EXPECT_FALSE(label.structure_texture.value());
}

TEST(Label, LeavesAbsentKeysToTheProgram) {
  const Label label = Parse("{}");
  EXPECT_EQ(label.text, "");
  EXPECT_EQ(label.at, glm::dvec2(0, 0));
  EXPECT_FALSE(label.size || label.width || label.depth || label.rounding || label.embossed ||
               label.script || label.h_form || label.grade || label.table);
}

TEST(Label, TakesANumberAfterTheLastColon) {
  EXPECT_EQ(ParseLabel("moontrace:mug:2", "{}", "m").geom, "mug");
  EXPECT_EQ(ParseLabel("moontrace:mug:2", "{}", "m").number, 2);
  EXPECT_EQ(ParseLabel("moontrace:left:mug", "{}", "m").geom, "left:mug");
  EXPECT_EQ(ParseLabel("moontrace:mug", "{}", "m").number, 0);
}

TEST(Label, NamesTheNearestKeyForAnUnknownOne) {
  const std::string text = Failure("{siz_mm=10}");
  EXPECT_TRUE(IsOneLine(text)) << text;
  EXPECT_TRUE(Holds(text, "siz_mm")) << text;
  EXPECT_TRUE(Holds(text, "size_mm")) << text;
  EXPECT_TRUE(Holds(text, "m.xml")) << text;
  EXPECT_TRUE(Holds(text, "moontrace:page")) << text;
}

TEST(Label, RefusesWhatIsNoLengthInOneLine) {
  for (const char* data : {"{size_mm=0}", "{size_mm=-1}", "{size_mm=nan}", "{size_mm=inf}",
                           "{size_mm='big'}", "{at_mm=[1]}", "{at_mm=[1,2,3]}", "{at_mm=[1e9,0]}",
                           "{embossed=1}", "{text=3}", "{text='A'", "text='A'", "", "{} x=1"}) {
    EXPECT_TRUE(IsOneLine(Failure(data))) << data << ": " << Failure(data);
  }
}

TEST(Label, NeedsAGeom) {
  EXPECT_TRUE(IsOneLine(ErrorOf([] { ParseLabel("moontrace:", "{}", "m.xml"); })));
}

}  // namespace
}  // namespace moontrace

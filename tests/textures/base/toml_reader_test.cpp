#include "textures/base/toml_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "textures/base/error.h"

namespace moontrace {
namespace {

std::string ErrorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TomlTable, ReadsEveryKindOfValue) {
  const TomlTable table = TomlTable::Parse(
      "mass_kg = 0.1\ncount = 3\nname = 'hand'\non = true\n"
      "at = [1, 2.5]\nwords = ['a', 'b']\n[inner]\nx = 1\n[[row]]\ny = 1\n[[row]]\ny = 2\n",
      "a.toml");
  EXPECT_EQ(table.Number("mass_kg"), 0.1);
  EXPECT_EQ(table.Number("count"), 3.0);
  EXPECT_EQ(table.Integer("count"), 3);
  EXPECT_EQ(table.String("name"), "hand");
  EXPECT_TRUE(table.Bool("on"));
  EXPECT_EQ(table.Numbers("at"), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(table.Strings("words"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(table.Table("inner").Number("x"), 1.0);
  ASSERT_EQ(table.Tables("row").size(), 2U);
  EXPECT_EQ(table.Tables("row")[1].Integer("y"), 2);
  EXPECT_TRUE(table.Tables("none").empty());
  EXPECT_NO_THROW(table.FailUnknown());
}

TEST(TomlTable, GivesTheDefaultForAnAbsentKeyOnly) {
  const TomlTable table = TomlTable::Parse("x = 'text'", "a.toml");
  EXPECT_EQ(table.Number("y", 4.5), 4.5);
  EXPECT_EQ(table.String("z", "q"), "q");
  EXPECT_EQ(ErrorOf([&] { table.Number("x", 1.0); }), "a.toml:1:5: x is a string; give a number");
}

TEST(TomlTable, NamesThePlaceOfBrokenToml) {
  const std::string error = ErrorOf([] { TomlTable::Parse("a = 1\nb = = 2\n", "a.toml"); });
  EXPECT_EQ(error.rfind("a.toml:2:5: broken TOML: ", 0), 0U) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

TEST(TomlTable, NamesTheNearestKnownKey) {
  const TomlTable table = TomlTable::Parse("x = 1\nsise_mm = 2\n", "a.toml");
  table.Number("x");
  table.Number("size_mm", 0);
  table.Number("depth_mm", 0);
  EXPECT_EQ(ErrorOf([&] { table.FailUnknown(); }),
            "a.toml:2:1: unknown key 'sise_mm'; did you mean 'size_mm'?");
}

TEST(TomlTable, DemandsAKeyAtTheTablesPlace) {
  const TomlTable table = TomlTable::Parse("x = 1\n[inner]\n", "a.toml");
  EXPECT_EQ(ErrorOf([&] { table.Table("inner").Number("mass_kg"); }),
            "a.toml:2:1: no key 'mass_kg'; add it (a number)");
}

TEST(TomlTable, RefusesNumbersThatAreNotFinite) {
  const TomlTable table = TomlTable::Parse("x = nan\ny = [1, inf]", "a.toml");
  EXPECT_EQ(ErrorOf([&] { table.Number("x"); }),
            "a.toml:1:5: x is not finite; give a finite number");
  EXPECT_EQ(ErrorOf([&] { table.Numbers("y"); }),
            "a.toml:2:9: y is not finite; give a finite number");
}

TEST(TomlTable, ReadsALoneInlineTableWithItsOwnColumns) {
  const TomlTable table = TomlTable::ParseInline("{text='MUG', at_mm=[0, 1]}", "label");
  EXPECT_EQ(table.String("text"), "MUG");
  EXPECT_EQ(table.Where("at_mm"), "label:1:20");
  const std::string broken =
      ErrorOf([] { TomlTable::ParseInline("{text='MUG', at_mm=}", "label"); });
  EXPECT_EQ(broken.rfind("label:1:20: broken TOML", 0), 0U) << broken;
  EXPECT_EQ(ErrorOf([] { TomlTable::ParseInline("7", "label"); }),
            "label:1:1: not one inline table; write {key = value, ...}");
  EXPECT_EQ(ErrorOf([] { TomlTable::ParseInline("{}\nx = 1", "label"); }),
            "label:1:1: not one inline table; write {key = value, ...}");
}

TEST(TomlTable, BoundsHostileText) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "a.";
  const std::string refusal = ": a key of more than 16 parts; nest less";
  EXPECT_EQ(ErrorOf([&] { TomlTable::Parse(deep + "a = 1", "a.toml"); }), "a.toml:1:34" + refusal);
  EXPECT_EQ(ErrorOf([&] {
              TomlTable::Parse("a = {b = \"\"\"\n\\\" '\"\"\", 'x\"'." + deep + "a = 1}", "a");
            }),
            "a:2:46" + refusal);
  EXPECT_NE(ErrorOf([&] { TomlTable::Parse("a = " + std::string(100000, '['), "a.toml"); }),
            "no error");
  EXPECT_EQ(ErrorOf([] { TomlTable::Parse(std::string(2000000, '\n'), "a.toml"); }),
            "a.toml: holds more than 1 MB; name a shorter file");
}

TEST(TomlTable, NamesAMissingFile) {
  EXPECT_EQ(ErrorOf([] { TomlTable::Read("/nowhere/a.toml"); }),
            "/nowhere/a.toml: cannot be opened (No such file or directory): check the path");
}

TEST(TomlTable, LeavesDotsInStringsCommentsAndNumbersAlone) {
  const std::string dots(100, '.');
  const TomlTable table =
      TomlTable::Parse("# " + dots + "\na = '" + dots + "'\nb = \"\"\"\n" + dots + "\"\"\"\nc = [" +
                           std::string(50, ' ') + "1.5, 2.5, 3.5]\n",
                       "a.toml");
  EXPECT_EQ(table.String("a"), dots);
  EXPECT_EQ(table.String("b"), dots);
}

TEST(TomlRange, TakesItsEndsAndNamesPlaceAndRangeOfOthers) {
  const TomlTable table = TomlTable::Parse("a = 1\nb = 2.5\n", "f.toml");
  EXPECT_EQ(InRange(table, "b", 2.5, 2.5, 3), 2.5);
  EXPECT_EQ(InRange(table, "b", 2.5, 0, 2.5), 2.5);
  EXPECT_THROW(InRange(table, "b", std::nan(""), 0, 3), InputError);
  try {
    InRange(table, "b", 2.5, 0, 2);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("f.toml:2:", 0), 0U) << error.what();
    EXPECT_NE(std::string(error.what()).find("2.5 is out of range: give 0 to 2"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace moontrace

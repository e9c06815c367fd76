#include <gtest/gtest.h>

#include <regex>

#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

/// Every bad input of the README: one line, the documented code, nothing left behind.
class BadInput : public CliTest {
 protected:
  void Expect(int code, const std::vector<std::string>& args, const std::string& named = "",
              const std::string& input = "") {
    const Outcome outcome = RunLine(args, input);
    std::string line;
    for (const std::string& arg : args) line += arg.substr(0, 40) + " ";
    EXPECT_EQ(outcome.code, code) << line << "\n" << outcome.err;
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << line << "\n" << outcome.err;
    EXPECT_LT(outcome.err.size(), 400U) << outcome.err;
    EXPECT_LE(Characters(Without(outcome.err, args)), 81U) << outcome.err;  // and the line's end
    EXPECT_NE(outcome.err.find(named), std::string::npos) << line << "\n" << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  }

  /// The words of our own in a line: what was given, paths above all, may be long.
  std::string Without(std::string line, std::vector<std::string> given) const {
    given.push_back(folder_.string());
    for (const char* foreign : {": broken TOML: ", "MuJoCo cannot load it: "}) {
      line = line.substr(0, line.find(foreign));  // what follows is a library's word
    }
    for (const std::string& word : given) {
      for (std::size_t at = 0; word.size() > 20 && (at = line.find(word)) != std::string::npos;) {
        line.erase(at, word.size());
      }
    }
    return line;
  }

  /// A script of one letter with this path, beside the rules of Moon.
  std::string Script(const std::string& path) {
    return ScriptFile(
        "<svg xmlns='http://www.w3.org/2000/svg' version='1.1'><defs><font "
        "horiz-adv-x='1000'><font-face units-per-em='1000' cap-height='1000' "
        "ascent='1000' descent='0'/><glyph unicode='a' glyph-name='a' "
        "horiz-adv-x='1000' d='" +
        path + "'/></font></defs></svg>");
  }
  std::string ScriptFile(const std::string& svg, const std::string& toml = "") {
    WriteAll(In("own.svg"), svg);
    WriteAll(In("own.toml"),
             toml.empty() ? ReadAll(SourcePath("textures/scripts/moon.toml")) : toml);
    return In("own.svg");
  }
};

const char* const kReaders[] = {"page", "trace"};

TEST_F(BadInput, Files) {
  for (const char* command : kReaders) {
    Expect(3, {command, "--file", In("none")}, In("none"));
    Expect(3, {command, "--file", folder_.string()}, folder_.string());
  }
  Expect(3, {"probe", "0", "0", "0", "--file", In("none")}, In("none"));
  WriteAll(In("big"), std::string(std::size_t{17} << 20U, 'a'));
  Expect(3, {"page", "--file", In("big")}, In("big"));
}

TEST_F(BadInput, Texts) {
  for (const char* command : kReaders) {
    Expect(3, {command, ""});
    Expect(3, {command, " \n "});
    Expect(3, {command, "-"}, "", "");
    Expect(3, {command, "AB\xFF"});
    Expect(3, {command, "\xC3"});
    Expect(3, {command, "\xE2\x98\x83"});  // nothing left to set
  }
}

TEST_F(BadInput, TenMegabytesCannotBeTraced) {
  Expect(3, {"trace", "-"}, "at most 20000", std::string(std::size_t{10} << 20U, 'a'));
}

// 2: a value that no machine could take, whatever text, script and page come with it.
TEST_F(BadInput, Numbers) {
  for (const char* option : {"--size-mm", "--width-mm", "--depth-mm", "--rounding-mm"}) {
    for (const char* value : {"0", "-1", "nan", "inf", "-inf", "1e300"}) {
      for (const char* command : kReaders) Expect(2, {command, "A", option, value}, option);
    }
  }
  for (const char* option : {"--margin-mm", "--letter-gap-mm", "--word-gap-mm"}) {
    for (const char* value : {"-1", "nan", "inf"}) Expect(2, {"page", "A", option, value}, option);
  }
  Expect(2, {"page", "A", "--line-pitch-mm", "0"}, "--line-pitch-mm");
  Expect(2, {"page", "A", "--grade", "nan"}, "--grade");
  Expect(2, {"page", "A", "--page", "nanx10"}, "--page");
  Expect(2, {"page", "A", "--page", "0x10"}, "--page");
  for (const char* option : {"--friction", "--tilt-deg", "--press-n", "--speed-mm-s"}) {
    Expect(2, {"trace", "A", option, "nan"}, option);
    Expect(2, {"trace", "A", option, "-1000"}, option);
  }
  for (const char* option : {"--seed", "--seconds", "--rate-hz", "--scale", "--press-n"}) {
    Expect(2, {"loop", "A", option, "-1"}, option);
  }
  Expect(2, {"probe", "1", "2", "nan", "A"}, "Z");
  Expect(2, {"script", "check", "moon", "--size-mm", "0"}, "--size-mm");
}

TEST_F(BadInput, Words) {
  Expect(2, {"trace", "A", "--law", "none"}, "--law");
  Expect(2, {"trace", "A", "--render", "none"}, "--render");
  Expect(2, {"page", "A", "--lines", "none"}, "--lines");
  Expect(2, {"page", "A", "--page", "none"}, "--page");
  for (const char* command : kReaders) {
    Expect(2, {command, "A", "--picture", In("p.gif")}, "p.gif");
  }
  Expect(2, {"script", "picture", "moon", "--picture", In("p.gif")}, "p.gif");
  Expect(2, {"script", "convert", "moon", "--to", In("p.gif")}, "p.gif");
}

// 4: this machine lacks it; another, with the device plugged in, would go on.
TEST_F(BadInput, Devices) {
  Expect(4, {"loop", "A", "--device", "none"}, "none");
  Expect(4, {"trace", "A", "--device", "none"}, "none");
  Expect(4, {"devices", "test", "none"}, "none");
  Expect(4, {"loop", "A", "--device", "plugin:" + In("none.so")}, "none.so");
}

// 3: each value is one that could be, and all together are none for this script and page.
TEST_F(BadInput, LettersThatCannotBe) {
  Expect(3, {"page", "A", "--width-mm", "1", "--rounding-mm", "0.3"});  // r > w/4
  Expect(3, {"trace", "A", "--width-mm", "1", "--rounding-mm", "0.3"});
  Expect(3, {"page", "A", "--size-mm", "10", "--width-mm", "11"});  // wider than a letter
  Expect(3, {"page", "A", "--size-mm", "200", "--page", "a5"});     // no room for one
  Expect(3, {"page", "H", "--h-form", "square"}, "square");
  Expect(3, {"page", "A", "--grade", "7"});
  Expect(3, {"trace", "A", "--friction", "0.8"});  // times the slope 1.67: above 0.9
}

TEST_F(BadInput, Scripts) {
  Expect(3, {"page", "A", "--script", "klingon"}, "klingon");
  Expect(3, {"page", "A", "--script", In("none.svg")}, In("none.svg"));
  Expect(3, {"page", "A", "--script", ScriptFile("<svg><broken")}, "own.svg:1");
  Expect(3, {"page", "A", "--script", ScriptFile("no xml at all")}, "own.svg");
  Expect(3, {"page", "A", "--script", ScriptFile("<html></html>")}, "own.svg");
  Expect(3, {"page", "A", "--script", ScriptFile("<svg xmlns='http://www.w3.org/2000/svg'/>")},
         "own.svg");
  Expect(3, {"page", "A", "--script", Script("M0 0 W5 5")}, "own.svg:1");
  Expect(3, {"page", "A", "--script", Script("M0 0 L nan 5")}, "own.svg:1");
  const std::string good = ReadAll(SourcePath("textures/scripts/moon.svg"));
  Expect(3, {"page", "A", "--script", ScriptFile(good, "name = [")}, "own.toml:1");
}

TEST_F(BadInput, Models) {
  const auto model = [this](const std::string& inner) {
    WriteAll(In("m.xml"), "<mujoco>" + inner + "</mujoco>");
    return In("m.xml");
  };
  const std::string plane =
      "<worldbody><geom name='p' type='plane' size='1 1 1'/>"
      "<geom name='b' type='sphere' size='1'/></worldbody>";
  Expect(3, {"trace", "A", "--model", In("none.xml")}, "none.xml");
  Expect(3, {"trace", "A", "--model", model("<worldbody>")}, "m.xml");
  Expect(3, {"trace", "A", "--model", model("<worldbody><geom type='lump'/></worldbody>")},
         "m.xml");
  Expect(3, {"trace", "A", "--model", model(plane)}, "m.xml");  // no label
  Expect(3,
         {"trace", "A", "--model",
          model(plane + "<custom><text name='moontrace:q' data='{}'/></custom>")},
         "m.xml");
  Expect(3,
         {"trace", "A", "--model",
          model(plane + "<custom><text name='moontrace:b' data=\"{face='top'}\"/></custom>")},
         "m.xml");  // a ball has no top
  Expect(3,
         {"trace", "A", "--model",
          model(plane + "<custom><text name='moontrace:p' data='{sise_mm=3}'/></custom>")},
         "size_mm");
  Expect(3,
         {"trace", "A", "--model",
          model(plane + "<custom><text name='moontrace:p' data='{size_mm='/></custom>")},
         "m.xml");
}

TEST_F(BadInput, PlacesThatCannotBeWritten) {
  WriteAll(In("file"), "");
  for (const char* command : kReaders) {
    Expect(4, {command, "A", "--picture", In("no/p.svg")}, In("no/p.svg"));
    Expect(4, {command, "A", "--picture", In("file") + "/p.svg"}, In("file"));
  }
  Expect(4, {"trace", "I", "--record", In("file") + "/r"}, In("file"));
  std::filesystem::create_directory(In("full"));
  WriteAll(In("full/kept"), "");
  Expect(3, {"trace", "I", "--record", In("full")}, In("full"));
  Expect(2, {"trace", "I", "--csv"}, "--record");
  ExpectOnly({"file", "full"});
}

TEST_F(BadInput, TooManyPictures) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "A\n";
  Expect(3, {"page", text, "--page", "60x30", "--margin-mm", "5", "--picture", In("p.svg")},
         "--picture");
  ExpectOnly({});
}

TEST_F(BadInput, Records) {
  ASSERT_EQ(RunLine({"trace", "I", "--record", In("r")}).code, 0);
  const std::string sheet = ReadAll(In("r/trial.json"));
  const std::string samples = ReadAll(In("r/samples.f64"));
  for (const char* check : {"--quiet", "--check"}) {
    WriteAll(In("r/samples.f64"), samples.substr(0, samples.size() - 100));
    Expect(3, {"replay", In("r"), check}, "samples.f64");
    WriteAll(In("r/samples.f64"), samples);
    WriteAll(In("r/trial.json"), sheet.substr(0, sheet.size() / 2));
    Expect(3, {"replay", In("r"), check}, "trial.json");
    WriteAll(In("r/trial.json"), "[]");
    Expect(3, {"replay", In("r"), check}, "trial.json");
    WriteAll(In("r/trial.json"), sheet);
  }
  // The page that the parameters describe is no longer the one recorded.
  WriteAll(In("r/trial.json"),
           std::regex_replace(sheet, std::regex("\"text\": ?\"I\""), "\"text\": \"T\""));
  Expect(3, {"replay", In("r"), "--check"}, In("r"));
  std::filesystem::remove(In("r/model.xml"));
  Expect(3, {"replay", In("r")}, In("r"));
  Expect(3, {"replay", folder_.string()}, folder_.string());
}

}  // namespace
}  // namespace moontrace

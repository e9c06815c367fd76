#include "sim/trial/trial_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "lessons/measure/scoring.h"
#include "textures/base/digest.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

TrialSheet Example() {
  TrialSheet sheet;
  sheet.head = {R"({"text":"MOON","size_mm":12.1})", 0xfedcba9876543210U, 18446744073709551615U,
                "simulated"};
  sheet.options.rendering = Rendering::kDirect;
  sheet.options.surface = {1234.5, 2.25, ForceLaw::kPaper};
  sheet.options.coupling_stiffness = 777;
  sheet.options.coupling_damping = 7.7;
  sheet.options.friction = 0.1;
  sheet.options.presliding_stiffness = 1999;
  sheet.options.tick = 0.0005;
  sheet.options.tilt = -0.3;
  sheet.state = {0.1, -0.0, 5e-324, -1.7976931348623157e308, 1.0 / 3.0, 42};
  sheet.build = {"0.1.0", "GCC 12", "-O3", 222, 223, "a processor", "avx fma"};
  sheet.start_time_utc = "2025-01-31T12:00:00Z";
  sheet.ticks = 2001;
  sheet.sample_digests = {1, 2, 3};
  sheet.model_digest = 4;
  sheet.events_digest = 5;
  sheet.csv_digest = 6;
  sheet.has_csv = true;
  sheet.result_json = R"({"coverage":0.99})";
  return sheet;
}

/// The message with which the text of a changed document is refused, "" when it is taken.
std::string Refusal(const std::function<void(nlohmann::json&)>& change) {
  nlohmann::json json = nlohmann::json::parse(FormatTrial(Example()));
  change(json);
  try {
    ParseTrial(json.dump(), "T");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void ExpectOneLineWith(const std::string& line, const std::string& part) {
  EXPECT_NE(line.find(part), std::string::npos) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
}

TEST(TrialSheet, ReadsBackEqualToTheBit) {
  const TrialSheet was = Example();
  const TrialSheet is = ParseTrial(FormatTrial(was), "T");
  EXPECT_TRUE(is.digest_holds);
  EXPECT_EQ(nlohmann::json::parse(is.head.parameters_json),
            nlohmann::json::parse(was.head.parameters_json));
  EXPECT_EQ(is.head.field_hash, was.head.field_hash);
  EXPECT_EQ(is.head.seed, was.head.seed);
  EXPECT_EQ(is.head.subject_kind, "simulated");
  EXPECT_EQ(is.options.rendering, Rendering::kDirect);
  EXPECT_EQ(is.options.surface.law, ForceLaw::kPaper);
  EXPECT_EQ(is.options.surface.stiffness, 1234.5);
  EXPECT_EQ(is.options.surface.force_cap, 2.25);
  EXPECT_EQ(is.options.coupling_stiffness, 777);
  EXPECT_EQ(is.options.coupling_damping, 7.7);
  EXPECT_EQ(is.options.friction, 0.1);
  EXPECT_EQ(is.options.presliding_stiffness, 1999);
  EXPECT_EQ(is.options.tick, 0.0005);
  EXPECT_EQ(is.options.tilt, -0.3);
  ASSERT_EQ(is.state.size(), was.state.size());
  EXPECT_EQ(std::memcmp(is.state.data(), was.state.data(), 8 * was.state.size()), 0);
  EXPECT_EQ(MadeBy(is.build), MadeBy(was.build));
  EXPECT_EQ(is.build.flags, "-O3");
  EXPECT_EQ(is.build.mujoco_compiled, 222);
  EXPECT_EQ(is.build.cpu_features, "avx fma");
  EXPECT_EQ(is.start_time_utc, was.start_time_utc);
  EXPECT_EQ(is.ticks, 2001U);
  EXPECT_EQ(is.sample_digests, was.sample_digests);
  EXPECT_EQ(is.model_digest, 4U);
  EXPECT_EQ(is.events_digest, 5U);
  EXPECT_EQ(is.csv_digest, 6U);
  EXPECT_TRUE(is.has_csv);
  EXPECT_EQ(is.result_json, R"({"coverage":0.99})");
}

TEST(TrialSheet, ReadsBackEveryDoubleEqualToTheBit) {
  // A fixed walk through bit patterns of all magnitudes.
  TrialSheet sheet = Example();
  sheet.state.clear();
  std::uint64_t bits = 88172645463325252U;
  while (sheet.state.size() < 2000) {
    bits ^= bits << 13;  // xorshift64 (Marsaglia 2003)
    bits ^= bits >> 7;
    bits ^= bits << 17;
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) sheet.state.push_back(value);
  }
  const TrialSheet is = ParseTrial(FormatTrial(sheet), "T");
  ASSERT_EQ(is.state.size(), sheet.state.size());
  EXPECT_EQ(std::memcmp(is.state.data(), sheet.state.data(), 8 * sheet.state.size()), 0);
}

TEST(TrialSheet, NoticesAChangedParameterAnywhere) {
  for (const char* pointer :
       {"/scene/page_stiffness_n_m", "/scene/friction", "/parameters/size_mm", "/initial_state/4",
        "/results/coverage", "/start_time_utc", "/seed", "/field_hash", "/program/flags"}) {
    nlohmann::json json = nlohmann::json::parse(FormatTrial(Example()));
    nlohmann::json& member = json[nlohmann::json::json_pointer(pointer)];
    if (member.is_string()) {
      std::string text = member.get<std::string>();
      text.back() = text.back() == '1' ? '2' : '1';
      member = text;
    } else if (member.is_number_float()) {
      member = std::nextafter(member.get<double>(), 1e300);
    } else {
      member = 7;
    }
    EXPECT_FALSE(ParseTrial(json.dump(), "T").digest_holds) << pointer;
  }
}

TEST(TrialSheet, KeepsItsDigestWhenOnlyTheLayoutChanges) {
  const nlohmann::json sorted = nlohmann::json::parse(FormatTrial(Example()));
  EXPECT_TRUE(ParseTrial(sorted.dump(), "T").digest_holds);
  EXPECT_TRUE(ParseTrial(sorted.dump(7), "T").digest_holds);
}

TEST(TrialSheet, RefusesAStateThatIsNotFinite) {
  TrialSheet sheet = Example();
  sheet.state[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(FormatTrial(sheet), InputError);
  sheet.state[2] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(FormatTrial(sheet), InputError);
}

TEST(TrialSheet, RefusesParametersThatAreNotAnObject) {
  for (const char* text : {"", "[1]", "{", "3", "{\"a\":1e999}"}) {
    TrialSheet sheet = Example();
    sheet.head.parameters_json = text;
    EXPECT_THROW(FormatTrial(sheet), InputError) << text;
    sheet = Example();
    sheet.result_json = text;
    EXPECT_THROW(FormatTrial(sheet), InputError) << text;
  }
}

TEST(TrialSheet, NamesLineAndColumnOfBrokenJson) {
  std::string line;
  try {
    ParseTrial("{\n \"schema\": moon}", "T");
  } catch (const InputError& error) {
    line = error.what();
  }
  ExpectOneLineWith(line, "T:2:12: not JSON");
}

TEST(TrialSheet, NamesAnotherSchemaVersion) {
  ExpectOneLineWith(Refusal([](auto& json) { json["schema_version"] = 2; }), "version 2");
  ExpectOneLineWith(Refusal([](auto& json) { json["schema"] = "other"; }), "schema: not");
  ExpectOneLineWith(Refusal([](auto& json) { json = nlohmann::json::array(); }), "schema: missing");
}

// The column phase holds the number of a phase, so every one needs its name.
TEST(TrialSheet, NamesEveryPhase) {
  const nlohmann::json json = nlohmann::json::parse(FormatTrial(Example()));
  const nlohmann::json& phases = json["samples"]["phases"];
  EXPECT_EQ(phases.at(static_cast<std::size_t>(TracePhase::kAir)), "air");
  EXPECT_EQ(phases.at(static_cast<std::size_t>(TracePhase::kEntry)), "entry");
  EXPECT_EQ(phases.at(static_cast<std::size_t>(TracePhase::kStroke)), "stroke");
  EXPECT_EQ(phases.at(static_cast<std::size_t>(TracePhase::kLift)), "lift");
  ASSERT_EQ(phases.size(), 5u);
  EXPECT_EQ(phases.at(static_cast<std::size_t>(TracePhase::kTravel)), "travel");
}

TEST(TrialSheet, NamesMissingAndForeignColumns) {
  ExpectOneLineWith(Refusal([](auto& json) { json["samples"]["columns"].erase(28); }),
                    "column stroke is missing");
  ExpectOneLineWith(Refusal([](auto& json) { json["samples"]["columns"].erase(3); }),
                    "device_vx_m_s stands where device_z_m belongs");
  ExpectOneLineWith(Refusal([](auto& json) { json["samples"]["columns"].push_back("more"); }),
                    "samples.columns[29]: one column too many");
  ExpectOneLineWith(Refusal([](auto& json) { json["samples"]["columns"][0] = "a\nb"; }), "a?b");
}

TEST(TrialSheet, RefusesEveryMissingMember) {
  const nlohmann::json whole = nlohmann::json::parse(FormatTrial(Example())).flatten();
  int removed = 0;
  for (const auto& member : whole.items()) {
    const nlohmann::json::json_pointer pointer(member.key());
    const std::string parent = pointer.parent_pointer().to_string();
    const bool ours = parent == "/scene" || parent == "/program" || parent == "/subject" ||
                      (parent == "/digests" && pointer.back() != "method" &&
                       pointer.back() != "samples.csv" && pointer.back() != "samples.f64");
    if (!ours) continue;
    ++removed;
    const std::string line =
        Refusal([&](auto& json) { json[pointer.parent_pointer()].erase(pointer.back()); });
    ExpectOneLineWith(line, pointer.back() + ": missing");
  }
  EXPECT_EQ(removed, 10 + 7 + 1 + 3);  // scene, program, subject, digests
}

TEST(TrialSheet, RefusesSenselessValues) {
  const auto refusal = [](const char* pointer, const nlohmann::json& value) {
    return Refusal([&](auto& json) { json[nlohmann::json::json_pointer(pointer)] = value; });
  };
  ExpectOneLineWith(refusal("/scene/friction", "much"), "scene.friction: not a number");
  ExpectOneLineWith(refusal("/scene/friction", -1), "scene.friction: out of range");
  ExpectOneLineWith(refusal("/scene/tick_s", 0), "scene.tick_s: out of range");
  ExpectOneLineWith(refusal("/scene/rendering", "mesh"), "neither proxy nor direct");
  ExpectOneLineWith(refusal("/initial_state", 3), "initial_state: not a list");
  ExpectOneLineWith(refusal("/initial_state/1", nullptr), "initial_state[1]: not a number");
  ExpectOneLineWith(refusal("/field_hash", "0x12"), "field_hash");
  ExpectOneLineWith(refusal("/samples/ticks", -1), "samples.ticks: not a whole number");
  ExpectOneLineWith(refusal("/samples/ticks", 1U << 24), "samples.ticks: too large");
  ExpectOneLineWith(refusal("/samples/ticks", 18446744073709551615U), "samples.ticks: too large");
  ExpectOneLineWith(refusal("/samples/ticks", 3001), "not one for every 1000 ticks");
  ExpectOneLineWith(refusal("/samples/digest_every_ticks", 0), "digest_every_ticks");
  ExpectOneLineWith(refusal("/digests", 1), "digests.model.xml: missing");
}

TEST(TrialSheet, IsBoundedInNestingAndNumberOfValues) {
  const std::string deep = std::string(1000000, '[');
  EXPECT_THROW(ParseTrial(deep, "T"), InputError);
  ExpectOneLineWith(Refusal([](auto& json) {
                      nlohmann::json nested;
                      for (int i = 0; i < 80; ++i) nested = nlohmann::json::array({nested});
                      json["parameters"]["nested"] = nested;
                    }),
                    "nested more than 64 deep");
  std::string wide = "[0";
  for (int i = 0; i < 1100000; ++i) wide += ",0";
  EXPECT_THROW(ParseTrial(wide + "]", "T"), InputError);
  // a list of objects is read in time that grows with its length only
  std::string objects = "[{}";
  for (int i = 0; i < 300'000; ++i) objects += ",{}";
  EXPECT_THROW(ParseTrial(objects + "]", "T"), InputError);
}

TEST(FormatEvent, IsOneLineOfJsonWhateverTheText) {
  const std::string line = FormatEvent(0.5, "lift", "a \"b\"\n\x01 \xff");
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  const nlohmann::json json = nlohmann::json::parse(line);
  EXPECT_EQ(json["time_s"], 0.5);
  EXPECT_EQ(json["what"], "lift");
  EXPECT_EQ(json["detail"], "a \"b\"\n\x01 \xef\xbf\xbd");  // U+FFFD stands for the broken byte
}

}  // namespace
}  // namespace moontrace

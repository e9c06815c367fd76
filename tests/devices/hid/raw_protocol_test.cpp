#include "devices/hid/raw_protocol.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/source_path.h"

namespace moontrace {
namespace {

/// A row of a byte table of raw_protocol.md.
struct Row {
  std::size_t place = 0;
  std::string type, field, unit;
};

std::size_t SizeOf(const std::string& type) {
  return static_cast<std::size_t>(std::atoi(type.c_str() + 1)) / 8;
}

std::string Trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The tables by the report's number, as the page tells them.
std::map<int, std::vector<Row>> ReadTables() {
  std::ifstream file(SourcePath("devices/raw_protocol.md"));
  std::map<int, std::vector<Row>> tables;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("## ", 0) == 0) number = 0;
    if (line.rfind("## Report ", 0) == 0) number = std::atoi(line.c_str() + 10);
    if (number == 0 || line.size() < 3 || line[0] != '|' || !std::isdigit(line[2])) continue;
    std::vector<std::string> cells;
    std::istringstream stream(line.substr(1));
    for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(Trimmed(cell));
    tables[number].push_back(
        {static_cast<std::size_t>(std::stoul(cells[0])), cells[1], cells[2], cells[3]});
  }
  return tables;
}

/// A field of a report, read by the page's table and nothing else.
double ByThePage(const std::vector<Row>& table, const std::string& field,
                 const std::uint8_t* bytes) {
  for (const Row& row : table) {
    if (row.field != field) continue;
    const std::size_t size = SizeOf(row.type);
    std::uint64_t value = 0;
    for (std::size_t i = size; i-- > 0;) value = value << 8 | bytes[row.place + i];
    const std::uint64_t sign = std::uint64_t{1} << (8 * size - 1);
    const bool negative = row.type[0] == 'i' && (value & sign) != 0;
    return static_cast<double>(value) - (negative ? 2.0 * static_cast<double>(sign) : 0);
  }
  ADD_FAILURE() << "the page has no field " << field;
  return 0;
}

TEST(RawProtocolPage, HasTablesWithoutGapsThatEndWhereTheReportsEnd) {
  const auto tables = ReadTables();
  ASSERT_EQ(tables.size(), 3u);
  const std::map<int, std::size_t> sizes = {{kRawInputNumber, kRawInputBytes},
                                            {kRawOutputNumber, kRawOutputBytes},
                                            {kRawHelloNumber, kRawHelloBytes}};
  for (const auto& [number, size] : sizes) {
    std::size_t place = 0;
    for (const Row& row : tables.at(number)) {
      EXPECT_EQ(row.place, place) << row.field << " of report " << number;
      place += SizeOf(row.type);
    }
    EXPECT_EQ(place, size) << "report " << number;
    EXPECT_LE(size, 64u);
  }
}

TEST(RawProtocolPage, DescribesTheInputReport) {
  RawInput input;
  input.sequence = 0xA1B2;
  input.ready = true;
  input.velocity_known = true;
  input.p_D = {0.012345, -0.067890, 1.0};
  input.v_D = {-0.5, 0.25, 2.000001};
  input.buttons = 0x80000005;
  input.answered = 513;
  const auto bytes = EncodeRawInput(input);
  const auto table = ReadTables().at(1);
  EXPECT_EQ(ByThePage(table, "number", bytes.data()), 1);
  EXPECT_EQ(ByThePage(table, "status", bytes.data()), 0b101);
  EXPECT_EQ(ByThePage(table, "sequence", bytes.data()), 0xA1B2);
  EXPECT_EQ(ByThePage(table, "x", bytes.data()), 12345);
  EXPECT_EQ(ByThePage(table, "y", bytes.data()), -67890);
  EXPECT_EQ(ByThePage(table, "z", bytes.data()), 1000000);
  EXPECT_EQ(ByThePage(table, "vx", bytes.data()), -500000);
  EXPECT_EQ(ByThePage(table, "vy", bytes.data()), 250000);
  EXPECT_EQ(ByThePage(table, "vz", bytes.data()), 2000001);
  EXPECT_EQ(ByThePage(table, "buttons", bytes.data()), 0x80000005);
  EXPECT_EQ(ByThePage(table, "answered", bytes.data()), 513);
  EXPECT_EQ(ByThePage(table, "crc", bytes.data()), RawCheckSum(std::span(bytes).first(34)));
}

TEST(RawProtocolPage, DescribesTheOutputReport) {
  const auto bytes = EncodeRawOutput({7, true, {1.5, -2.25, 0.001}});
  const auto table = ReadTables().at(2);
  EXPECT_EQ(ByThePage(table, "number", bytes.data()), 2);
  EXPECT_EQ(ByThePage(table, "flags", bytes.data()), 1);
  EXPECT_EQ(ByThePage(table, "sequence", bytes.data()), 7);
  EXPECT_EQ(ByThePage(table, "fx", bytes.data()), 1500);
  EXPECT_EQ(ByThePage(table, "fy", bytes.data()), -2250);
  EXPECT_EQ(ByThePage(table, "fz", bytes.data()), 1);
}

TEST(RawProtocolPage, DescribesTheFeatureReport) {
  RawHello hello;
  hello.dead_man = 0.015;
  hello.workspace_D = {0.05, 0.04, 0.03};  // edges: half of the way from end to end
  hello.peak_force = 3.5;
  hello.rate = 1000;
  hello.buttons = 2;
  hello.measures = {true, true, true};
  hello.pushes = {true, false, true};
  hello.position_step = 2.5e-6;
  hello.force_step = 0.004;
  const auto bytes = EncodeRawHello(hello);
  const auto table = ReadTables().at(3);
  EXPECT_EQ(ByThePage(table, "version", bytes.data()), 1);
  EXPECT_EQ(ByThePage(table, "magic", bytes.data()), 0x4E4F4F4D);
  EXPECT_EQ(ByThePage(table, "dead_man", bytes.data()), 15);
  EXPECT_EQ(ByThePage(table, "width", bytes.data()), 100000);
  EXPECT_EQ(ByThePage(table, "depth", bytes.data()), 80000);
  EXPECT_EQ(ByThePage(table, "height", bytes.data()), 60000);
  EXPECT_EQ(ByThePage(table, "peak_force", bytes.data()), 3500);
  EXPECT_EQ(ByThePage(table, "rate", bytes.data()), 1000);
  EXPECT_EQ(ByThePage(table, "buttons", bytes.data()), 2);
  EXPECT_EQ(ByThePage(table, "axes", bytes.data()), 0b101111);
  EXPECT_EQ(ByThePage(table, "position_step", bytes.data()), 2500);
  EXPECT_EQ(ByThePage(table, "force_step", bytes.data()), 4000);
}

TEST(RawCheckSum, IsTheCatalogued) {
  // The check value of CRC-16/CCITT-FALSE in every catalogue of CRCs.
  const std::string text = "123456789";
  EXPECT_EQ(RawCheckSum({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}), 0x29B1);
}

TEST(DecodeRawInput, GivesBackWhatWasEncoded) {
  RawInput input;
  input.sequence = 65535;
  input.has_let_go = true;
  input.p_D = {-2.0, 0.000001, 0.1};
  input.buttons = 9;
  const auto bytes = EncodeRawInput(input);
  const auto again = DecodeRawInput(bytes);
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->sequence, 65535);
  EXPECT_FALSE(again->ready);
  EXPECT_TRUE(again->has_let_go);
  // Half a micrometre of rounding, and the last bits of doubles.
  EXPECT_NEAR(again->p_D.x, -2.0, 1e-12);
  EXPECT_NEAR(again->p_D.y, 0.000001, 1e-12);
  EXPECT_EQ(again->buttons, 9u);
}

TEST(DecodeRawInput, TakesZerosBehindTheReport) {
  const auto bytes = EncodeRawInput({});
  std::vector<std::uint8_t> packet(bytes.begin(), bytes.end());
  packet.resize(64, 0);
  EXPECT_TRUE(DecodeRawInput(packet).has_value());
}

TEST(DecodeRawInput, RefusesEveryFlippedBitAndEveryShorterReport) {
  auto bytes = EncodeRawInput({});
  for (std::size_t i = 0; i < bytes.size() * 8; ++i) {
    const auto bit = static_cast<std::uint8_t>(1u << (i % 8));
    bytes[i / 8] ^= bit;
    EXPECT_FALSE(DecodeRawInput(bytes).has_value()) << "bit " << i;
    bytes[i / 8] ^= bit;
  }
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(DecodeRawInput(std::span(bytes).first(size)).has_value()) << size;
  }
}

TEST(DecodeRawHello, RefusesAnotherVersionAndAnotherMagic) {
  const auto good = EncodeRawHello({});
  ASSERT_TRUE(DecodeRawHello(good).has_value());
  for (const std::size_t place : {1u, 2u, 5u}) {
    auto bytes = good;
    bytes[place] = static_cast<std::uint8_t>(bytes[place] + 1);
    const std::uint16_t sum = RawCheckSum(std::span(bytes).first(kRawHelloBytes - 2));
    bytes[kRawHelloBytes - 2] = static_cast<std::uint8_t>(sum);
    bytes[kRawHelloBytes - 1] = static_cast<std::uint8_t>(sum >> 8);
    EXPECT_FALSE(DecodeRawHello(bytes).has_value()) << place;
  }
}

TEST(EncodeRawOutput, TurnsWhatIsNoNumberIntoZeroAndHoldsTheRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto output = DecodeRawOutput(EncodeRawOutput({0, true, {nan, 1e300, -1e300}}));
  ASSERT_TRUE(output.has_value());
  EXPECT_EQ(output->f_D.x, 0);
  EXPECT_NEAR(output->f_D.y, 2147483.647, 1e-6);  // 2^31 - 1 mN
  EXPECT_NEAR(output->f_D.z, -2147483.648, 1e-6);
}

}  // namespace
}  // namespace moontrace

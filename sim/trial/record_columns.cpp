#include "sim/trial/record_columns.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "textures/base/error.h"

namespace moontrace {
namespace {

double Whole(const RecordColumns& columns, std::size_t column, double greatest,
             std::string_view where, std::size_t tick) {
  const double value = columns[column];
  // Minus zero would come back as another bit pattern.
  if (value >= 0 && value <= greatest && value == std::floor(value) && !std::signbit(value)) {
    return value;
  }
  throw InputError(fmt::format("{}: altered: tick {}, column {} holds {}; use an unaltered copy",
                               where, tick, kRecordColumns[column], value));
}

glm::dvec3 Vector(const RecordColumns& columns, std::size_t first) {
  return {columns[first], columns[first + 1], columns[first + 2]};
}

}  // namespace

RecordColumns ToColumns(const RecordRow& row) noexcept {
  const DeviceState& in = row.input;
  const TickResult& out = row.output;
  return {in.time,
          in.p_D.x,
          in.p_D.y,
          in.p_D.z,
          in.v_D.x,
          in.v_D.y,
          in.v_D.z,
          in.velocity_known ? 1.0 : 0.0,
          static_cast<double>(in.buttons),
          out.tip_P.x,
          out.tip_P.y,
          out.tip_P.z,
          out.proxy_P.x,
          out.proxy_P.y,
          out.proxy_P.z,
          out.force_P.x,
          out.force_P.y,
          out.force_P.z,
          out.force_W.x,
          out.force_W.y,
          out.force_W.z,
          out.page_force_P.x,
          out.page_force_P.y,
          out.page_force_P.z,
          out.depth,
          out.energy_out,
          out.fault ? 1.0 : 0.0,
          row.phase,
          row.stroke};
}

RecordRow FromColumns(const RecordColumns& columns, std::string_view where, std::size_t tick) {
  const double all_buttons = std::numeric_limits<std::uint32_t>::max();
  RecordRow row;
  row.input.time = columns[0];
  row.input.p_D = Vector(columns, 1);
  row.input.v_D = Vector(columns, 4);
  row.input.velocity_known = Whole(columns, 7, 1, where, tick) == 1;
  row.input.buttons = static_cast<std::uint32_t>(Whole(columns, 8, all_buttons, where, tick));
  row.output.tip_P = Vector(columns, 9);
  row.output.proxy_P = Vector(columns, 12);
  row.output.force_P = Vector(columns, 15);
  row.output.force_W = Vector(columns, 18);
  row.output.page_force_P = Vector(columns, 21);
  row.output.depth = columns[24];
  row.output.energy_out = columns[25];
  row.output.fault = Whole(columns, 26, 1, where, tick) == 1;
  row.phase = columns[27];
  row.stroke = columns[28];
  return row;
}

}  // namespace moontrace

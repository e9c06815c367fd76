#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "sim/trial/record.h"

namespace moontrace {

/// The columns of samples.f64 in order (schema version 1): what the device gave, in the device's
/// frame D, then what the tick answered, in the page's frame P unless the name says W.
inline constexpr std::array<std::string_view, 29> kRecordColumns = {
    "time_s",        "device_x_m",     "device_y_m",     "device_z_m",     "device_vx_m_s",
    "device_vy_m_s", "device_vz_m_s",  "velocity_known", "buttons",        "tip_x_m",
    "tip_y_m",       "tip_z_m",        "proxy_x_m",      "proxy_y_m",      "proxy_z_m",
    "force_x_n",     "force_y_n",      "force_z_n",      "force_x_W_n",    "force_y_W_n",
    "force_z_W_n",   "page_force_x_n", "page_force_y_n", "page_force_z_n", "depth_m",
    "energy_out_j",  "fault",          "phase",          "stroke",
};
/// The first column that Scene::Tick computed, and the first after those.
inline constexpr std::size_t kFirstOutput = 9;
inline constexpr std::size_t kAfterOutputs = 27;

using RecordColumns = std::array<double, kRecordColumns.size()>;
inline constexpr std::size_t kRowBytes = sizeof(RecordColumns);

RecordColumns ToColumns(const RecordRow& row) noexcept;

/// The inverse, equal to the bit. Throws InputError starting with `where` when a flag is neither 0
/// nor 1 or the buttons are no whole number of 32 bits.
RecordRow FromColumns(const RecordColumns& columns, std::string_view where, std::size_t tick);

}  // namespace moontrace

// The columns of a strike map's CSV, for its writer and its reader.
#pragma once

#include "core/scene/bowling_scene.h"

#include <QByteArray>

#include <array>

namespace thetalane::mapcolumns {

enum Column {
    Offset,
    Angle,
    PinsDown,
    Strike,
    Standing,
    Row,
    Rows,
    SceneName,
    Speed,
    Mass,
    SpinRate,
    Position,
    Restitution,
    ColumnCount
};
inline constexpr std::array<const char*, ColumnCount> names{
    "offset_m", "angle_deg", "pins_down", "strike",   "standing",   "row",        "rows",
    "scene",    "speed_m_s", "mass_kg",   "spin_rpm", "position_m", "restitution"};
inline constexpr std::array sceneNames{"rack", "bowling"};

QByteArray header();

// Pins left, 7-10; empty for none.
QByteArray standingText(const PinSet& left);

} // namespace thetalane::mapcolumns

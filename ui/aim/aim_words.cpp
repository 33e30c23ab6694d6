// What stands beside what is aimed.
#include "ui/aim/aim_tool.h"
#include "ui/words/number_text.h"

#include <cmath>

namespace thetalane {
namespace {

// As many digits as a hand can set.
QString fixed(double value, int digits) {
    const double shown = std::abs(value) < 0.5 * std::pow(10, -digits) ? 0 : value; // not -0.00
    return QString::number(shown, 'f', digits).replace('-', QChar(0x2212));
}

} // namespace

QString AimTool::valueText(AimPart part) const {
    const Throw& t = ballThrow();
    switch (part) {
    case AimPart::Direction: {
        const QString angle = fixed(std::abs(t.direction) / perDegree, 2);
        const double there = placeOf(AimPart::Direction, t).x;
        const QString side = t.direction > 0   ? tr("%1° to the right").arg(angle)
                             : t.direction < 0 ? tr("%1° to the left").arg(angle)
                                               : tr("straight");
        return std::abs(there) > regulation::laneWidth / 2
                   ? side
                   : tr("%1, over board %2").arg(side).arg(boardAt(there));
    }
    case AimPart::Speed:
        return fixed(t.speed / inMetresPerSecond(m_units.speed), 2) + ' ' + unitSymbol(m_units.speed);
    case AimPart::Rotation: {
        const double axis = t.axis / perDegree;
        const QString turns = fixed(t.spin / perRpm, 0) + QStringLiteral(" rpm");
        if (!(t.spin > 0))
            return tr("no rotation");
        const QString angle = fixed(axis, 0);
        return angle == QStringLiteral("0") ? tr("%1, forward roll").arg(turns)
               : axis > 0                   ? tr("%1, axis %2°, hooks left").arg(turns, angle)
                                            : tr("%1, axis %2°, hooks right").arg(turns, angle);
    }
    case AimPart::Ball:
        break;
    }
    return tr("%1 m, board %2").arg(fixed(t.position, 3)).arg(boardAt(t.position));
}

QString AimTool::limitText() const {
    switch (m_limit) {
    case AimLimit::EdgeOfLane:
        return tr("The ball's centre stays on the lane");
    case AimLimit::Steepest:
        return tr("By hand up to %1°; more can be typed").arg(numberText(directionSpan.high));
    case AimLimit::Slowest:
        return tr("By hand not below %1; less can be typed").arg(speedText(1, m_units.speed));
    case AimLimit::Fastest:
        return tr("By hand up to %1; more can be typed").arg(speedText(16, m_units.speed));
    case AimLimit::MostRotation:
        return tr("By hand up to %1 rpm; more can be typed").arg(numberText(rotationSpan.high));
    case AimLimit::SideSpin:
        return tr("±90° is side spin alone; more would turn backwards");
    case AimLimit::None:
        break;
    }
    return {};
}

QString AimTool::tipOf(AimPart part) const {
    const QString keys = tr("Shift: fine. A and the arrow keys do the same. Esc: as before.");
    switch (part) {
    case AimPart::Ball:
        return tr("Drag the ball along the foul line.") + '\n' + keys;
    case AimPart::Direction:
        return tr("Drag the tip to aim.") + '\n' + keys;
    case AimPart::Speed:
        return tr("Drag along the arrow: the speed.") + '\n' + keys;
    case AimPart::Rotation:
        break;
    }
    return tr("Drag round the ball: the axis; outwards: more rotation.") + '\n' + keys;
}

} // namespace thetalane

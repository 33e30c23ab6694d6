// Icons drawn by the program: paths on a grid of 24 by 24, sharp at any scale, in the colour asked for.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPainterPath>
#include <QRectF>

class QPainter;

namespace thetalane {

enum class Icon {
    Play,
    Pause,
    Start, // to time 0
    FrameBack,
    FrameForward,
    CollisionBack,
    CollisionForward,
    Reset,
    Zoom,
    Globe, // the language
    Projector,
    Plus,
    Minus,
    Open,
    Moon, // dark or light
    Down, // there is more to choose from
};

// To be filled, on the grid of 24 by 24.
QPainterPath iconPath(Icon icon);

void paintIcon(QPainter& painter, Icon icon, const QRectF& where, const QColor& colour);

// For menus and tool bars; drawn anew at every size and scale.
QIcon makeIcon(Icon icon, const QColor& colour, const QColor& disabled);

} // namespace thetalane

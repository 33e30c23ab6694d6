#include "ui/game/player_colours.h"

#include "core/bowling/game.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <array>

namespace thetalane {
namespace {

struct ColourNames {
    Q_DECLARE_TR_FUNCTIONS(PlayerColours)
};

std::size_t index(int colour) {
    return std::size_t(std::clamp(colour, 0, int(mostPlayers) - 1));
}

} // namespace

QColor playerColour(int colour) {
    static constexpr std::array<QRgb, mostPlayers> colours{0xff0072B2, 0xffD55E00, 0xff009E73, 0xffCC79A7,
                                                           0xffE69F00, 0xff56B4E9, 0xff7A8590, 0xffE8D92C};
    return QColor(colours[index(colour)]);
}

QString playerColourName(int colour) {
    const std::array<QString, mostPlayers> names{ColourNames::tr("blue"),   ColourNames::tr("red"),
                                                 ColourNames::tr("green"),  ColourNames::tr("pink"),
                                                 ColourNames::tr("orange"), ColourNames::tr("light blue"),
                                                 ColourNames::tr("grey"),  ColourNames::tr("yellow")};
    return names[index(colour)];
}

QIcon playerIcon(int colour, int side) {
    constexpr int sharp = 3; // for screens with smaller pixels
    QPixmap pixmap(side * sharp, side * sharp);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(playerColour(colour));
    painter.drawEllipse(QRectF(pixmap.rect()).adjusted(2, 2, -2, -2));
    return QIcon(pixmap);
}

} // namespace thetalane

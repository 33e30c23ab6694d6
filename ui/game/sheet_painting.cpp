#include "ui/game/sheet_painting.h"

#include "core/bowling/score_notation.h"
#include "ui/game/player_colours.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace thetalane {
namespace {

using Size = Appearance::Size;

QColor mixed(const QColor& a, const QColor& b, double part) {
    const auto mix = [part](int x, int y) { return int(x + (y - x) * part); };
    return QColor(mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue()));
}

class SheetPainter {
public:
    SheetPainter(QPainter& painter, const SheetLayout& layout, const SheetContent& content,
                 const Appearance& look)
        : m_painter(painter)
        , m_layout(layout)
        , m_content(content)
        , m_look(look) {}

    void rows() {
        for (std::size_t player = 0; player < m_content.cards.size(); ++player) {
            background(player);
            name(player);
            for (int f = 0; f < framesOfAGame; ++f)
                frame(player, f);
            total(player);
        }
        lines();
        for (std::size_t player = 0; player < m_content.cards.size(); ++player)
            if (const auto now = frameOfNow(player))
                outline(m_layout.frame(player, *now), m_look.accent(), m_look.projector() ? 4 : 2);
        if (m_content.cursor)
            outline(m_layout.frame(m_content.cursor->player, m_content.cursor->frame), m_look.text(),
                    m_look.projector() ? 3 : 2);
    }

    void header(double top) {
        const QRectF all = m_layout.header().translated(0, top);
        m_painter.fillRect(all, m_look.window());
        m_painter.setPen(m_look.quietText());
        m_painter.setFont(m_look.font(Size::Small));
        text(m_layout.name(0), all, Qt::AlignLeft, m_content.nameWord, m_look.unit() * 2);
        for (int f = 0; f < framesOfAGame; ++f) {
            const bool now = m_content.turn && m_content.turn->turn.frame == f + 1;
            m_painter.setFont(m_look.font(Size::Small, now));
            m_painter.setPen(now ? m_look.accent() : m_look.quietText());
            text(m_layout.heading(f), all, Qt::AlignHCenter, QString::number(f + 1), 0);
        }
        m_painter.setFont(m_look.font(Size::Small));
        m_painter.setPen(m_look.quietText());
        text(m_layout.total(0), all, Qt::AlignHCenter, m_content.totalWord, 0);
        m_painter.setPen(QPen(m_look.line(), 1));
        m_painter.drawLine(all.bottomLeft(), all.bottomRight());
    }

private:
    void text(const QRectF& across, const QRectF& down, Qt::Alignment align, const QString& words,
              int inset) {
        const QRectF area(across.left() + inset, down.top(), across.width() - inset, down.height());
        m_painter.drawText(area, int(align | Qt::AlignVCenter), words);
    }

    bool hasTurn(std::size_t player) const { return m_content.turn && m_content.turn->player == player; }

    std::optional<int> frameOfNow(std::size_t player) const {
        return hasTurn(player) ? std::optional(m_content.turn->turn.frame - 1) : std::nullopt;
    }

    void background(std::size_t player) {
        const QRectF row = m_layout.row(player);
        m_painter.fillRect(row,
                           hasTurn(player) ? mixed(m_look.card(), m_look.accent(), 0.06) : m_look.card());
        if (const auto now = frameOfNow(player))
            m_painter.fillRect(m_layout.frame(player, *now), mixed(m_look.card(), m_look.accent(), 0.18));
        if (const auto& h = m_content.hovered; h && h->player == player)
            m_painter.fillRect(h->roll ? m_layout.roll(player, h->frame, *h->roll)
                                       : m_layout.frameTotal(player, h->frame),
                               mixed(m_look.card(), m_look.accent(), 0.12));
        if (const auto& r = m_content.replayed; r && r->player == player && r->roll)
            m_painter.fillRect(m_layout.roll(player, r->frame, *r->roll),
                               mixed(m_look.card(), m_look.ink(Ink::Triangle), 0.55));
    }

    // A spot of the player's colour; a bar of it where it is the player's turn.
    void name(std::size_t player) {
        const QRectF area = m_layout.name(player);
        const double unit = m_look.unit(), spot = unit * 1.2;
        const QColor colour = playerColour(m_content.game.players[player].colour);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(colour);
        if (hasTurn(player))
            m_painter.drawRect(QRectF(area.left(), area.top(), unit * 0.6, area.height()));
        m_painter.drawEllipse(QRectF(area.left() + unit * 1.2, area.center().y() - spot / 2, spot, spot));
        m_painter.setFont(m_look.font(Size::Normal, hasTurn(player)));
        m_painter.setPen(m_look.text());
        const QRectF room = area.adjusted(unit * 1.2 + spot + unit * 0.6, 0, -unit / 2, 0);
        const QString name = QString::fromStdString(m_content.game.players[player].name);
        m_painter.drawText(room, int(Qt::AlignLeft | Qt::AlignVCenter),
                           QFontMetricsF(m_painter.font()).elidedText(name, Qt::ElideRight, room.width()));
    }

    void frame(std::size_t player, int f) {
        const Scorecard& card = m_content.cards[player];
        const int count = m_layout.rollCount(f);
        const bool now = frameOfNow(player) == f; // on a ground that would swallow a hairline
        m_painter.setPen(QPen(now ? mixed(m_look.card(), m_look.accent(), 0.55) : m_look.line(), 1));
        m_painter.setBrush(Qt::NoBrush);
        for (int r = 1; r < count; ++r) // the first ball stands free, the others in boxes of their own
            m_painter.drawRect(m_layout.roll(player, f, r));
        if (f >= int(card.frames().size()))
            return;
        const FrameScore& score = card.frames()[std::size_t(f)];
        for (int r = 0; r < count; ++r)
            if (const auto d = deliveryAt(card, f, r, count);
                d && (count == 3 || !card.deliveries()[*d].strike || r == 1))
                roll(card.deliveries()[*d], m_layout.roll(player, f, r));
        if (score.total) {
            m_painter.setFont(m_look.font(Size::Large, false));
            m_painter.setPen(m_look.text());
            m_painter.drawText(m_layout.frameTotal(player, f), Qt::AlignCenter,
                               QString::number(*score.total));
        }
        if (score.corrected)
            corner(m_layout.frame(player, f));
    }

    void roll(const ScoredDelivery& d, const QRectF& box) {
        const bool clears = d.strike || d.spare;
        QFont font = m_look.font(Size::Normal, clears);
        m_painter.setFont(font);
        m_painter.setPen(d.delivery.foul ? m_look.error() : clears ? m_look.accent() : m_look.text());
        const char symbol = symbolOf(d);
        m_painter.drawText(box, Qt::AlignCenter,
                           symbol == '-' ? QString(QChar(0x2013)) : QString(QLatin1Char(symbol)));
        if (!d.split)
            return;
        const double radius = std::min({box.height() * 0.46, box.width() * 0.48, font.pixelSize() * 0.72});
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(QPen(m_look.textInk(Ink::Second), m_look.projector() ? 2.2 : 1.4));
        m_painter.drawEllipse(box.center(), radius, radius);
    }

    // Corrected by hand: a corner turned down.
    void corner(const QRectF& frame) {
        const double side = m_look.unit() * 1.1;
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(m_look.ink(Ink::Triangle));
        const QPointF at = frame.bottomRight();
        m_painter.drawPolygon(QPolygonF({at, at - QPointF(side, 0), at - QPointF(0, side)}));
    }

    void total(std::size_t player) {
        const QRectF area = m_layout.total(player);
        const Scorecard& card = m_content.cards[player];
        const bool over = card.complete();
        QRectF upper = area;
        if (!over)
            upper.setHeight(area.height() * 0.6);
        m_painter.setFont(m_look.font(over && !m_look.projector() ? Size::Title : Size::Large, true));
        m_painter.setPen(over && isBest(player) ? m_look.accent() : m_look.text());
        m_painter.drawText(upper, Qt::AlignCenter, QString::number(card.runningTotal()));
        if (over)
            return;
        m_painter.setFont(m_look.font(Size::Small));
        m_painter.setPen(m_look.quietText());
        m_painter.drawText(area.adjusted(0, area.height() * 0.54, 0, 0), Qt::AlignCenter,
                           m_content.mostWord.arg(card.highestPossible()));
    }

    bool isBest(std::size_t player) const {
        const int own = m_content.cards[player].runningTotal();
        return !m_content.turn && std::all_of(m_content.cards.begin(), m_content.cards.end(),
                                              [own](const auto& c) { return c.runningTotal() <= own; });
    }

    void lines() {
        m_painter.setPen(QPen(m_look.line(), 1));
        for (std::size_t player = 0; player < m_content.cards.size(); ++player) {
            const QRectF row = m_layout.row(player);
            for (int f = 0; f < framesOfAGame; ++f) {
                const QRectF frame = m_layout.frame(player, f);
                m_painter.drawLine(frame.topLeft(), frame.bottomLeft());
            }
            m_painter.drawLine(m_layout.total(player).topLeft(), m_layout.total(player).bottomLeft());
            m_painter.drawLine(row.bottomLeft(), row.bottomRight());
        }
    }

    void outline(const QRectF& area, const QColor& colour, double width) {
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        m_painter.drawRect(area.adjusted(width / 2, width / 2, -width / 2, -width / 2));
    }

    QPainter& m_painter;
    const SheetLayout& m_layout;
    const SheetContent& m_content;
    const Appearance& m_look;
};

} // namespace

std::optional<std::size_t> deliveryAt(const Scorecard& card, int frame, int roll, int rollCount) {
    if (frame >= int(card.frames().size()))
        return std::nullopt;
    const FrameScore& f = card.frames()[std::size_t(frame)];
    const auto first = std::size_t(f.first);
    if (rollCount == 2 && card.deliveries()[first].strike)
        return first;
    return roll < f.count ? std::optional(first + std::size_t(roll)) : std::nullopt;
}

void paintSheet(QPainter& painter, const SheetLayout& layout, const SheetContent& content,
                const Appearance& appearance) {
    SheetPainter(painter, layout, content, appearance).rows();
}

void paintSheetHeader(QPainter& painter, const SheetLayout& layout, const SheetContent& content,
                      const Appearance& appearance, double top) {
    SheetPainter(painter, layout, content, appearance).header(top);
}

} // namespace thetalane

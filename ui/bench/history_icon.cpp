#include "ui/bench/history_icon.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace thetalane {
namespace {

constexpr double grid = 24;

class HistoryEngine : public QIconEngine {
public:
    HistoryEngine(bool forward, const QColor& colour, const QColor& disabled)
        : m_forward(forward)
        , m_colour(colour)
        , m_disabled(disabled) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const double side = std::min(rect.width(), rect.height());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(QRectF(rect).center());
        painter->scale((m_forward ? -1 : 1) * side / grid, side / grid);
        painter->translate(-grid / 2, -grid / 2);
        QPainterPath path({5, 9.5});
        path.lineTo(14, 9.5);
        path.arcTo(QRectF(9, 9.5, 10, 10), 90, -180);
        path.lineTo(9, 19.5);
        path.moveTo(9.5, 4.5);
        path.lineTo(4.5, 9.5);
        path.lineTo(9.5, 14.5);
        const QColor ink = mode == QIcon::Disabled ? m_disabled : m_colour;
        painter->setPen(QPen(ink, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->drawPath(path);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect({}, size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new HistoryEngine(*this); }

private:
    bool m_forward;
    QColor m_colour, m_disabled;
};

} // namespace

QIcon historyIcon(bool forward, const QColor& colour, const QColor& disabled) {
    return QIcon(new HistoryEngine(forward, colour, disabled));
}

} // namespace thetalane

#include "ui/map/map_legend.h"

#include "ui/plot/strike_map_figure.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QPainter>

#include <cmath>

namespace thetalane {

MapLegend::MapLegend(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("mapLegend"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
    retranslate();
}

void MapLegend::setMarked(int pinsDown) {
    m_marked = pinsDown;
    update();
}

QSize MapLegend::sizeHint() const {
    const double line = QFontMetricsF(m_appearance.font(Appearance::Size::Small)).height();
    return {300, int(std::ceil(1.3 * line + 1.5 * m_appearance.unit()))};
}

void MapLegend::retranslate() {
    m_title = tr("Pins down");
    setAccessibleName(m_title);
    setToolTip(tr("How many pins go down there; amber: all ten, a strike"));
    update();
}

void MapLegend::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void MapLegend::paintEvent(QPaintEvent*) {
    QPainter p(this);
    const Appearance& a = m_appearance;
    const QFont font = a.font(Appearance::Size::Small);
    const QFontMetricsF metrics(font);
    p.setFont(font);
    p.setPen(a.quietText());
    const double words = std::ceil(metrics.horizontalAdvance(m_title)) + a.unit();
    const double high = 1.5 * a.unit();
    p.drawText(QRectF(0, 0, words, high), Qt::AlignLeft | Qt::AlignVCenter, m_title);
    const double wide = (width() - words - 2) / 11.0;
    for (int pins = 0; pins <= 10; ++pins) {
        const QRectF swatch(words + pins * wide, 1, wide - 2, high - 2);
        p.setPen(QPen(a.line(), 1));
        p.setBrush(pins == 10 ? strikeColour() : pinsDownColour(pins));
        p.drawRect(swatch);
        if (pins == m_marked) {
            p.setPen(QPen(a.text(), a.lineWidth()));
            p.setBrush(Qt::NoBrush);
            p.drawRect(swatch);
        }
        p.setPen(pins == m_marked ? a.text() : a.quietText());
        p.drawText(QRectF(swatch.left() - wide, high, 3 * wide, 1.3 * metrics.height()),
                   Qt::AlignHCenter | Qt::AlignTop, QString::number(pins));
    }
}

} // namespace thetalane

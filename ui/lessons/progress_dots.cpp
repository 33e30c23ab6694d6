#include "ui/lessons/progress_dots.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace thetalane {

ProgressDots::ProgressDots(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("lessonDots"));
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
    retranslate();
}

void ProgressDots::setPages(int count, int question) {
    m_count = count;
    m_question = question;
    retranslate();
    update();
}

void ProgressDots::setPage(int page) {
    m_page = page;
    retranslate();
    update();
}

void ProgressDots::retranslate() {
    setAccessibleName(tr("Page %1 of %2").arg(m_page + 1).arg(m_count));
    setToolTip(tr("Page %1 of %2; click a dot to go there").arg(m_page + 1).arg(m_count));
}

void ProgressDots::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

QSize ProgressDots::sizeHint() const {
    return {12 * m_appearance.unit(), m_appearance.projector() ? 36 : 24};
}

double ProgressDots::pitch() const {
    return std::min(3.0 * m_appearance.unit(), double(width()) / std::max(1, m_count));
}

double ProgressDots::left() const {
    return (width() - m_count * pitch()) / 2;
}

void ProgressDots::mousePressEvent(QMouseEvent* event) {
    const int page = int((event->position().x() - left()) / pitch());
    if (event->button() == Qt::LeftButton && event->position().x() >= left() && page < m_count)
        emit chosen(page);
}

void ProgressDots::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int k = 0; k < m_count; ++k) {
        const bool isHere = k == m_page;
        const double radius = std::min(m_appearance.unit() * (isHere ? 0.75 : 0.5), pitch() / 2 - 1);
        const QPointF centre(left() + (k + 0.5) * pitch(), height() / 2.0);
        const QColor colour = k <= m_page ? m_appearance.accent() : m_appearance.quietText();
        painter.setPen(QPen(colour, m_appearance.lineWidth() * 0.75));
        painter.setBrush(k <= m_page ? QBrush(colour) : QBrush(Qt::NoBrush));
        if (k == m_question) {
            const double r = radius * 1.3;
            const QPointF diamond[] = {centre + QPointF(0, -r), centre + QPointF(r, 0),
                                       centre + QPointF(0, r), centre + QPointF(-r, 0)};
            painter.drawPolygon(diamond, 4);
        } else {
            painter.drawEllipse(centre, radius, radius);
        }
    }
}

} // namespace thetalane

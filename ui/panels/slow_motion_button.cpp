#include "ui/panels/slow_motion_button.h"

#include "ui/panels/rate_chooser.h"

#include <QEvent>
#include <QPainter>

#include <cmath>
#include <numbers>

namespace thetalane {

SlowMotionButton::SlowMotionButton(const Context& context, QWidget* parent)
    : QAbstractButton(parent)
    , m_context(context) {
    setObjectName(QStringLiteral("slowMotionButton"));
    setCheckable(true);
    setChecked(context.playhead.slowAtImpact());
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(this, &QAbstractButton::toggled, &context.playhead, &Playhead::setSlowAtImpact);
    connect(&context.playhead, &Playhead::slowAtImpactChanged, this, &QAbstractButton::setChecked);
    connect(&context.appearance, &Appearance::changed, this, [this] { updateGeometry(); });
    retranslate();
}

void SlowMotionButton::retranslate() {
    const QString name = tr("Slow motion at impact");
    setAccessibleName(name);
    setToolTip(
        tr("Slow motion at impact: %1 while the ball meets the pins").arg(rateText(Playhead::impactRate)));
}

void SlowMotionButton::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QAbstractButton::changeEvent(event);
}

QSize SlowMotionButton::sizeHint() const {
    const int side = m_context.appearance.projector() ? 40 : 30;
    return {side, side};
}

// Two discs as they meet, and the flash between them.
void SlowMotionButton::paintEvent(QPaintEvent*) {
    const Appearance& look = m_context.appearance;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5);
    if (isChecked() || underMouse() || isDown()) {
        QColor back = isChecked() ? look.accent() : look.line();
        back.setAlphaF(isChecked() ? 0.18f : 1);
        painter.setPen(Qt::NoPen);
        painter.setBrush(back);
        painter.drawRoundedRect(box, 6, 6);
    }
    if (hasFocus()) {
        painter.setPen(QPen(look.accent(), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box, 6, 6);
    }
    const QColor ink = isChecked() ? look.accent() : look.text();
    const double r = 0.17 * width();
    const QPointF contact = box.center() + QPointF(0.04 * width(), 0.08 * width());
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawEllipse(contact - QPointF(1.15 * r, 0), r, r);
    painter.setPen(QPen(ink, 0.06 * width(), Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(contact + QPointF(0.75 * r, 0), 0.65 * r, 0.65 * r);
    for (const double angle : {60.0, 90.0, 120.0}) {
        const QPointF out(std::cos(angle * std::numbers::pi / 180),
                          -std::sin(angle * std::numbers::pi / 180));
        painter.drawLine(contact + out * 1.15 * r, contact + out * 1.9 * r);
    }
}

} // namespace thetalane

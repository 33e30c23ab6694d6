#include "ui/steps/step_header.h"

#include "ui/words/glossary.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace thetalane {

using Size = Appearance::Size;

StepHeader::StepHeader(const Appearance& appearance, Stage stage, QWidget* parent)
    : QAbstractButton(parent)
    , m_appearance(appearance)
    , m_stage(stage) {
    setObjectName(QStringLiteral("stepHeader%1").arg(int(stage)));
    static constexpr const char* terms[] = {"contact",  "velocity-split", "rotation",
                                            "exchange", "rotation-back",  "momentum-conservation"};
    setProperty(termProperty, terms[int(stage)]);
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
    retranslate();
}

void StepHeader::retranslate() {
    setText(stageTitle(m_stage));
    setToolTip(tr("Open step %1: %2").arg(int(m_stage)).arg(text()));
    setAccessibleName(tr("Step %1: %2").arg(int(m_stage)).arg(text()));
    update();
}

void StepHeader::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QAbstractButton::changeEvent(event);
}

// Up and down are the panel's: they step the stage, where a button would move the focus.
void StepHeader::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down)
        event->ignore();
    else
        QAbstractButton::keyPressEvent(event);
}

void StepHeader::setCurrent(bool current) {
    m_current = current;
    update();
}

void StepHeader::setKey(const WorkedLine& line) {
    m_key = line;
    setAccessibleDescription(plainText(line));
    update();
}

QSize StepHeader::sizeHint() const {
    return {240, 5 * m_appearance.unit() - 4};
}

QSize StepHeader::minimumSizeHint() const {
    return {160, sizeHint().height()};
}

void StepHeader::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double unit = m_appearance.unit();
    const QColor accent = m_appearance.accent();
    if (!m_current && (underMouse() || hasFocus())) {
        QColor wash = accent;
        wash.setAlphaF(0.07f);
        painter.fillRect(rect(), wash);
    }
    if (hasFocus()) {
        painter.setPen(QPen(accent, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }

    const double d = m_appearance.pixels(Size::Normal) + 1.1 * unit;
    const QRectF circle(1.5 * unit, (height() - d) / 2, d, d);
    painter.setPen(m_current ? QPen(Qt::NoPen) : QPen(m_appearance.quietText(), 1.2));
    painter.setBrush(m_current ? QBrush(accent) : QBrush(Qt::NoBrush));
    painter.drawEllipse(circle);
    painter.setPen(m_current ? m_appearance.card() : m_appearance.quietText());
    painter.setFont(m_appearance.font(Size::Normal, true));
    painter.drawText(circle, Qt::AlignCenter, QString::number(int(m_stage)));

    const QFont font = m_appearance.font(m_current ? Size::Large : Size::Normal, m_current);
    const QFontMetricsF metrics(font);
    const double left = circle.right() + unit;
    const double right = width() - 1.5 * unit;
    painter.setFont(font);
    painter.setPen(m_current ? m_appearance.text() : m_appearance.quietText());
    const double titleWidth = std::min(metrics.horizontalAdvance(text()), right - left);
    painter.drawText(QRectF(left, 0, right - left, height()), Qt::AlignVCenter | Qt::AlignLeft,
                     metrics.elidedText(text(), Qt::ElideRight, right - left));
    if (m_current)
        return;

    const FormulaLayout layout(m_appearance, m_appearance.pixels(Size::Normal));
    const FormulaBox key = layout.box(row({m_key.left, op("="), m_key.result}));
    if (!isEmpty(m_key.result) && key.width < right - left - titleWidth - unit)
        paintFormula(painter, key, {right - key.width, height() / 2.0 + layout.axis()}, m_appearance);
}

} // namespace thetalane

#include "ui/lane/zoom_buttons.h"

#include "ui/lane/arrow.h"
#include "ui/lane/lane_view.h"

#include <QEvent>
#include <QPainter>

namespace thetalane {
namespace {

enum class Icon { Plus, Minus, Fit };

class IconButton : public QAbstractButton {
public:
    IconButton(Icon icon, const Appearance& appearance, QWidget* parent)
        : QAbstractButton(parent)
        , m_icon(icon)
        , m_look(appearance) {
        setCursor(Qt::ArrowCursor);
        setFocusPolicy(Qt::TabFocus);
        setAttribute(Qt::WA_Hover);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
        painter.setPen(QPen(hasFocus() ? m_look.accent() : m_look.line(), hasFocus() ? 2 : 1));
        painter.setBrush(isDown()       ? mixed(m_look.accent(), m_look.card(), 0.2)
                         : underMouse() ? mixed(m_look.accent(), m_look.card(), 0.08)
                                        : faded(m_look.card(), 0.92));
        painter.drawRoundedRect(box, 6, 6);
        painter.setPen(
            QPen(m_look.quietText(), 0.9 * m_look.lineWidth(), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const QPointF c = box.center();
        const double r = 0.22 * width();
        if (m_icon == Icon::Fit) {
            paintCorners(painter, c, r);
            return;
        }
        painter.drawLine(c - QPointF(r, 0), c + QPointF(r, 0));
        if (m_icon == Icon::Plus)
            painter.drawLine(c - QPointF(0, r), c + QPointF(0, r));
    }

private:
    static void paintCorners(QPainter& painter, const QPointF& c, double r) {
        for (const int sx : {-1, 1})
            for (const int sy : {-1, 1}) {
                const QPointF corner = c + QPointF(sx * r, sy * r);
                const QPointF l[] = {corner - QPointF(0, sy * 0.7 * r), corner,
                                     corner - QPointF(sx * 0.7 * r, 0)};
                painter.drawPolyline(l, 3);
            }
    }

    Icon m_icon;
    const Appearance& m_look;
};

} // namespace

ZoomButtons::ZoomButtons(LaneView& view, const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_buttons{new IconButton(Icon::Plus, appearance, this), new IconButton(Icon::Minus, appearance, this),
                new IconButton(Icon::Fit, appearance, this)} {
    m_buttons[0]->setObjectName("zoomIn");
    m_buttons[1]->setObjectName("zoomOut");
    m_buttons[2]->setObjectName("zoomFit");
    connect(m_buttons[0], &QAbstractButton::clicked, &view, &LaneView::zoomIn);
    connect(m_buttons[1], &QAbstractButton::clicked, &view, &LaneView::zoomOut);
    connect(m_buttons[2], &QAbstractButton::clicked, &view, &LaneView::fit);
    connect(&appearance, &Appearance::changed, this, [this] {
        arrange();
        emit resized();
    });
    arrange();
    retranslate();
}

QSize ZoomButtons::sizeHint() const {
    const int side = m_appearance.projector() ? 40 : 30;
    return {3 * side + 2 * 4, side};
}

void ZoomButtons::arrange() {
    const int side = sizeHint().height();
    for (int i = 0; i < 3; ++i)
        m_buttons[std::size_t(i)]->setGeometry(i * (side + 4), 0, side, side);
}

void ZoomButtons::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void ZoomButtons::retranslate() {
    const QString names[] = {tr("Zoom in"), tr("Zoom out"), tr("Show everything")};
    const char* keys[] = {"+", "−", "F"};
    for (std::size_t i = 0; i < 3; ++i) {
        m_buttons[i]->setAccessibleName(names[i]);
        m_buttons[i]->setToolTip(QStringLiteral("%1 (%2)").arg(names[i], QString::fromUtf8(keys[i])));
    }
}

} // namespace thetalane

#include "ui/lane/zoom_buttons.h"

#include "ui/lane/arrow.h"
#include "ui/lane/lane_view.h"

#include <QEvent>
#include <QPainter>

namespace thetalane {
namespace {

enum class Icon { Rack, FoulLine, Follow, Plus, Minus, Fit };

class IconButton : public QAbstractButton {
public:
    IconButton(Icon icon, const Appearance& appearance, QWidget* parent)
        : QAbstractButton(parent)
        , m_icon(icon)
        , m_look(appearance) {
        setCursor(Qt::ArrowCursor);
        setFocusPolicy(Qt::TabFocus);
        setAttribute(Qt::WA_Hover);
        setCheckable(icon == Icon::Follow);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
        const bool bright = hasFocus() || isChecked();
        painter.setPen(QPen(bright ? m_look.accent() : m_look.line(), bright ? 2 : 1));
        painter.setBrush(isDown() || isChecked() ? mixed(m_look.accent(), m_look.card(), 0.2)
                         : underMouse()          ? mixed(m_look.accent(), m_look.card(), 0.08)
                                                 : faded(m_look.card(), 0.92));
        painter.drawRoundedRect(box, 6, 6);
        painter.setPen(QPen(isChecked() ? m_look.accent() : m_look.quietText(), 0.9 * m_look.lineWidth(),
                            Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        paintIcon(painter, box.center(), 0.22 * width());
    }

private:
    void paintIcon(QPainter& painter, const QPointF& c, double r) const {
        switch (m_icon) {
        case Icon::Rack:
            return paintPins(painter, c, r);
        case Icon::FoulLine: // a ball on a line, and where it is to go
            painter.drawLine(c + QPointF(-1.2 * r, 0.7 * r), c + QPointF(1.2 * r, 0.7 * r));
            painter.drawEllipse(c + QPointF(0, 0.7 * r), 0.45 * r, 0.45 * r);
            return paintUp(painter, c, 0.0, -1.25 * r, 0.4 * r);
        case Icon::Follow: // a ball in a frame that goes up
            paintCorners(painter, c, 1.15 * r);
            return paintUp(painter, c, 0.65 * r, -0.65 * r, 0.4 * r);
        case Icon::Fit:
            return paintCorners(painter, c, r);
        case Icon::Plus:
            painter.drawLine(c - QPointF(0, r), c + QPointF(0, r));
            [[fallthrough]];
        case Icon::Minus:
            painter.drawLine(c - QPointF(r, 0), c + QPointF(r, 0));
        }
    }

    static void paintPins(QPainter& painter, const QPointF& c, double r) {
        painter.setBrush(painter.pen().color());
        painter.setPen(Qt::NoPen);
        for (int row = 0; row < 3; ++row)
            for (int k = 0; k <= row; ++k)
                painter.drawEllipse(c + QPointF((k - row / 2.0) * 0.95, 0.8 - row * 0.85) * r, 0.3 * r,
                                    0.3 * r);
    }

    static void paintUp(QPainter& painter, const QPointF& c, double from, double to, double head) {
        painter.drawLine(c + QPointF(0, from), c + QPointF(0, to));
        const QPointF wings[] = {c + QPointF(-head, to + head), c + QPointF(0, to),
                                 c + QPointF(head, to + head)};
        painter.drawPolyline(wings, 3);
    }

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
    , m_appearance(appearance) {
    static constexpr std::pair<Icon, const char*> kinds[placeCount] = {
        {Icon::Rack, "showRack"}, {Icon::FoulLine, "showFoulLine"}, {Icon::Follow, "followBall"},
        {Icon::Plus, "zoomIn"},   {Icon::Minus, "zoomOut"},         {Icon::Fit, "zoomFit"}};
    for (const auto& [icon, name] : kinds) {
        m_buttons.push_back(new IconButton(icon, appearance, this));
        m_buttons.back()->setObjectName(name);
    }
    connect(m_buttons[Rack], &QAbstractButton::clicked, &view, &LaneView::showRack);
    connect(m_buttons[FoulLine], &QAbstractButton::clicked, &view, &LaneView::showFoulLine);
    connect(m_buttons[Follow], &QAbstractButton::clicked, &view, &LaneView::setFollowing);
    connect(m_buttons[Follow], &QAbstractButton::clicked, this, &ZoomButtons::followChosen);
    connect(&view, &LaneView::followingChanged, m_buttons[Follow], &QAbstractButton::setChecked);
    connect(m_buttons[In], &QAbstractButton::clicked, &view, &LaneView::zoomIn);
    connect(m_buttons[Out], &QAbstractButton::clicked, &view, &LaneView::zoomOut);
    connect(m_buttons[Fit], &QAbstractButton::clicked, &view, &LaneView::fit);
    connect(&appearance, &Appearance::changed, this, [this] {
        arrange();
        emit resized();
    });
    arrange();
    retranslate();
}

void ZoomButtons::setLane(bool lane) {
    if (lane == m_lane)
        return;
    m_lane = lane;
    arrange();
    emit resized();
}

QSize ZoomButtons::sizeHint() const {
    const int side = m_appearance.projector() ? 40 : 30;
    const int count = m_lane ? placeCount : placeCount - In;
    return {count * side + (count - 1) * 4 + (m_lane ? 8 : 0), side};
}

void ZoomButtons::arrange() {
    const int side = sizeHint().height();
    int x = 0;
    for (int place = 0; place < placeCount; ++place) {
        QAbstractButton* button = m_buttons[std::size_t(place)];
        button->setVisible(m_lane || place >= In);
        if (!m_lane && place < In)
            continue;
        if (m_lane && place == In)
            x += 8;
        button->setGeometry(x, 0, side, side);
        x += side + 4;
    }
}

void ZoomButtons::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void ZoomButtons::retranslate() {
    const std::pair<QString, const char*> words[placeCount] = {
        {tr("Show the rack"), "P"}, {tr("Show the foul line"), "B"}, {tr("Follow the ball"), "C"},
        {tr("Zoom in"), "+"},       {tr("Zoom out"), "−"},           {tr("Show everything"), "F"}};
    for (std::size_t i = 0; i < placeCount; ++i) {
        m_buttons[i]->setAccessibleName(words[i].first);
        m_buttons[i]->setToolTip(
            QStringLiteral("%1 (%2)").arg(words[i].first, QString::fromUtf8(words[i].second)));
    }
}

} // namespace thetalane

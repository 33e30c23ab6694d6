#include "ui/predict/predict_figure.h"

#include "ui/words/number_text.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <limits>

namespace thetalane {
namespace {

using Size = Appearance::Size;

Vec2d rounded(const Vec2d& v, double step) {
    return {std::round(v.x / step) * step, std::round(v.y / step) * step};
}

// How long an arrow from a place may be drawn so that its tip stays in the room [px per m/s].
double reachOf(const QPointF& from, const Vec2d& v, const QRectF& room) {
    const auto along = [](double start, double pace, double low, double high) {
        return pace > 0   ? (high - start) / pace
               : pace < 0 ? (low - start) / pace
                          : std::numeric_limits<double>::infinity();
    };
    return std::max(0.0, std::min(along(from.x(), v.x, room.left(), room.right()),
                                  along(from.y(), -v.y, room.top(), room.bottom())));
}

// A step that reads well, about a hundredth of the speed: 0.01, 0.02, 0.05, 0.1 …
double stepFor(double speed) {
    const double raw = speed / 60, ten = std::pow(10.0, std::floor(std::log10(raw)));
    return raw / ten >= 5 ? 5 * ten : raw / ten >= 2 ? 2 * ten : ten;
}

} // namespace

PredictFigure::PredictFigure(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("predictFigure"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
    retranslate();
}

void PredictFigure::setKnown(const Known& known) {
    m_known = known;
    m_truth.reset();
    m_chosen = 0;
    update();
}

void PredictFigure::setGuess(const VelocityPair<double>& guess) {
    m_guess = guess;
    keepInside();
    retranslate();
}

void PredictFigure::reveal(const std::optional<VelocityPair<double>>& truth) {
    m_truth = truth;
    update();
}

void PredictFigure::retranslate() {
    setAccessibleName(tr("Arrows after the collision, as you expect them"));
    QStringList values;
    for (int b = 0; b < bodies(); ++b)
        values << QStringLiteral("%1: (%2, %3) m/s")
                      .arg(b == 0 ? m_known.firstName : m_known.secondName, numberText(guessOf(b).x, 3),
                           numberText(guessOf(b).y, 3));
    setAccessibleDescription(values.join(QStringLiteral("; ")));
    setToolTip(tr("Drag the round tips. With the keyboard: arrow keys move the tip, Shift for larger steps, "
                  "Space changes to the other body."));
}

void PredictFigure::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

QSize PredictFigure::sizeHint() const {
    return {320, m_appearance.projector() ? 260 : 240};
}

QSize PredictFigure::minimumSizeHint() const {
    return {240, m_appearance.projector() ? 180 : 170};
}

// The bodies take a quarter of the figure, the arrows the rest.
double PredictFigure::pixelsPerMetre() const {
    const double size = std::min(width(), height());
    const double metres =
        m_known.isWall ? 4 * m_known.first.radius : 2 * (m_known.first.radius + m_known.second.radius);
    return metres > 0 ? 0.36 * size / metres : 1;
}

// What is typed may be longer than what a tip can be dragged to.
void PredictFigure::keepInside() {
    m_inside = m_guess;
    update();
}

// From the masses alone: as fast as the lighter one may get to be; and no arrow ends outside.
double PredictFigure::pixelsPerSpeed() const {
    const double masses = m_known.first.mass + m_known.second.mass;
    const double gain = m_known.isWall ? 1 : 2 * std::max(m_known.first.mass, m_known.second.mass) / masses;
    const double widest = m_known.speed * 1.2 * gain;
    double scale = widest > 0 ? 0.46 * std::min(width(), height()) / widest : 1;
    const double edge = m_appearance.projector() ? 16 : 12; // for the ring at the tip
    const QRectF room = QRectF(rect()).adjusted(edge, edge, -edge, -edge - m_appearance.pixels(Size::Small));
    for (int b = 0; b < bodies(); ++b) {
        scale = std::min(scale, reachOf(centre(b), b == 0 ? m_inside.first : m_inside.second, room));
        if (m_truth)
            scale = std::min(scale, reachOf(centre(b), b == 0 ? m_truth->first : m_truth->second, room));
    }
    return scale;
}

// Seen from the point where they touch, which is in the middle.
QPointF PredictFigure::centre(int body) const {
    const Vec2d along{m_known.contact.cosTheta, m_known.contact.sinTheta};
    const double reach = body == 0 ? m_known.first.radius : -m_known.second.radius;
    const double scale = pixelsPerMetre();
    return {width() / 2.0 + along.x * reach * scale, height() / 2.0 - along.y * reach * scale};
}

QPointF PredictFigure::tip(int body) const {
    const Vec2d v = guessOf(body);
    return centre(body) + QPointF(v.x, -v.y) * pixelsPerSpeed();
}

int PredictFigure::tipAt(QPointF where) const {
    const double reach = m_appearance.projector() ? 22 : 16;
    int found = -1;
    double nearest = reach;
    for (int b = 0; b < bodies(); ++b)
        if (const double d = QLineF(where, tip(b)).length(); d <= nearest) {
            nearest = d;
            found = b;
        }
    return found;
}

void PredictFigure::put(int body, const Vec2d& velocity) {
    guessOf(body) = velocity;
    if (m_dragged < 0)
        keepInside();
    retranslate();
    update();
    emit guessed(m_guess);
}

void PredictFigure::mousePressEvent(QMouseEvent* event) {
    setFocus();
    m_dragged = event->button() == Qt::LeftButton && !m_truth ? tipAt(event->position()) : -1;
    if (m_dragged >= 0)
        m_chosen = m_dragged;
    update();
}

void PredictFigure::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragged < 0) {
        setCursor(!m_truth && tipAt(event->position()) >= 0 ? Qt::OpenHandCursor : Qt::ArrowCursor);
        return;
    }
    setCursor(Qt::ClosedHandCursor);
    const QPointF inside(std::clamp(event->position().x(), 4.0, width() - 4.0),
                         std::clamp(event->position().y(), 4.0, height() - 4.0));
    const QPointF arrow = (inside - centre(m_dragged)) / pixelsPerSpeed();
    put(m_dragged, rounded({arrow.x(), -arrow.y()}, stepFor(m_known.speed)));
}

void PredictFigure::mouseReleaseEvent(QMouseEvent* event) {
    m_dragged = -1;
    keepInside();
    setCursor(!m_truth && tipAt(event->position()) >= 0 ? Qt::OpenHandCursor : Qt::ArrowCursor);
}

bool PredictFigure::keyPressed(int key, Qt::KeyboardModifiers modifiers) {
    const double step = stepFor(m_known.speed) * (modifiers & Qt::ShiftModifier ? 10 : 1);
    Vec2d v = guessOf(m_chosen);
    switch (key) {
    case Qt::Key_Left:
        v.x -= step;
        break;
    case Qt::Key_Right:
        v.x += step;
        break;
    case Qt::Key_Up:
        v.y += step;
        break;
    case Qt::Key_Down:
        v.y -= step;
        break;
    case Qt::Key_Space:
        m_chosen = bodies() - 1 - m_chosen;
        update();
        return true;
    default:
        return false;
    }
    const auto clean = [](double x) { return QString::number(x, 'g', 12).toDouble(); }; // 0.1 + 0.2 is 0.3
    put(m_chosen, {clean(v.x), clean(v.y)});
    return true;
}

// The window has other uses for these keys.
bool PredictFigure::event(QEvent* event) {
    if ((event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) || m_truth)
        return QWidget::event(event);
    auto* key = static_cast<QKeyEvent*>(event);
    const bool ours =
        (key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down) || key->key() == Qt::Key_Space;
    if (!ours || key->modifiers() & (Qt::ControlModifier | Qt::AltModifier))
        return QWidget::event(event);
    if (event->type() == QEvent::KeyPress)
        keyPressed(key->key(), key->modifiers());
    event->accept();
    return true;
}

void PredictFigure::paintBodies(QPainter& painter) const {
    const Appearance& look = m_appearance;
    const double scale = pixelsPerMetre();
    const QPointF middle(width() / 2.0, height() / 2.0);
    const QPointF along(m_known.contact.cosTheta, -m_known.contact.sinTheta);
    const QPointF across(-along.y(), along.x());
    painter.setPen(QPen(look.line().darker(115), 1, Qt::DashLine));
    painter.drawLine(middle - along * width(), middle + along * width()); // the line of centres
    if (m_known.isWall) {
        painter.setPen(QPen(look.quietText(), 2 * look.lineWidth()));
        painter.drawLine(middle - across * width(), middle + across * width());
    }
    for (int b = 0; b < bodies(); ++b) {
        QColor fill = look.ink(b == 0 ? Ink::First : Ink::Second);
        painter.setPen(QPen(fill, 1.5));
        fill.setAlpha(36);
        painter.setBrush(fill);
        const double r = (b == 0 ? m_known.first.radius : m_known.second.radius) * scale;
        painter.drawEllipse(centre(b), r, r);
        // Beside the line of centres, behind the way that the two pass each other.
        const double passing = m_known.first.velocity.y * m_known.contact.cosTheta -
                               m_known.first.velocity.x * m_known.contact.sinTheta;
        const QPointF beside = across * ((passing >= 0 ? 1 : -1) * (r + 0.8 * look.pixels(Size::Normal)));
        painter.setPen(look.textInk(b == 0 ? Ink::First : Ink::Second));
        painter.setFont(look.font(Size::Normal, true));
        painter.drawText(QRectF(centre(b) + beside - QPointF(60, 14), QSizeF(120, 28)), Qt::AlignCenter,
                         b == 0 ? m_known.firstName : m_known.secondName);
    }
}

void PredictFigure::paintArrow(QPainter& painter, int body, const Vec2d& v, const QColor& colour,
                               double width, Qt::PenStyle style, bool filled) const {
    const QPointF from = centre(body), to = from + QPointF(v.x, -v.y) * pixelsPerSpeed();
    const QLineF line(from, to);
    if (line.length() < 2)
        return;
    const QPointF along = (to - from) / line.length(), across(-along.y(), along.x());
    const double head = std::min(5 * width, line.length());
    QPen pen(colour, width, style, Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLine(from, to - along * (filled ? head * 0.8 : 0));
    const QPointF left = to - along * head + across * head * 0.5,
                  right = to - along * head - across * head * 0.5;
    painter.setPen(QPen(colour, filled ? 1 : width));
    painter.setBrush(filled ? QBrush(colour) : QBrush(Qt::NoBrush));
    const QPointF points[] = {left, to, right};
    filled ? painter.drawPolygon(points, 3) : painter.drawPolyline(points, 3);
}

void PredictFigure::paintTip(QPainter& painter, int body) const {
    const QColor colour = m_appearance.ink(body == 0 ? Ink::First : Ink::Second);
    const double r = m_appearance.projector() ? 11 : 8;
    const bool isChosen = body == m_chosen && (hasFocus() || m_dragged == body);
    painter.setPen(QPen(isChosen ? m_appearance.text() : colour, isChosen ? 3 : 2));
    painter.setBrush(m_appearance.card());
    painter.drawEllipse(tip(body), r, r);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(tip(body), r * 0.4, r * 0.4);
}

// What the kinds of arrows mean.
void PredictFigure::paintKey(QPainter& painter) const {
    const Appearance& look = m_appearance;
    const QFont font = look.font(Appearance::Size::Small);
    painter.setFont(font);
    const QFontMetrics metrics(font);
    struct Row {
        QString text;
        Qt::PenStyle style;
        double width;
        bool quiet;
    };
    std::vector<Row> rows{{tr("before"), Qt::DotLine, look.lineWidth(), true},
                          {tr("expected"), Qt::DashLine, look.lineWidth(), false}};
    if (m_truth)
        rows.push_back({tr("truth"), Qt::SolidLine, 2 * look.lineWidth(), false});
    double x = look.unit();
    for (const Row& row : rows) {
        const double y = height() - metrics.height() / 2.0 - 4;
        painter.setPen(QPen(row.quiet ? look.quietText() : look.text(), row.width, row.style, Qt::FlatCap));
        painter.drawLine(QPointF(x, y), QPointF(x + 24, y));
        painter.setPen(look.text());
        painter.drawText(QPointF(x + 30, y + metrics.ascent() / 2.0 - 1), row.text);
        x += 30 + metrics.horizontalAdvance(row.text) + 2 * look.unit();
    }
}

void PredictFigure::paintEvent(QPaintEvent*) {
    const Appearance& look = m_appearance;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(hasFocus() ? look.accent() : look.line(), hasFocus() ? 2 : 1));
    painter.setBrush(look.card());
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
    painter.setClipRect(rect().adjusted(2, 2, -2, -2));
    paintBodies(painter);
    for (int b = 0; b < bodies(); ++b) {
        const Ink ink = b == 0 ? Ink::First : Ink::Second;
        QColor pale = look.ink(ink);
        pale.setAlpha(170);
        paintArrow(painter, b, b == 0 ? m_known.first.velocity : m_known.second.velocity, pale,
                   look.lineWidth(), Qt::DotLine, false);
        if (m_truth)
            paintArrow(painter, b, b == 0 ? m_truth->first : m_truth->second, look.ink(ink),
                       2 * look.lineWidth(), Qt::SolidLine, true);
    }
    for (int b = 0; b < bodies(); ++b) {
        paintArrow(painter, b, guessOf(b), look.textInk(b == 0 ? Ink::First : Ink::Second),
                   1.25 * look.lineWidth(), Qt::DashLine, m_truth.has_value());
        if (!m_truth)
            paintTip(painter, b);
    }
    paintKey(painter);
}

} // namespace thetalane

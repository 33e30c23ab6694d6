#include "ui/panels/scrub_bar.h"

#include "ui/count_text.h"
#include "ui/words/instant.h"
#include "ui/words/number_text.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <vector>

namespace thetalane {

ScrubBar::ScrubBar(const Context& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context) {
    setObjectName(QStringLiteral("scrubBar"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    connect(&context.playhead, &Playhead::timeChanged, this, qOverload<>(&QWidget::update));
    connect(&context.playhead, &Playhead::selectionChanged, this, qOverload<>(&QWidget::update));
    connect(&context.session, &Session::runChanged, this, &ScrubBar::forgetTicks);
    connect(&context.session, &Session::chapterChanged, this, &ScrubBar::forgetTicks);
    connect(&context.session, &Session::progressed, this, &ScrubBar::showProgress);
    connect(&context.appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        forgetTicks();
    });
    retranslate();
}

void ScrubBar::retranslate() {
    setAccessibleName(tr("Time"));
    setAccessibleDescription(
        tr("Drag to any time. Click a tick to open that collision. Arrow keys step by frames, with Ctrl by "
           "collisions; Home and End go to the ends."));
}

void ScrubBar::forgetTicks() {
    m_ticks = {};
    update();
}

void ScrubBar::showProgress() {
    if (m_context.playhead.end() != m_ticksUntil)
        m_ticks = {};
    update();
}

double ScrubBar::xAt(double time) const {
    const double end = m_context.playhead.end();
    return margin() + (end > 0 ? time / end : 0) * (width() - 2 * margin());
}

double ScrubBar::timeAt(double x) const {
    const double share = (x - margin()) / std::max(1.0, width() - 2 * margin());
    return std::clamp(share, 0.0, 1.0) * m_context.playhead.end();
}

std::optional<std::size_t> ScrubBar::collisionNear(double x) const {
    const auto collisions = m_context.session.timeline().collisions();
    if (collisions.empty())
        return std::nullopt;
    // Of the same instant, the first.
    const auto firstFrom = [&](double time) {
        return std::size_t(std::lower_bound(collisions.begin(), collisions.end(), time,
                                            [](const Collision& c, double t) { return c.time < t; }) -
                           collisions.begin());
    };
    const std::size_t after = firstFrom(timeAt(x));
    std::optional<std::size_t> best;
    double nearest = reach + 0.5;
    const auto consider = [&](std::size_t k) {
        const double distance = std::abs(xAt(collisions[k].time) - x);
        const double seen = m_futureHidden ? m_context.playhead.time() : m_context.playhead.end();
        if (distance < nearest && collisions[k].time <= seen) {
            nearest = distance;
            best = k;
        }
    };
    if (after > 0)
        consider(firstFrom(collisions[after - 1].time));
    if (after < collisions.size())
        consider(after);
    return best;
}

QString ScrubBar::hintAt(double x) const {
    const auto k = collisionNear(x);
    if (!k) {
        const RunPart part = m_context.session.part();
        return part.ended || timeAt(x) < part.computedTo
                   ? QString()
                   : tr("Not computed yet; so far %1 s").arg(numberText(std::floor(part.computedTo), 6));
    }
    const Scene& scene = m_context.session.scene();
    const auto collisions = m_context.session.timeline().collisions();
    const Collision& c = collisions[*k];
    // An id, a partner's name and a time: nothing here is a word to translate.
    QString text = QStringLiteral("%1: %2 → %3, %4 s")
                       .arg(countText(m_context.session.part().collisionsBefore + std::int64_t(*k) + 1),
                            bodyName(scene, c.first), partnerName(scene, c), numberText(c.time));
    const Instant instant = instantOf(collisions, *k);
    const int more = int(instant.begin + instant.size - *k) - 1;
    if (more)
        text +=
            QStringLiteral("\n") +
            (instant.passes == 1
                 ? tr("and %n more at the same instant, resolved together", nullptr, more)
                 : tr("and %n more at the same instant, in %1 passes", nullptr, more).arg(instant.passes));
    return text;
}

QSize ScrubBar::sizeHint() const {
    return {m_context.appearance.unit() * 40, m_context.appearance.projector() ? 44 : 32};
}

QSize ScrubBar::minimumSizeHint() const {
    return {m_context.appearance.unit() * 12, sizeHint().height()};
}

double ScrubBar::tickHeight(bool shared) const {
    const double one = m_context.appearance.projector() ? 9 : 6;
    return shared ? one * 1.8 : one;
}

void ScrubBar::paintTicks(QPainter& painter) const {
    const Appearance& look = m_context.appearance;
    // One tick a column of pixels, however many collisions share it.
    enum : char { None, Alone, Shared };
    std::vector<char> columns(std::size_t(std::max(1, width())), None);
    for (const Collision& c : m_context.session.timeline().collisions()) {
        if (c.time > m_context.playhead.end())
            break;
        char& column = columns[std::size_t(std::clamp(int(xAt(c.time)), 0, width() - 1))];
        column = std::max<char>(column, c.group ? Shared : Alone);
    }
    QColor quiet = look.quietText();
    quiet.setAlpha(look.projector() ? 220 : 150);
    if (!m_context.session.part().isWhole())
        quiet.setAlpha(quiet.alpha() / 2); // it only shows what part is at hand
    painter.setPen(Qt::NoPen);
    painter.setBrush(quiet);
    const double thick = look.projector() ? 2 : 1.5;
    for (std::size_t x = 0; x < columns.size(); ++x)
        if (columns[x] != None) {
            const double up = tickHeight(columns[x] == Shared);
            painter.drawRect(QRectF(double(x) - thick / 2 + 0.5, middle() - up, thick, 2 * up));
            if (columns[x] == Shared) // feet, as a bracket has them
                for (const double y : {middle() - up, middle() + up - thick})
                    painter.drawRect(QRectF(double(x) - 2 * thick + 0.5, y, 4 * thick, thick));
        }
}

const QPixmap& ScrubBar::ticks() {
    const QSize size = this->size() * devicePixelRatioF();
    if (m_ticks.size() != size) {
        m_ticks = QPixmap(size);
        m_ticks.setDevicePixelRatio(devicePixelRatioF());
        m_ticks.fill(Qt::transparent);
        m_ticksUntil = m_context.playhead.end();
        QPainter painter(&m_ticks);
        painter.setRenderHint(QPainter::Antialiasing);
        paintTicks(painter);
    }
    return m_ticks;
}

void ScrubBar::paintSelected(QPainter& painter) const {
    const auto selected = m_context.playhead.selected();
    const auto collisions = m_context.session.timeline().collisions();
    if (!selected || *selected >= collisions.size())
        return;
    const Collision& c = collisions[*selected];
    const double up = tickHeight(c.group != 0) + 2;
    const double thick = m_context.appearance.projector() ? 5 : 4;
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_context.appearance.ink(Ink::Triangle));
    painter.drawRoundedRect(QRectF(xAt(c.time) - thick / 2, middle() - up, thick, 2 * up), 1, 1);
}

// As far as the run is computed; the rest thin.
void ScrubBar::paintLine(QPainter& painter, double thick) const {
    const RunPart part = m_context.session.part();
    const double end = width() - margin();
    const double computed = part.ended ? end : std::min(end, xAt(part.computedTo));
    const QColor line = m_context.appearance.line();
    painter.setPen(QPen(line, 1));
    painter.drawLine(QPointF(computed, middle()), QPointF(end, middle()));
    painter.setPen(QPen(line, thick, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(margin(), middle()), QPointF(computed, middle()));
}

void ScrubBar::hideFuture(bool hidden) {
    m_futureHidden = hidden;
    update();
}

void ScrubBar::paintEvent(QPaintEvent*) {
    const Appearance& look = m_context.appearance;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double now = xAt(m_context.playhead.time());
    const double thick = look.projector() ? 4 : 3;
    paintLine(painter, thick);
    painter.setPen(QPen(look.accent(), thick, Qt::SolidLine, Qt::RoundCap));
    if (now > margin())
        painter.drawLine(QPointF(margin(), middle()), QPointF(now, middle()));
    if (m_futureHidden)
        painter.setClipRect(QRectF(0, 0, now, height()));
    painter.drawPixmap(0, 0, ticks());
    painter.setClipping(false);

    const double radius = look.projector() ? 9 : 6;
    painter.setPen(QPen(look.card(), 2));
    painter.setBrush(look.accent());
    painter.drawEllipse(QPointF(now, middle()), radius, radius);
    paintSelected(painter);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(look.accent(), 1.5));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
    }
}

void ScrubBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    m_pressed = true;
    m_dragging = false;
    m_pressedAt = event->position().x();
    if (const auto k = collisionNear(m_pressedAt)) {
        m_context.playhead.select(*k);
        return;
    }
    m_context.playhead.setPlaying(false);
    m_context.playhead.setTime(timeAt(m_pressedAt));
}

void ScrubBar::mouseMoveEvent(QMouseEvent* event) {
    const double x = event->position().x();
    if (!m_pressed) {
        const QString hint = hintAt(x);
        hint.isEmpty() ? QToolTip::hideText()
                       : QToolTip::showText(event->globalPosition().toPoint(), hint, this);
        return;
    }
    // A hand that trembles on a tick does not let go of it.
    constexpr double trembling = 3;
    m_dragging = m_dragging || std::abs(x - m_pressedAt) > trembling;
    if (m_dragging)
        m_context.playhead.setTime(timeAt(x));
}

void ScrubBar::mouseReleaseEvent(QMouseEvent*) {
    m_pressed = m_dragging = false;
}

void ScrubBar::wheelEvent(QWheelEvent* event) {
    const QPoint turned = event->angleDelta();
    m_wheel += std::abs(turned.x()) > std::abs(turned.y()) ? turned.x() : turned.y();
    const int notches = m_wheel / QWheelEvent::DefaultDeltasPerStep;
    m_wheel -= notches * QWheelEvent::DefaultDeltasPerStep;
    if (notches)
        m_context.playhead.stepFrames(notches);
    event->accept();
}

void ScrubBar::keyPressEvent(QKeyEvent* event) {
    Playhead& playhead = m_context.playhead;
    const bool far = event->modifiers() & Qt::ControlModifier;
    switch (event->key()) {
    case Qt::Key_Left:
        return far ? playhead.stepCollisions(-1) : playhead.stepFrames(-1);
    case Qt::Key_Right:
        return far ? playhead.stepCollisions(1) : playhead.stepFrames(1);
    case Qt::Key_PageUp:
        return playhead.stepCollisions(-1);
    case Qt::Key_PageDown:
        return playhead.stepCollisions(1);
    case Qt::Key_Home:
        playhead.setPlaying(false);
        return playhead.setTime(0);
    case Qt::Key_End:
        playhead.setPlaying(false);
        return playhead.setTime(playhead.end());
    default:
        QWidget::keyPressEvent(event);
    }
}

void ScrubBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace thetalane

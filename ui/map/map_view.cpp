#include "ui/map/map_view.h"

#include "ui/plot/strike_map_figure.h"
#include "ui/words/number_text.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double tickLength = 4;
constexpr double pocketOffset = 0.0676, pocketAngle = 6 * std::numbers::pi / 180; // of the books

// White below, dark above: seen on every cell.
template <class Draw> void twice(QPainter& p, const Appearance& a, const Draw& draw) {
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(QColor(Qt::white), 2.2 * a.lineWidth(), Qt::SolidLine, Qt::RoundCap));
    draw();
    p.setPen(QPen(QColor(0x1E, 0x24, 0x2B), 0.9 * a.lineWidth(), Qt::SolidLine, Qt::RoundCap));
    draw();
}

} // namespace

MapView::MapView(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("mapView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(&appearance, &Appearance::changed, this, [this] {
        m_picture = {};
        updateGeometry();
        update();
    });
    retranslate();
}

void MapView::setMap(std::shared_ptr<const StrikeMap> map) {
    const bool other = !map || !m_map || map->settings.across != m_map->settings.across ||
                       map->settings.up != m_map->settings.up;
    m_map = std::move(map);
    m_picture = {};
    if (other && m_pointed)
        point(std::nullopt);
    update();
}

void MapView::setPresent(std::optional<Values> values) {
    m_present = values;
    update();
}

void MapView::setDots(std::vector<Values> dots) {
    m_dots = std::move(dots);
    update();
}

double MapView::leftMargin() const {
    const QFontMetricsF small(m_appearance.font(Appearance::Size::Small));
    return 1.6 * small.height() + small.horizontalAdvance(QStringLiteral("−16")) + tickLength + 4;
}

double MapView::bottomMargin() const {
    return 2.5 * QFontMetricsF(m_appearance.font(Appearance::Size::Small)).height() + tickLength;
}

QRectF MapView::cells() const {
    const double pad = m_appearance.unit() / 2.0;
    return QRectF(QRectF(rect()).adjusted(leftMargin(), pad, -pad, -bottomMargin()).toAlignedRect());
}

QSize MapView::sizeHint() const {
    const int wide = m_appearance.projector() ? 480 : 344;
    return {wide, heightForWidth(wide)};
}

QSize MapView::minimumSizeHint() const {
    return {240, 220};
}

// A little wider than high, so that what is said about it stands below it.
int MapView::heightForWidth(int width) const {
    const double plot = width - leftMargin() - m_appearance.unit() / 2.0;
    return int(std::clamp(plot * 0.8, 160.0, 640.0) + bottomMargin() + m_appearance.unit() / 2.0);
}

std::optional<MapView::Place> MapView::placeAt(const QPointF& at) const {
    const QRectF area = cells();
    if (!m_map || m_map->stride == 0 || !area.contains(at))
        return std::nullopt;
    const auto index = [](double part, int count) { return std::clamp(int(part * count), 0, count - 1); };
    Place place{index((at.x() - area.left()) / area.width(), m_map->columns()),
                index((area.bottom() - at.y()) / area.height(), m_map->rows())};
    place.column -= place.column % m_map->stride;
    place.row -= place.row % m_map->stride;
    return place;
}

QPointF MapView::pointOf(const Values& values) const {
    const QRectF area = cells();
    const MapSettings& s = m_map->settings;
    const auto part = [](const MapAxis& axis, double value) {
        return axisPlace(axis, inShownUnit(axis.quantity, value));
    };
    return {area.left() + part(s.across, values.across) * area.width(),
            area.bottom() - part(s.up, values.up) * area.height()};
}

QPointF MapView::pointOf(const Place& place) const {
    const QRectF area = cells();
    return {area.left() + (place.column + 0.5) / m_map->columns() * area.width(),
            area.bottom() - (place.row + 0.5) / m_map->rows() * area.height()};
}

bool MapView::shows(const Values& values) const {
    return m_map && cells().contains(pointOf(values));
}

void MapView::describe(const QString& text) {
    setAccessibleDescription(text);
}

void MapView::retranslate() {
    setAccessibleName(tr("Strike map"));
    setToolTip(
        tr("Point at a throw to see what it leaves standing; click to throw it. Arrow keys move, Enter "
           "throws."));
    update();
}

void MapView::point(std::optional<Place> place) {
    if (place == m_pointed)
        return;
    m_pointed = place;
    update();
    emit pointedChanged();
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
    const auto place = placeAt(event->position());
    setCursor(place ? Qt::CrossCursor : Qt::ArrowCursor);
    point(place);
}

void MapView::mousePressEvent(QMouseEvent* event) {
    const auto place = event->button() == Qt::LeftButton ? placeAt(event->position()) : std::nullopt;
    if (!place)
        return;
    point(place);
    emit chosen(*place);
}

void MapView::leaveEvent(QEvent* event) {
    if (!hasFocus())
        point(std::nullopt);
    QWidget::leaveEvent(event);
}

// From the middle of the map, where nothing was pointed at before; ten at a time with Shift.
bool MapView::stepBy(int key, int cells) {
    if (!m_map || m_map->stride == 0)
        return false;
    const int stride = m_map->stride;
    const auto onGrid = [=](int k, int count) {
        k = std::clamp(k, 0, count - 1);
        return k - k % stride;
    };
    Place to = m_pointed.value_or(Place{m_map->columns() / 2, m_map->rows() / 2});
    if (m_pointed) {
        const int step = cells * stride;
        to.column += key == Qt::Key_Right ? step : key == Qt::Key_Left ? -step : 0;
        to.row += key == Qt::Key_Up ? step : key == Qt::Key_Down ? -step : 0;
    }
    point(Place{onGrid(to.column, m_map->columns()), onGrid(to.row, m_map->rows())});
    return true;
}

bool MapView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) { // the window's own arrows wait
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool plain = (key->modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
        if (plain && key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void MapView::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    if (key >= Qt::Key_Left && key <= Qt::Key_Down) {
        stepBy(key, event->modifiers() & Qt::ShiftModifier ? 10 : 1);
        return;
    }
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && m_pointed) {
        emit chosen(*m_pointed);
        return;
    }
    QWidget::keyPressEvent(event);
}

void MapView::focusInEvent(QFocusEvent* event) {
    update();
    QWidget::focusInEvent(event);
}

void MapView::focusOutEvent(QFocusEvent* event) {
    update();
    QWidget::focusOutEvent(event);
}

void MapView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void MapView::resizeEvent(QResizeEvent* event) {
    m_picture = {};
    QWidget::resizeEvent(event);
}

const QPixmap& MapView::picture() {
    if (m_picture.isNull()) {
        const QSizeF size = cells().size();
        m_picture = QPixmap((size * devicePixelRatioF()).toSize());
        m_picture.setDevicePixelRatio(devicePixelRatioF());
        m_picture.fill(m_appearance.card());
        QPainter p(&m_picture);
        paintCells(p, QRectF(QPointF(), size), *m_map);
    }
    return m_picture;
}

void MapView::paintAxes(QPainter& p) const {
    const Appearance& a = m_appearance;
    const QRectF area = cells();
    const MapSettings& s = m_map->settings;
    const QFont font = a.font(Appearance::Size::Small);
    const double line = QFontMetricsF(font).height();
    p.setFont(font);
    p.setPen(QPen(a.quietText(), 1));
    p.setBrush(Qt::NoBrush);
    p.drawRect(area);
    const int most = a.projector() ? 5 : 7;
    for (const double tick : axisTicks(s.across, most)) {
        const double x = area.left() + axisPlace(s.across, tick) * area.width();
        p.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + tickLength));
        p.drawText(QRectF(x - 4 * line, area.bottom() + tickLength, 8 * line, line),
                   Qt::AlignHCenter | Qt::AlignTop, numberText(tick));
    }
    for (const double tick : axisTicks(s.up, most)) {
        const double y = area.bottom() - axisPlace(s.up, tick) * area.height();
        p.drawLine(QPointF(area.left() - tickLength, y), QPointF(area.left(), y));
        p.drawText(QRectF(area.left() - tickLength - 2 - 5 * line, y - line / 2, 5 * line, line),
                   Qt::AlignRight | Qt::AlignVCenter, numberText(tick));
    }
    p.setPen(a.text());
    p.drawText(QRectF(0, height() - 1.3 * line, width(), 1.3 * line), Qt::AlignCenter,
               quantityTitle(s.across.quantity));
    p.save();
    p.translate(0.65 * line, area.center().y());
    p.rotate(-90);
    p.drawText(QRectF(-height() / 2.0, -line / 2, height(), line), Qt::AlignCenter,
               quantityTitle(s.up.quantity));
    p.restore();
}

void MapView::paintPockets(QPainter& p) const {
    const MapSettings& s = m_map->settings;
    if (s.across.quantity != MapQuantity::Offset || s.up.quantity != MapQuantity::Angle)
        return;
    const double r = 0.75 * m_appearance.unit();
    for (const double side : {1.0, -1.0}) {
        const Values pocket{side * pocketOffset, side * pocketAngle};
        if (shows(pocket))
            twice(p, m_appearance, [&] { p.drawEllipse(pointOf(pocket), r, r); });
    }
}

void MapView::paintMark(QPainter& p, const QPointF& at) const {
    const double inner = 0.5 * m_appearance.unit(), outer = 1.6 * m_appearance.unit();
    twice(p, m_appearance, [&] {
        for (const auto& [x, y] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}})
            p.drawLine(at + QPointF(x * inner, y * inner), at + QPointF(x * outer, y * outer));
    });
}

void MapView::paintEvent(QPaintEvent*) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const Appearance& a = m_appearance;
    if (!m_map)
        return;
    const QRectF area = cells();
    p.drawPixmap(area.topLeft(), picture());
    paintAxes(p);
    p.setClipRect(area);
    paintPockets(p);
    const double dot = 0.45 * a.unit();
    for (const Values& values : m_dots)
        if (shows(values)) {
            p.setPen(QPen(QColor(Qt::white), 0.7 * a.lineWidth()));
            p.setBrush(a.ink(Ink::Second));
            p.drawEllipse(pointOf(values), dot, dot);
        }
    if (m_present)
        paintMark(p, pointOf(*m_present));
    if (m_pointed) {
        const double wide = std::max(6.0, area.width() / m_map->columns() * std::max(1, m_map->stride));
        const double high = std::max(6.0, area.height() / m_map->rows() * std::max(1, m_map->stride));
        const QPointF at = pointOf(*m_pointed);
        twice(p, a, [&] { p.drawRect(QRectF(at.x() - wide / 2, at.y() - high / 2, wide, high)); });
    }
    if (hasFocus()) {
        p.setClipping(false);
        p.setBrush(Qt::NoBrush);
        p.setPen(QPen(a.accent(), a.lineWidth()));
        p.drawRect(area.adjusted(-1, -1, 1, 1));
    }
}

} // namespace thetalane

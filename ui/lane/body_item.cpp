#include "ui/lane/body_item.h"

#include "core/scene/bowling_scene.h"
#include "ui/lane/arrow.h"
#include "ui/lane/scale.h"
#include "ui/words/worked_steps.h"

#include <QFontMetricsF>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

constexpr double smallestBall = 4.5; // [px] so that a ball 19 m away is still found
constexpr double shadeFrom = 6;      // [px] below it, a shade is only noise
constexpr double capHeight = 0.73;   // of a sans serif's size
const QColor neckRed(0xC8, 0x3A, 0x3A);

// A pin's profile by the equipment specifications: height above its base, and half its width there [m].
constexpr double belly = 0.1143; // where it is widest
constexpr std::pair<double, double> profile[] = {
    {0, 0.0258},      {0.0191, 0.0359}, {0.0572, 0.0496}, {0.0857, 0.0573}, {0.1143, 0.0605},
    {0.1492, 0.0580}, {0.1842, 0.0470}, {0.2191, 0.0314}, {0.2381, 0.0250}, {0.2540, 0.0228},
    {0.2762, 0.0237}, {0.2985, 0.0266}, {0.3207, 0.0306}, {0.3429, 0.0323}, {0.3620, 0.0296},
    {0.3740, 0.0205}, {0.3810, 0}};

// Lying along x with its belly at 0 [m].
const QPainterPath& pinOutline() {
    static const QPainterPath outline = [] {
        QPolygonF points;
        for (const auto& [height, half] : profile)
            points << QPointF(height - belly, half);
        for (auto p = std::rbegin(profile); p != std::rend(profile); ++p)
            points << QPointF(p->first - belly, -p->second);
        QPainterPath path;
        path.addPolygon(points);
        path.closeSubpath();
        return path;
    }();
    return outline;
}

QString wordName(const std::string& id) {
    Body body;
    body.id = id;
    return bodyName(body);
}

} // namespace

BodyItem::BodyItem(const Body& body, Ink ink, bool nameBeside, const Appearance& appearance)
    : m_appearance(appearance)
    , m_kind(body.kind)
    , m_radius(body.radius * unitsPerMetre)
    , m_ink(ink)
    , m_nameBeside(nameBeside) {
    setZValue(1);
    takeName(bodyName(body));
    if (isWordName(body))
        m_id = body.id;
}

void BodyItem::takeName(const QString& name) {
    m_name = name;
    QFont font = m_appearance.font(Appearance::Size::Normal, true);
    font.setPixelSize(100);
    m_nameWidth = std::max(QFontMetricsF(font).horizontalAdvance(m_name) / 100, 0.1);
}

void BodyItem::setRole(Role role) {
    if (role == m_role)
        return;
    m_role = role;
    placeInDepth();
    update();
}

// What lies on the floor lies under what stands.
void BodyItem::placeInDepth() {
    setZValue(chosen() ? 2 : m_tipped ? 0.5 : 1);
}

void BodyItem::setTipped(std::optional<double> share, const Vec2d& along) {
    if (share == m_tipped)
        return;
    m_tipped = share;
    m_along = along;
    placeInDepth();
    update();
}

void BodyItem::setHovered(bool hovered) {
    m_hovered = hovered;
    update();
}

void BodyItem::setLost(bool lost) {
    if (lost == m_lost)
        return;
    m_lost = lost;
    update();
}

void BodyItem::setTurn(const std::optional<Orientation>& turn) {
    if (turn == m_turn)
        return;
    m_turn = turn;
    update();
}

// Names and halos are sized in pixels: the margin lets them show at any sensible zoom.
QRectF BodyItem::boundingRect() const {
    const double r = 4 * m_radius;
    return {-r, -r, 2 * r, 2 * r};
}

QColor BodyItem::fill() const {
    switch (m_role) {
    case Role::First:
        return m_appearance.ink(Ink::First);
    case Role::Second:
        return m_appearance.ink(Ink::Second);
    default:
        break;
    }
    if (m_kind == BodyKind::Pin)
        return m_appearance.pin();
    return ownInk() == Ink::Plain ? mixed(m_appearance.quietText(), m_appearance.card(), 0.8)
                                  : m_appearance.ink(m_ink);
}

QColor BodyItem::edge() const {
    if (m_role == Role::First)
        return m_appearance.textInk(Ink::First);
    if (m_role == Role::Second)
        return m_appearance.textInk(Ink::Second);
    if (m_kind == BodyKind::Pin)
        return mixed(m_appearance.quietText(), m_appearance.card(), 0.75);
    return ownInk() == Ink::Plain ? m_appearance.quietText() : m_appearance.textInk(m_ink);
}

void BodyItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (!m_id.empty())
        if (const QString name = wordName(m_id); name != m_name)
            takeName(name);
    const QPointF at = painter->worldTransform().map(QPointF(0, 0));
    const double painterScale = painter->worldTransform().m11();
    double radius = m_radius * painterScale;
    if (m_kind == BodyKind::Ball)
        radius = std::max(radius, smallestBall);
    const Pixels pixels(*painter);
    if (m_role == Role::Receding)
        painter->setOpacity(0.32);
    else if (m_role == Role::Beside)
        painter->setOpacity(0.6);
    else if (m_lost)
        painter->setOpacity(0.42);
    if (m_hovered) {
        painter->setPen(Qt::NoPen);
        painter->setBrush(faded(m_appearance.accent(), 0.22));
        const double halo = radius + 4 * m_appearance.lineWidth();
        painter->drawEllipse(at, halo, halo);
    }
    if (m_kind == BodyKind::Ball)
        paintBall(*painter, at, radius);
    else if (m_tipped && !chosen())
        paintLying(*painter, at, unitsPerMetre * painterScale);
    else
        paintPin(*painter, at, radius);
    if (!chosen()) // the overlay finds a place for those two
        paintName(*painter, at, radius);
}

void BodyItem::paintBall(QPainter& painter, const QPointF& at, double radius) const {
    const bool thin = m_role == Role::Receding || radius < shadeFrom;
    painter.setPen(QPen(edge(), thin ? 1 : m_appearance.lineWidth() * 0.75));
    if (chosen() && !thin) {
        // Light inside, so that what the overlay draws on it is seen.
        const double rim = 1.5 * m_appearance.lineWidth();
        painter.setPen(QPen(fill(), rim));
        painter.setBrush(mixed(fill(), m_appearance.card(), 0.16));
        painter.drawEllipse(at, radius - rim / 2, radius - rim / 2);
        paintTurn(painter, at, radius - rim);
        return;
    }
    painter.setBrush(fill());
    painter.drawEllipse(at, radius, radius);
    if (thin)
        return;
    if (m_turn)
        return paintTurn(painter, at, radius - 0.5);
    // Two flat discs: a gradient would cost ten times as much in every frame, and be louder.
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(QColor(Qt::white), 0.1));
    painter.drawEllipse(at - QPointF(radius, radius) * 0.16, radius * 0.68, radius * 0.68);
}

// From above: the half around the holes is lighter, and three holes lie around its pole. The edge of the half
// is a great circle; of it, and of the holes, what faces up is seen.
void BodyItem::paintTurn(QPainter& painter, const QPointF& at, double radius) const {
    if (!m_turn)
        return;
    const auto seen = [&](const Direction& d) { return at + QPointF(d.x, -d.y) * radius; };
    const Direction pole = turned(*m_turn, {0, 0, 1});
    const double flat = std::hypot(pole.x, pole.y);
    QPainterPath half;
    const QRectF disc(at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    if (flat < 1e-6) {
        if (pole.z > 0)
            half.addEllipse(disc);
    } else {
        // The rim on the pole's side, and back along the visible half of the great circle.
        const Vec2d to{pole.x / flat, pole.y / flat};
        const double start = std::atan2(to.y, to.x) * 180 / std::numbers::pi - 90;
        half.arcMoveTo(disc, start);
        half.arcTo(disc, start, 180);
        constexpr int pieces = 24;
        for (int k = 1; k < pieces; ++k) {
            const double u = std::numbers::pi * k / pieces;
            const Vec2d across{-to.y, to.x};
            half.lineTo(seen({across.x * std::cos(u) - to.x * pole.z * std::sin(u),
                              across.y * std::cos(u) - to.y * pole.z * std::sin(u), 0}));
        }
        half.closeSubpath();
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(chosen() ? faded(fill(), 0.16) : faded(QColor(Qt::white), 0.3));
    painter.drawPath(half);
    // Two for the fingers and one for the thumb, each foreshortened towards the rim.
    static constexpr Direction holes[] = {{-0.2, 0.3, 0.933}, {0.2, 0.3, 0.933}, {0, -0.22, 0.975}};
    painter.setBrush(chosen() ? faded(edge(), 0.35) : faded(QColor(Qt::black), 0.55));
    for (const Direction& hole : holes) {
        const Direction d = turned(*m_turn, hole);
        if (d.z <= 0)
            continue;
        const double size = 0.1 * radius;
        painter.save();
        painter.translate(seen(d));
        painter.rotate(-std::atan2(d.y, d.x) * 180 / std::numbers::pi);
        painter.drawEllipse(QPointF(), size * d.z, size);
        painter.restore();
    }
}

// White from above, with the ring of the neck.
void BodyItem::paintPin(QPainter& painter, const QPointF& at, double radius) const {
    const double rim = m_appearance.lineWidth() * (chosen() ? std::min(radius / 12, 1.5) : 0.6);
    painter.setPen(QPen(chosen() ? fill() : edge(), rim));
    painter.setBrush(chosen() ? mixed(fill(), m_appearance.pin(), 0.1) : m_appearance.pin());
    painter.drawEllipse(at, radius - rim / 2, radius - rim / 2);
    if (radius < shadeFrom)
        return;
    const double ring = radius * 0.6;
    painter.setPen(QPen(m_role == Role::Receding ? edge()
                        : chosen()               ? faded(neckRed, 0.3)
                                                 : neckRed,
                        std::clamp(radius * 0.07, 1.0, 4.0)));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, ring, ring);
}

// The disc is what the engine knows of it; its belly is there, and it lies the way it was struck. On the way
// down it is seen at a slant.
void BodyItem::paintLying(QPainter& painter, const QPointF& at, double perMetre) const {
    const double radius = m_radius * perMetre / unitsPerMetre;
    const QColor white = mixed(m_appearance.pin(), m_appearance.woodLine(), 0.8);
    const double thin = m_appearance.lineWidth() * 0.5;
    if (radius < shadeFrom) {
        painter.setPen(QPen(edge(), thin));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, radius, radius);
        return;
    }
    const double slant = std::sin(*m_tipped * std::numbers::pi / 2);
    const double scale = radius / regulation::pinRadius;
    painter.save();
    painter.translate(at);
    painter.rotate(-std::atan2(m_along.y, m_along.x) * 180 / std::numbers::pi);
    painter.scale(std::max(slant, 0.05) * scale, scale);
    QPen rim(edge(), thin);
    rim.setCosmetic(true);
    painter.setPen(rim);
    painter.setBrush(white);
    painter.drawPath(pinOutline());
    QPen neck(m_role == Role::Receding ? edge() : neckRed, std::clamp(radius * 0.1, 1.0, 5.0));
    neck.setCosmetic(true);
    neck.setCapStyle(Qt::FlatCap);
    painter.setPen(neck);
    for (const auto& [height, half] : {std::pair{0.235, 0.0245}, {0.268, 0.0225}})
        painter.drawLine(QPointF(height - belly, -half), QPointF(height - belly, half));
    painter.restore();
    painter.setPen(QPen(faded(edge(), 0.7), thin, Qt::DotLine));
    painter.setBrush(faded(m_appearance.pin(), 0.6 * (1 - slant)));
    painter.drawEllipse(at, radius - thin / 2, radius - thin / 2);
}

void BodyItem::paintName(QPainter& painter, const QPointF& at, double radius) const {
    const double room = (m_kind == BodyKind::Pin ? 0.52 : 0.8) * radius;
    QFont font = m_appearance.font(Appearance::Size::Normal, true);
    const double least = m_appearance.pixels(Appearance::Size::Small) * 0.85;
    const double most = m_appearance.pixels(Appearance::Size::Title);
    const double size = std::min({most, 1.3 * room, 1.75 * room / m_nameWidth});
    painter.setPen(m_kind == BodyKind::Pin ? m_appearance.text() : QColor(Qt::white));
    if (size >= least && !m_turn) { // a name over the finger holes would hide how it turns
        const double pixels = std::floor(size);
        font.setPixelSize(int(pixels));
        painter.setFont(font);
        painter.drawText(at + QPointF(-m_nameWidth / 2, capHeight / 2) * pixels, m_name);
        return;
    }
    if (!m_nameBeside || m_role == Role::Receding)
        return;
    font.setPixelSize(m_appearance.pixels(Appearance::Size::Small));
    painter.setFont(font);
    painter.setPen(m_appearance.quietText());
    painter.drawText(at + QPointF(radius * 0.75 + 3, -radius * 0.75 - 2), m_name);
}

} // namespace thetalane

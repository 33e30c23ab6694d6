#include "ui/map/map_controls.h"

#include "ui/map/map_words.h"
#include "ui/panels/icon_button.h"
#include "ui/panels/number_field.h"
#include "ui/panels/panel.h"
#include "ui/words/glossary.h"
#include "ui/words/scene_text.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double perMinute = 2 * std::numbers::pi / 60;

enum Ball { UsualBall, PresentBall };

void say(QWidget& widget, const QString& name, const QString& toolTip) {
    widget.setAccessibleName(name);
    widget.setToolTip(toolTip);
}

} // namespace

std::optional<Entry> entryOfSession(const Session& session) {
    if (const auto& ballThrow = session.currentThrow())
        return entryOf(*ballThrow, session.scene().friction);
    const Scene& scene = session.scene();
    const Body* ball = nullptr;
    bool pins = false;
    for (const Body& body : scene.bodies) {
        if (body.kind == BodyKind::Ball && ball)
            return std::nullopt;
        if (body.kind == BodyKind::Ball)
            ball = &body;
        pins = pins || body.kind == BodyKind::Pin;
    }
    if (!ball || !pins || scene.friction || scene.frame || !(ball->velocity.y > 0))
        return std::nullopt;
    const double slope = ball->velocity.x / ball->velocity.y;
    return Entry{ball->position.x - ball->position.y * slope, -std::atan(slope), norm(ball->velocity)};
}

MapControls::MapControls(const Context& context, int cells, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_cells(cells)
    , m_grid(new QGridLayout(this))
    , m_times(new QLabel(QStringLiteral("×"), this))
    , m_scene(combo("mapScene", 0, 0))
    , m_across(combo("mapAcross", 1, 0))
    , m_up(combo("mapUp", 1, 2))
    , m_ball(combo("mapBall", 0, 2))
    , m_e(new QLabel(this))
    , m_restitution(new NumberField(context.appearance, QStringLiteral("mapRestitution"), this))
    , m_message(new QLabel(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->addWidget(m_times, 1, 1);
    m_grid->addWidget(m_e, 2, 0, 1, 2);
    m_grid->addWidget(m_restitution, 2, 2, Qt::AlignLeft);
    m_grid->addWidget(m_message, 3, 0, 1, 3);
    m_grid->setColumnStretch(0, 1);
    m_grid->setColumnStretch(2, 1);
    m_message->setObjectName(QStringLiteral("mapMessage"));
    m_restitution->setStep(0.05, 0, 1);
    m_restitution->setValue(defaultPinRestitution);
    for (int k = 0; k < 2; ++k) {
        m_scene->addItem(QString(), k);
        m_ball->addItem(QString(), k);
    }
    m_scene->setCurrentIndex(int(MapScene::Bowling));
    fillQuantities();
    m_up->setCurrentIndex(m_up->findData(int(MapQuantity::Angle)));
    m_shown = {MapQuantity::Offset, MapQuantity::Angle};
    nameTerms();
    setTerm(m_e, "restitution");
    setTerm(m_restitution, "restitution");
    connectAll();
    restyle();
    retranslate();
}

// As everywhere: the mark of a list over a box without a frame of the style's own.
QComboBox* MapControls::combo(const char* name, int row, int column) {
    auto* box = new QComboBox(this);
    box->setObjectName(QLatin1String(name));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    m_grid->addWidget(box, row, column);
    m_grid->addWidget(new IconMark(m_context.appearance, Icon::Down, this), row, column,
                      Qt::AlignRight | Qt::AlignVCenter);
    return box;
}

void MapControls::connectAll() {
    connect(m_scene, &QComboBox::activated, this, [this] {
        fillQuantities();
        showBalls();
        emit changed();
    });
    connect(m_ball, &QComboBox::activated, this, &MapControls::changed);
    connect(m_across, &QComboBox::activated, this, [this] { choose(m_across, m_up, 0); });
    connect(m_up, &QComboBox::activated, this, [this] { choose(m_up, m_across, 1); });
    connect(m_restitution, &NumberField::edited, this, &MapControls::changed);
    connect(m_restitution, &NumberField::becameUnreadable, this, &MapControls::showMessage);
    connect(&m_context.appearance, &Appearance::changed, this, &MapControls::restyle);
    connect(&m_context.session, &Session::runChanged, this, &MapControls::showBalls);
}

// The same quantity twice is none: then the other axis takes what this one had.
void MapControls::choose(QComboBox* chosen, QComboBox* other, std::size_t axis) {
    const auto quantity = MapQuantity(chosen->currentData().toInt());
    if (other->currentData() == chosen->currentData()) {
        other->setCurrentIndex(other->findData(int(m_shown[axis])));
        m_shown[1 - axis] = m_shown[axis];
    }
    m_shown[axis] = quantity;
    nameTerms();
    emit changed();
}

MapScene MapControls::scene() const {
    return MapScene(m_scene->currentIndex());
}

bool MapControls::ballIsPresent() const {
    return m_ball->currentIndex() == PresentBall && m_context.session.currentThrow();
}

// Spin is nothing on a rack without friction.
void MapControls::fillQuantities() {
    for (QComboBox* box : {m_across, m_up}) {
        const QVariant before = box->currentData();
        box->clear();
        for (std::size_t q = 0; q < mapQuantities; ++q)
            if (scene() == MapScene::Bowling || MapQuantity(q) != MapQuantity::Spin)
                box->addItem(quantityName(MapQuantity(q)), int(q));
        box->setCurrentIndex(std::max(0, box->findData(before)));
    }
    if (m_across->currentData() == m_up->currentData())
        m_up->setCurrentIndex(m_across->currentIndex() == 0 ? 1 : 0);
    m_shown = {MapQuantity(m_across->currentData().toInt()), MapQuantity(m_up->currentData().toInt())};
    nameTerms();
}

void MapControls::nameTerms() {
    setTerm(m_across, quantityTerm(m_shown[0]));
    setTerm(m_up, quantityTerm(m_shown[1]));
}

MapAxis MapControls::axisOf(MapQuantity quantity) const {
    switch (quantity) {
    case MapQuantity::Offset:
        return {quantity, -0.16, 0.16, m_cells};
    case MapQuantity::Angle:
        return {quantity, -8 * degree, 8 * degree, m_cells};
    case MapQuantity::Speed:
        return {quantity, 4, 12, m_cells};
    case MapQuantity::Spin:
        return {quantity, 0, 600 * perMinute, m_cells};
    case MapQuantity::Mass:
        break;
    }
    return {quantity, 2.7, regulation::maxBallMass, m_cells};
}

MapSettings MapControls::settings() const {
    MapSettings s = defaultMap(scene(), m_cells, m_cells);
    s.across = axisOf(m_shown[0]);
    s.up = axisOf(m_shown[1]);
    s.restitution = m_restitution->value();
    const Session& session = m_context.session;
    if (scene() == MapScene::Bowling && session.currentThrow())
        s.friction = session.scene().friction;
    if (!ballIsPresent())
        return s;
    const Throw& t = *session.currentThrow();
    const auto entry = entryOf(t, session.scene().friction);
    s.base.mass = t.mass;
    s.base.speed = scene() == MapScene::Rack && entry ? entry->speed : t.speed;
    s.base.spin = scene() == MapScene::Rack ? 0 : t.spin;
    s.base.position = scene() == MapScene::Rack ? 0 : t.position;
    // What an axis varies is left alone: the map stays what it is while the throw is aimed.
    const auto varied = [&](MapQuantity q) { return m_shown[0] == q || m_shown[1] == q; };
    if (entry && !varied(MapQuantity::Offset))
        s.base.offset = entry->offset;
    if (entry && !varied(MapQuantity::Angle))
        s.base.angle = entry->angle;
    return s;
}

std::optional<MapView::Values> MapControls::presentValues() const {
    const Session& session = m_context.session;
    const auto entry = entryOfSession(session);
    if (!entry)
        return std::nullopt;
    const auto& t = session.currentThrow();
    const auto valueOf = [&](MapQuantity q) -> std::optional<double> {
        switch (q) {
        case MapQuantity::Offset:
            return entry->offset;
        case MapQuantity::Angle:
            return entry->angle;
        case MapQuantity::Speed:
            return scene() == MapScene::Rack ? std::optional(entry->speed)
                   : t                       ? std::optional(t->speed)
                                             : std::nullopt;
        case MapQuantity::Spin:
            return t ? std::optional(t->spin) : std::nullopt;
        case MapQuantity::Mass:
            return t ? std::optional(t->mass) : std::nullopt;
        }
        return std::nullopt;
    };
    const auto across = valueOf(m_shown[0]), up = valueOf(m_shown[1]);
    return across && up ? std::optional(MapView::Values{*across, *up}) : std::nullopt;
}

bool MapControls::isSound() {
    showMessage();
    return m_message->text().isEmpty();
}

void MapControls::showMessage() {
    QString text = m_restitution->unreadable();
    const double e = m_restitution->value();
    if (text.isEmpty() && !(e >= 0 && e <= 1))
        text = sceneErrorMessage(
            {.code = SceneErrorCode::OutOfRange, .path = {}, .value = e, .low = 0, .high = 1});
    m_restitution->setWrong(!text.isEmpty());
    if (text.isEmpty())
        if (const auto refusal = refusalOf(settings()))
            text = refusalText(*refusal);
    m_message->setText(text);
    makeMessage(*m_message, m_context.appearance);
}

void MapControls::showBalls() {
    const auto& t = m_context.session.currentThrow();
    if (!t && m_ball->currentIndex() == PresentBall) {
        m_ball->setCurrentIndex(UsualBall);
        emit changed();
    }
    m_ball->setEnabled(t.has_value());
}

void MapControls::retranslate() {
    m_scene->setItemText(int(MapScene::Rack), tr("Rack, no friction"));
    m_scene->setItemText(int(MapScene::Bowling), tr("Whole lane"));
    m_ball->setItemText(UsualBall, tr("Usual ball"));
    m_ball->setItemText(PresentBall, tr("Ball of this throw"));
    for (QComboBox* box : {m_across, m_up})
        for (int k = 0; k < box->count(); ++k)
            box->setItemText(k, quantityName(MapQuantity(box->itemData(k).toInt())));
    say(*m_scene, tr("Where"),
        tr("The rack alone, the ball close before it; or the whole lane with friction and oil, where "
           "direction "
           "and axis of rotation are found for each place"));
    say(*m_ball, tr("Ball"),
        tr("Usual: 6.8 kg; 6.8 m/s at the rack; on the lane 8 m/s and 400 rpm from the middle. Or weight, "
           "speed, "
           "rotation and position of the present throw"));
    say(*m_across, tr("From left to right"), tr("What changes from left to right"));
    say(*m_up, tr("From below to above"), tr("What changes from below to above"));
    m_e->setText(tr("Coefficient of restitution e"));
    m_restitution->setWords(tr("Coefficient of restitution e"),
                            tr("Between ball and pins, and pins and pins"));
    showBalls();
    showMessage();
}

void MapControls::restyle() {
    const Appearance& a = m_context.appearance;
    m_grid->setHorizontalSpacing(a.unit() / 2);
    m_grid->setVerticalSpacing(a.unit() / 2);
    for (QWidget* w : std::initializer_list<QWidget*>{m_scene, m_across, m_up, m_ball, m_e, m_times})
        w->setFont(a.font(Appearance::Size::Normal));
    showMessage();
}

} // namespace thetalane

#include "ui/panels/throw_panel.h"

#include "ui/panels/icon_button.h"
#include "ui/panels/spin_dial.h"
#include "ui/panels/value_row.h"
#include "ui/words/glossary.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double halfLane = regulation::laneWidth / 2; // m
constexpr double maxSpeed = 100;                       // m/s

constexpr std::array massUnits{MassUnit::Kilogram, MassUnit::Pound};
constexpr std::array speedUnits{SpeedUnit::MetresPerSecond, SpeedUnit::KilometresPerHour,
                                SpeedUnit::MilesPerHour};

template <class Units> QStringList symbolsOf(const Units& units) {
    QStringList symbols;
    for (const auto unit : units)
        symbols << unitSymbol(unit);
    return symbols;
}

// What is shown already stands for the exact value behind it.
void put(double& kept, double shown, double value, double meant) {
    if (value != shown)
        kept = meant;
}

// A lane of the user's own has no throw; its ball is one.
Throw throwOf(const Session& session) {
    if (session.currentThrow())
        return *session.currentThrow();
    Throw t;
    for (const Body& body : session.scene().bodies)
        if (body.kind == BodyKind::Ball) {
            t.mass = body.mass;
            t.speed = std::hypot(body.velocity.x, body.velocity.y);
            t.direction = t.speed > 0 ? std::atan2(body.velocity.x, body.velocity.y) : 0;
            t.position = body.position.x;
            t.spin = std::hypot(body.spin.x, body.spin.y);
            if (t.spin > 0) // from the axis of a ball that rolls the way it goes
                t.axis = std::remainder(std::atan2(-body.spin.y, -body.spin.x) + t.direction,
                                        2 * std::numbers::pi);
            break;
        }
    return t;
}

} // namespace

ThrowPanel::ThrowPanel(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_dial(new SpinDial(context.appearance, QStringLiteral("spinDial"), this))
    , m_rollNote(new QLabel(this))
    , m_pathLabel(new QLabel(this))
    , m_path(new QComboBox(this))
    , m_throwButton(new QPushButton(this))
    , m_default(new QPushButton(this))
    , m_column(new QVBoxLayout)
    , m_foot(new QVBoxLayout)
    , m_spinRow(new QHBoxLayout) {
    setObjectName(QStringLiteral("throwPanel"));
    setTerm(m_dial, "axis");
    setTerm(m_throwButton, "delivery");
    makeRows();
    auto* scroll = new QScrollArea(this);
    scroll->setFocusPolicy(Qt::NoFocus); // the Tab key goes to what stands in it
    auto* inside = new QWidget(scroll);
    inside->setLayout(m_column);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(scroll, 1);
    layout->addLayout(m_foot);
    makePathAhead();
    makeButtons(*m_foot);
    connect(&session(), &Session::runChanged, this, &ThrowPanel::showThrow);
    connect(&session(), &Session::edited, this, &ThrowPanel::foresee);
    connect(&session(), &Session::opened, this, &ThrowPanel::foresee);
    restyle();
    retranslate();
    showThrow();
}

void ThrowPanel::makeRows() {
    struct Kind {
        const char* name;
        ValueRow::Span span;
        const char* unit;
        const char* term;
    };
    static constexpr Kind kinds[rowCount] = {
        {"weight", {}, "", "mass"}, // in units to choose
        {"speed", {}, "", "speed"},
        {"direction", directionSpan, "°", "direction"},
        {"position", positionSpan, "m", "board"},
        {"rotation", rotationSpan, "rpm", "angular-velocity"},
        {"axis", axisSpan, "°", "axis"},
        {"pinRestitution", {0, 1, 0.01, 0}, "", "restitution"},
    };
    for (int r = 0; r < rowCount; ++r) {
        const Kind& kind = kinds[r];
        auto* row = new ValueRow(appearance(), QString::fromLatin1(kind.name), kind.span,
                                 QString::fromUtf8(kind.unit), this);
        connect(row, &ValueRow::edited, this, [this, r](double value) { take(r, value); });
        connect(row, &ValueRow::becameUnreadable, this, &ThrowPanel::apply);
        row->setTerm(kind.term);
        m_rows[std::size_t(r)] = row;
        m_column->addWidget(row);
        if (r == Axis)
            makeDial();
    }
    connect(m_rows[Mass], &ValueRow::unitChosen, this, [this](int k) {
        chooseUnits({massUnits[std::size_t(k)], m_units.speed});
    });
    connect(m_rows[Speed], &ValueRow::unitChosen, this, [this](int k) {
        chooseUnits({m_units.mass, speedUnits[std::size_t(k)]});
    });
    setUnits({});
    m_column->addStretch(1);
}

void ThrowPanel::makeDial() {
    m_rollNote->setObjectName(QStringLiteral("rollNote"));
    m_rollNote->setWordWrap(true);
    m_spinRow->addWidget(m_dial);
    m_spinRow->addWidget(m_rollNote, 1);
    m_column->addLayout(m_spinRow);
    connect(m_dial, &SpinDial::edited, this, &ThrowPanel::takeSpin);
}

void ThrowPanel::makePathAhead() {
    m_path->setObjectName(QStringLiteral("pathAhead"));
    m_path->addItems({QString(), QString()});
    m_pathLabel->setBuddy(m_path);
    auto* row = new QGridLayout;
    row->addWidget(m_pathLabel, 0, 0);
    row->addWidget(m_path, 0, 1);
    row->addWidget(new IconMark(appearance(), Icon::Down, this), 0, 1, Qt::AlignRight | Qt::AlignVCenter);
    row->setColumnStretch(1, 1);
    m_foot->addLayout(row);
    connect(m_path, &QComboBox::activated, this, [this](int index) {
        m_foresight = Foresight(index);
        session().setForesight(m_foresight);
    });
}

void ThrowPanel::setUnits(const ThrowUnits& units) {
    m_units = units;
    const auto indexOf = [](const auto& all, auto unit) {
        return int(std::find(all.begin(), all.end(), unit) - all.begin());
    };
    m_rows[Mass]->setSpan(massSpan(units.mass));
    m_rows[Mass]->setUnits(symbolsOf(massUnits), indexOf(massUnits, units.mass));
    m_rows[Speed]->setSpan(speedSpan(units.speed));
    m_rows[Speed]->setUnits(symbolsOf(speedUnits), indexOf(speedUnits, units.speed));
    showNumbers();
    emit unitsChanged(units);
}

void ThrowPanel::chooseUnits(const ThrowUnits& units) {
    if (units == m_units)
        return setUnits(units); // the menu's mark stays where it was
    rememberThrowUnits(units);
    setUnits(units);
    showNotes();
    showErrors();
}

// A throw that was edited is shown as far as was wished; one that was thrown, to its end.
void ThrowPanel::foresee() {
    if (session().currentThrow() && playhead().time() == 0 && !playhead().playing())
        session().setForesight(m_foresight);
}

double ThrowPanel::factorOf(int row) const {
    return row == Mass ? inKilograms(m_units.mass) : row == Speed ? inMetresPerSecond(m_units.speed) : 1;
}

void ThrowPanel::makeButtons(QVBoxLayout& layout) {
    m_throwButton->setObjectName(QStringLiteral("throwButton"));
    // A click leaves the focus, and with it the space bar, where it is.
    m_throwButton->setFocusPolicy(Qt::TabFocus);
    m_default->setFocusPolicy(Qt::TabFocus);
    m_throwButton->setProperty("prominent", true);
    m_default->setObjectName(QStringLiteral("defaultThrowButton"));
    m_default->setProperty("quiet", true);
    m_default->setCursor(Qt::PointingHandCursor);
    layout.addWidget(m_throwButton);
    layout.addWidget(m_default, 0, Qt::AlignHCenter);
    connect(m_throwButton, &QPushButton::clicked, this, &ThrowPanel::throwBall);
    connect(m_default, &QPushButton::clicked, this,
            [this] { session().setThrow(Throw{}, defaultPinRestitution); });
}

void ThrowPanel::restyle() {
    Panel::restyle();
    const int unit = appearance().unit();
    m_column->setContentsMargins(unit, unit, unit, unit);
    m_column->setSpacing(unit);
    m_foot->setContentsMargins(unit, unit, unit, unit);
    m_foot->setSpacing(unit);
    m_spinRow->setSpacing(unit);
    makeQuiet(*m_rollNote, appearance());
    m_pathLabel->setFont(appearance().font(Appearance::Size::Normal));
    m_path->setFont(appearance().font(Appearance::Size::Normal));
    m_default->setFont(appearance().font(Appearance::Size::Normal));
    m_throwButton->setFont(appearance().font(Appearance::Size::Large, true));
}

void ThrowPanel::showThrow() {
    setEnabled(session().scene().lane.has_value());
    if (m_applying || !isEnabled())
        return;
    m_throw = throwOf(session());
    m_restitution = session().scene().restitution;
    m_errors.clear();
    showNumbers();
    showNotes();
    showErrors();
}

void ThrowPanel::showNumbers() {
    m_rows[Mass]->setValue(m_throw.mass / factorOf(Mass));
    m_rows[Speed]->setValue(m_throw.speed / factorOf(Speed));
    m_rows[Direction]->setValue(m_throw.direction / perDegree);
    m_rows[Position]->setValue(m_throw.position);
    m_rows[Spin]->setValue(m_throw.spin / perRpm);
    m_rows[Axis]->setValue(m_throw.axis / perDegree);
    m_rows[Restitution]->setValue(m_restitution);
}

void ThrowPanel::takeSpin(double rpm, double axis) {
    m_rows[Spin]->setValue(rpm);
    m_rows[Axis]->setValue(axis);
    put(m_throw.spin, m_throw.spin / perRpm, rpm, rpm * perRpm);
    put(m_throw.axis, m_throw.axis / perDegree, axis, radians(axis));
    apply();
}

void ThrowPanel::take(int row, double value) {
    const double factor = factorOf(row);
    switch (row) {
    case Mass:
        put(m_throw.mass, m_throw.mass / factor, value, value * factor);
        break;
    case Speed:
        put(m_throw.speed, m_throw.speed / factor, value, value * factor);
        break;
    case Direction:
        put(m_throw.direction, m_throw.direction / perDegree, value, radians(value));
        break;
    case Position:
        m_throw.position = value;
        break;
    case Spin:
        put(m_throw.spin, m_throw.spin / perRpm, value, value * perRpm);
        break;
    case Axis:
        put(m_throw.axis, m_throw.axis / perDegree, value, radians(value));
        break;
    default:
        m_restitution = value;
    }
    apply();
}

std::vector<SceneError> ThrowPanel::wrongRows() const {
    std::vector<SceneError> wrong;
    const auto need = [&](Row row, double low, double high) {
        const double value = m_rows[row]->value();
        const double factor = factorOf(row);
        // Of another unit as many digits as can be typed back.
        const double most = factor == 1 ? high : std::floor(high / factor * 100) / 100;
        if (!(value * factor >= low && value * factor <= high))
            wrong.push_back({.code = SceneErrorCode::OutOfRange,
                             .path = std::to_string(row),
                             .value = value,
                             .low = low,
                             .high = most});
    };
    const auto needPositive = [&](Row row, double high) {
        if (m_rows[row]->value() > 0)
            return need(row, 0, high);
        wrong.push_back({.code = SceneErrorCode::NotPositive,
                         .path = std::to_string(row),
                         .value = m_rows[row]->value()});
    };
    needPositive(Mass, regulation::maxBallMass);
    needPositive(Speed, maxSpeed);
    const double nearlySideways = std::nextafter(90.0, 0.0); // 90° itself never gets to the pins
    need(Direction, -nearlySideways, nearlySideways);
    need(Position, -halfLane, halfLane);
    need(Restitution, 0, 1);
    return wrong;
}

void ThrowPanel::apply() {
    m_errors = wrongRows();
    const bool readable = std::all_of(m_rows.begin(), m_rows.end(),
                                      [](const ValueRow* row) { return row->unreadable().isEmpty(); });
    if (readable && m_errors.empty()) {
        m_applying = true;
        session().setThrow(m_throw, m_restitution);
        m_applying = false;
    }
    showNotes();
    showErrors();
}

void ThrowPanel::throwBall() {
    playhead().setPlaying(false);
    playhead().setTime(0);
    playhead().setPlaying(true);
}

} // namespace thetalane

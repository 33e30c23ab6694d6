#include "ui/panels/throw_panel.h"

#include "ui/panels/value_row.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180;      // rad
constexpr double rpm = 2 * std::numbers::pi / 60;      // rad/s
constexpr double pound = 0.45359237;                   // kg
constexpr double halfLane = regulation::laneWidth / 2; // m
constexpr double maxSpeed = 100;                       // m/s
constexpr int boards = 39;

// In the order of the default throw's own arithmetic: typing 1.5 gives its very bits.
double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

// Counted from the right, as bowlers do.
int boardAt(double position) {
    const double width = regulation::laneWidth / boards;
    return int(std::clamp(std::floor((halfLane - position) / width) + 1, 1.0, double(boards)));
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
    , m_rollNote(new QLabel(this))
    , m_throwButton(new QPushButton(this))
    , m_default(new QPushButton(this))
    , m_column(new QVBoxLayout)
    , m_foot(new QVBoxLayout) {
    setObjectName(QStringLiteral("throwPanel"));
    makeRows();
    auto* scroll = new QScrollArea(this);
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
    makeButtons(*m_foot);
    connect(&session(), &Session::runChanged, this, &ThrowPanel::showThrow);
    restyle();
    retranslate();
    showThrow();
}

void ThrowPanel::makeRows() {
    struct Kind {
        const char* name;
        ValueRow::Span span;
        const char* unit;
    };
    static constexpr Kind kinds[rowCount] = {
        {"weight", {2.7, regulation::maxBallMass, 0.01, 2.7}, "kg"},
        {"speed", {4, 12, 0.1, 4}, "m/s"},
        {"direction", {-6, 6, 0.1, 0}, "°"},
        {"position", {-0.52, 0.52, 0.01, 0}, "m"},
        {"rotation", {0, 600, 10, 0}, "rpm"},
        {"axis", {-90, 90, 1, 0}, "°"},
        {"pinRestitution", {0, 1, 0.01, 0}, ""},
    };
    for (int r = 0; r < rowCount; ++r) {
        const Kind& kind = kinds[r];
        auto* row = new ValueRow(appearance(), QString::fromLatin1(kind.name), kind.span,
                                 QString::fromUtf8(kind.unit), this);
        connect(row, &ValueRow::edited, this, [this, r](double value) { take(r, value); });
        connect(row, &ValueRow::becameUnreadable, this, &ThrowPanel::apply);
        m_rows[std::size_t(r)] = row;
        m_column->addWidget(row);
        if (r == Axis)
            m_column->addWidget(m_rollNote);
    }
    m_rollNote->setObjectName(QStringLiteral("rollNote"));
    m_rollNote->setWordWrap(true);
    m_column->addStretch(1);
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

void ThrowPanel::retranslate() {
    const auto say = [this](Row row, const QString& label, const QString& toolTip) {
        m_rows[row]->setWords(label, toolTip);
    };
    say(Mass, tr("Ball mass"), tr("Mass of the ball: more than 0, at most 7.26 kg"));
    say(Speed, tr("Speed"), tr("Speed at the foul line: more than 0, at most 100 m/s"));
    say(Direction, tr("Direction"), tr("Angle from straight down the lane, positive to the right"));
    say(Position, tr("Position"),
        tr("The ball's centre at the foul line, from the middle, positive to the right; boards are counted "
           "from the right"));
    say(Spin, tr("Rotation"),
        tr("Turns a minute at the foul line; it acts through the friction of the lane"));
    say(Axis, tr("Axis of rotation"),
        tr("0: a forward roll; positive: turned so that the ball hooks to the left, 90: side spin alone"));
    say(Restitution, tr("Coefficient of restitution e"), tr("Between ball and pins, and pins and pins"));
    m_throwButton->setText(tr("Throw"));
    m_throwButton->setToolTip(tr("Throw the ball from the foul line"));
    m_throwButton->setAccessibleName(tr("Throw"));
    m_default->setText(tr("Default throw"));
    m_default->setToolTip(tr("Every attribute as it was at first"));
    m_default->setAccessibleName(tr("Default throw"));
    showNotes();
    showErrors();
}

void ThrowPanel::restyle() {
    Panel::restyle();
    const int unit = appearance().unit();
    m_column->setContentsMargins(unit, unit, unit, unit);
    m_column->setSpacing(unit);
    m_foot->setContentsMargins(unit, unit, unit, unit);
    m_foot->setSpacing(unit / 2);
    makeQuiet(*m_rollNote, appearance());
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
    m_rows[Mass]->setValue(m_throw.mass);
    m_rows[Speed]->setValue(m_throw.speed);
    m_rows[Direction]->setValue(m_throw.direction / degree);
    m_rows[Position]->setValue(m_throw.position);
    m_rows[Spin]->setValue(m_throw.spin / rpm);
    m_rows[Axis]->setValue(m_throw.axis / degree);
    m_rows[Restitution]->setValue(m_restitution);
    showNotes();
    showErrors();
}

void ThrowPanel::take(int row, double value) {
    switch (row) {
    case Mass:
        m_throw.mass = value;
        break;
    case Speed:
        m_throw.speed = value;
        break;
    case Direction:
        m_throw.direction = radians(value);
        break;
    case Position:
        m_throw.position = value;
        break;
    case Spin:
        m_throw.spin = value * rpm;
        break;
    case Axis:
        m_throw.axis = radians(value);
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
        if (!(value >= low && value <= high))
            wrong.push_back({.code = SceneErrorCode::OutOfRange,
                             .path = std::to_string(row),
                             .value = value,
                             .low = low,
                             .high = high});
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

void ThrowPanel::showErrors() {
    for (int r = 0; r < rowCount; ++r) {
        QString message = m_rows[std::size_t(r)]->unreadable();
        for (const SceneError& error : m_errors)
            if (message.isEmpty() && error.path == std::to_string(r))
                message = r == Direction
                              ? tr("must be between −90 and 90, is %1").arg(numberText(error.value))
                              : sceneErrorMessage(error);
        m_rows[std::size_t(r)]->setMessage(message);
    }
}

void ThrowPanel::showNotes() {
    const double direction = m_rows[Direction]->value();
    m_rows[Mass]->setNote(QString::number(m_rows[Mass]->value() / pound, 'f', 1) + QStringLiteral(" lb"));
    m_rows[Speed]->setNote(QString::number(m_rows[Speed]->value() * 3.6, 'f', 1) + QStringLiteral(" km/h"));
    m_rows[Direction]->setNote(direction > 0   ? tr("to the right")
                               : direction < 0 ? tr("to the left")
                                               : tr("straight"));
    m_rows[Position]->setNote(tr("board %1").arg(boardAt(m_rows[Position]->value())));
    showRoll();
}

// What rotation and axis do to this throw, on this lane.
void ThrowPanel::showRoll() {
    const double axis = m_rows[Axis]->value();
    const bool turns = m_rows[Spin]->value() > 0;
    const double sideways = turns ? std::sin(radians(axis)) : 0;
    const bool aside = std::abs(sideways) > 1e-12;
    m_rows[Axis]->setNote(!turns         ? QString()
                          : !aside       ? tr("forward roll")
                          : sideways > 0 ? tr("hooks left")
                                         : tr("hooks right"));
    const auto& friction = session().scene().friction;
    if (!friction)
        m_rollNote->setText(tr("This lane has no friction, so rotation does not change the path."));
    else if (!turns)
        m_rollNote->setText(tr(
            "Thrown without rotation, the ball slides until friction makes it roll; its path is straight."));
    else if (!aside)
        m_rollNote->setText(
            tr("Rotation about the axis of a forward roll changes how soon the ball rolls; its "
               "path stays straight."));
    else
        m_rollNote->setText(
            friction->oil.empty()
                ? tr("The ball slides and curves aside until it rolls; then it goes straight on.")
                : tr("The ball slides and curves aside until it rolls: little on the oil, more beyond it; "
                     "then it goes straight on."));
}

void ThrowPanel::throwBall() {
    playhead().setPlaying(false);
    playhead().setTime(0);
    playhead().setPlaying(true);
}

} // namespace thetalane

#include "ui/panels/body_group.h"

#include "ui/panels/number_field.h"
#include "ui/panels/panel.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>

#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Exact along the axes, where cos 90° would leave a crumb.
Vec2d polar(double length, double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    if (turn == 0)
        return {length, 0};
    if (std::abs(turn) == 180)
        return {-length, 0};
    if (std::abs(turn) == 90)
        return {0, std::copysign(length, turn)};
    return {length * std::cos(turn * degree), length * std::sin(turn * degree)};
}

double length(Vec2d v) {
    return std::hypot(v.x, v.y); // does not overflow on the way
}

} // namespace

BodyGroup::BodyGroup(const Appearance& appearance, int index, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_index(index)
    , m_grid(new QGridLayout(this))
    , m_id(new QLabel(this)) {
    static constexpr const char* names[] = {"Mass", "Radius", "Speed", "Direction", "X",
                                            "Y",    "SpinX",  "SpinY", "SpinZ",     "Inertia"};
    static constexpr const char* units[] = {"kg", "m", "m/s", "°", "m", "m", "rad/s", "rad/s", "rad/s", ""};
    static constexpr double steps[] = {0.1, 0.01, 0.1, 1, 0.01, 0.01, 1, 1, 1, 0.01};
    const QString name = QStringLiteral("body%1").arg(index);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->addWidget(m_id, 0, 0, 1, 2);
    for (int f = 0; f < fieldCount; ++f) {
        const auto at = std::size_t(f);
        m_fields[at] = new NumberField(appearance, name + names[f], this);
        m_fields[at]->setUnit(QString::fromUtf8(units[f]));
        if (f == Mass || f == Radius || f == Inertia)
            m_fields[at]->setStep(steps[f], steps[f]);
        else if (f == Speed)
            m_fields[at]->setStep(steps[f], 0);
        else
            m_fields[at]->setStep(steps[f]);
        m_labels[at] = new QLabel(this);
        m_labels[at]->setBuddy(m_fields[at]->edit());
        const int row = 1 + f / 2 * 3;
        m_grid->addWidget(m_labels[at], row, f % 2);
        m_grid->addWidget(m_fields[at], row + 1, f % 2);
        connect(m_fields[at], &NumberField::edited, this, [this, f](double value) { take(f, value); });
        connect(m_fields[at], &NumberField::becameUnreadable, this, &BodyGroup::edited);
    }
    for (int r = 0; r < fieldCount / 2; ++r) {
        auto* message = new QLabel(this);
        message->setObjectName(name + names[2 * r] + "Message");
        m_messages[std::size_t(r)] = message;
        m_grid->addWidget(message, 3 + 3 * r, 0, 1, 2);
    }
    m_grid->setColumnStretch(0, 1);
    m_grid->setColumnStretch(1, 1);
    connect(&appearance, &Appearance::changed, this, &BodyGroup::restyle);
    restyle();
    retranslate();
}

void BodyGroup::restyle() {
    const int unit = m_appearance.unit();
    m_grid->setHorizontalSpacing(unit * 2);
    m_grid->setVerticalSpacing(2);
    m_id->setFont(m_appearance.font(Appearance::Size::Normal, true));
    m_id->setContentsMargins(unit * 2, 0, 0, 0); // room for the dot
    for (QLabel* label : m_labels) {
        makeQuiet(*label, m_appearance);
        label->setContentsMargins(0, unit / 2, 0, 0);
    }
    for (QLabel* message : m_messages)
        makeMessage(*message, m_appearance);
}

void BodyGroup::retranslate() {
    const QString names[] = {
        tr("Mass"),       tr("Radius"), tr("Speed"),  tr("Direction"), tr("Position x"),
        tr("Position y"), tr("Spin x"), tr("Spin y"), tr("Spin z"),    tr("Moment of inertia β")};
    const QString hints[] = {
        tr("Mass of this body, greater than 0"),
        tr("Radius of this body, greater than 0"),
        tr("Speed of this body, 0 or more"),
        tr("Direction of motion, counter-clockwise from x"),
        tr("Where the centre is, to the right"),
        tr("Where the centre is, upwards"),
        tr("Angular velocity about x; negative rolls up the screen"),
        tr("Angular velocity about y; positive rolls to the right"),
        tr("Angular velocity about the vertical, counter-clockwise; it does not bend the path"),
        tr("β = I/(m R²), greater than 0, at most 1; 0.4 for a uniform sphere")};
    for (std::size_t f = 0; f < fieldCount; ++f) {
        const double value = m_fields[f]->value();
        QString hint = hints[f] + QStringLiteral("\n") + exactText(value);
        if (f >= SpinX && f <= SpinZ) // and as bowlers count
            hint += QStringLiteral(" rad/s = %1 rpm").arg(numberText(value * 30 / std::numbers::pi));
        m_labels[f]->setText(names[f]);
        m_fields[f]->setWords(QStringLiteral("%1, %2").arg(QString::fromStdString(m_body.id), names[f]),
                              hint);
    }
}

void BodyGroup::showFields(bool turns) {
    for (int f = SpinX; f <= Inertia; ++f) {
        m_labels[std::size_t(f)]->setVisible(turns);
        m_fields[std::size_t(f)]->setVisible(turns);
    }
}

void BodyGroup::show(const Body& body, bool turns) {
    m_body = body;
    showFields(turns);
    const double speed = length(body.velocity);
    m_id->setText(QString::fromStdString(body.id));
    m_fields[Mass]->setValue(body.mass);
    m_fields[Radius]->setValue(body.radius);
    m_fields[Speed]->setValue(speed);
    m_fields[Direction]->setValue(speed > 0 ? std::atan2(body.velocity.y, body.velocity.x) / degree : 0);
    m_fields[X]->setValue(body.position.x);
    m_fields[Y]->setValue(body.position.y);
    m_fields[SpinX]->setValue(body.spin.x);
    m_fields[SpinY]->setValue(body.spin.y);
    m_fields[SpinZ]->setValue(body.spin.z);
    m_fields[Inertia]->setValue(body.inertia);
    showErrors({});
    retranslate();
}

void BodyGroup::setColour(const QColor& colour) {
    m_colour = colour;
    update();
}

void BodyGroup::take(int field, double value) {
    const double speed = length(m_body.velocity);
    switch (field) {
    case Mass:
        m_body.mass = value;
        break;
    case Radius:
        m_body.radius = value;
        break;
    case Speed:
        if (value >= 0) // scaled, so that the direction stays as it was
            m_body.velocity = speed > 0 && value > 0 ? m_body.velocity * (value / speed)
                                                     : polar(value, m_fields[Direction]->value());
        break;
    case Direction:
        m_body.velocity = polar(speed, value);
        break;
    case X:
        m_body.position.x = value;
        break;
    case Y:
        m_body.position.y = value;
        break;
    case SpinX:
        m_body.spin.x = value;
        break;
    case SpinY:
        m_body.spin.y = value;
        break;
    case SpinZ:
        m_body.spin.z = value;
        break;
    default:
        m_body.inertia = value;
    }
    retranslate(); // the tool tips tell every digit
    emit edited();
}

bool BodyGroup::isUsable() const {
    for (const NumberField* field : m_fields)
        if (!field->unreadable().isEmpty())
            return false;
    return m_fields[Speed]->value() >= 0;
}

void BodyGroup::complain(int field, const QString& message) {
    m_fields[std::size_t(field)]->setWrong(true);
    addMessage(field / 2, m_labels[std::size_t(field)]->text(), message);
}

void BodyGroup::addMessage(int row, const QString& about, const QString& message) {
    QLabel& label = *m_messages[std::size_t(row)];
    const QString line = QStringLiteral("%1: %2").arg(about, message);
    label.setText(label.text().isEmpty() ? line : label.text() + u'\n' + line);
    label.show();
}

void BodyGroup::showErrors(const std::vector<SceneError>& errors) {
    for (NumberField* field : m_fields)
        field->setWrong(false);
    for (QLabel* message : m_messages) {
        message->clear();
        message->hide();
    }
    for (int f = 0; f < fieldCount; ++f)
        if (const QString why = m_fields[std::size_t(f)]->unreadable(); !why.isEmpty())
            complain(f, why);
    if (const double speed = m_fields[Speed]->value(); speed < 0)
        complain(Speed, tr("must be 0 or more, is %1").arg(numberText(speed)));

    const QString own = QStringLiteral("bodies[%1].").arg(m_index);
    for (const SceneError& error : errors) {
        const QString path = QString::fromStdString(error.path);
        // An overlap is told to both: either may be the one that was just moved.
        const bool overlaps = error.code == SceneErrorCode::Overlap && error.first == m_body.id;
        if (!path.startsWith(own) && !overlaps)
            continue;
        const QString key = overlaps ? QStringLiteral("position") : path.mid(own.size());
        if (key == "position") {
            m_fields[X]->setWrong(true);
            m_fields[Y]->setWrong(true);
            addMessage(X / 2, tr("Position"), sceneErrorMessage(error));
            continue;
        }
        complain(fieldFor(key), sceneErrorMessage(error));
    }
}

int BodyGroup::fieldFor(const QString& key) const {
    static const std::pair<const char*, Field> fields[] = {
        {"mass", Mass},    {"radius", Radius}, {"velocity", Speed}, {"position[1", Y},   {"position", X},
        {"spin[1", SpinY}, {"spin[2", SpinZ},  {"spin", SpinX},     {"inertia", Inertia}};
    for (const auto& [start, field] : fields)
        if (key.startsWith(QLatin1String(start)))
            return field;
    return X;
}

void BodyGroup::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_colour);
    const double radius = m_appearance.unit() * 0.625;
    painter.drawEllipse(QPointF(radius, m_id->geometry().center().y() + 0.5), radius, radius);
}

} // namespace thetalane

#include "ui/panels/body_group.h"

#include "ui/bench/rules/edit_options.h"
#include "ui/bench/rules/placing.h"
#include "ui/panels/icon_button.h"
#include "ui/panels/number_field.h"
#include "ui/panels/panel.h"
#include "ui/panels/value_slider.h"
#include "ui/words/glossary.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"
#include "ui/words/worked_steps.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>

#include <cmath>
#include <limits>
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

BodyGroup::BodyGroup(const Appearance& appearance, const EditOptions& options, int index, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_options(options)
    , m_index(index)
    , m_grid(new QGridLayout(this))
    , m_name(new QLineEdit(this))
    , m_kind(new QComboBox(this))
    , m_remove(new IconButton(appearance, Icon::Minus, "", this))
    , m_nameMessage(new QLabel(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setColumnStretch(0, 1);
    m_grid->setColumnStretch(1, 1);
    buildHead();
    buildFields();
    connect(&appearance, &Appearance::changed, this, &BodyGroup::restyle);
    restyle();
    retranslate();
}

void BodyGroup::buildHead() {
    const QString name = QStringLiteral("body%1").arg(m_index);
    m_name->setObjectName(name + "Name");
    m_kind->setObjectName(name + "Kind");
    m_remove->setObjectName(name + "Remove");
    m_nameMessage->setObjectName(name + "NameMessage");
    m_kind->addItems({QString(), QString()});
    m_kind->installEventFilter(this);
    auto* kind = new QWidget(this);
    auto* kindLayout = new QGridLayout(kind);
    kindLayout->setContentsMargins(0, 0, 0, 0);
    kindLayout->addWidget(m_kind, 0, 0);
    kindLayout->addWidget(new IconMark(m_appearance, Icon::Down, kind), 0, 0,
                          Qt::AlignRight | Qt::AlignVCenter);
    auto* head = new QHBoxLayout;
    head->setSpacing(m_appearance.unit() / 2);
    head->addSpacing(m_appearance.unit() * 2); // room for the dot
    head->addWidget(m_name, 3);
    head->addWidget(kind, 2);
    head->addWidget(m_remove);
    m_grid->addLayout(head, 0, 0, 1, 2);
    m_grid->addWidget(m_nameMessage, 1, 0, 1, 2);
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        const std::string id = m_name->text().trimmed().toStdString();
        if (id == m_body.id)
            return;
        m_body.id = id;
        emit edited();
    });
    connect(m_kind, &QComboBox::activated, this, [this](int chosen) {
        m_body.kind = BodyKind(chosen);
        emit edited();
    });
    connect(m_remove, &IconButton::clicked, this, [this] { emit removeWanted(m_index); });
}

void BodyGroup::buildFields() {
    static constexpr const char* names[] = {"Mass", "Radius", "Speed", "Direction", "X",
                                            "Y",    "SpinX",  "SpinY", "SpinZ",     "Inertia"};
    static constexpr const char* units[] = {"kg", "m", "m/s", "°", "m", "m", "rad/s", "rad/s", "rad/s", ""};
    static constexpr const char* terms[] = {"mass",
                                            "radius",
                                            "speed",
                                            "direction",
                                            nullptr,
                                            nullptr,
                                            "angular-velocity",
                                            "angular-velocity",
                                            "angular-velocity",
                                            "moment-of-inertia"};
    static constexpr double steps[] = {0.1, 0.01, 0.1, 1, 0.01, 0.01, 1, 1, 1, 0.01};
    static constexpr double spans[][2] = {{0.1, 10}, {0.02, 0.3}}; // of the sliders
    const QString name = QStringLiteral("body%1").arg(m_index);
    for (int f = 0; f < fieldCount; ++f) {
        const auto at = std::size_t(f);
        m_fields[at] = new NumberField(m_appearance, name + names[f], this);
        m_fields[at]->setUnit(QString::fromUtf8(units[f]));
        if (f == Mass || f == Radius || f == Inertia)
            m_fields[at]->setStep(steps[f], steps[f]);
        else
            m_fields[at]->setStep(steps[f]);
        m_labels[at] = new QLabel(this);
        m_labels[at]->setBuddy(m_fields[at]->edit());
        if (terms[f])
            for (QWidget* about : std::initializer_list<QWidget*>{m_labels[at], m_fields[at]})
                setTerm(about, terms[f]);
        const int row = 2 + f / 2 * 4;
        m_grid->addWidget(m_labels[at], row, f % 2);
        m_grid->addWidget(m_fields[at], row + 1, f % 2);
        connect(m_fields[at], &NumberField::edited, this, [this, f](double value) { take(f, value); });
        connect(m_fields[at], &NumberField::becameUnreadable, this, &BodyGroup::edited);
        if (at >= m_sliders.size())
            continue;
        m_sliders[at] = new ValueSlider(m_appearance, name + names[f] + "Slider", this);
        m_sliders[at]->setSpan(spans[f][0], spans[f][1], steps[f], spans[f][0]);
        m_grid->addWidget(m_sliders[at], row + 2, f % 2);
        connect(m_sliders[at], &ValueSlider::numberEdited, this, [this, f](double value) {
            m_fields[std::size_t(f)]->setValue(value);
            take(f, value);
        });
    }
    for (int r = 0; r < fieldCount / 2; ++r) {
        auto* message = new QLabel(this);
        message->setObjectName(name + names[2 * r] + "Message");
        m_messages[std::size_t(r)] = message;
        m_grid->addWidget(message, 5 + 4 * r, 0, 1, 2);
    }
}

void BodyGroup::restyle() {
    const int unit = m_appearance.unit();
    m_grid->setHorizontalSpacing(unit * 2);
    m_grid->setVerticalSpacing(2);
    m_name->setFont(m_appearance.font(Appearance::Size::Normal, true));
    m_name->setMinimumWidth(unit * 6);
    m_kind->setFont(m_appearance.font(Appearance::Size::Normal));
    m_kind->setMinimumWidth(unit * 8);
    makeMessage(*m_nameMessage, m_appearance);
    for (QLabel* label : m_labels) {
        makeQuiet(*label, m_appearance);
        label->setContentsMargins(0, unit / 2, 0, 0);
    }
    for (QLabel* message : m_messages)
        makeMessage(*message, m_appearance);
}

void BodyGroup::retranslate() {
    const bool oneLine = m_options.oneLine();
    const QString names[] = {tr("Mass"),
                             tr("Radius"),
                             oneLine ? tr("Velocity") : tr("Speed"),
                             tr("Direction"),
                             tr("Position x"),
                             tr("Position y"),
                             tr("Spin x"),
                             tr("Spin y"),
                             tr("Spin z"),
                             tr("Moment of inertia β")};
    const QString hints[] = {
        tr("Mass of this body, greater than 0"),
        tr("Radius of this body, greater than 0"),
        oneLine ? tr("Velocity along x; negative: to the left") : tr("Speed of this body, 0 or more"),
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
        const QString name = QStringLiteral("%1, %2").arg(bodyName(m_body), names[f]);
        m_fields[f]->setWords(name, hint);
        if (f < m_sliders.size())
            m_sliders[f]->setWords(name, hint);
    }
    m_name->setToolTip(tr("Name of this body; each has its own"));
    m_name->setAccessibleName(tr("Name"));
    m_kind->setItemText(int(BodyKind::Ball), tr("Ball"));
    m_kind->setItemText(int(BodyKind::Pin), tr("Pin"));
    m_kind->setToolTip(tr("Ball or pin: they look different; on a floor with friction balls roll"));
    m_kind->setAccessibleName(tr("Kind"));
    m_remove->setWords(tr("Remove %1").arg(bodyName(m_body)), tr("Remove %1").arg(bodyName(m_body)));
}

void BodyGroup::showFields(bool turns) {
    const bool oneLine = m_options.oneLine();
    for (int f = Direction; f <= Inertia; ++f) {
        const bool shown = f >= SpinX ? turns : f == X || !oneLine;
        m_labels[std::size_t(f)]->setVisible(shown);
        m_fields[std::size_t(f)]->setVisible(shown);
    }
    const auto step = oneLine ? -std::numeric_limits<double>::infinity() : 0;
    m_fields[Speed]->setStep(0.1, step);
}

void BodyGroup::show(const Body& body, bool turns, bool removable) {
    m_body = m_dense = body;
    showFields(turns);
    const double speed = length(body.velocity);
    if (const QString id = QString::fromStdString(body.id); m_name->text() != id)
        m_name->setText(id);
    m_kind->setCurrentIndex(int(body.kind));
    m_remove->setEnabled(removable);
    m_fields[Mass]->setValue(body.mass);
    m_fields[Radius]->setValue(body.radius);
    m_sliders[Mass]->setNumber(body.mass);
    m_sliders[Radius]->setNumber(body.radius);
    m_fields[Speed]->setValue(m_options.oneLine() ? body.velocity.x : speed);
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
        takeMass(value);
        break;
    case Radius:
        m_body.radius = value;
        m_sliders[Radius]->setNumber(value);
        if (value > 0)
            m_dense.radius = value;
        break;
    case Speed:
        if (m_options.oneLine())
            m_body.velocity = {value, 0};
        else if (value >= 0) // scaled, so that the direction stays as it was
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

void BodyGroup::takeMass(double mass) {
    Body dense = m_dense;
    setMass(dense, mass, m_options.constantSize());
    m_body.mass = mass;
    m_sliders[Mass]->setNumber(mass);
    if (!(mass > 0))
        return;
    m_dense = dense;
    if (m_options.constantSize())
        return;
    m_body.radius = dense.radius;
    m_fields[Radius]->setValue(dense.radius);
    m_sliders[Radius]->setNumber(dense.radius);
}

bool BodyGroup::isUsable() const {
    for (const NumberField* field : m_fields)
        if (!field->unreadable().isEmpty())
            return false;
    return m_options.oneLine() || m_fields[Speed]->value() >= 0;
}

void BodyGroup::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_colour);
    const double radius = m_appearance.unit() * 0.625;
    painter.drawEllipse(QPointF(radius, m_name->geometry().center().y() + 0.5), radius, radius);
}

// A wheel that scrolls the panel must not change what passes under it.
bool BodyGroup::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Wheel && !m_kind->hasFocus()) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace thetalane

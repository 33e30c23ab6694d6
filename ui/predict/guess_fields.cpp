#include "ui/predict/guess_fields.h"

#include "ui/panels/number_field.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180; // rad

// Of 90° exactly, 0 and not 6·10⁻¹⁷.
double tidy(double value, double scale) {
    return std::abs(value) < 1e-12 * scale ? 0 : value;
}

Vec2d fromPolar(double speed, double degrees) {
    return {tidy(speed * std::cos(degrees * degree), std::abs(speed)),
            tidy(speed * std::sin(degrees * degree), std::abs(speed))};
}

} // namespace

GuessFields::GuessFields(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_grid(new QGridLayout(this))
    , m_mode(new QPushButton(this))
    , m_momentum(new QCheckBox(this))
    , m_energy(new QCheckBox(this)) {
    setObjectName(QStringLiteral("guessFields"));
    makeFields();
    m_mode->setObjectName(QStringLiteral("guessMode"));
    m_mode->setProperty("quiet", true);
    m_momentum->setObjectName(QStringLiteral("guessMomentum"));
    m_energy->setObjectName(QStringLiteral("guessEnergy"));
    m_grid->setContentsMargins(0, 0, 0, 0);
    for (int b = 0; b < 2; ++b) {
        m_heads[std::size_t(b)] = new QLabel(this);
        m_names[std::size_t(b)] = new QLabel(this);
        m_grid->addWidget(m_heads[std::size_t(b)], 0, 1 + b, Qt::AlignHCenter);
        m_grid->addWidget(m_names[std::size_t(b)], 1 + b, 0);
        m_grid->addWidget(&field(2 * b), 1 + b, 1);
        m_grid->addWidget(&field(2 * b + 1), 1 + b, 2);
    }
    m_grid->addWidget(m_mode, 3, 0, 1, 3, Qt::AlignRight);
    m_grid->addWidget(m_momentum, 4, 0, 1, 3);
    m_grid->addWidget(&field(MomentumX), 5, 1);
    m_grid->addWidget(&field(MomentumY), 5, 2);
    m_grid->addWidget(m_energy, 6, 0, 1, 2);
    m_grid->addWidget(&field(Energy), 6, 2);
    m_grid->setColumnStretch(1, 1);
    m_grid->setColumnStretch(2, 1);
    connect(m_mode, &QPushButton::clicked, this, [this] {
        m_polar = !m_polar;
        showVelocities();
        retranslate();
    });
    for (QCheckBox* box : {m_momentum, m_energy})
        connect(box, &QCheckBox::toggled, this, [this] {
            showMarks();
            take();
        });
    restyle();
    retranslate();
    showMarks();
    // As they are read, not as they were made.
    const std::initializer_list<QWidget*> order{field(FirstX).edit(),
                                                field(FirstY).edit(),
                                                field(SecondX).edit(),
                                                field(SecondY).edit(),
                                                m_mode,
                                                m_momentum,
                                                field(MomentumX).edit(),
                                                field(MomentumY).edit(),
                                                m_energy,
                                                field(Energy).edit()};
    for (auto next = order.begin() + 1; next != order.end(); ++next)
        setTabOrder(*(next - 1), *next);
}

void GuessFields::makeFields() {
    static constexpr const char* names[fieldCount] = {"guessFirstX",    "guessFirstY",    "guessSecondX",
                                                      "guessSecondY",   "guessMomentumX", "guessMomentumY",
                                                      "guessEnergyLost"};
    for (int f = 0; f < fieldCount; ++f) {
        auto* number = new NumberField(m_appearance, QString::fromLatin1(names[f]), this);
        connect(number, &NumberField::edited, this, &GuessFields::take);
        connect(number, &NumberField::becameUnreadable, this, [this] {
            showMarks();
            emit edited();
        });
        m_fields[std::size_t(f)] = number;
    }
    field(Energy).setUnit(QStringLiteral("J"));
}

void GuessFields::setUp(const QString& first, const QString& second, bool isWall, double speed) {
    m_first = first;
    m_second = second;
    m_isWall = isWall;
    m_prediction = {};
    m_momentum->setChecked(false);
    m_energy->setChecked(false);
    for (NumberField* f : m_fields) {
        f->setValue(0);
        f->setStep(std::pow(10.0, std::floor(std::log10(std::max(speed, 1e-6) / 5))));
    }
    showMarks();
    retranslate();
}

void GuessFields::setVelocities(const VelocityPair<double>& velocities) {
    m_prediction.after = velocities;
    showVelocities();
}

void GuessFields::showVelocities() {
    for (int b = 0; b < 2; ++b) {
        const Vec2d v = b == 0 ? m_prediction.after.first : m_prediction.after.second;
        field(2 * b).setValue(m_polar ? norm(v) : v.x);
        field(2 * b + 1).setValue(m_polar ? (norm(v) > 0 ? std::atan2(v.y, v.x) / degree : 0) : v.y);
    }
}

void GuessFields::take() {
    const auto velocity = [this](int b) {
        const double one = field(2 * b).value(), two = field(2 * b + 1).value();
        return m_polar ? fromPolar(one, two) : Vec2d{one, two};
    };
    m_prediction.after = {velocity(0), m_isWall ? Vec2d{} : velocity(1)};
    m_prediction.momentum.reset();
    m_prediction.energyLost.reset();
    if (m_momentum->isChecked() && !m_isWall)
        m_prediction.momentum = Vec2d{field(MomentumX).value(), field(MomentumY).value()};
    if (m_energy->isChecked())
        m_prediction.energyLost = field(Energy).value();
    showMarks();
    emit edited();
}

void GuessFields::showMarks() {
    for (NumberField* f : m_fields) {
        f->setWrong(!f->unreadable().isEmpty());
        f->edit()->setReadOnly(!m_editable);
    }
    m_names[1]->setVisible(!m_isWall);
    field(SecondX).setVisible(!m_isWall);
    field(SecondY).setVisible(!m_isWall);
    m_momentum->setVisible(!m_isWall);
    field(MomentumX).setVisible(!m_isWall && m_momentum->isChecked());
    field(MomentumY).setVisible(!m_isWall && m_momentum->isChecked());
    field(Energy).setVisible(m_energy->isChecked());
    m_momentum->setEnabled(m_editable);
    m_energy->setEnabled(m_editable);
}

void GuessFields::setEditable(bool editable) {
    m_editable = editable;
    showMarks();
}

bool GuessFields::isReadable() const {
    return unreadable().isEmpty();
}

QString GuessFields::unreadable() const {
    for (const NumberField* f : m_fields)
        if (!f->isHidden() && !f->unreadable().isEmpty())
            return f->unreadable();
    return {};
}

void GuessFields::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void GuessFields::retranslate() {
    const QString after = tr("after the collision, as you expect it");
    for (int b = 0; b < 2; ++b) {
        const QString& name = b == 0 ? m_first : m_second;
        m_names[std::size_t(b)]->setText(name);
        const QString one = m_polar ? tr("Speed of %1").arg(name) : QStringLiteral("%1, vx").arg(name);
        const QString two = m_polar ? tr("Direction of %1").arg(name) : QStringLiteral("%1, vy").arg(name);
        field(2 * b).setWords(one, one + QStringLiteral(": ") + after);
        field(2 * b + 1).setWords(
            two, two + QStringLiteral(": ") +
                     (m_polar ? tr("from the x axis, counterclockwise, as you expect it") : after));
        field(2 * b).setUnit(QStringLiteral("m/s"));
        field(2 * b + 1).setUnit(m_polar ? QStringLiteral("°") : QStringLiteral("m/s"));
    }
    m_heads[0]->setText(m_polar ? tr("Speed") : QStringLiteral("<i>v</i><sub>x</sub>"));
    m_heads[1]->setText(m_polar ? tr("Direction") : QStringLiteral("<i>v</i><sub>y</sub>"));
    m_mode->setText(m_polar ? tr("As components") : tr("As speed and direction"));
    m_mode->setToolTip(tr("How the velocities are typed"));
    m_mode->setAccessibleName(m_mode->text());
    m_momentum->setText(tr("Total momentum too: x, y [kg·m/s]"));
    m_momentum->setToolTip(tr("Predict the momentum of both together after the collision"));
    m_energy->setText(tr("Energy lost too"));
    m_energy->setToolTip(tr("Predict how much kinetic energy the collision takes"));
    field(MomentumX).setWords(tr("Total momentum, x"), tr("Of both together, after the collision"));
    field(MomentumY).setWords(tr("Total momentum, y"), tr("Of both together, after the collision"));
    field(Energy).setWords(tr("Energy lost"), m_energy->toolTip());
}

void GuessFields::restyle() {
    using Size = Appearance::Size;
    const int unit = m_appearance.unit();
    m_grid->setHorizontalSpacing(unit / 2);
    m_grid->setVerticalSpacing(unit / 2);
    for (int b = 0; b < 2; ++b) {
        m_names[std::size_t(b)]->setFont(m_appearance.font(Size::Normal, true));
        m_names[std::size_t(b)]->setStyleSheet(
            QStringLiteral("color: %1;").arg(m_appearance.textInk(b == 0 ? Ink::First : Ink::Second).name()));
    }
    for (QLabel* head : m_heads) {
        head->setFont(m_appearance.font(Size::Normal));
        head->setStyleSheet(QStringLiteral("color: %1;").arg(m_appearance.quietText().name()));
    }
    m_mode->setFont(m_appearance.font(Size::Small));
    const int box = m_appearance.projector() ? 22 : 16;
    for (QCheckBox* b : {m_momentum, m_energy}) {
        b->setFont(m_appearance.font(Size::Normal));
        b->setMinimumHeight(m_appearance.projector() ? 36 : 24);
        b->setStyleSheet(QStringLiteral("QCheckBox { color: %1; } QCheckBox:focus { color: %2; } "
                                        "QCheckBox::indicator { width: %3px; height: %3px; }")
                             .arg(m_appearance.text().name(), m_appearance.accent().name())
                             .arg(box));
    }
}

} // namespace thetalane

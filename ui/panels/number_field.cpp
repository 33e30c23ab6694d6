#include "ui/panels/number_field.h"

#include "ui/words/number_text.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStyle>
#include <QWheelEvent>

#include <cmath>

namespace thetalane {
namespace {

const QChar trueMinus(0x2212);

QString shownText(double value) {
    if (value == 0)
        return QStringLiteral("0"); // not -0
    return QString::number(value, 'g', 6).replace('-', trueMinus);
}

} // namespace

NumberField::NumberField(const Appearance& appearance, const QString& name, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_edit(new QLineEdit(this))
    , m_unit(new QLabel(this)) {
    m_edit->setObjectName(name);
    m_edit->setAlignment(Qt::AlignRight);
    m_edit->installEventFilter(this);
    m_unit->setBuddy(m_edit);
    setFocusProxy(m_edit);
    setStep(m_step);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_edit, 1);
    layout->addWidget(m_unit);
    connect(m_edit, &QLineEdit::editingFinished, this, &NumberField::commit);
    connect(&appearance, &Appearance::changed, this, &NumberField::restyle);
    restyle();
    show(0);
}

void NumberField::restyle() {
    // Said to each: with a style sheet a font does not come down from the parent.
    m_edit->setFont(m_appearance.font(Appearance::Size::Normal));
    m_unit->setFont(m_appearance.font(Appearance::Size::Small));
    m_unit->setStyleSheet(QStringLiteral("color: %1;").arg(m_appearance.quietText().name()));
    // The widest unit there is, so that the fields of a column end at the same place.
    m_unit->setFixedWidth(QFontMetrics(m_unit->font()).horizontalAdvance(QStringLiteral("rad/s")) + 2);
    m_edit->setMinimumWidth(m_appearance.unit() * 7);
    if (!m_unitButton)
        return;
    m_unitButton->setFont(m_unit->font());
    m_unitButton->setFixedWidth(m_unit->width());
    m_unitButton->setStyleSheet(
        QStringLiteral("QPushButton { border: none; background: transparent; padding: 0; text-align: left; "
                       "color: %1; } QPushButton:hover { text-decoration: underline; } "
                       "QPushButton:focus { border-bottom: 2px solid %1; }")
            .arg(m_appearance.accent().name()));
}

void NumberField::setUnits(const QStringList& units, int chosen) {
    if (!m_unitButton) {
        m_unitButton = new QPushButton(this);
        m_unitButton->setObjectName(m_edit->objectName() + QStringLiteral("Unit"));
        m_unitButton->setFocusPolicy(Qt::TabFocus);
        m_unitButton->setCursor(Qt::PointingHandCursor);
        m_unitMenu = new QMenu(this);
        connect(m_unitButton, &QPushButton::clicked, this, &NumberField::showUnitMenu);
        delete layout()->replaceWidget(m_unit, m_unitButton);
        m_unit->hide();
        for (int k = 0; k < units.size(); ++k)
            m_unitMenu->addAction(units[k], this, [this, k] { emit unitChosen(k); })->setCheckable(true);
    }
    const auto actions = m_unitMenu->actions();
    for (int k = 0; k < actions.size(); ++k)
        actions[k]->setChecked(k == chosen);
    m_unitButton->setText(units[chosen]);
    restyle();
}

void NumberField::setUnitWords(const QString& name, const QString& toolTip) {
    m_unitButton->setAccessibleName(name);
    m_unitButton->setToolTip(toolTip);
}

void NumberField::showUnitMenu() {
    m_unitMenu->popup(m_unitButton->mapToGlobal(QPoint(0, m_unitButton->height())));
}

void NumberField::setStep(double step, double low, double high) {
    m_step = step;
    m_low = low;
    m_high = high;
}

void NumberField::setUnit(const QString& unit) {
    m_unit->setText(unit);
    restyle();
}

void NumberField::setWords(const QString& name, const QString& toolTip) {
    m_edit->setAccessibleName(name);
    m_edit->setToolTip(toolTip);
}

void NumberField::setValue(double value) {
    m_value = value;
    m_isUnreadable = false;
    setWrong(false);
    if (m_edit->text() != shownText(value) || m_shown != shownText(value))
        show(value);
}

QString NumberField::unreadable() const {
    if (!m_isUnreadable)
        return {};
    if (m_unread.isEmpty())
        return tr("must be a number, is empty");
    return tr("must be a number, is “%1”").arg(m_unread.size() > 12 ? m_unread.left(11) + u'…' : m_unread);
}

void NumberField::setWrong(bool wrong) {
    if (wrong == m_wrong)
        return;
    m_wrong = wrong;
    m_edit->setProperty("wrong", wrong);
    m_edit->style()->unpolish(m_edit);
    m_edit->style()->polish(m_edit);
}

void NumberField::show(double value) {
    m_shown = shownText(value);
    m_edit->setText(m_shown);
    m_edit->setCursorPosition(0);
}

void NumberField::commit() {
    const QString text = m_edit->text();
    if (text == m_shown && !m_isUnreadable)
        return;
    if (const auto number = parseNumber(text)) {
        // The text as it stood stands for the exact value behind it.
        const double value = text == m_shown ? m_value : *number;
        const bool news = m_isUnreadable || value != m_value;
        setValue(value);
        if (news)
            emit edited(value);
        return;
    }
    m_isUnreadable = true;
    m_unread = text.trimmed();
    emit becameUnreadable();
}

void NumberField::stepBy(int steps, Qt::KeyboardModifiers modifiers) {
    commit();
    if (m_isUnreadable)
        return;
    const double step = m_step * (modifiers & Qt::ShiftModifier ? 10 : 1);
    // Twelve digits: 0.1 + 0.2 is to be 0.3.
    const double value = QString::number(m_value + steps * step, 'g', 12).toDouble();
    const bool leaves = (value < m_low && value < m_value) || (value > m_high && value > m_value);
    if (leaves || value == m_value)
        return;
    setValue(value);
    m_edit->selectAll();
    emit edited(value);
}

bool NumberField::keyPressed(int key, Qt::KeyboardModifiers modifiers) {
    switch (key) {
    case Qt::Key_Up:
        stepBy(1, modifiers);
        return true;
    case Qt::Key_Down:
        stepBy(-1, modifiers);
        return true;
    case Qt::Key_Escape: // what stood before the typing
        if (m_edit->text() == m_shown && !m_isUnreadable)
            return false;
        m_edit->setText(m_shown);
        commit();
        return true;
    default:
        return false;
    }
}

bool NumberField::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        event->ignore(); // no number has a space in it: the bar plays and pauses here too
        return true;
    }
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (keyPressed(key->key(), key->modifiers()))
            return true;
    } else if (event->type() == QEvent::Wheel && m_edit->hasFocus()) {
        // Only with the focus: a wheel that scrolls the panel must not change what passes under it.
        const auto* wheel = static_cast<QWheelEvent*>(event);
        m_wheel += wheel->angleDelta().y();
        const int notches = m_wheel / QWheelEvent::DefaultDeltasPerStep;
        m_wheel -= notches * QWheelEvent::DefaultDeltasPerStep;
        if (notches)
            stepBy(notches, wheel->modifiers());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace thetalane

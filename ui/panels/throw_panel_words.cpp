// What the throw's attributes are called, what is wrong with them, and what they do.
#include "ui/panels/spin_dial.h"
#include "ui/panels/throw_panel.h"
#include "ui/panels/value_row.h"
#include "ui/words/glossary.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include <cmath>

namespace thetalane {

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
    m_rows[Mass]->setUnitWords(tr("Unit of the mass"), tr("Choose the unit"));
    m_rows[Speed]->setUnitWords(tr("Unit of the speed"), tr("Choose the unit"));
    say(Restitution, tr("Coefficient of restitution e"), tr("Between ball and pins, and pins and pins"));
    m_pathLabel->setText(tr("Path shown"));
    m_path->setItemText(int(Foresight::Whole), tr("to the end"));
    m_path->setItemText(int(Foresight::FirstContact), tr("to the first contact"));
    m_path->setAccessibleName(tr("Path shown"));
    m_path->setToolTip(tr("How much is shown before the ball is thrown"));
    m_throwButton->setText(tr("Throw"));
    m_throwButton->setToolTip(tr("Throw the ball from the foul line"));
    m_throwButton->setAccessibleName(tr("Throw"));
    m_default->setText(tr("Default throw"));
    m_default->setToolTip(tr("Every attribute as it was at first"));
    m_default->setAccessibleName(tr("Default throw"));
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
    // The same in the unit that the reader may think in.
    const auto otherMass = m_units.mass == MassUnit::Kilogram ? MassUnit::Pound : MassUnit::Kilogram;
    const auto otherSpeed = m_units.speed == SpeedUnit::MetresPerSecond ? SpeedUnit::KilometresPerHour
                                                                        : SpeedUnit::MetresPerSecond;
    const auto other = [](double value, const QString& symbol) {
        return QString::number(value, 'f', 1) + ' ' + symbol;
    };
    m_rows[Mass]->setNote(
        other(m_rows[Mass]->value() * factorOf(Mass) / inKilograms(otherMass), unitSymbol(otherMass)));
    m_rows[Speed]->setNote(other(m_rows[Speed]->value() * factorOf(Speed) / inMetresPerSecond(otherSpeed),
                                 unitSymbol(otherSpeed)));
    m_rows[Direction]->setNote(direction > 0   ? tr("to the right")
                               : direction < 0 ? tr("to the left")
                                               : tr("straight"));
    m_rows[Position]->setNote(tr("board %1").arg(boardAt(m_rows[Position]->value())));
    showRoll();
}

// What rotation and axis do to this throw, on this lane.
void ThrowPanel::showRoll() {
    const double axis = m_rows[Axis]->value();
    const double rpm = m_rows[Spin]->value();
    const bool turns = rpm > 0;
    m_dial->setSpin(rpm, axis);
    m_dial->setWords(tr("Rotation and its axis"),
                     tr("Drag the bead: round the ball for the axis, outwards for more rotation. Wheel: "
                        "rotation, with Shift the axis. Arrow keys; Shift: fine"),
                     tr("%1 rpm, axis %2°").arg(numberText(rpm), numberText(axis)));
    const double sideways = turns ? std::sin(radians(axis)) : 0;
    const bool aside = std::abs(sideways) > 1e-12;
    m_rows[Axis]->setNote(!turns         ? QString()
                          : !aside       ? tr("forward roll")
                          : sideways > 0 ? tr("hooks left")
                                         : tr("hooks right"));
    const auto& friction = session().scene().friction;
    setTerm(m_rollNote, !friction || !aside ? "friction" : friction->oil.empty() ? "hook" : "oil-pattern");
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

} // namespace thetalane

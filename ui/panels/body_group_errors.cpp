// What is wrong with a body, said beside its fields.
#include "ui/bench/rules/edit_options.h"
#include "ui/panels/body_group.h"
#include "ui/panels/number_field.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"

#include <QLabel>

namespace thetalane {

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
    m_nameMessage->clear();
    m_nameMessage->hide();
    for (QLabel* message : m_messages) {
        message->clear();
        message->hide();
    }
    for (int f = 0; f < fieldCount; ++f)
        if (const QString why = m_fields[std::size_t(f)]->unreadable(); !why.isEmpty())
            complain(f, why);
    if (const double speed = m_fields[Speed]->value(); speed < 0 && !m_options.oneLine())
        complain(Speed, tr("must be 0 or more, is %1").arg(numberText(speed)));

    const QString own = QStringLiteral("bodies[%1].").arg(m_index);
    for (const SceneError& error : errors) {
        const QString path = QString::fromStdString(error.path);
        // An overlap is told to both: either may be the one that was just moved.
        const bool overlaps = error.code == SceneErrorCode::Overlap && error.first == m_body.id;
        if (!path.startsWith(own) && !overlaps)
            continue;
        const QString key = overlaps ? QStringLiteral("position") : path.mid(own.size());
        if (key == "id") {
            m_nameMessage->setText(QStringLiteral("%1: %2").arg(tr("Name"), sceneErrorMessage(error)));
            m_nameMessage->show();
            continue;
        }
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

} // namespace thetalane

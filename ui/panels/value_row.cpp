#include "ui/panels/value_row.h"

#include "ui/panels/number_field.h"
#include "ui/panels/panel.h"
#include "ui/panels/value_slider.h"
#include "ui/words/glossary.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

namespace thetalane {

ValueRow::ValueRow(const Appearance& appearance, const QString& name, const Span& span, const QString& unit,
                   QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_grid(new QGridLayout(this))
    , m_label(new QLabel(this))
    , m_field(new NumberField(appearance, name + "Field", this))
    , m_slider(new ValueSlider(appearance, name + "Slider", this))
    , m_note(new QLabel(this))
    , m_message(new QLabel(this)) {
    m_message->setObjectName(name + "Message");
    m_note->setObjectName(name + "Note");
    m_label->setBuddy(m_field->edit());
    m_label->setWordWrap(true);
    m_field->setUnit(unit);
    setSpan(span);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->addWidget(m_label, 0, 0);
    m_grid->addWidget(m_field, 0, 1);
    m_grid->addWidget(m_slider, 1, 0);
    m_grid->addWidget(m_note, 1, 1);
    m_grid->addWidget(m_message, 2, 0, 1, 2);
    m_grid->setColumnStretch(0, 1);
    connect(m_field, &NumberField::edited, this, [this](double value) {
        m_slider->setNumber(value);
        emit edited(value);
    });
    connect(m_field, &NumberField::becameUnreadable, this, &ValueRow::becameUnreadable);
    connect(m_field, &NumberField::unitChosen, this, &ValueRow::unitChosen);
    connect(m_slider, &ValueSlider::numberEdited, this, [this](double value) {
        m_field->setValue(value);
        emit edited(value);
    });
    connect(&appearance, &Appearance::changed, this, &ValueRow::restyle);
    restyle();
}

void ValueRow::restyle() {
    const int unit = m_appearance.unit();
    m_grid->setHorizontalSpacing(unit);
    m_grid->setVerticalSpacing(0);
    const int fieldWidth = m_appearance.projector() ? unit * 12 : unit * 14;
    m_field->setFixedWidth(fieldWidth);
    m_note->setFixedWidth(fieldWidth);
    m_label->setFont(m_appearance.font(Appearance::Size::Normal));
    makeQuiet(*m_note, m_appearance);
    makeMessage(*m_message, m_appearance);
}

void ValueRow::setSpan(const Span& span) {
    m_field->setStep(span.step, span.low, span.high);
    m_slider->setSpan(span.low, span.high, span.step, span.origin);
}

void ValueRow::setUnits(const QStringList& units, int chosen) {
    m_field->setUnits(units, chosen);
}

void ValueRow::setUnitWords(const QString& name, const QString& toolTip) {
    m_field->setUnitWords(name, toolTip);
}

double ValueRow::value() const {
    return m_field->value();
}

void ValueRow::setValue(double value) {
    m_field->setValue(value);
    m_slider->setNumber(value);
}

void ValueRow::setWords(const QString& label, const QString& toolTip) {
    m_label->setText(label);
    m_field->setWords(label, toolTip);
    m_slider->setWords(label, toolTip);
}

// A pause over the name explains it; the number has more to tell about itself, but F1 knows.
void ValueRow::setTerm(const char* id) {
    thetalane::setTerm(this, id);
    thetalane::setTerm(m_label, id);
}

void ValueRow::setNote(const QString& note) {
    m_note->setText(note);
}

void ValueRow::setMessage(const QString& message) {
    m_message->setText(message);
    m_message->setVisible(!message.isEmpty());
    m_field->setWrong(!message.isEmpty());
}

QString ValueRow::unreadable() const {
    return m_field->unreadable();
}

} // namespace thetalane

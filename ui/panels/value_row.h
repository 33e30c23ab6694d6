// One quantity: its name, a number to type, a slider to move, a quiet note beside, and a message below when
// wrong.
#pragma once

#include "ui/appearance.h"

#include <QWidget>

class QGridLayout;
class QLabel;

namespace thetalane {

class NumberField;
class ValueSlider;

class ValueRow : public QWidget {
    Q_OBJECT
public:
    struct Span {
        double low = 0;
        double high = 1;
        double step = 0.01;
        double origin = 0; // from where the slider's line is filled
    };

    // The field is named name + "Field", the slider name + "Slider", the message name + "Message".
    ValueRow(const Appearance& appearance, const QString& name, const Span& span, const QString& unit,
             QWidget* parent = nullptr);

    double value() const;
    void setValue(double value);

    void setSpan(const Span& span);
    // Units to choose from; the values are then in the chosen one.
    void setUnits(const QStringList& units, int chosen);
    void setUnitWords(const QString& name, const QString& toolTip);

    void setWords(const QString& label, const QString& toolTip);
    void setTerm(const char* id); // of the glossary
    void setNote(const QString& note);
    void setMessage(const QString& message); // empty: nothing is wrong

    // Why the text is no number, or empty.
    QString unreadable() const;

signals:
    void edited(double value);
    void becameUnreadable();
    void unitChosen(int index);

private:
    void restyle();

    const Appearance& m_appearance;
    QGridLayout* m_grid;
    QLabel* m_label;
    NumberField* m_field;
    ValueSlider* m_slider;
    QLabel* m_note;
    QLabel* m_message;
};

} // namespace thetalane

// A number with its unit that can be typed, stepped and turned with the wheel. Whatever is typed stands and
// is answered; nothing is clamped in silence. Up to six digits are shown, and the exact value is kept until
// edited.
#pragma once

#include "ui/appearance.h"

#include <QWidget>

#include <limits>
#include <optional>

class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;

namespace thetalane {

class NumberField : public QWidget {
    Q_OBJECT
public:
    // name becomes the objectName of the line edit, which is what a user meets.
    NumberField(const Appearance& appearance, const QString& name, QWidget* parent = nullptr);

    double value() const { return m_value; } // as it was given, to the last bit
    void setValue(double value);             // drops what was being typed

    // Stepping stays within [low, high]; typing does not have to.
    void setStep(double step, double low = -std::numeric_limits<double>::infinity(),
                 double high = std::numeric_limits<double>::infinity());
    void setUnit(const QString& unit);
    // The unit becomes a button, named as the edit and "Unit", with a menu of them.
    void setUnits(const QStringList& units, int chosen);
    void setUnitWords(const QString& name, const QString& toolTip);
    void setWords(const QString& name, const QString& toolTip);

    // Empty, or why the text is no number, in the language of now.
    QString unreadable() const;
    void setWrong(bool wrong); // marked in the colour of errors
    bool isWrong() const { return m_wrong; }

    QLineEdit* edit() const { return m_edit; }

signals:
    void edited(double value); // a number was entered that is not the one before, or mends an unreadable text
    void becameUnreadable();
    void unitChosen(int index); // of setUnits(), by the user

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void restyle();
    void showUnitMenu();
    void commit();
    void stepBy(int steps, Qt::KeyboardModifiers modifiers);
    void show(double value);
    bool keyPressed(int key, Qt::KeyboardModifiers modifiers);

    const Appearance& m_appearance;
    QLineEdit* m_edit;
    QLabel* m_unit;
    QPushButton* m_unitButton = nullptr; // in the label's place
    QMenu* m_unitMenu = nullptr;
    QString m_shown; // what was put into the edit for m_value
    QString m_unread;
    double m_value = 0;
    double m_step = 0.1;
    double m_low = 0;
    double m_high = 0;
    int m_wheel = 0;
    bool m_wrong = false;
    bool m_isUnreadable = false;
};

} // namespace thetalane

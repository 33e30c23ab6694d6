// The header of a step's card: its number, its title, and in short what came out while the card is closed.
#pragma once

#include "ui/steps/formula_layout.h"
#include "ui/words/worked_steps.h"

#include <QAbstractButton>

namespace thetalane {

class StepHeader : public QAbstractButton {
    Q_OBJECT
public:
    StepHeader(const Appearance& appearance, Stage stage, QWidget* parent = nullptr);

    void setCurrent(bool current);
    void setKey(const WorkedLine& line);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    void retranslate();

protected:
    void paintEvent(QPaintEvent*) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }

private:
    const Appearance& m_appearance;
    Stage m_stage;
    bool m_current = false;
    WorkedLine m_key;
};

} // namespace thetalane

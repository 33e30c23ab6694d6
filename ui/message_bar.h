// One line under the top bar: what is wrong with a file that was opened. Nothing modal.
#pragma once

#include "ui/context.h"

#include <QFrame>

class QLabel;
class QToolButton;

namespace thetalane {

class MessageBar : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(const Context& context, QWidget* parent = nullptr);

    void showError(const QString& text);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void applyAppearance();

    Appearance& m_appearance;
    QLabel* m_text;
    QToolButton* m_close;
};

} // namespace thetalane

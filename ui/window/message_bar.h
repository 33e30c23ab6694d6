// One line under the top bar: what is wrong with a file that was opened. Nothing modal.
#pragma once

#include "ui/context.h"

#include <QFrame>

#include <functional>

class QLabel;
class QToolButton;

namespace thetalane {

class MessageBar : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(const Context& context, QWidget* parent = nullptr);

    // Asked for again when the language changes.
    void showError(std::function<QString()> text);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void applyAppearance();

    Appearance& m_appearance;
    QLabel* m_text;
    std::function<QString()> m_error;
    QToolButton* m_close;
};

} // namespace thetalane

// Offers what a crash left behind, one scene after the other. Nothing modal; closed, it is offered again at
// the next start.
#pragma once

#include "ui/bench/file_flow.h"
#include "ui/context.h"

#include <QFrame>

class QLabel;
class QPushButton;
class QToolButton;

namespace thetalane {

class RecoveryBar : public QFrame {
    Q_OBJECT
public:
    RecoveryBar(const Context& context, FileFlow& flow, QWidget* parent = nullptr);

    void retranslate();

protected:
    void changeEvent(QEvent* event) override;

private:
    void restyle();
    void showOffer();

    const Appearance& m_appearance;
    FileFlow& m_flow;
    QLabel* m_text;
    QPushButton* m_recover;
    QPushButton* m_discard;
    QToolButton* m_close;
    bool m_closed = false;
};

} // namespace thetalane

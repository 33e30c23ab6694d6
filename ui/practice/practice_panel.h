// Practice: spares, and what changes if one attribute of the throw does.
#pragma once

#include "ui/panels/panel.h"

class QVBoxLayout;

namespace thetalane {

class SpareBox;
class VaryBox;

class PracticePanel : public Panel {
    Q_OBJECT
public:
    explicit PracticePanel(const Context& context, QWidget* parent = nullptr);

    SpareBox& spares() { return *m_spares; }
    VaryBox& varied() { return *m_varied; }

    void retranslate() override;

signals:
    void thrown(); // at the pins of spare practice

protected:
    void restyle() override;

private:
    QVBoxLayout* m_column;
    SpareBox* m_spares;
    VaryBox* m_varied;
};

} // namespace thetalane

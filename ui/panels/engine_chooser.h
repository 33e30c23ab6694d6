// How contacts are found: exactly, or by the paper's loop with its step.
#pragma once

#include "ui/panels/panel.h"

class QComboBox;

namespace thetalane {

class EngineChooser : public Panel {
    Q_OBJECT
public:
    explicit EngineChooser(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;

protected:
    void restyle() override;

private:
    void choose(int index);
    void showCurrent();

    QComboBox* m_combo;
};

} // namespace thetalane

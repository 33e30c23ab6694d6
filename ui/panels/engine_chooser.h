// How contacts are found: exactly, by the paper's loop with its step, or by swept steps.
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
    static QString engineText(const EngineSettings& settings);

    QComboBox* m_combo;
};

} // namespace thetalane

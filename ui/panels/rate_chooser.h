// How fast time goes: − 1/8× +.
#pragma once

#include "ui/panels/panel.h"

class QLabel;

namespace thetalane {

class IconButton;

QString rateText(double rate); // "1/8×", "2×"

class RateChooser : public Panel {
    Q_OBJECT
public:
    explicit RateChooser(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;

protected:
    void restyle() override;

private:
    void step(int by);
    void showRate();

    IconButton* m_slower;
    IconButton* m_faster;
    QLabel* m_rate;
};

} // namespace thetalane

// How long the run goes on: quiet beside the present time, for whoever wants to watch longer. Not there where
// the run ends by itself.
#pragma once

#include "ui/panels/panel.h"

class QMenu;
class QPushButton;

namespace thetalane {

class UntilChooser : public Panel {
    Q_OBJECT
public:
    explicit UntilChooser(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void resized();

protected:
    void restyle() override;

private:
    void fillMenu();
    void showCurrent();

    QPushButton* m_button;
    QMenu* m_menu;
};

} // namespace thetalane

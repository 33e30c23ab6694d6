// Which scene: the built-in ones by kind, or a file.
#pragma once

#include "ui/panels/panel.h"

class QMenu;
class QPushButton;

namespace thetalane {

class SceneChooser : public Panel {
    Q_OBJECT
public:
    explicit SceneChooser(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void openFileRequested();

protected:
    void restyle() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    enum class Kind { TwoBodies, ManyBodies, Lane };

    void fillMenu();
    void addHeading(Kind kind);
    void showCurrent();

    QPushButton* m_button;
    QMenu* m_menu;
};

} // namespace thetalane

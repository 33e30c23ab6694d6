// Which scene: the built-in ones by kind, or a file.
#pragma once

#include "ui/panels/panel.h"

#include <functional>

class QMenu;
class QPushButton;

namespace thetalane {

struct BuiltinScene;

class SceneChooser : public Panel {
    Q_OBJECT
public:
    explicit SceneChooser(const Context& context, QWidget* parent = nullptr);

    // Asked before another scene is opened: does what it is given when nothing would be lost by it.
    void setGuard(std::function<void(std::function<void()>)> guard) { m_guard = std::move(guard); }

    void retranslate() override;
    void setInLesson(bool on); // a title could tell what the lesson asks
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void openFileRequested();

protected:
    void restyle() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    enum class Kind { TwoBodies, ManyBodies, Lane };

    static Kind kindOf(const Scene& scene);
    void fillMenu();
    void addHeading(Kind kind);
    void addScene(const BuiltinScene& entry, const Scene& scene);
    void showCurrent();
    void choose(const QString& id);

    std::function<void(std::function<void()>)> m_guard;
    QPushButton* m_button;
    QMenu* m_menu;
    bool m_inLesson = false;
};

} // namespace thetalane

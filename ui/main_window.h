// The window: assembly only. Everything in it talks to the session and the playhead, never to each other.
#pragma once

#include "ui/context.h"
#include "ui/words/language.h"

#include <QMainWindow>

#include <functional>

class QStackedWidget;
class QTabWidget;
class QToolButton;

namespace thetalane {

class BodiesPanel;
class Divide;
class IconButton;
class LabPanel;
class LanePanel;
class MessageBar;
class SceneChooser;
class StepPanel;
class ThrowPanel;
enum class Preset;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow(const Context& context, Language& language, QWidget* parent = nullptr);
    ~MainWindow() override;

    void setProjector(bool on);
    void setReducedMotion(bool on); // for pictures and for people who prefer it

    // Geometry, divide and projector mode, in the user's settings.
    void restoreState();
    void saveState() const;

    // Opens a scene file; what is wrong with it is said in the window, and the last good scene stays.
    void openFile(const QString& path);

    // Opens the accuracy lab on one of its questions, which it then measures.
    void openLab(Preset preset);
    bool isMeasuring() const;

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildTopBar();
    void buildCentre();
    void buildShortcuts();
    // givesWayTo: says which widget with the focus has the key itself.
    void addShortcut(const QKeySequence& keys, std::function<void()> action,
                     bool (*givesWayTo)(const QWidget*) = nullptr);
    void retranslate();
    void applyAppearance();
    void styleApplication();
    void showPanelsFor(const Run& run);
    void openSelection();
    void toggleLanguage();
    void chooseFile();

    Context m_context;
    Language& m_language;
    QWidget* m_topBar = nullptr;
    SceneChooser* m_scenes = nullptr;
    IconButton* m_reset = nullptr;
    QToolButton* m_projector = nullptr;
    QToolButton* m_korean = nullptr;
    QToolButton* m_english = nullptr;
    MessageBar* m_message = nullptr;
    Divide* m_divide = nullptr;
    LanePanel* m_lane = nullptr;
    QTabWidget* m_tabs = nullptr;
    StepPanel* m_steps = nullptr;
    QStackedWidget* m_attributes = nullptr; // the bodies', or the throw's
    BodiesPanel* m_bodies = nullptr;
    ThrowPanel* m_throw = nullptr;
    LabPanel* m_lab = nullptr;
};

} // namespace thetalane

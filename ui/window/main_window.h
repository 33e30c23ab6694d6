// The window: assembly only. Everything in it talks to the session and the playhead, never to each other.
#pragma once

#include "ui/context.h"
#include "ui/words/language.h"

#include <QMainWindow>

class QStackedWidget;

namespace thetalane {

class Divide;
class LanePanel;
class MessageBar;
class Rail;
class Shortcuts;
class TermHelp;
class TopBar;
enum class Preset;
enum class Room;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow(const Context& context, Language& language, QWidget* parent = nullptr);
    ~MainWindow() override;

    void setReducedMotion(bool on); // for pictures and for people who prefer it

    // Geometry, divide, theme and projector mode, in the user's settings.
    void restoreState();
    void saveState() const;

    // Opens a scene file; what is wrong with it is said in the window, and the last good scene stays.
    void openFile(const QString& path);

    void enter(Room room);
    void explainTerm(); // the one under the mouse, or of the widget with the focus

    // Opens the accuracy lab on one of its questions, which it then measures.
    void openLab(Preset preset);
    bool isMeasuring() const;

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildCentre();
    void furnishRooms();
    void buildShortcuts();
    void retranslate();
    void applyAppearance();
    void styleApplication();
    void showPanelsFor(const Run& run);
    void openSelection();
    void toggleLanguage();
    void chooseFile();

    Context m_context;
    Language& m_language;
    TopBar* m_topBar = nullptr;
    MessageBar* m_message = nullptr;
    Divide* m_divide = nullptr;
    LanePanel* m_lane = nullptr;
    QStackedWidget* m_panels = nullptr;
    Rail* m_rail = nullptr;
    Shortcuts* m_shortcuts = nullptr;
    TermHelp* m_terms = nullptr;
    bool m_isThrow = false; // what the attributes are of
};

} // namespace thetalane

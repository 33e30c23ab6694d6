// The window: assembly only. Everything in it talks to the session and the playhead, never to each other.
#pragma once

#include "ui/context.h"
#include "ui/words/language.h"

#include <QMainWindow>

class QStackedWidget;

namespace thetalane {

class AimTool;
class Alley;
class Desk;
class Divide;
class EditOptions;
class EditTool;
class FileFlow;
class LanePanel;
class LessonPanel;
class MessageBar;
class Rail;
class Shortcuts;
class TermHelp;
class TimelineBar;
class TopBar;
enum class LessonShow;
enum class Preset;
enum class Room;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow(const Context& context, Language& language, QWidget* parent = nullptr);
    ~MainWindow() override;

    // Geometry, divide and how it looks, in the user's settings.
    void restoreState();
    void saveState() const;
    // Edits that are not saved are kept from now on, and those of a crash are offered.
    void keepRecoveries();

    // Opens a scene file; what is wrong with it is said in the window, and the last good scene stays.
    void openFile(const QString& path);

    void enter(Room room);
    void explainTerm(); // the one under the mouse, or of the widget with the focus

    // Opens the accuracy lab on one of its questions, which it then measures.
    void openLab(Preset preset);
    bool isMeasuring() const;

    Alley& alley() { return *m_alley; }
    Desk& desk() { return *m_desk; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildCentre();
    void buildTools();
    void furnishRooms();
    void furnishClassroom();
    void furnishAlley();
    void buildShortcuts();
    void retranslate();
    void showTitle();
    void applyAppearance();
    void styleApplication();
    void showPanelsFor(const Run& run);
    void followGame();
    void bringForward(LessonShow what);
    void addCaption(LessonPanel& lessons);
    void hideFuture();
    void openSelection();
    void toggleLanguage();

    Context m_context;
    Language& m_language;
    Desk* m_desk;
    FileFlow* m_files;
    EditOptions* m_editing;
    Alley* m_alley;
    TopBar* m_topBar = nullptr;
    MessageBar* m_message = nullptr;
    Divide* m_divide = nullptr;
    LanePanel* m_lane = nullptr;
    TimelineBar* m_timeline = nullptr;
    QStackedWidget* m_panels = nullptr;
    Rail* m_rail = nullptr;
    AimTool* m_aim = nullptr;
    EditTool* m_edit = nullptr;
    Shortcuts* m_shortcuts = nullptr;
    TermHelp* m_terms = nullptr;
    bool m_isThrow = false; // what the attributes are of
    bool m_inLesson = false;
    bool m_mayLoseEdits = false; // said once, for the lesson that comes
    bool m_leaving = false;      // the question of what is not saved was answered
    bool m_isAsked = false;      // a lesson's question is open
    bool m_predicting = false;   // or a class predicts: the lane does not tell what comes
};

} // namespace thetalane

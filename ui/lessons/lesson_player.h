// A lesson being given: which page is open, and how the window gets there. It talks to the session and the
// playhead alone.
#pragma once

#include "core/format/lesson_file.h"
#include "ui/context.h"

#include <QObject>
#include <QTimer>

namespace thetalane {

// Its pages are the stops and, at its place, the question. Every page holds until the next one is asked for.
class LessonPlayer : public QObject {
    Q_OBJECT
public:
    explicit LessonPlayer(const Context& context, QObject* parent = nullptr);

    // Opens the first page. The engine of before comes back with leave(); the scene stays, to go on with.
    void start(const Lesson& lesson);
    void leave();
    bool running() const { return m_lesson.has_value(); }
    const Lesson& lesson() const { return *m_lesson; } // while running

    int page() const { return m_page; }
    int pageCount() const;
    int questionPage() const; // -1: there is none
    bool isQuestion() const { return running() && m_page == questionPage(); }
    const LessonStop* stop() const; // null on the question's page

    // What the engine says of the question; nothing for a choice. Asked for when it is revealed, not before.
    std::optional<Vec2d> truth() const { return truthOf(*m_lesson); }

    // On the way to a stop by playing; then next() is there at once.
    bool travelling() const { return m_travelling || m_stages.isActive(); }
    // Somebody changed the scene or the engine: the lesson's words may no longer fit. Any page puts it back.
    bool isChanged() const { return m_changed; }

public slots:
    void next();
    void back();
    void goTo(int page); // without playing
    void putBack();      // the scene of this page

signals:
    void started();
    void left();
    void pageChanged();
    void arrived();
    void changed(bool isChanged);
    void showRequested(thetalane::LessonShow what);

private:
    const LessonSetting& settingOf(int page) const;
    void open(int page, bool byPlaying);
    void bring(const LessonSetting& setting);
    void putEngine(const EngineSettings& engine);
    void holdAtQuestion();
    void travel(const LessonStop& stop);
    void arrive(bool stageByStage);
    void stepToStage();
    void stopTravelling();
    void watchRun();
    double timeOf(const LessonStop& stop) const;

    Context m_context;
    std::optional<Lesson> m_lesson;
    EngineSettings m_engineBefore;
    double m_rateBefore = 1;
    int m_page = 0;
    bool m_travelling = false;
    bool m_bringing = false;
    bool m_changed = false;
    QTimer m_stages; // from stage to stage, at a pace that can be followed
};

} // namespace thetalane

#include "ui/run_ahead.h"

#include <chrono>

namespace thetalane {
namespace {

bool holds(const Chapter& chapter, const RunAhead::Place& place) {
    if (const double* time = std::get_if<double>(&place))
        return chapter.holdsTime(*time);
    return chapter.holdsCollision(std::get<std::int64_t>(place));
}

RunAhead::Progress progressOf(LongRun& run) {
    RunAhead::Progress progress{run.computedTo(), run.collisionCount(), run.endReason(), 0};
    if (progress.end && progress.collisions > 0)
        progress.lastCollision =
            run.chapterOfCollision(progress.collisions)->timeline.collisions().back().time;
    return progress;
}

} // namespace

RunAhead::RunAhead(std::unique_ptr<LongRun> run)
    : m_run(std::move(run))
    , m_progress(progressOf(*m_run))
    , m_thread([this] { work(); }) {}

RunAhead::~RunAhead() {
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_toDo.notify_all();
    m_thread.join();
}

RunAhead::Progress RunAhead::progress() const {
    const std::lock_guard lock(m_mutex);
    return m_progress;
}

bool RunAhead::isComputed(const Place& place) const {
    const std::lock_guard lock(m_mutex);
    return isComputedLocked(place);
}

bool RunAhead::isComputedLocked(const Place& place) const {
    if (const auto* number = std::get_if<std::int64_t>(&place))
        return *number >= 1 && *number <= m_progress.collisions;
    return m_progress.end || std::get<double>(place) < m_progress.computedTo;
}

RunAhead::ChapterPtr RunAhead::foundAlready(const Place& place) const {
    for (const ChapterPtr& found : {m_answer, m_next})
        if (found && holds(*found, place))
            return found;
    return nullptr;
}

RunAhead::ChapterPtr RunAhead::chapter(const Place& place, int patience) {
    std::unique_lock lock(m_mutex);
    if (!isComputedLocked(place))
        return nullptr;
    if (auto found = foundAlready(place))
        return found;
    m_asked = place;
    m_toDo.notify_all();
    ChapterPtr found;
    m_done.wait_for(lock, std::chrono::milliseconds(patience),
                    [&] { return (found = foundAlready(place)) != nullptr; });
    return found;
}

void RunAhead::expect(double time) {
    const std::lock_guard lock(m_mutex);
    if (!isComputedLocked(time) || foundAlready(time))
        return;
    m_expected = time;
    m_toDo.notify_all();
}

void RunAhead::waitFor(const Place& place) {
    std::unique_lock lock(m_mutex);
    m_done.wait(lock, [&] { return m_progress.end || isComputedLocked(place); });
}

// What is asked for goes first, then what will be, then the rest of the run.
void RunAhead::work() {
    std::unique_lock lock(m_mutex);
    while (!m_stop) {
        if (m_asked)
            answer(lock, m_asked, m_answer);
        else if (m_expected)
            answer(lock, m_expected, m_next);
        else if (!m_progress.end)
            goOn(lock);
        else
            m_toDo.wait(lock);
    }
}

void RunAhead::answer(std::unique_lock<std::mutex>& lock, std::optional<Place>& question, ChapterPtr& found) {
    const Place place = *question;
    found.reset(); // first out, then in
    lock.unlock();
    auto chapter = std::holds_alternative<double>(place)
                       ? m_run->chapterAt(std::get<double>(place))
                       : m_run->chapterOfCollision(std::get<std::int64_t>(place));
    lock.lock();
    found = std::move(chapter);
    if (question == place) // and nothing else was asked meanwhile
        question.reset();
    m_done.notify_all();
}

void RunAhead::goOn(std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    m_run->goOn();
    const Progress progress = progressOf(*m_run);
    lock.lock();
    m_progress = progress;
    m_done.notify_all();
}

} // namespace thetalane

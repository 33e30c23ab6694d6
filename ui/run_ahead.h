// Computes a long run to its end on a thread of its own, and meanwhile finds any chapter that is computed.
#pragma once

#include "core/engine/long_run.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <variant>

namespace thetalane {

class RunAhead {
public:
    // A moment [s], or the number of a collision, from 1.
    using Place = std::variant<double, std::int64_t>;
    using ChapterPtr = std::shared_ptr<const Chapter>;

    struct Progress {
        double computedTo = 0;       // s
        std::int64_t collisions = 0; // so far
        std::optional<EndReason> end;
        double lastCollision = 0; // s; known where the run ended by itself
    };

    explicit RunAhead(std::unique_ptr<LongRun> run);
    ~RunAhead(); // waits for the chapter that is being computed

    Progress progress() const;
    bool isComputed(const Place& place) const;

    // The chapter of a place that is computed; null where it takes longer than `patience` [ms]. It is then
    // found all the same, for whoever asks again. A question takes the place of an earlier one.
    ChapterPtr chapter(const Place& place, int patience);
    // It will be wanted soon.
    void expect(double time);

    // Until the place is computed, or the run has ended.
    void waitFor(const Place& place);

private:
    void work();
    void goOn(std::unique_lock<std::mutex>& lock);
    void answer(std::unique_lock<std::mutex>& lock, std::optional<Place>& question, ChapterPtr& found);
    ChapterPtr foundAlready(const Place& place) const;
    bool isComputedLocked(const Place& place) const;

    std::unique_ptr<LongRun> m_run; // the thread's alone
    mutable std::mutex m_mutex;     // for all that follows
    std::condition_variable m_toDo;
    std::condition_variable m_done;
    Progress m_progress;
    std::optional<Place> m_asked;
    std::optional<Place> m_expected;
    ChapterPtr m_answer;
    ChapterPtr m_next;
    bool m_stop = false;
    std::thread m_thread; // the last one: it needs the others
};

} // namespace thetalane

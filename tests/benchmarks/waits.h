// What a person waits, and how much of that the processor worked for us: on a busy machine others have it
// too.
#pragma once

#include "tests/benchmarks/table.h"
#include "tests/benchmarks/timing.h"

#include <QElapsedTimer>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace thetalane::benchmarks {

struct Wait {
    double wall = 0; // s
    double work = 0; // s, of all threads
};

class Stopwatch {
public:
    Stopwatch()
        : m_work(processorTime()) {
        m_clock.start();
    }
    Wait lap() {
        const Wait wait{double(m_clock.nsecsElapsed()) * 1e-9, processorTime() - m_work};
        m_clock.start();
        m_work = processorTime();
        return wait;
    }

private:
    QElapsedTimer m_clock;
    double m_work;
};

inline Wait waited(const std::function<void()>& work) {
    Stopwatch watch;
    work();
    return watch.lap();
}

inline std::string text(const Wait& wait) {
    return seconds(wait.wall) + " (" + seconds(wait.work) + ")";
}

// Of each by itself.
inline Wait quantile(const std::vector<Wait>& waits, double part) {
    std::vector<double> wall, work;
    for (const Wait& w : waits) {
        wall.push_back(w.wall);
        work.push_back(w.work);
    }
    std::sort(wall.begin(), wall.end());
    std::sort(work.begin(), work.end());
    const auto place = std::size_t(part * double(waits.size() - 1) + 0.5);
    return {wall[place], work[place]};
}

} // namespace thetalane::benchmarks

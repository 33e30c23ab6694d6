#include "core/study/strike_map.h"

#include "core/bowling/pinfall.h"
#include "core/engine/engine.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <numbers>
#include <thread>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double perMinute = 2 * std::numbers::pi / 60;
constexpr int coarsest = 16; // every 16th column and row first

// In the order of MapQuantity.
using Values = std::array<double, mapQuantities>;

Values valuesAt(const MapSettings& s, int column, int row) {
    Values v{s.base.offset, s.base.angle, s.base.speed, s.base.spin, s.base.mass};
    v[std::size_t(s.across.quantity)] = s.across.at(column);
    v[std::size_t(s.up.quantity)] = s.up.at(row);
    return v;
}

double of(const Values& v, MapQuantity q) {
    return v[std::size_t(q)];
}

std::optional<Throw> throwOf(const MapSettings& s, const Values& v) {
    Throw t;
    t.mass = of(v, MapQuantity::Mass);
    t.speed = of(v, MapQuantity::Speed);
    t.spin = of(v, MapQuantity::Spin);
    t.position = s.base.position;
    return throwArriving(t, of(v, MapQuantity::Offset), of(v, MapQuantity::Angle), s.friction);
}

std::optional<Body> ballOf(const MapSettings& s, const Values& v) {
    if (s.scene == MapScene::Rack)
        return rackBall(of(v, MapQuantity::Offset), -of(v, MapQuantity::Angle), of(v, MapQuantity::Speed),
                        of(v, MapQuantity::Mass));
    const auto t = throwOf(s, v);
    return t ? std::optional(thrownBall(*t)) : std::nullopt;
}

Scene emptyScene(const MapSettings& s) {
    return s.scene == MapScene::Rack ? rackScene(0, 0, 1, s.restitution)
                                     : bowlingScene({}, s.restitution, s.friction);
}

// Throws one ball after another at the same rack.
class Thrower {
public:
    explicit Thrower(const MapSettings& settings)
        : m_map(settings)
        , m_scene(emptyScene(settings)) {
        m_engine.keepDetail = false;
    }

    MapCell cell(int column, int row) {
        auto ball = ballOf(m_map, valuesAt(m_map, column, row));
        if (!ball)
            return {0, MapCell::State::NoThrow};
        m_scene.bodies[0] = *std::move(ball);
        Run run = std::get<Run>(simulate(std::move(m_scene), m_engine));
        m_scene = std::move(run.scene);
        return {standingAfter(run.timeline), MapCell::State::Known};
    }

private:
    // As fallenPins() has it, of a rack whose pin k is body k: at a few microseconds a throw, reading the
    // pins' names costs.
    std::uint16_t standingAfter(const Timeline& timeline) const {
        unsigned standing = 0;
        for (unsigned pin = 1; pin <= 10; ++pin) {
            const bool fallen =
                timeline.struckSpeed(pin) > m_tipping || timeline.segments(pin).back().place != Place::Play;
            standing |= unsigned(!fallen) << (pin - 1);
        }
        return std::uint16_t(standing);
    }

    const MapSettings& m_map;
    Scene m_scene;
    EngineSettings m_engine;
    double m_tipping = pinTippingSpeed();
};

// The cells that a stride adds to the one before it.
std::vector<std::uint32_t> cellsOf(const StrikeMap& map, int stride) {
    const bool first = stride == coarsest;
    std::vector<std::uint32_t> cells;
    for (int row = 0; row < map.rows(); row += stride)
        for (int column = 0; column < map.columns(); column += stride)
            if (first || row % (2 * stride) != 0 || column % (2 * stride) != 0)
                cells.push_back(std::uint32_t(row) * std::uint32_t(map.columns()) + std::uint32_t(column));
    return cells;
}

// One stride's cells, shared out in small pieces: some throws take ten times as long as others.
class Workers {
public:
    Workers(StrikeMap& map, const std::vector<std::uint32_t>& cells, const std::stop_token& stop)
        : m_map(map)
        , m_cells(cells)
        , m_stop(stop) {}

    // progressed(done): by the calling thread. False when stopped.
    template <class Progressed> bool run(int threads, Progressed&& progressed) {
        {
            std::vector<std::jthread> helpers;
            for (int k = 1; k < threads && std::size_t(k) * piece < m_cells.size(); ++k)
                helpers.emplace_back([this] { work([](std::size_t) {}); });
            work(progressed);
        }
        if (m_error)
            std::rethrow_exception(m_error);
        return !m_stop.stop_requested();
    }

private:
    static constexpr std::size_t piece = 16;

    template <class Progressed> void work(Progressed&& progressed) try {
        Thrower thrower(m_map.settings);
        const auto columns = std::uint32_t(m_map.columns());
        while (!m_stop.stop_requested() && !m_failed) {
            const std::size_t begin = m_next.fetch_add(piece), end = std::min(begin + piece, m_cells.size());
            if (begin >= m_cells.size())
                return;
            for (std::size_t k = begin; k < end; ++k) {
                const std::uint32_t c = m_cells[k];
                m_map.cells[c] = thrower.cell(int(c % columns), m_map.settings.firstRow + int(c / columns));
            }
            progressed(m_done.fetch_add(end - begin) + end - begin);
        }
    } catch (...) { // to be thrown where the map was asked for
        const std::lock_guard lock(m_errors);
        m_error = std::current_exception();
        m_failed = true;
    }

    StrikeMap& m_map;
    const std::vector<std::uint32_t>& m_cells;
    const std::stop_token& m_stop;
    std::atomic<std::size_t> m_next = 0;
    std::atomic<std::size_t> m_done = 0;
    std::atomic<bool> m_failed = false;
    std::mutex m_errors;
    std::exception_ptr m_error;
};

struct Limits {
    double low, high;
};
// What a lane, a ball and a release can be, generously.
constexpr std::array<Limits, mapQuantities> limits{{{-0.5, 0.5},
                                                    {-30 * degree, 30 * degree},
                                                    {0.1, 100},
                                                    {0, 10'000 * perMinute},
                                                    {0.1, regulation::maxBallMass}}};

} // namespace

MapSettings defaultMap(MapScene scene, int columns, int rows) {
    MapSettings s;
    s.scene = scene;
    s.across = {MapQuantity::Offset, -0.16, 0.16, columns};
    s.up = {MapQuantity::Angle, 0, 8 * degree, rows};
    s.base.angle = 6 * degree;
    s.base.speed = scene == MapScene::Rack ? 6.8 : 8.0;
    s.base.spin = scene == MapScene::Rack ? 0 : 400 * perMinute;
    if (scene == MapScene::Bowling)
        s.friction = houseFriction();
    s.rowCount = rows;
    return s;
}

std::optional<MapRefusal> refusalOf(const MapSettings& s) {
    for (const int count : {s.across.count, s.up.count})
        if (count < 1)
            return MapRefusal{MapFault::Count, {}, double(count), 1, double(mostMapCells)};
    if (double(s.across.count) * s.up.count > mostMapCells)
        return MapRefusal{MapFault::TooManyCells, {}, double(s.across.count) * s.up.count, 1, mostMapCells};
    if (s.across.quantity == s.up.quantity)
        return MapRefusal{MapFault::SameQuantity, s.up.quantity};
    const bool spins = s.scene == MapScene::Bowling && s.friction;
    for (const MapAxis* axis : {&s.across, &s.up})
        if (axis->quantity == MapQuantity::Spin && !spins)
            return MapRefusal{MapFault::SpinWithoutFriction, MapQuantity::Spin};
    for (const auto& [column, row] : {std::pair{0, 0}, std::pair{s.across.count - 1, s.up.count - 1}}) {
        const Values v = valuesAt(s, column, row);
        for (std::size_t q = 0; q < mapQuantities; ++q)
            if (!(v[q] >= limits[q].low && v[q] <= limits[q].high))
                return MapRefusal{MapFault::OutOfRange, MapQuantity(q), v[q], limits[q].low, limits[q].high};
    }
    if (s.firstRow < 0 || s.rowCount < 1 || s.rowCount > s.up.count - s.firstRow)
        return MapRefusal{MapFault::Rows, {}, double(s.firstRow + s.rowCount), 1, double(s.up.count)};
    return std::nullopt;
}

StrikeMap computeStrikeMap(const MapSettings& settings, int threads, const MapWatch& watch,
                           const std::stop_token& stop) {
    const int used = threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency()));
    StrikeMap map{settings, {}, 0};
    map.cells.resize(std::size_t(map.columns()) * std::size_t(map.rows()));
    std::size_t before = 0;
    for (int stride = coarsest; stride >= 1; stride /= 2) {
        const auto cells = cellsOf(map, stride);
        Workers workers(map, cells, stop);
        const bool finished = workers.run(used, [&](std::size_t done) {
            if (watch.progressed)
                watch.progressed(before + done, map.cells.size());
        });
        if (!finished)
            break;
        before += cells.size();
        map.stride = stride;
        if (watch.refined)
            watch.refined(map);
    }
    return map;
}

std::optional<Scene> mapScene(const MapSettings& settings, int column, int row) {
    auto ball = ballOf(settings, valuesAt(settings, column, row));
    if (!ball)
        return std::nullopt;
    Scene scene = emptyScene(settings);
    scene.bodies[0] = *std::move(ball);
    return scene;
}

std::optional<Throw> mapThrow(const MapSettings& settings, int column, int row) {
    return settings.scene == MapScene::Bowling ? throwOf(settings, valuesAt(settings, column, row))
                                               : std::nullopt;
}

} // namespace thetalane

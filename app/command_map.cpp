// thetalane map: pins down over offset and entry angle, whole or in parts, and parts put together
#include "app/commands.h"
#include "app/console.h"
#include "app/map_picture.h"
#include "app/map_words.h"
#include "app/options.h"
#include "app/save_file.h"
#include "app/text_table.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <cstdio>
#include <numbers>

namespace thetalane {
namespace {

struct MapCommandText {
    Q_DECLARE_TR_FUNCTIONS(MapCommandText)
};

constexpr double degree = std::numbers::pi / 180;
constexpr double perMinute = 2 * std::numbers::pi / 60;
constexpr std::string_view sceneWords[] = {"rack", "bowling"};
constexpr int mostThreads = 1024;

void declare(Arguments& a) {
    a.takesValue("scene", "rack|bowling",
                 MapCommandText::tr("rack: ten pins without friction; bowling: the whole lane; rack unless "
                                    "said"));
    a.takesValue("offsets", "N", MapCommandText::tr("how many offsets, the columns; 256 unless said"));
    a.takesValue("angles", "N", MapCommandText::tr("how many entry angles, the rows; 256 unless said"));
    a.takesValue("offset-from", "M",
                 MapCommandText::tr("from the head pin, positive to the right; -0.16 unless said"));
    a.takesValue("offset-to", "M", MapCommandText::tr("0.16 unless said"));
    a.takesValue("angle-from", "DEG",
                 MapCommandText::tr("of the path at the pins, positive to the left, as a right-hander's hook "
                                    "comes in; 0 unless said"));
    a.takesValue("angle-to", "DEG", MapCommandText::tr("8 unless said"));
    a.takesValue("speed", "M/S",
                 MapCommandText::tr("rack: at the pins, 6.8 unless said; bowling: at the foul line, 8 unless "
                                    "said"));
    a.takesValue("mass", "KG", MapCommandText::tr("of the ball, at most 7.26 kg; 6.8 unless said"));
    a.takesValue("spin", "RPM",
                 MapCommandText::tr("bowling: direction and axis are found for each cell; 400 unless said"));
    a.takesValue("position", "M",
                 MapCommandText::tr("bowling: at the foul line; 0, the middle, unless said"));
    a.takesValue("restitution", "E", MapCommandText::tr("between bodies; 0.75 unless said"));
    a.takesValue("rows", "A-B", MapCommandText::tr("only these rows, from 1; a part to be merged later"));
    a.takesValue("threads", "N", MapCommandText::tr("as many as the machine has unless said"));
    a.takesValue("csv", "FILE", MapCommandText::tr("writes a line for each cell"));
    a.takesValue("picture", "FILE.png", MapCommandText::tr("draws the map"));
    a.takesValue("merge", "FILES…",
                 MapCommandText::tr("puts the parts in these CSV files together instead of throwing"));
}

// The files behind --merge, up to the next option; the first stays with it.
struct Sorted {
    QStringList arguments;
    QStringList files;
};
Sorted mergeFiles(const QStringList& arguments) {
    Sorted sorted;
    bool collecting = false;
    for (const QString& argument : arguments) {
        const bool option = argument.startsWith("--") && argument.size() > 2;
        const bool first = !sorted.arguments.isEmpty() && sorted.arguments.last() == "--merge";
        if (first && !option) {
            sorted.arguments << argument;
            sorted.files << argument;
            collecting = true;
            continue;
        }
        if (collecting && !option) {
            sorted.files << argument;
            continue;
        }
        collecting = argument.startsWith("--merge=");
        if (collecting)
            sorted.files << argument.section('=', 1);
        sorted.arguments << argument;
    }
    return sorted;
}

constexpr Range atLeast(double low) {
    return {.low = low, .lowOpen = false};
}

void readRows(Arguments& a, MapSettings& s) {
    s.rowCount = s.up.count;
    if (!a.has("rows"))
        return;
    static const QRegularExpression form("^([0-9]{1,9})-([0-9]{1,9})$");
    const auto match = form.match(a.value("rows"));
    const int from = match.captured(1).toInt(), to = match.captured(2).toInt();
    if (!match.hasMatch() || from < 1 || to < from || to > s.up.count)
        a.note("--rows: " + MapCommandText::tr("must be A-B with 1 <= A <= B <= %1, is \"%2\"")
                                .arg(s.up.count)
                                .arg(a.value("rows")));
    s.firstRow = from - 1;
    s.rowCount = to - from + 1;
}

void onlyOfTheLane(Arguments& a, MapScene scene) {
    for (const char* option : {"spin", "position"})
        if (scene == MapScene::Rack && a.has(option))
            a.note(QString("--%1: ").arg(option) +
                   MapCommandText::tr("has no meaning on the rack; add --scene bowling"));
}

int gridCount(Arguments& a, const QString& option) {
    const qint64 count = a.count(option, 256);
    if (count > mostMapCells)
        a.note("--" + option + ": " + MapCommandText::tr("must be at most %1").arg(mostMapCells));
    return int(std::clamp<qint64>(count, 1, mostMapCells));
}

MapSettings settingsOf(Arguments& a) {
    const auto scene = MapScene(a.choice("scene", 0, sceneWords));
    MapSettings s = defaultMap(scene, gridCount(a, "offsets"), gridCount(a, "angles"));
    s.across.from = a.number("offset-from", s.across.from);
    s.across.to = a.number("offset-to", s.across.to);
    s.up.from = a.number("angle-from", 0) * degree;
    s.up.to = a.number("angle-to", 8) * degree;
    s.base.speed = a.number("speed", s.base.speed, positive);
    s.base.mass = a.number("mass", s.base.mass, positive);
    s.base.spin = a.has("spin") ? a.number("spin", 400, atLeast(0)) * perMinute : s.base.spin;
    constexpr double edge = regulation::laneWidth / 2;
    s.base.position = a.number("position", 0, {-edge, edge, false, false});
    s.restitution = a.number("restitution", s.restitution, {0, 1, false, false});
    onlyOfTheLane(a, scene);
    if (s.across.from > s.across.to)
        a.note("--offset-to: " + MapCommandText::tr("must not be less than --offset-from"));
    if (s.up.from > s.up.to)
        a.note("--angle-to: " + MapCommandText::tr("must not be less than --angle-from"));
    readRows(a, s);
    return s;
}

// Told only of a map that takes its time: after each second, in one line that is written over on a terminal.
class Progress {
public:
    Progress() { m_clock.start(); }
    void operator()(std::size_t done, std::size_t all) {
        if (m_clock.elapsed() < 1000 * (m_told + 1))
            return;
        ++m_told;
        const QString line = MapCommandText::tr("%1 % of %2 throws").arg(100 * done / all).arg(all);
        std::fprintf(stderr, "%s\n", line.toUtf8().constData());
    }

private:
    QElapsedTimer m_clock;
    qint64 m_told = 0;
};

std::variant<StrikeMap, int> readParts(const QStringList& files) {
    std::vector<MapFile> parts;
    for (const QString& name : files) {
        QFile file(name);
        if (!file.open(QIODevice::ReadOnly))
            return wrongCall(
                MapCommandText::tr("%1: cannot be read: %2").arg(oneLine(name), file.errorString()));
        parts.push_back({name.toStdString(), file.readAll()});
    }
    auto merged = mergeMaps(parts);
    if (const auto* error = std::get_if<MapFileError>(&merged))
        return wrongCall(mapFileMessage(*error));
    return std::get<StrikeMap>(std::move(merged));
}

std::variant<StrikeMap, int> mapAsked(Arguments& a, const QStringList& files) {
    if (a.has("merge")) {
        for (const char* option :
             {"scene", "offsets", "angles", "offset-from", "offset-to", "angle-from", "angle-to", "speed",
              "mass", "spin", "position", "restitution", "rows", "threads"})
            if (a.has(option))
                a.note(QString("--%1: ").arg(option) +
                       MapCommandText::tr("has no meaning with --merge; leave one of the two out"));
        if (const auto status = a.faults())
            return *status;
        return readParts(files);
    }
    const MapSettings settings = settingsOf(a);
    const qint64 threads = a.has("threads") ? a.count("threads", 1) : 0;
    if (threads > mostThreads)
        a.note("--threads: " + MapCommandText::tr("must be at most %1").arg(mostThreads));
    if (const auto status = a.faults())
        return *status;
    if (const auto refusal = refusalOf(settings))
        return wrongCall(mapRefusalMessage(*refusal, settings));
    return computeStrikeMap(settings, int(threads), {.progressed = Progress()});
}

// Bands of the map, from the smallest angle: how wide the strikes are there.
void printBands(const StrikeMap& map) {
    const int bands = std::min(8, map.rows());
    const MapAxis& up = map.settings.up;
    const QList<Column> columns{{MapCommandText::tr("Entry angle [°]"), Column::Align::Left},
                                {MapCommandText::tr("Pins down, mean")},
                                {MapCommandText::tr("Strikes")}};
    printTable(columns, std::size_t(bands), [&](std::size_t band) {
        const int from = int(band) * map.rows() / bands, to = int(band + 1) * map.rows() / bands;
        double pins = 0;
        int strikes = 0, known = 0;
        for (int row = from; row < to; ++row)
            for (int column = 0; column < map.columns(); ++column) {
                const MapCell& cell = map.at(column, row);
                known += cell.known();
                pins += cell.known() ? cell.pinsDown() : 0;
                strikes += cell.strike();
            }
        const auto angle = [&](int row) {
            return QString::number(up.at(map.settings.firstRow + row) / degree, 'f', 2);
        };
        const QString range =
            to - from > 1 ? angle(from) + QStringLiteral(" – ") + angle(to - 1) : angle(from);
        return QStringList{range, known ? QString::number(pins / known, 'f', 2) : QString("–"),
                           known ? MapCommandText::tr("%1 %").arg(100.0 * strikes / known, 0, 'f', 1)
                                 : QString("–")};
    });
}

void printSummary(const StrikeMap& map) {
    const auto strikes =
        std::count_if(map.cells.begin(), map.cells.end(), [](auto& c) { return c.strike(); });
    const auto none = std::count_if(map.cells.begin(), map.cells.end(), [](auto& c) { return !c.known(); });
    printLine(map.settings.scene == MapScene::Rack
                  ? MapCommandText::tr("Strike map of the rack without friction")
                  : MapCommandText::tr("Strike map of the whole lane"));
    printLine(MapCommandText::tr("Throws: %1, strikes: %2").arg(map.cells.size()).arg(strikes));
    if (none > 0)
        printLine(MapCommandText::tr("Cells that no throw arrives in: %1").arg(none));
    printLine();
    printBands(map);
    printLine();
    printLine(
        MapCommandText::tr("Pins here are discs that slide; real pins fall over and sweep others down. "
                           "The map shows where the pocket lies and how it widens, not how often a real "
                           "bowler strikes."));
}

// Empty, where both may be written.
std::optional<int> wrongOutput(const Arguments& a) {
    for (const char* option : {"csv", "picture"}) {
        if (a.has(option) && a.value(option).isEmpty())
            return wrongCall(QString("--%1: ").arg(option) + MapCommandText::tr("needs the name of a file"));
    }
    if (a.has("picture") && !a.value("picture").endsWith(".png", Qt::CaseInsensitive))
        return wrongCall("--picture: " +
                         MapCommandText::tr("must end in .png, is \"%1\"").arg(a.value("picture")));
    for (const char* option : {"csv", "picture"})
        if (a.has(option))
            if (const auto status = cannotSave(a.value(option)))
                return status;
    return std::nullopt;
}

} // namespace

std::variant<int, MapPictureRequest> mapCommand(const Call& call) {
    const Sorted sorted = mergeFiles(call.arguments);
    Arguments a("map [--scene rack|bowling] [--offsets N] [--angles N] [--csv FILE] [--picture FILE.png] …",
                commandSummary("map"));
    declare(a);
    if (const auto status = a.read(sorted.arguments))
        return *status;
    if (const auto status = wrongOutput(a))
        return *status;
    auto asked = mapAsked(a, sorted.files);
    if (const int* status = std::get_if<int>(&asked))
        return *status;
    StrikeMap map = std::get<StrikeMap>(std::move(asked));
    if (a.has("csv"))
        if (const int status = saveFile(a.value("csv"), mapCsv(map)); status != Done)
            return status;
    printSummary(map);
    const int status = finishOutput();
    if (status != Done || !a.has("picture"))
        return status;
    return MapPictureRequest{std::move(map), a.value("picture"), call.language};
}

} // namespace thetalane

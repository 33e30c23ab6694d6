#include "core/format/json_text.h"
#include "core/format/map_columns.h"
#include "core/format/map_csv.h"

#include <QList>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

namespace thetalane {
namespace {

using namespace mapcolumns;

constexpr double degree = std::numbers::pi / 180;
constexpr double perMinute = 2 * std::numbers::pi / 60;

using Fields = QList<QByteArray>;

// One part after another, line by line; the first fault ends it.
class Merger {
public:
    std::variant<StrikeMap, MapFileError> merge(std::span<const MapFile> parts) {
        for (const MapFile& part : parts)
            if (!read(part))
                return m_error;
        if (!complete())
            return m_error;
        return assembled();
    }

private:
    struct ReadRow {
        std::string file;
        std::string angle;
        std::vector<std::string> offsets;
        std::vector<MapCell> cells;
    };

    bool read(const MapFile& part) {
        m_file = part.name;
        m_line = 0;
        m_begun.clear();
        qsizetype at = 0;
        while (at < part.text.size()) {
            qsizetype end = part.text.indexOf('\n', at);
            end = end < 0 ? part.text.size() : end;
            QByteArray line = part.text.mid(at, end - at);
            if (line.endsWith('\r')) // what has been through a spreadsheet or Windows
                line.chop(1);
            ++m_line;
            at = end + 1;
            if (m_line == 1 ? !isHeader(line) : !line.isEmpty() && !readLine(line.split(',')))
                return false;
        }
        if (m_line < 2)
            return fail({.fault = m_line == 0 ? MapFileFault::NotAMap : MapFileFault::Empty,
                         .expected = header().toStdString()});
        return true;
    }

    bool isHeader(QByteArray line) {
        if (line.startsWith("\xEF\xBB\xBF"))
            line.remove(0, 3);
        if (line == header())
            return true;
        return fail({.fault = MapFileFault::NotAMap,
                     .text = line.left(80).toStdString(),
                     .expected = header().toStdString()});
    }

    bool readLine(const Fields& fields) {
        if (fields.size() != ColumnCount)
            return fail({.fault = MapFileFault::FieldCount,
                         .text = std::to_string(fields.size()),
                         .expected = std::to_string(int(ColumnCount))});
        int row = 0;
        MapCell cell;
        return sameSettings(fields) && rowNumber(fields, row) && readCell(fields, cell) &&
               add(fields, row, cell);
    }

    // The first line of the first file says how it must be.
    bool sameSettings(const Fields& fields) {
        if (m_settings.isEmpty()) {
            if (!readSettings(fields))
                return false;
            m_settings = fields;
            m_settingsFile = m_file;
            return true;
        }
        for (int c = Rows; c < ColumnCount; ++c)
            if (fields[c] != m_settings[c])
                return fail({.fault = MapFileFault::OtherSettings,
                             .column = names[std::size_t(c)],
                             .text = fields[c].toStdString(),
                             .expected = m_settings[c].toStdString(),
                             .other = m_settingsFile});
        return true;
    }

    bool readSettings(const Fields& fields) {
        const auto scene = std::find(sceneNames.begin(), sceneNames.end(), fields[SceneName]);
        if (scene == sceneNames.end())
            return wrongValue(SceneName, fields, "rack, bowling");
        double rows = 0, speed = 0, mass = 0, spin = 0, position = 0, restitution = 0;
        if (!number(Rows, fields, rows) || !number(Speed, fields, speed) || !number(Mass, fields, mass) ||
            !number(SpinRate, fields, spin) || !number(Position, fields, position) ||
            !number(Restitution, fields, restitution))
            return false;
        if (!(rows >= 1 && rows <= mostMapCells) || rows != std::floor(rows))
            return wrongValue(Rows, fields, "1 – " + std::to_string(mostMapCells));
        if (!(restitution >= 0 && restitution <= 1))
            return wrongValue(Restitution, fields, "0 – 1");
        MapSettings s = defaultMap(MapScene(scene - sceneNames.begin()), 1, int(rows));
        s.base.speed = speed;
        s.base.mass = mass;
        s.base.spin = spin * perMinute;
        s.base.position = position;
        s.restitution = restitution;
        m_map.settings = s;
        return true;
    }

    bool rowNumber(const Fields& fields, int& row) {
        double value = 0;
        if (!number(Row, fields, value))
            return false;
        const int rows = m_map.settings.up.count;
        if (!(value >= 1 && value <= rows) || value != std::floor(value))
            return wrongValue(Row, fields, "1 – " + std::to_string(rows));
        row = int(value);
        return true;
    }

    bool readCell(const Fields& fields, MapCell& cell) {
        double offset = 0, angle = 0, down = 0;
        if (!number(Offset, fields, offset) || !number(Angle, fields, angle))
            return false;
        if (fields[PinsDown].isEmpty() && fields[Strike].isEmpty() && fields[Standing].isEmpty()) {
            cell.state = MapCell::State::NoThrow;
            return true;
        }
        if (!number(PinsDown, fields, down))
            return false;
        PinSet left;
        for (const QByteArray& pin : fields[Standing].isEmpty() ? Fields{} : fields[Standing].split('-')) {
            bool whole = false;
            const int n = pin.toInt(&whole);
            if (!whole || n < 1 || n > 10)
                return wrongValue(Standing, fields, "1 – 10");
            left.set(std::size_t(n - 1));
        }
        cell = {std::uint16_t(left.to_ulong()), MapCell::State::Known};
        if (fields[Standing] != standingText(left))
            return wrongValue(Standing, fields, standingText(left).toStdString());
        if (down != cell.pinsDown())
            return wrongValue(PinsDown, fields, std::to_string(cell.pinsDown()));
        if (fields[Strike] != (cell.strike() ? "1" : "0"))
            return wrongValue(Strike, fields, cell.strike() ? "1" : "0");
        return true;
    }

    // A row's cells stand together, in one file.
    bool add(const Fields& fields, int row, const MapCell& cell) {
        ReadRow& r = m_rows[row];
        if (m_begun.empty() || m_begun.back() != row) {
            if (!r.cells.empty())
                return fail({.fault = MapFileFault::RowTwice, .other = r.file, .row = row});
            m_begun.push_back(row);
            r.file = m_file;
            r.angle = fields[Angle].toStdString();
        }
        if (fields[Angle].toStdString() != r.angle)
            return wrongValue(Angle, fields, r.angle);
        r.offsets.push_back(fields[Offset].toStdString());
        r.cells.push_back(cell);
        return true;
    }

    bool complete() {
        m_line = 0;
        m_file.clear();
        if (m_rows.empty())
            return fail({.fault = MapFileFault::Empty});
        for (int row = 1; row <= m_map.settings.up.count; ++row)
            if (!m_rows.contains(row)) {
                const auto next = m_rows.upper_bound(row);
                return fail({.fault = MapFileFault::RowsMissing,
                             .row = row,
                             .lastRow = (next == m_rows.end() ? m_map.settings.up.count : next->first - 1)});
            }
        return sameOffsets() && evenAngles();
    }

    bool sameOffsets() {
        const ReadRow& first = m_rows.begin()->second;
        MapAxis& across = m_map.settings.across;
        across = {MapQuantity::Offset, std::stod(first.offsets.front()), std::stod(first.offsets.back()),
                  int(first.offsets.size())};
        for (const auto& [row, r] : m_rows) {
            m_file = r.file;
            if (r.offsets.size() != first.offsets.size())
                return fail({.fault = MapFileFault::RowUnfinished,
                             .text = std::to_string(r.offsets.size()),
                             .expected = std::to_string(first.offsets.size()),
                             .other = first.file,
                             .row = row});
            for (std::size_t k = 0; k < r.offsets.size(); ++k) {
                const auto expected = shortestDigits(across.at(int(k))).toStdString();
                if (r.offsets[k] != expected)
                    return otherSettings(Offset, r.offsets[k], expected, row, first.file);
            }
        }
        return true;
    }

    bool evenAngles() {
        const double from = std::stod(m_rows.begin()->second.angle);
        const double to = std::stod(m_rows.rbegin()->second.angle);
        m_map.settings.up = {MapQuantity::Angle, from * degree, to * degree, m_map.settings.up.count};
        const MapAxis axis{MapQuantity::Angle, from, to, m_map.settings.up.count};
        for (const auto& [row, r] : m_rows) {
            m_file = r.file;
            const auto expected = shortestDigits(axis.at(row - 1)).toStdString();
            if (r.angle != expected)
                return otherSettings(Angle, r.angle, expected, row, m_rows.begin()->second.file);
        }
        return true;
    }

    StrikeMap assembled() {
        m_map.settings.rowCount = m_map.settings.up.count;
        m_map.stride = 1;
        for (auto& [row, r] : m_rows)
            m_map.cells.insert(m_map.cells.end(), r.cells.begin(), r.cells.end());
        return std::move(m_map);
    }

    bool number(Column c, const Fields& fields, double& out) {
        const QByteArray& text = fields[c];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
        if (error == std::errc() && end == text.data() + text.size() && std::isfinite(out))
            return true;
        return fail({.fault = MapFileFault::NotANumber,
                     .column = names[std::size_t(c)],
                     .text = text.left(40).toStdString()});
    }

    bool wrongValue(Column c, const Fields& fields, std::string expected) {
        return fail({.fault = MapFileFault::WrongValue,
                     .column = names[std::size_t(c)],
                     .text = fields[c].left(40).toStdString(),
                     .expected = std::move(expected)});
    }

    bool otherSettings(Column c, std::string text, std::string expected, int row, std::string other) {
        return fail({.fault = MapFileFault::OtherSettings,
                     .column = names[std::size_t(c)],
                     .text = std::move(text),
                     .expected = std::move(expected),
                     .other = std::move(other),
                     .row = row});
    }

    bool fail(MapFileError error) {
        m_error = std::move(error);
        m_error.file = m_file;
        m_error.line = m_line;
        return false;
    }

    std::string m_file;
    int m_line = 0;
    std::vector<int> m_begun; // rows, in this file
    Fields m_settings;        // the first line
    std::string m_settingsFile;
    std::map<int, ReadRow> m_rows;
    StrikeMap m_map;
    MapFileError m_error;
};

} // namespace

std::variant<StrikeMap, MapFileError> mergeMaps(std::span<const MapFile> parts) {
    return Merger().merge(parts);
}

} // namespace thetalane

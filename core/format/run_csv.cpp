#include "core/format/json_text.h"
#include "core/format/run_file.h"
#include "core/format/run_names.h"

#include <QList>

#include <cmath>

namespace thetalane {
namespace {

// RFC 4180: a cell with a comma, a quote or a line break goes in quotes, its own quotes doubled.
QByteArray textCell(const std::string& text) {
    QByteArray cell = QByteArray::fromStdString(text);
    if (cell.contains(',') || cell.contains('"') || cell.contains('\n') || cell.contains('\r'))
        cell = '"' + cell.replace('"', "\"\"") + '"';
    return cell;
}

QByteArray numberCell(double value) {
    return std::isfinite(value) ? shortestDigits(value) : QByteArray();
}

void addPair(QList<QByteArray>& row, const VelocityPair<double>& v, bool wall) {
    row << numberCell(v.first.x) << numberCell(v.first.y);
    row << (wall ? QByteArray() : numberCell(v.second.x)) << (wall ? QByteArray() : numberCell(v.second.y));
}

QByteArray header() {
    QList<QByteArray> names{"number",    "time",      "first",     "second",      "group",      "restitution",
                            "contact.a", "contact.b", "contact.Z", "contact.cos", "contact.sin"};
    for (const char* stage : {"before", "rotated", "exchanged", "after"})
        for (const char* part : {".first.x", ".first.y", ".second.x", ".second.y"})
            names << QByteArray(stage) + part;
    return (names << "impulse"
                  << "energy_loss"
                  << "pass"
                  << "together")
               .join(',') +
           "\n";
}

QByteArray rowOf(const Run& run, const Collision& c, std::size_t number) {
    const PairCollision<double>& s = c.steps;
    QList<QByteArray> row{QByteArray::number(qulonglong(number)),
                          numberCell(c.time),
                          textCell(run.scene.bodies[std::size_t(c.first)].id),
                          textCell(secondName(run.scene, c)),
                          c.group > 0 ? QByteArray::number(c.group) : QByteArray(),
                          numberCell(s.restitution)};
    for (const double value : {s.contact.a, s.contact.b, s.contact.Z, s.contact.cosTheta, s.contact.sinTheta})
        row << numberCell(value);
    for (const auto* stage : {&s.before, &s.rotated, &s.exchanged, &s.after})
        addPair(row, *stage, c.isWall());
    row << numberCell(s.impulse) << numberCell(s.energyLoss);
    for (const int n : {c.pass, c.together})
        row << (c.group > 0 ? QByteArray::number(n) : QByteArray());
    return row.join(',') + "\n";
}

} // namespace

bool writeRunCsv(const Run& run, QIODevice& out) {
    const auto write = [&out](const QByteArray& line) { return out.write(line) == line.size(); };
    bool good = write(header());
    const auto collisions = run.timeline.collisions();
    for (std::size_t i = 0; i < collisions.size() && good; ++i)
        good = write(rowOf(run, collisions[i], i + 1));
    return good;
}

} // namespace thetalane

#include "core/format/json_text.h"
#include "core/format/run_file.h"
#include "core/format/run_names.h"

#include <QJsonDocument>

namespace thetalane {
namespace {

// Writes in pieces, and remembers a piece that did not go through.
class Output {
public:
    explicit Output(QIODevice& device)
        : m_device(device) {}

    Output& operator<<(const QByteArray& piece) {
        m_good = m_good && m_device.write(piece) == piece.size();
        return *this;
    }
    bool good() const { return m_good; }

private:
    QIODevice& m_device;
    bool m_good = true;
};

QByteArray quoted(const char* word) {
    return '"' + QByteArray(word) + '"';
}

QByteArray contactText(const Contact<double>& c) {
    return "{\"a\": " + jsonNumber(c.a) + ", \"b\": " + jsonNumber(c.b) + ", \"Z\": " + jsonNumber(c.Z) +
           ", \"cos\": " + jsonNumber(c.cosTheta) + ", \"sin\": " + jsonNumber(c.sinTheta) + '}';
}

QByteArray velocities(const VelocityPair<double>& v, bool wall) {
    const QByteArray second = wall ? QByteArray() : ", \"second\": " + jsonPair(v.second);
    return "{\"first\": " + jsonPair(v.first) + second + '}';
}

QByteArray collisionText(const Run& run, const Collision& c, std::size_t number) {
    const PairCollision<double>& s = c.steps;
    const bool wall = c.isWall();
    QByteArray text = "{\"number\": " + QByteArray::number(qulonglong(number)) +
                      ", \"time\": " + jsonNumber(c.time) +
                      ", \"first\": " + jsonString(run.scene.bodies[std::size_t(c.first)].id) +
                      ", \"second\": " + jsonString(secondName(run.scene, c));
    if (c.group > 0)
        text += ", \"group\": " + QByteArray::number(c.group);
    text += ", \"restitution\": " + jsonNumber(s.restitution) +
            ",\n     \"contact\": " + contactText(s.contact) +
            ",\n     \"before\": " + velocities(s.before, wall) +
            ", \"rotated\": " + velocities(s.rotated, wall) +
            ",\n     \"exchanged\": " + velocities(s.exchanged, wall) +
            ", \"after\": " + velocities(s.after, wall) + ",\n     \"impulse\": " + jsonNumber(s.impulse) +
            ", \"energy_loss\": " + jsonNumber(s.energyLoss) + '}';
    return text;
}

void writeHead(const Run& run, Output& out) {
    const EngineSettings& s = run.settings;
    const bool stepped = s.kind == EngineKind::Stepped;
    out << "{\n  \"format\": \"thetalane-run\", \"version\": 1, \"engine\": " + quoted(fileName(s.kind)) +
               ", \"precision\": " + quoted(fileName(s.precision)) +
               ", \"step\": " + (stepped ? jsonNumber(s.step) : QByteArray("null")) +
               (stepped && s.approachingOnly ? ", \"approaching_only\": true" : "") +
               ", \"until\": " + jsonNumber(s.until) +
               ",\n  \"collision_count\": " + QByteArray::number(qlonglong(run.timeline.collisionCount()));
}

void writeCollisions(const Run& run, Output& out) {
    const auto collisions = run.timeline.collisions();
    out << ",\n  \"collisions\": [";
    for (std::size_t i = 0; i < collisions.size() && out.good(); ++i)
        out << (i == 0 ? "\n    " : ",\n    ") + collisionText(run, collisions[i], i + 1);
    out << (collisions.empty() ? "]" : "\n  ]");
}

void writeDepartures(const Run& run, Output& out) {
    out << ",\n  \"departures\": [";
    bool first = true;
    for (const Departure& d : run.timeline.departures()) {
        out << (first ? "\n    " : ",\n    ") + QByteArray("{\"time\": ") + jsonNumber(d.time) +
                   ", \"body\": " + jsonString(run.scene.bodies[std::size_t(d.body)].id) +
                   ", \"place\": " + quoted(fileName(d.place)) + '}';
        first = false;
    }
    out << (first ? "]" : "\n  ]");
}

void writeEnd(const Run& run, std::span<const BodyState> states, Output& out) {
    out << ",\n  \"end\": {\"time\": " + jsonNumber(run.timeline.endTime()) +
               ", \"reason\": " + quoted(fileName(run.timeline.endReason())) + ",\n    \"bodies\": [";
    for (std::size_t i = 0; i < states.size() && out.good(); ++i)
        out << (i == 0 ? "\n      " : ",\n      ") + QByteArray("{\"id\": ") +
                   jsonString(run.scene.bodies[i].id) + ", \"position\": " + jsonPair(states[i].position) +
                   ", \"velocity\": " + jsonPair(states[i].velocity) + '}';
    out << "\n    ]}";
}

QByteArray totalsText(const Totals& t) {
    return "{\"momentum\": " + jsonPair(t.momentum) + ", \"energy\": " + jsonNumber(t.energy) + '}';
}

void writeExtra(const QJsonObject& extra, Output& out) {
    for (auto it = extra.begin(); it != extra.end(); ++it) {
        const QByteArray alone =
            QJsonDocument(QJsonObject{{it.key(), it.value()}}).toJson(QJsonDocument::Compact);
        out << ",\n  " + alone.mid(1, alone.size() - 2);
    }
}

} // namespace

Totals startTotals(const Run& run) {
    std::vector<BodyState> states;
    states.reserve(run.scene.bodies.size());
    for (const Body& b : run.scene.bodies)
        states.push_back({b.position, b.velocity});
    return totals(run.scene, states);
}

bool writeRunJson(const Run& run, QIODevice& device, const QJsonObject& extra) {
    Output out(device);
    const auto end = run.timeline.stateAt(run.timeline.endTime());
    writeHead(run, out);
    if (run.settings.keepDetail) {
        writeCollisions(run, out);
        if (run.scene.lane)
            writeDepartures(run, out);
    }
    writeEnd(run, end, out);
    out << ",\n  \"totals\": {\"start\": " + totalsText(startTotals(run)) +
               ", \"end\": " + totalsText(totals(run.scene, end)) + '}';
    writeExtra(extra, out);
    out << "\n}\n";
    return out.good();
}

} // namespace thetalane

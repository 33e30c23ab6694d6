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
        text += ", \"group\": " + QByteArray::number(c.group) + ", \"pass\": " + QByteArray::number(c.pass) +
                ", \"together\": " + QByteArray::number(c.together);
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
    const bool event = s.kind == EngineKind::Event, stepped = s.kind == EngineKind::Stepped;
    out << "{\n  \"format\": \"thetalane-run\", \"version\": 1, \"engine\": " + quoted(fileName(s.kind)) +
               ", \"precision\": " + quoted(fileName(s.precision)) +
               ", \"step\": " + (event ? QByteArray("null") : jsonNumber(s.step)) +
               (stepped && s.approachingOnly ? ", \"approaching_only\": true" : "") +
               (s.kind == EngineKind::Swept ? ", \"passes\": " + QByteArray::number(s.passes) : "") +
               (event && !s.ties ? ", \"one_at_a_time\": true" : "") + ", \"until\": " + jsonNumber(s.until);
    if (run.scene.friction && event)
        out << ", \"contact_time\": " + jsonNumber(s.contactTime);
    out << ",\n  \"collision_count\": " + QByteArray::number(qlonglong(run.timeline.collisionCount()));
}

// One item a line.
template <class Items, class ToText>
void writeList(const char* key, const Items& items, Output& out, ToText&& toText) {
    out << ",\n  " + quoted(key) + ": [";
    for (std::size_t i = 0; i < items.size() && out.good(); ++i)
        out << (i == 0 ? "\n    " : ",\n    ") + toText(items[i], i);
    out << (items.empty() ? "]" : "\n  ]");
}

QByteArray departureText(const Run& run, const Departure& d) {
    return "{\"time\": " + jsonNumber(d.time) +
           ", \"body\": " + jsonString(run.scene.bodies[std::size_t(d.body)].id) +
           ", \"place\": " + quoted(fileName(d.place)) + '}';
}

QByteArray lastingText(const Run& run, const LastingContact& c) {
    return "{\"from\": " + jsonNumber(c.from) + ", \"to\": " + jsonNumber(c.to) +
           ", \"first\": " + jsonString(run.scene.bodies[std::size_t(c.first)].id) +
           ", \"second\": " + jsonString(secondName(run.scene, c)) + '}';
}

void writeDetail(const Run& run, Output& out) {
    writeList("collisions", run.timeline.collisions(), out,
              [&run](const Collision& c, std::size_t i) { return collisionText(run, c, i + 1); });
    if (run.scene.friction)
        writeList("lasting", run.timeline.lastingContacts(), out,
                  [&run](const LastingContact& c, std::size_t) { return lastingText(run, c); });
    if (run.scene.lane)
        writeList("departures", run.timeline.departures(), out,
                  [&run](const Departure& d, std::size_t) { return departureText(run, d); });
}

QByteArray bodyText(const Scene& scene, std::size_t i, const BodyState& state) {
    QByteArray text = "{\"id\": " + jsonString(scene.bodies[i].id) +
                      ", \"position\": " + jsonPair(state.position) +
                      ", \"velocity\": " + jsonPair(state.velocity);
    if (scene.friction)
        text += ", \"spin\": " + jsonTriple(state.spin) + ", \"phase\": " + quoted(fileName(state.phase));
    return text + '}';
}

void writeEnd(const Run& run, std::span<const BodyState> states, Output& out) {
    out << ",\n  \"end\": {\"time\": " + jsonNumber(run.timeline.endTime()) +
               ", \"reason\": " + quoted(fileName(run.timeline.endReason())) + ",\n    \"bodies\": [";
    for (std::size_t i = 0; i < states.size() && out.good(); ++i)
        out << (i == 0 ? "\n      " : ",\n      ") + bodyText(run.scene, i, states[i]);
    out << "\n    ]}";
}

QByteArray totalsText(const Scene& scene, std::span<const BodyState> states) {
    const Totals t = totals(scene, states);
    QByteArray text = "{\"momentum\": " + jsonPair(t.momentum) + ", \"energy\": " + jsonNumber(t.energy);
    if (scene.friction)
        text += ", \"rotational_energy\": " + jsonNumber(rotationalEnergy(scene, states));
    return text + '}';
}

void writeExtra(const QJsonObject& extra, Output& out) {
    for (auto it = extra.begin(); it != extra.end(); ++it) {
        const QByteArray alone =
            QJsonDocument(QJsonObject{{it.key(), it.value()}}).toJson(QJsonDocument::Compact);
        out << ",\n  " + alone.mid(1, alone.size() - 2);
    }
}

} // namespace

std::vector<BodyState> startStates(const Run& run) {
    std::vector<BodyState> states;
    states.reserve(run.scene.bodies.size());
    for (const Body& b : run.scene.bodies)
        states.push_back({b.position, b.velocity, Place::Play, b.spin});
    return states;
}

double rotationalEnergy(const Scene& scene, std::span<const BodyState> states) {
    double sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Body& b = scene.bodies[i];
        const Spin<double>& w = states[i].spin;
        if (b.kind == BodyKind::Ball)
            sum += b.inertia * b.mass * b.radius * b.radius * (w.x * w.x + w.y * w.y + w.z * w.z) / 2;
    }
    return sum;
}

bool writeRunJson(const Run& run, QIODevice& device, const QJsonObject& extra) {
    Output out(device);
    const auto end = run.timeline.stateAt(run.timeline.endTime());
    writeHead(run, out);
    if (run.settings.keepDetail)
        writeDetail(run, out);
    writeEnd(run, end, out);
    out << ",\n  \"totals\": {\"start\": " + totalsText(run.scene, startStates(run)) +
               ", \"end\": " + totalsText(run.scene, end) + '}';
    writeExtra(extra, out);
    out << "\n}\n";
    return out.good();
}

} // namespace thetalane

#include "core/timeline/recorder.h"

#include <cmath>

namespace thetalane {

Recorder::Recorder(std::size_t bodyCount, bool keepDetail)
    : m_bodyCount(bodyCount)
    , m_keepDetail(keepDetail) {
    m_record.struckSpeeds.assign(bodyCount, 0);
    m_record.segments.reserve(keepDetail ? 4 * bodyCount + 24 : bodyCount);
    m_record.collisions.reserve(keepDetail ? 16 : 0);
}

void Recorder::segment(int body, const Segment& segment) {
    if (m_keepDetail || m_record.segments.size() < m_bodyCount)
        m_record.segments.push_back({body, segment});
    else
        m_record.segments[std::size_t(body)].segment =
            segment; // the first ones came in the order of the bodies
}

void Recorder::segment(int body, const Segment& s, const Rotation& rotation) {
    if (m_keepDetail || m_record.rotations.size() < m_bodyCount)
        m_record.rotations.push_back(rotation);
    else
        m_record.rotations[std::size_t(body)] = rotation;
    segment(body, s);
}

void Recorder::lasting(const LastingContact& contact) {
    if (m_keepDetail)
        m_record.lasting.push_back(contact);
}

void Recorder::departure(const Departure& departure) {
    if (m_keepDetail)
        m_record.departures.push_back(departure);
}

Timeline Recorder::finish(double endTime, EndReason reason) {
    for (double& speed : m_record.struckSpeeds)
        speed = std::sqrt(speed);
    m_record.endTime = endTime;
    m_record.endReason = reason;
    return Timeline(m_bodyCount, std::move(m_record));
}

} // namespace thetalane

#include "ui/game/frame_draft.h"

namespace thetalane {

FrameDraft::FrameDraft(ScoringRules rules, int frame, std::vector<Delivery> deliveries)
    : m_rules(rules)
    , m_frame(frame)
    , m_deliveries(std::move(deliveries)) {}

// A frame is judged alone: as the first one, or the tenth after nine strikes.
Scorecard FrameDraft::cardBefore(int ball) const {
    Scorecard card(m_rules);
    for (int k = 1; isLong() && k < framesOfAGame; ++k)
        card.add({.pins = pinsOfARack});
    for (int k = 0; k < ball && k < int(m_deliveries.size()); ++k)
        card.add(m_deliveries[std::size_t(k)]);
    return card;
}

std::optional<Turn> FrameDraft::turn(int ball) const {
    if (ball > int(m_deliveries.size()))
        return std::nullopt;
    auto turn = cardBefore(ball).next();
    const int frame = isLong() ? framesOfAGame : 1;
    return turn && turn->frame == frame ? turn : std::nullopt;
}

bool FrameDraft::isWhole() const {
    return !m_deliveries.empty() && !turn(int(m_deliveries.size()));
}

QString FrameDraft::text() const {
    if (m_deliveries.empty())
        return {};
    const Scorecard card = cardBefore(int(m_deliveries.size()));
    return QString::fromStdString(rollsText(card, isLong() ? framesOfAGame - 1 : 0));
}

std::optional<RollError> FrameDraft::setText(const QString& typed) {
    QString text = typed.trimmed().toUpper();
    text.replace(QChar(0x2212), u'-').replace(QChar(0x2013), u'-');
    const QString before = isLong() ? QStringLiteral("X X X X X X X X X ") : QString();
    auto read = readRolls((before + text).toStdString(), m_rules);
    if (auto* error = std::get_if<RollError>(&read))
        return std::move(*error);
    const Scorecard& card = std::get<Scorecard>(read);
    const std::size_t frame = isLong() ? framesOfAGame - 1 : 0;
    if (card.frames().size() > frame + 1)
        return RollError{.fault = RollFault::FrameIsOver};
    std::vector<Delivery> deliveries;
    for (std::size_t k = isLong() ? framesOfAGame - 1 : 0; k < card.deliveries().size(); ++k) {
        Delivery d = card.deliveries()[k].delivery;
        const std::size_t own = deliveries.size();
        if (own < m_deliveries.size() && m_deliveries[own].pins == d.pins && m_deliveries[own].foul == d.foul)
            d.down = m_deliveries[own].down;
        deliveries.push_back(d);
    }
    m_deliveries.swap(deliveries);
    // The pins of a ball before may have changed its count, and those of this one may lie already.
    for (std::size_t k = 0; k < m_deliveries.size(); ++k)
        if (cardBefore(int(k)).errorOf(m_deliveries[k]))
            m_deliveries[k].down.reset();
    return std::nullopt;
}

void FrameDraft::togglePin(int ball, int pin) {
    const auto met = turn(ball);
    if (!met || !met->pins || !(*met->pins)[std::size_t(pin)])
        return;
    if (ball == int(m_deliveries.size()))
        m_deliveries.push_back({.pins = 0, .down = PinSet{}});
    Delivery& d = m_deliveries[std::size_t(ball)];
    PinSet down = d.down.value_or(PinSet{});
    down.flip(std::size_t(pin));
    d = {.pins = int(down.count()), .down = down, .foul = d.foul};
    std::size_t fitting = std::size_t(ball) + 1;
    while (fitting < m_deliveries.size() && turn(int(fitting)) &&
           !cardBefore(int(fitting)).errorOf(m_deliveries[fitting]))
        ++fitting;
    m_deliveries.resize(fitting);
}

} // namespace thetalane

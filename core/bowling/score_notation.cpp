#include "core/bowling/score_notation.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace thetalane {
namespace {

constexpr std::string_view spaces = " \t\r\n\v\f";

// The symbol at the beginning: one character of UTF-8.
std::string firstSymbol(std::string_view text) {
    std::size_t length = 1;
    while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
        ++length;
    return std::string(text.substr(0, length));
}

using Roll = std::variant<Delivery, RollError>;

Roll digit(int pins, const Turn& turn, int before) {
    const std::string text = std::to_string(pins);
    if (pins > turn.standing)
        return RollError{RollFault::MorePins, turn.frame, text, turn.standing};
    if (pins == turn.standing)
        return RollError{RollFault::SpareAsDigits, turn.frame, text, turn.standing, before};
    return Delivery{.pins = pins};
}

// before: the pins of the delivery before.
Roll readRoll(std::string_view rest, const Turn& turn, int before) {
    const char c = rest[0];
    const auto fault = [&](RollFault f) {
        return RollError{f, turn.frame, firstSymbol(rest), turn.standing};
    };
    if (c >= '1' && c <= '9')
        return digit(c - '0', turn, before);
    switch (c) {
    case '-':
        return Delivery{};
    case 'F':
    case 'f':
        return Delivery{.foul = true};
    case 'X':
    case 'x':
        if (!turn.firstOnRack)
            return fault(RollFault::StrikeNotFirst);
        return Delivery{.pins = pinsOfARack};
    case '/':
        if (turn.firstOnRack)
            return fault(RollFault::SpareFirst);
        return Delivery{.pins = turn.standing};
    case '0':
        return fault(RollFault::Zero);
    default:
        return fault(RollFault::UnknownSymbol);
    }
}

bool onlyStrikes(std::string_view word) {
    return word.find_first_not_of("Xx") == std::string_view::npos;
}

// In the tenth frame of the traditional rules, rolls may be spaced.
bool maySpace(const Scorecard& card, const Turn& turn) {
    return turn.frame == framesOfAGame && card.rules() == ScoringRules::Traditional;
}

// What stands between two spaces.
std::optional<RollError> readWord(std::string_view word, Scorecard& card) {
    int frame = 0; // of the roll before, in this word
    for (std::size_t k = 0; k < word.size(); ++k) {
        const auto turn = card.next();
        if (!turn)
            return RollError{RollFault::GameOver, framesOfAGame, firstSymbol(word.substr(k))};
        if (frame != 0 && turn->frame != frame && !onlyStrikes(word))
            return RollError{RollFault::FrameIsOver, frame, std::string(word)};
        frame = turn->frame;
        const int before = card.deliveries().empty() ? 0 : card.deliveries().back().delivery.pins;
        const Roll roll = readRoll(word.substr(k), *turn, before);
        if (const auto* error = std::get_if<RollError>(&roll))
            return *error;
        card.add(std::get<Delivery>(roll));
    }
    return std::nullopt;
}

} // namespace

std::variant<Scorecard, RollError> readRolls(std::string_view text, ScoringRules rules) {
    Scorecard card(rules);
    for (std::size_t at = text.find_first_not_of(spaces); at != std::string_view::npos;) {
        if (const auto turn = card.next(); turn && turn->ball > 1 && !maySpace(card, *turn))
            return RollError{RollFault::FrameGoesOn, turn->frame, rollsText(card, card.frames().size() - 1),
                             turn->standing};
        const std::size_t end = std::min(text.find_first_of(spaces, at), text.size());
        if (const auto error = readWord(text.substr(at, end - at), card))
            return *error;
        at = text.find_first_not_of(spaces, end);
    }
    return card;
}

char symbolOf(const ScoredDelivery& d) {
    if (d.delivery.foul)
        return 'F';
    if (d.strike || d.spare)
        return d.strike ? 'X' : '/';
    return d.delivery.pins == 0 ? '-' : char('0' + d.delivery.pins);
}

std::string rollsText(const Scorecard& card, std::size_t frame) {
    const FrameScore& f = card.frames()[frame];
    std::string text;
    for (const ScoredDelivery& d : card.deliveries().subspan(std::size_t(f.first), std::size_t(f.count)))
        text += symbolOf(d);
    return text;
}

} // namespace thetalane

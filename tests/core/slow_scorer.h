// Ten-pin scoring the slow way: rolls as plain numbers, every frame looked at on its own. Written beside the
// scorecard, sharing nothing with it.
#pragma once

#include <optional>
#include <vector>

namespace slow {

constexpr int foul = -1; // a roll that counts nothing and has its pins set up again

inline int points(int roll) {
    return roll == foul ? 0 : roll;
}

struct Game {
    bool legal = true; // otherwise the rest says nothing
    bool over = false;
    std::vector<std::optional<int>> totals; // of the frames begun
};

// The rolls from `at` on, taken as one frame: how many it has, or 0 while it is unfinished, -1 when illegal.
inline int ordinaryFrame(const std::vector<int>& rolls, std::size_t at) {
    const int first = rolls[at];
    if (first == 10)
        return 1;
    if (at + 1 >= rolls.size())
        return 0;
    const int second = rolls[at + 1];
    if (first != foul && points(first) + points(second) > 10)
        return -1;
    return 2;
}

// Pins that may stand before the ball `k` (0, 1, 2) of a tenth frame.
inline int standingInTenth(const std::vector<int>& tenth, std::size_t k) {
    int standing = 10;
    for (std::size_t i = 0; i < k; ++i) {
        if (tenth[i] == foul) {
            standing = 10;
            continue;
        }
        standing -= tenth[i];
        if (standing == 0)
            standing = 10;
    }
    return standing;
}

inline int tenthFrame(const std::vector<int>& rolls, std::size_t at) {
    std::vector<int> tenth(rolls.begin() + long(at), rolls.end());
    const bool strike = tenth[0] == 10;
    const bool spare = !strike && tenth.size() > 1 && points(tenth[0]) + points(tenth[1]) == 10;
    const std::size_t wanted = strike || spare ? 3 : 2;
    for (std::size_t k = 0; k < tenth.size() && k < wanted; ++k)
        if (tenth[k] != foul && tenth[k] > standingInTenth(tenth, k))
            return -1;
    return tenth.size() < wanted ? 0 : int(wanted);
}

inline Game score(const std::vector<int>& rolls, bool currentFrame) {
    Game game;
    for (const int roll : rolls)
        if (roll != foul && (roll < 0 || roll > 10))
            return {false, false, {}};
    std::size_t at = 0;
    std::optional<int> total = 0;
    for (int frame = 1; frame <= 10; ++frame) {
        if (at >= rolls.size())
            return game;
        const bool tenth = frame == 10 && !currentFrame;
        const int count = tenth ? tenthFrame(rolls, at) : ordinaryFrame(rolls, at);
        if (count < 0)
            return {false, false, {}};
        if (count == 0) {
            game.totals.push_back({});
            return game;
        }
        int sum = 0;
        for (int k = 0; k < count; ++k)
            sum += points(rolls[at + std::size_t(k)]);
        const bool strike = rolls[at] == 10, spare = !strike && !tenth && sum == 10;
        std::optional<int> own = sum;
        if (currentFrame && strike)
            own = 30;
        else if (currentFrame && spare)
            own = 10 + points(rolls[at]);
        else if (!tenth && (strike || spare)) {
            const std::size_t bonus = strike ? 2 : 1, from = at + std::size_t(count);
            if (from + bonus > rolls.size())
                own.reset();
            for (std::size_t k = 0; own && k < bonus; ++k)
                own = *own + points(rolls[from + k]);
        }
        if (total && own)
            total = *total + *own;
        else
            total.reset();
        game.totals.push_back(total);
        at += std::size_t(count);
    }
    game.over = true;
    game.legal = at == rolls.size();
    return game;
}

} // namespace slow

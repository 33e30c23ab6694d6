// Speed against accuracy: every method on every case, held against the next-event engine with 113 bits.
//
// Costs are processor time, measured on one thread while nothing else of the study runs, the methods in turn,
// so that what slows the machine slows all alike. Errors are measured afterwards on all threads.
#pragma once

#include "core/study/method.h"
#include "core/study/study_cases.h"

#include <array>
#include <functional>
#include <stop_token>
#include <vector>

namespace thetalane {

// Positions are compared at (k + 1)/8 of the time studied, k = 0 to 7.
inline constexpr std::size_t studyTimes = 8;

struct Quartiles {
    double lower = 0;
    double median = 0;
    double upper = 0;
};

// Of one case and time: the rms over the bodies of the distance from where they should be. Over the cases:
struct PositionError {
    double median = 0; // m
    double rms = 0;    // m
    double worst = 0;  // m
};

enum class MethodState {
    Measured,
    Waiting, // the study was cancelled, or has not come so far
    Refused, // MethodResult::refusal says why
    TooSlow, // one run would take longer than StudyOptions::patience; the cost is extrapolated
};

struct MethodResult {
    Method method;
    MethodState state = MethodState::Waiting;
    Refusal refusal{};
    std::size_t cases = 0; // whose errors are in here; without any the errors say nothing
    int costRounds = 0;    // of the costs; none: they say nothing

    double sameTouched = 0; // part of the cases, 0 to 1: the same set of pins (without pins: bodies) touched
    double sameDown = 0;    // the same pins down
    double sameOrder = 0;   // the same contacts in the same order
    // Of the cases whose contacts differ: which is the first that does, from 0, and its time in the
    // reference.
    Quartiles firstDifference{};
    Quartiles differenceTime{};                     // s
    std::array<PositionError, studyTimes> errors{}; // the last one: at the end of the time studied
    double energyDrift = 0;   // median of |E - E_ref|/E_start at the end, of translation alone
    double momentumDrift = 0; // median of |P - P_ref|/Σ|p|_start at the end
    double missed = 0;        // a case: contacts of the reference that do not happen
    double repeated = 0;      // a case: contacts of two that already met, and since then met nobody else
    double collisions = 0;    // a case
    // Of how many collisions digitsLeft() says something, and of what part it is within one digit of the
    // truth.
    std::int64_t digitsAsked = 0;
    double digitsRight = 0;

    Quartiles cost{};            // of a case [µs], over the rounds
    double costPerSecond = 0;    // simulated [µs]
    double costPerCollision = 0; // [µs]; 0 where nothing collides
    double costRatio = 0;        // to the first method, median of the rounds

    const PositionError& error() const { return errors.back(); }
};

struct StudyResult {
    std::vector<MethodResult> methods; // in the order asked for
    double until = 0;                  // [s]; less than asked where the truth would take too long
    double untilAsked = 0;
    Method truth; // the reference in double for crowds for which 113 bits are too dear
    // The least over the cases, at the last collision; infinite where it is not known.
    double truthDigits = 0;
    std::size_t cases = 0; // done, with every method
    std::size_t casesAsked = 0;
    bool cancelled = false;
};

struct StudyOptions {
    std::vector<Method> methods = studyMethods(MethodSet::Standard);
    Method truth = referenceMethod(); // what errors are measured against
    int threads = 0;                  // 0: as many as the machine has
    int costRounds = 9;               // 0: costs are not measured
    double patience = 5;              // for one run, also of the reference [s]
};

// What each model of the scene costs, and what changes without it: truth is the first method, with all
// models.
StudyOptions ablationStudy(const Scene& scene);

enum class StudyStage { Truth, Cost, Errors }; // Truth: how far it gets with patience
struct StudyProgress {
    StudyStage stage{};
    std::size_t done = 0; // of this stage
    std::size_t total = 0;
};

// Called on the thread that runs the study, some ten times a second, with what is known so far; for the first
// time when every method has one round of costs and the first cases.
using StudyReport = std::function<void(const StudyResult&, const StudyProgress&)>;

// Returns what it has when `stop` is requested, labelled; one run is not interrupted.
StudyResult runStudy(const StudyCases& cases, const StudyOptions& options, const StudyReport& report = {},
                     std::stop_token stop = {});

} // namespace thetalane

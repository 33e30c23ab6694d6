#include "app/study_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace thetalane {
namespace {

struct Words {
    const char* name; // in the CSV
    const char* title;
};

// In the order of the enumerations.
constexpr Words rowWords[] = {
    {"mass-ratio", QT_TRANSLATE_NOOP("StudyWords", "Mass ratios")},
    {"radius-ratio", QT_TRANSLATE_NOOP("StudyWords", "Radius ratios")},
    {"speed", QT_TRANSLATE_NOOP("StudyWords", "Speeds")},
    {"coordinates", QT_TRANSLATE_NOOP("StudyWords", "Coordinates")},
    {"restitution", QT_TRANSLATE_NOOP("StudyWords", "Restitution")},
    {"coincident", QT_TRANSLATE_NOOP("StudyWords", "Coincident centres")},
    {"grazing", QT_TRANSLATE_NOOP("StudyWords", "Grazing")},
    {"long-run", QT_TRANSLATE_NOOP("StudyWords", "Many collisions")},
    {"pi", QT_TRANSLATE_NOOP("StudyWords", "Counting π")},
    {"time-reversal", QT_TRANSLATE_NOOP("StudyWords", "Time reversal")},
    {"collapse", QT_TRANSLATE_NOOP("StudyWords", "Inelastic collapse")},
    {"lasting-contact", QT_TRANSLATE_NOOP("StudyWords", "Lasting contact")},
    {"contact-time", QT_TRANSLATE_NOOP("StudyWords", "Cost of lasting contact")},
    {"mirror", QT_TRANSLATE_NOOP("StudyWords", "Mirror symmetry")},
};
static_assert(std::size(rowWords) == std::size_t(ExtremeRow::Mirror) + 1);

constexpr Words caseWords[] = {
    {"head-on", QT_TRANSLATE_NOOP("StudyWords", "head-on, masses %1 : 1")},
    {"glancing", QT_TRANSLATE_NOOP("StudyWords", "glancing, masses %1 : 1")},
    {"radii", QT_TRANSLATE_NOOP("StudyWords", "radii %1 : 1")},
    {"speed", QT_TRANSLATE_NOOP("StudyWords", "%1 m/s")},
    {"offset", QT_TRANSLATE_NOOP("StudyWords", "moved by %1 m")},
    {"scaled", QT_TRANSLATE_NOOP("StudyWords", "%1 times as large")},
    {"e", QT_TRANSLATE_NOOP("StudyWords", "e = %1")},
    {"same-place", QT_TRANSLATE_NOOP("StudyWords", "a scene with two at one place")},
    {"apart", QT_TRANSLATE_NOOP("StudyWords", "centres %1 m apart")},
    {"tiny-radii", QT_TRANSLATE_NOOP("StudyWords", "radii of %1 m")},
    {"inside", QT_TRANSLATE_NOOP("StudyWords", "%1 m inside")},
    {"inside-slanted", QT_TRANSLATE_NOOP("StudyWords", "%1 m inside, slanted")},
    {"outside", QT_TRANSLATE_NOOP("StudyWords", "%1 m outside")},
    {"outside-slanted", QT_TRANSLATE_NOOP("StudyWords", "%1 m outside, slanted")},
    {"gas", QT_TRANSLATE_NOOP("StudyWords", "gas in a box, %1 collisions")},
    {"open-crowd", QT_TRANSLATE_NOOP("StudyWords", "open crowd, %1 collisions")},
    {"masses", QT_TRANSLATE_NOOP("StudyWords", "masses 1 : %1")},
    {"there-and-back", QT_TRANSLATE_NOOP("StudyWords", "%1 collisions there and back")},
    {"three-in-a-line", QT_TRANSLATE_NOOP("StudyWords", "three in a line, e = %1")},
    {"chain-at-a-wall", QT_TRANSLATE_NOOP("StudyWords", "chain of %1 at a wall, e = 0")},
    {"ball-pushes-pin", QT_TRANSLATE_NOOP("StudyWords", "ball pushes pin, contact time %1 s")},
    {"pin-between-two", QT_TRANSLATE_NOOP("StudyWords", "pin between two, contact time %1 s")},
    {"ball-spun-at-a-wall", QT_TRANSLATE_NOOP("StudyWords", "ball spun at a wall, contact time %1 s")},
    {"rack-head-on", QT_TRANSLATE_NOOP("StudyWords", "ball straight at the rack, e = %1")},
    {"cue-on-two", QT_TRANSLATE_NOOP("StudyWords", "ball on two, e = %1")},
};
static_assert(std::size(caseWords) == std::size_t(ExtremeCase::CueOnTwo) + 1);

constexpr Words measureWords[] = {
    {"velocity", QT_TRANSLATE_NOOP("StudyWords", "speed after [m/s]")},
    {"contact-time", QT_TRANSLATE_NOOP("StudyWords", "time of contact [s]")},
    {"contact-time-in-path", QT_TRANSLATE_NOOP("StudyWords", "time of contact [s], error in path [m]")},
    {"normal-angle", QT_TRANSLATE_NOOP("StudyWords", "line of centres [rad]")},
    {"energy-after", QT_TRANSLATE_NOOP("StudyWords", "energy after [J]")},
    {"energy-loss", QT_TRANSLATE_NOOP("StudyWords", "energy loss [J]")},
    {"refused", QT_TRANSLATE_NOOP("StudyWords", "refused (1: yes)")},
    {"cos-theta", "cos θ"},
    {"meets", QT_TRANSLATE_NOOP("StudyWords", "they meet (1: yes)")},
    {"collisions", QT_TRANSLATE_NOOP("StudyWords", "collisions")},
    {"collisions-at-most", QT_TRANSLATE_NOOP("StudyWords", "collisions, at most")},
    {"stretches-at-most", QT_TRANSLATE_NOOP("StudyWords", "stretches of motion, at most")},
    {"energy-drift", QT_TRANSLATE_NOOP("StudyWords", "energy drift, relative")},
    {"momentum-drift", QT_TRANSLATE_NOOP("StudyWords", "momentum drift, relative")},
    {"way-from-start", QT_TRANSLATE_NOOP("StudyWords", "distance from the start [m]")},
    {"common-velocity", QT_TRANSLATE_NOOP("StudyWords", "common velocity [m/s]")},
    {"energy-rise", QT_TRANSLATE_NOOP("StudyWords", "largest rise of energy, relative")},
    {"overlap", QT_TRANSLATE_NOOP("StudyWords", "deepest overlap [m]")},
    {"end-position", QT_TRANSLATE_NOOP("StudyWords", "difference of end positions [m]")},
    {"asymmetry", QT_TRANSLATE_NOOP("StudyWords", "asymmetry [m, m/s]")},
};
static_assert(std::size(measureWords) == std::size_t(ExtremeMeasure::Asymmetry) + 1);

QString translated(const Words& words) {
    return QCoreApplication::translate("StudyWords", words.title);
}

QString shortest(double value) {
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

} // namespace

QString rowTitle(ExtremeRow row) {
    return translated(rowWords[int(row)]);
}

QString caseTitle(const ExtremeResult& result) {
    const QString title = translated(caseWords[int(result.kase)]);
    return title.contains("%1") ? title.arg(shortest(result.value)) : title;
}

QString measureTitle(ExtremeMeasure measure) {
    return translated(measureWords[int(measure)]);
}

QString extremesCsv(const std::vector<ExtremeResult>& results) {
    QString text = "row,case,asked,exact,got,error,bound,within\n";
    for (const ExtremeResult& r : results)
        text += QStringList{rowWords[int(r.row)].name,
                            QString(caseWords[int(r.kase)].name) + ' ' + shortest(r.value),
                            measureWords[int(r.asked)].name,
                            shortest(r.exact),
                            shortest(r.got),
                            shortest(r.error),
                            shortest(r.bound),
                            r.within() ? "yes" : "no"}
                    .join(',') +
                '\n';
    return text;
}

} // namespace thetalane

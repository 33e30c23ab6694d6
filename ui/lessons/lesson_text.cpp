#include "ui/lessons/lesson_text.h"

#include "ui/words/kept_units.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"
#include "ui/words/worked_steps.h"

#include <QCoreApplication>
#include <QLocale>

namespace thetalane {
namespace {

struct LessonText {
    Q_DECLARE_TR_FUNCTIONS(LessonText)
};

QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

QString listOf(const std::vector<std::string>& words) {
    QStringList list;
    for (const std::string& w : words)
        list << QStringLiteral("\"%1\"").arg(text(w));
    return list.join(QStringLiteral(", "));
}

QString unknownWordMessage(const LessonError& e) {
    if (!e.other.empty())
        return LessonText::tr("\"%1\" is not known; did you mean \"%2\"?").arg(text(e.text), text(e.other));
    return LessonText::tr("\"%1\" does not fit here; must be one of %2").arg(text(e.text), listOf(e.allowed));
}

QString placeMessage(const LessonError& e) {
    switch (e.fault) {
    case LessonFault::NoPlace:
        return LessonText::tr(
            "needs either \"at\" (\"start\", or seconds) or \"collision\" (a number from 1)");
    case LessonFault::NoSuchCollision:
        return e.high > 0 ? LessonText::tr("there is no collision %1; the last one is %2")
                                .arg(numberText(e.value), numberText(e.high))
                          : LessonText::tr("there is no collision %1; nothing collides in this scene")
                                .arg(numberText(e.value));
    case LessonFault::BeyondTheEnd:
        return LessonText::tr("must be at most %1 s, where the run ends, is %2")
            .arg(numberText(e.high), numberText(e.value));
    case LessonFault::NothingToMeasure:
        return LessonText::tr("has no answer here; add \"after\": the number of a collision after which the "
                              "body moves");
    default:
        return {};
    }
}

QString lessonErrorMessage(const LessonError& e) {
    switch (e.fault) {
    case LessonFault::Shape:
        return sceneErrorMessage(e.scene);
    case LessonFault::WrongFormat:
        return LessonText::tr("must be \"%1\", is \"%2\"")
            .arg(QStringLiteral("thetalane-lesson"), text(e.text));
    case LessonFault::WrongVersion:
        return LessonText::tr("must be 1, is %1").arg(numberText(e.value));
    case LessonFault::UnknownWord:
        return unknownWordMessage(e);
    case LessonFault::UnknownBody:
        return LessonText::tr("there is no body \"%1\"; there are %2").arg(text(e.text), listOf(e.allowed));
    case LessonFault::NotWhole:
        return LessonText::tr("must be a whole number, is %1").arg(numberText(e.value));
    case LessonFault::OutOfRange:
        return LessonText::tr("must be from %1 to %2, is %3")
            .arg(numberText(e.low), numberText(e.high), numberText(e.value));
    case LessonFault::NoWords:
        return LessonText::tr("must have a text in \"en\" or \"ko\"");
    case LessonFault::NoStops:
        return LessonText::tr("must hold at least one stop");
    case LessonFault::TooFewOptions:
        return LessonText::tr("must hold at least two options, holds %1").arg(numberText(e.value));
    case LessonFault::Refused:
        return refusalMessage(e.refusal);
    default:
        return placeMessage(e);
    }
}

QString bodyOf(const Scene& scene, int body) {
    return body < int(scene.bodies.size()) ? bodyName(scene, body) : QString();
}

} // namespace

QString inLanguageOfNow(const Title& title) {
    const bool korean = QLocale().language() == QLocale::Korean; // Language::use() sets it
    const std::string& wanted = korean ? title.ko : title.en;
    return text(!wanted.empty() ? wanted : korean ? title.en : title.ko);
}

QString quantityUnit(QuantityKind kind) {
    switch (kind) {
    case QuantityKind::Speed:
    case QuantityKind::Velocity:
        return QStringLiteral("m/s");
    case QuantityKind::Direction:
    case QuantityKind::AngleBetween:
    case QuantityKind::Theta:
        return QStringLiteral("°");
    case QuantityKind::EnergyLost:
        return QStringLiteral("J");
    case QuantityKind::MomentumSize:
    case QuantityKind::TotalMomentum:
        return QStringLiteral("kg·m/s");
    case QuantityKind::Collisions:
    case QuantityKind::PinsDown:
        break;
    }
    return {};
}

QString quantityName(const Scene& scene, const Quantity& q) {
    const QString body = bodyOf(scene, q.body), other = bodyOf(scene, q.other);
    switch (q.kind) {
    case QuantityKind::Speed:
        return LessonText::tr("Speed of %1").arg(body);
    case QuantityKind::Direction:
        return LessonText::tr("Direction of %1").arg(body);
    case QuantityKind::AngleBetween:
        return LessonText::tr("Angle between %1 and %2").arg(body, other);
    case QuantityKind::Theta:
        return LessonText::tr("Angle θ");
    case QuantityKind::EnergyLost:
        return LessonText::tr("Energy lost");
    case QuantityKind::MomentumSize:
    case QuantityKind::TotalMomentum:
        return LessonText::tr("Total momentum");
    case QuantityKind::Collisions:
        return LessonText::tr("Collisions");
    case QuantityKind::PinsDown:
        return LessonText::tr("Pins down");
    case QuantityKind::Velocity:
        return LessonText::tr("Velocity of %1").arg(body);
    }
    return {};
}

QString valueText(QuantityKind kind, const Vec2d& value) {
    const auto rounded = [](double v) { return numberText(std::abs(v) < 1e-9 ? 0 : v); }; // not 1.1·10⁻¹⁷
    const QString unit = quantityUnit(kind);
    if (isVector(kind))
        return QStringLiteral("(%1, %2) %3").arg(rounded(value.x), rounded(value.y), unit);
    if (isCount(kind))
        return numberText(value.x, 9);
    return unit == QStringLiteral("°") ? rounded(value.x) + unit : rounded(value.x) + u' ' + unit;
}

QString lessonErrorText(const LessonError& error) {
    const QString message = lessonErrorMessage(error);
    return error.path.empty() ? message : text(error.path) + QStringLiteral(": ") + message;
}

QString keptWords(QString words) {
    const auto isHangul = [](QChar c) { return c.unicode() >= 0xAC00 && c.unicode() <= 0xD7A3; };
    for (qsizetype i = words.size() - 1; i > 0; --i)
        if (isHangul(words[i]) && !words[i - 1].isSpace())
            words.insert(i, QChar(0x2060)); // a joiner without width
    return keptUnits(words);
}

} // namespace thetalane

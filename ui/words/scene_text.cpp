#include "ui/words/scene_text.h"

#include "core/format/scene_file.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

namespace thetalane {
namespace {

struct SceneText {
    Q_DECLARE_TR_FUNCTIONS(SceneText)
};

// What Qt's JSON reader and ours say, for the translators; it is looked up by its English text.
[[maybe_unused]] constexpr const char* readerReasons[] = {
    QT_TRANSLATE_NOOP("SceneText", "the file is empty"),
    QT_TRANSLATE_NOOP("SceneText", "a comma or a closing bracket is missing"),
    QT_TRANSLATE_NOOP("SceneText", "a number needs a digit on each side of its point"),
    QT_TRANSLATE_NOOP("SceneText", "a control character in a text must be escaped"),
    QT_TRANSLATE_NOOP("SceneText", "unterminated object"),
    QT_TRANSLATE_NOOP("SceneText", "missing name separator"),
    QT_TRANSLATE_NOOP("SceneText", "unterminated array"),
    QT_TRANSLATE_NOOP("SceneText", "missing value separator"),
    QT_TRANSLATE_NOOP("SceneText", "illegal value"),
    QT_TRANSLATE_NOOP("SceneText", "invalid termination by number"),
    QT_TRANSLATE_NOOP("SceneText", "illegal number"),
    QT_TRANSLATE_NOOP("SceneText", "invalid escape sequence"),
    QT_TRANSLATE_NOOP("SceneText", "invalid UTF8 string"),
    QT_TRANSLATE_NOOP("SceneText", "unterminated string"),
    QT_TRANSLATE_NOOP("SceneText", "object is missing after a comma"),
    QT_TRANSLATE_NOOP("SceneText", "too deeply nested document"),
    QT_TRANSLATE_NOOP("SceneText", "too large document"),
    QT_TRANSLATE_NOOP("SceneText", "garbage at the end of the document"),
};

QString digits(double value) {
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

// A depth is a difference: its last digits are rounding, and nobody moves a ball by them.
QString depthText(double metres) {
    return QString::number(metres, 'g', 6);
}

QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

QString sideNameOfKey(const std::string& key) {
    for (const Side side : sides) {
        static constexpr const char* keys[] = {"left", "right", "bottom", "top"};
        if (key == keys[int(side)])
            return sideName(side);
    }
    return text(key);
}

QString wrongTypeMessage(ExpectedType expected) {
    switch (expected) {
    case ExpectedType::Number:
        return SceneText::tr("must be a number");
    case ExpectedType::String:
        return SceneText::tr("must be a text in quotes");
    case ExpectedType::Object:
        return SceneText::tr("must be an object: {…}");
    case ExpectedType::Array:
        return SceneText::tr("must be a list: […]");
    case ExpectedType::Pair:
        return SceneText::tr("must be two numbers: [x, y]");
    case ExpectedType::Triple:
        return SceneText::tr("must be three numbers: [x, y, z]");
    case ExpectedType::BodyKind:
        return SceneText::tr("must be \"ball\" or \"pin\"");
    }
    return {};
}

QString notJsonMessage(const SceneError& error) {
    if (error.other == duplicateKeyReason)
        return SceneText::tr("is there twice; an object may have a key only once");
    const QString reason = QCoreApplication::translate("SceneText", error.other.c_str());
    return SceneText::tr("not valid JSON: %1").arg(reason);
}

// What is wrong with one value.
QString valueMessage(const SceneError& e) {
    switch (e.code) {
    case SceneErrorCode::NotFinite:
        return SceneText::tr("must be a finite number");
    case SceneErrorCode::NotPositive:
        return SceneText::tr("must be greater than 0, is %1").arg(digits(e.value));
    case SceneErrorCode::OutOfRange:
        return SceneText::tr("must be from %1 to %2, is %3")
            .arg(digits(e.low), digits(e.high), digits(e.value));
    case SceneErrorCode::OutOfOpenRange:
        return SceneText::tr("must be greater than %1 and at most %2, is %3")
            .arg(digits(e.low), digits(e.high), digits(e.value));
    case SceneErrorCode::EmptyId:
        return SceneText::tr("must not be empty");
    case SceneErrorCode::DuplicateId:
        return SceneText::tr("\"%1\" is taken by an earlier body; every id must be unique")
            .arg(text(e.other));
    case SceneErrorCode::ReservedId:
        return SceneText::tr("\"%1\" begins with \"%2\", which names the walls in a run; choose another id")
            .arg(text(e.other), text(std::string(wallPrefix)));
    case SceneErrorCode::NoBodies:
        return SceneText::tr("must hold at least one body");
    case SceneErrorCode::TooManyBodies:
        return SceneText::tr("must hold at most %1 bodies, holds %2").arg(digits(e.high), digits(e.value));
    default:
        return {};
    }
}

// What is wrong with where things are.
QString placeMessage(const SceneError& e) {
    switch (e.code) {
    case SceneErrorCode::Overlap:
        return SceneText::tr("%1 overlaps %2 by %3 m; move them at least that far apart")
            .arg(text(e.other), text(e.first), depthText(e.value));
    case SceneErrorCode::OverlapsWall:
        return SceneText::tr("%1 is %3 m beyond the %2; move it inside by at least that much")
            .arg(text(e.first), sideNameOfKey(e.other), depthText(e.value));
    case SceneErrorCode::OffTheLane:
        return SceneText::
            tr("%1 is not on the lane; its centre must be between the edges of the lane and before its end")
                .arg(text(e.first));
    case SceneErrorCode::WallsCrossed:
        return SceneText::tr("must be greater than %1, which is the opposite side, is %2")
            .arg(digits(e.low), digits(e.value));
    default:
        return {};
    }
}

// What is wrong with where the floor changes and the kickbacks stand.
QString laneMessage(const SceneError& e) {
    switch (e.code) {
    case SceneErrorCode::OilReversed:
        return SceneText::tr("must be greater than %1, where the oil begins, is %2")
            .arg(digits(e.low), digits(e.value));
    case SceneErrorCode::OilOverlap:
        return SceneText::tr(
                   "must be at least %1, where %2 ends, is %3; list the oil zones from low y to high y")
            .arg(digits(e.low), text(e.other), digits(e.value));
    case SceneErrorCode::KickbacksOffTheLane:
        return SceneText::tr("must be from %1, the foul line, to %2, the end of the lane, is %3")
            .arg(digits(e.low), digits(e.high), digits(e.value));
    default:
        return {};
    }
}

// What is wrong with the file.
QString fileMessage(const SceneError& e) {
    switch (e.code) {
    case SceneErrorCode::Unreadable:
        return SceneText::tr("cannot be read: %1").arg(text(e.other));
    case SceneErrorCode::NotJson:
        return notJsonMessage(e);
    case SceneErrorCode::NotAnObject:
        return wrongTypeMessage(ExpectedType::Object);
    case SceneErrorCode::MissingKey:
        return SceneText::tr("is missing");
    case SceneErrorCode::UnknownKey:
        return e.other.empty() ? SceneText::tr("is not a known key; remove it")
                               : SceneText::tr("is not a known key; did you mean \"%1\"?").arg(text(e.other));
    case SceneErrorCode::WrongType:
        return wrongTypeMessage(e.expected);
    case SceneErrorCode::WrongFormat:
        return SceneText::tr("must be \"thetalane-scene\", is \"%1\"").arg(text(e.other));
    case SceneErrorCode::WrongVersion:
        return SceneText::tr("must be 1, is %1").arg(digits(e.value));
    default:
        return {};
    }
}

// A field's name stays as it is in the file; a line and a column are told in the reader's language.
QString placeText(const SceneError& error) {
    static const QRegularExpression lineAndColumn("^line (\\d+), column (\\d+)$");
    const auto match = lineAndColumn.match(text(error.path));
    if (error.code != SceneErrorCode::NotJson || !match.hasMatch())
        return text(error.path);
    return SceneText::tr("line %1, column %2").arg(match.captured(1), match.captured(2));
}

} // namespace

QString sceneTitle(const Scene& scene, Language::Code language) {
    const bool korean = language == Language::Code::Korean;
    const std::string& asked = korean ? scene.title.ko : scene.title.en;
    const std::string& other = korean ? scene.title.en : scene.title.ko;
    return text(asked.empty() ? other : asked);
}

QString sceneErrorMessage(const SceneError& error) {
    for (const auto& message :
         {valueMessage(error), placeMessage(error), laneMessage(error), fileMessage(error)})
        if (!message.isEmpty())
            return message;
    return {};
}

QString sceneErrorText(const SceneError& error) {
    const QString message = sceneErrorMessage(error);
    return error.path.empty() ? message : placeText(error) + ": " + message;
}

QString refusalMessage(const Refusal& refusal) {
    switch (refusal.reason) {
    case RefusalReason::TooManySteps:
        return SceneText::tr(
                   "takes %1 steps, more than the %2 allowed; make the step longer or the time shorter")
            .arg(QString::number(refusal.value, 'g', 3), QString::number(refusal.limit, 'f', 0));
    case RefusalReason::UntilNotPositive:
    case RefusalReason::StepNotPositive:
    case RefusalReason::MaxCollisionsNotPositive:
    case RefusalReason::PassesNotPositive:
    case RefusalReason::ContactTimeNotPositive:
        break;
    }
    return SceneText::tr("must be greater than 0, is %1").arg(digits(refusal.value));
}

QString endReasonText(EndReason reason) {
    switch (reason) {
    case EndReason::Until:
        return SceneText::tr("the time asked for was reached");
    case EndReason::AtRest:
        return SceneText::tr("everything is at rest");
    case EndReason::NoMoreCollisions:
        return SceneText::tr("no more collisions can happen");
    case EndReason::MaxCollisions:
        return SceneText::tr("the most collisions allowed were reached");
    }
    return {};
}

QString sideName(Side side) {
    switch (side) {
    case Side::Left:
        return SceneText::tr("left wall");
    case Side::Right:
        return SceneText::tr("right wall");
    case Side::Bottom:
        return SceneText::tr("bottom wall");
    case Side::Top:
        return SceneText::tr("top wall");
    }
    return {};
}

} // namespace thetalane

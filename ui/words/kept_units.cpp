#include "ui/words/kept_units.h"

#include <QRegularExpression>

namespace thetalane {

QString keptUnits(QString text) {
    static const QRegularExpression gap("(?<=[0-9]) (?=(?:m|s|J|kg|cm|mm|ms|N|%)(?![A-Za-z]))");
    static const QRegularExpression mark("(?<=[a-z])([/·])(?=[a-z])");
    text.replace(gap, QString(QChar(0xA0)));
    return text.replace(mark, QStringLiteral("\u2060\\1\u2060"));
}

} // namespace thetalane

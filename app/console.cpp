#include "app/console.h"

#include <QCoreApplication>
#include <QFile>

#include <cstdio>

namespace thetalane {
namespace {

QFile& outputFile() {
    static QFile file;
    if (!file.isOpen())
        file.open(fileno(stdout), QIODevice::WriteOnly);
    return file;
}

void tell(const QString& message) {
    const QByteArray line = oneLine(message).toUtf8() + '\n';
    std::fwrite(line.constData(), 1, std::size_t(line.size()), stderr);
}

bool breaksLine(QChar c) {
    return c.category() == QChar::Other_Control || c == QChar::LineSeparator ||
           c == QChar::ParagraphSeparator;
}

QString escaped(QChar c) {
    if (c == '\n')
        return "\\n";
    if (c == '\t')
        return "\\t";
    return QString("\\u%1").arg(int(c.unicode()), 4, 16, QChar('0'));
}

} // namespace

QIODevice& standardOutput() {
    return outputFile();
}

void print(const QString& text) {
    outputFile().write(text.toUtf8());
}

void printLine(const QString& text) {
    print(text + '\n');
}

int finishOutput() {
    QFile& file = outputFile();
    if (file.error() == QFileDevice::NoError && file.flush())
        return Done;
    return failure(QCoreApplication::translate("Console", "standard output: cannot be written: %1")
                       .arg(file.errorString()));
}

int wrongCall(const QString& message) {
    tell(message);
    return WrongCall;
}

int failure(const QString& message) {
    tell(message);
    return Failed;
}

QString oneLine(const QString& text) {
    QString line;
    line.reserve(text.size());
    for (const QChar c : text)
        line += breaksLine(c) ? escaped(c) : QString(c);
    return line;
}

} // namespace thetalane

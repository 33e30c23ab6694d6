// What the commands write: UTF-8 whatever the locale says, errors in one line.
#pragma once

#include <QIODevice>
#include <QString>

namespace thetalane {

enum ExitStatus { Done = 0, Failed = 1, WrongCall = 2 };

QIODevice& standardOutput();
void print(const QString& text);
void printLine(const QString& text = {});

// Everything out; Failed, with a line that says why, where it could not be written.
int finishOutput();

// A line on standard error: what, where, and what would be right. Returns the status to leave with.
int wrongCall(const QString& message);
int failure(const QString& message);

// Line breaks and other control characters as \n, \u001b, so that a name cannot break a line or a terminal.
QString oneLine(const QString& text);

} // namespace thetalane

// The built program, called as a shell would call it.
#pragma once

#include <QByteArray>
#include <QProcess>
#include <QString>
#include <QStringList>

struct Outcome {
    int status = -1;
    QByteArray out;
    QString error;
};

// With no display, no locale and nothing else of this process's environment.
inline Outcome call(const QStringList& arguments, const QByteArray& input = {},
                    const QStringList& environment = {}) {
    QProcess process;
    process.setEnvironment(QStringList{"PATH=/usr/bin:/bin"} + environment);
    process.start(THETALANE_PROGRAM, arguments);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(60'000) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), process.readAllStandardOutput(),
            QString::fromUtf8(process.readAllStandardError())};
}

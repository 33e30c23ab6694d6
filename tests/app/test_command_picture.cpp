// thetalane picture: the window, drawn without a display.
#include "tests/app/program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

namespace {

bool isOneLine(const QString& error) {
    return error.endsWith('\n') && error.count('\n') == 1;
}

} // namespace

class TestCommandPicture : public QObject {
    Q_OBJECT

private slots:
    void aPictureHasTheSizeAskedFor() {
        QTemporaryDir dir;
        const QString path = dir.filePath("picture.png");
        // Less than the window's least size, as much as that and more; on a screen of double density.
        for (const QString size : {"320x400", "640x480", "800x560", "1280x800"}) {
            const Outcome o = call(
                {"picture", "rack", "--collision", "2", "--size", size, "--output", path, "--language", "en"},
                {}, {"QT_SCALE_FACTOR=2"});
            if (o.error.contains("without the window"))
                return; // nothing can draw
            QVERIFY2(o.status == 0 && o.error.isEmpty(), qPrintable(o.error));
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray head = file.read(24); // of a PNG: width and height are its last eight bytes
            QCOMPARE(QString("%1x%2")
                         .arg(qFromBigEndian<quint32>(head.data() + 16))
                         .arg(qFromBigEndian<quint32>(head.data() + 20)),
                     size);
        }
    }

    void aPictureThatDoesNotFitLeavesTheOldOne() {
        QTemporaryDir dir;
        const QString path = dir.filePath("picture.png");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("old") == 3);
        file.close();
        QProcess process;
        process.setEnvironment({"PATH=/usr/bin:/bin"});
        // A file may grow to 4 KiB, as on a disk that is nearly full.
        process.start("/bin/sh", {"-c", "trap '' XFSZ; ulimit -f 8; exec \"$0\" picture rack --output \"$1\"",
                                  THETALANE_PROGRAM, path});
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 1);
        const QString error = QString::fromUtf8(process.readAllStandardError());
        QVERIFY2(isOneLine(error), qPrintable(error));
        QVERIFY2(error.contains("too large") || error.contains("without the window"), qPrintable(error));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("old"));
        QCOMPARE(QDir(dir.path()).entryList(QDir::Files), QStringList("picture.png"));
    }

    // Another panel, another look, another language: another picture; the same call, the same bytes.
    void whatIsAskedForIsSeen() {
        if (drawn({}).isEmpty())
            return; // nothing can draw
        const QList<QStringList> calls{{},
                                       {"--language", "ko"},
                                       {"--dark"},
                                       {"--projector"},
                                       {"--panel", "words"},
                                       {"--panel", "collisions"},
                                       {"--panel", "attributes"},
                                       {"--panel", "accuracy"},
                                       {"--at", "0.5"}};
        QList<QByteArray> pictures;
        for (const QStringList& call : calls) {
            const QByteArray picture = drawn(call);
            QVERIFY2(picture.startsWith("\x89PNG"), qPrintable(call.join(' ')));
            QVERIFY2(!pictures.contains(picture), qPrintable(call.join(' ')));
            pictures << picture;
        }
        QCOMPARE(drawn(calls.back()), pictures.back());
    }

    // The accuracy lab is measured here and now, and open.
    void aQuestionOfTheLabIsMeasured() {
        const QByteArray without = drawn({"--panel", "accuracy"});
        if (without.isEmpty())
            return;
        const QByteArray lab = drawn({"--lab", "2"});
        QVERIFY(lab.startsWith("\x89PNG"));
        QVERIFY(lab != without);
    }

    void anUnknownPanelIsRefused() {
        const Outcome o =
            call({"picture", "rack", "--output", "x.png", "--panel", "acuracy", "--language", "en"});
        QCOMPARE(o.status, 2);
        QVERIFY2(isOneLine(o.error), qPrintable(o.error));
        QVERIFY2(o.error.contains("--panel") || o.error.contains("without the window"), qPrintable(o.error));
    }

private:
    // Empty where the program was built without its window.
    QByteArray drawn(const QStringList& options) {
        const QString path = m_dir.filePath("picture.png");
        QFile::remove(path);
        QStringList arguments{"picture", "two-balls", "--output", path};
        if (!options.contains("--language"))
            arguments << "--language"
                      << "en";
        call(arguments + options);
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir m_dir;
};

QTEST_GUILESS_MAIN(TestCommandPicture)
#include "test_command_picture.moc"

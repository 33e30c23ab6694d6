// Both languages are complete: nothing in the sources that the .ts files do not hold, nothing unfinished, and
// Korean where there are words.
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

namespace {

struct Message {
    QString context;
    QString source;
    QStringList translations;
    bool unfinished = false;
};

QList<Message> readMessages(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QXmlStreamReader xml(&file);
    QList<Message> messages;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        const auto name = xml.name();
        if (name == u"name")
            context = xml.readElementText();
        else if (name == u"message")
            messages.append({context, {}, {}, false});
        else if (name == u"source")
            messages.last().source = xml.readElementText();
        else if (name == u"translation") {
            messages.last().unfinished = xml.attributes().hasAttribute("type");
            messages.last().translations << xml.readElementText(QXmlStreamReader::IncludeChildElements);
        }
    }
    return messages;
}

bool hasHangul(const QString& text) {
    static const QRegularExpression hangul("[\\x{AC00}-\\x{D7A3}]");
    return hangul.match(text).hasMatch();
}

// Names, symbols and units stay as they are.
bool hasWords(QString text) {
    static const QRegularExpression kept(
        "ThetaLane|English|Ctrl|Space|SCENE|FILE|COMMAND|%L?[0-9n]|thetalane|--[a-z-]+|"
        "[a-z]+\\.json|\\*\\.json|\\bJSON\\b|\\bCSV\\b|\\bPNG\\b"),
        word("[A-Za-z]{3,}");
    return word.match(text.remove(kept)).hasMatch();
}

} // namespace

class TestTranslations : public QObject {
    Q_OBJECT

private slots:
    void everyStringIsTranslated_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("ko") << "ko";
        QTest::newRow("en") << "en";
    }
    void everyStringIsTranslated() {
        QFETCH(QString, language);
        const QDir root(THETALANE_SOURCE_DIR);
        QTemporaryDir dir;
        const QString ts = dir.filePath("thetalane_" + language + ".ts");
        QVERIFY(QFile::copy(root.filePath("translations/thetalane_" + language + ".ts"), ts));
        QFile(ts).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        QStringList arguments{"-silent", "-no-obsolete", "-locations", "none"};
        if (language == "en")
            arguments << "-pluralonly";
        arguments << "-I" << root.path() << root.filePath("ui") << root.filePath("app") << "-ts" << ts;
        QCOMPARE(QProcess::execute(THETALANE_LUPDATE, arguments), 0);
        const auto messages = readMessages(ts);
        QVERIFY(language == "en" || messages.size() > 50);
        for (const Message& m : messages) {
            QVERIFY2(!m.unfinished && !m.translations.join("").isEmpty(),
                     qPrintable(m.context + ": " + m.source));
            if (language == "ko" && hasWords(m.source))
                QVERIFY2(hasHangul(m.translations.join("")), qPrintable(m.context + ": " + m.source));
        }
    }

    // %1, %2, … are all used, in any order.
    void placeholdersSurvive() {
        const QDir root(THETALANE_SOURCE_DIR);
        static const QRegularExpression placeholder("%L?[0-9n]");
        for (const Message& m : readMessages(root.filePath("translations/thetalane_ko.ts"))) {
            QSet<QString> asked, given;
            for (auto it = placeholder.globalMatch(m.source); it.hasNext();)
                asked.insert(it.next().captured());
            for (auto it = placeholder.globalMatch(m.translations.join("")); it.hasNext();)
                given.insert(it.next().captured());
            QVERIFY2(asked == given, qPrintable(m.context + ": " + m.source));
        }
    }
};

QTEST_APPLESS_MAIN(TestTranslations)
#include "test_translations.moc"

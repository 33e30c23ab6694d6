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

    // A textbook's term for each, and the same everywhere. Left out: words that mean other things as well
    // (a speed of computing, to strike, a double of 53 bits).
    void termsAreThoseOfATextbook_data() {
        QTest::addColumn<QString>("english");
        QTest::addColumn<QString>("korean");
        const auto row = [](const char* english, const char* korean) {
            QTest::newRow(english) << QString(english) << QString::fromUtf8(korean);
        };
        row("coefficient of restitution", "반발 계수");
        row("momentum", "운동량");
        row("impulse", "충격량");
        row("kinetic energy", "운동 에너지");
        row("relative velocity", "상대 속도");
        row("velocity", "속도");
        row("component", "성분");
        row("line of centres", "중심선");
        row("centre of mass", "질량 중심");
        row("mass", "질량");
        row("action and reaction", "작용 반작용|작용과 반작용");
        row("friction", "마찰");
        row("head pin", "헤드핀");
        row("foul line", "파울 라인");
        row("gutter", "거터");
        row("pocket", "포켓");
        row("spare", "스페어");
        row("board", "보드");
        row("oil", "오일");
        row("strike map", "스트라이크 지도");
        row("score sheet", "점수판");
        row("delivery", "투구");
        row("turkey", "터키");
        row("perfect game", "퍼펙트 게임");
    }
    void termsAreThoseOfATextbook() {
        QFETCH(QString, english);
        QFETCH(QString, korean);
        const QRegularExpression word("\\b" + english + "(s|ies)?\\b",
                                      QRegularExpression::CaseInsensitiveOption);
        const QRegularExpression term(korean), option("--[-a-z]+");
        const QDir root(THETALANE_SOURCE_DIR);
        int found = 0;
        for (const Message& m : readMessages(root.filePath("translations/thetalane_ko.ts"))) {
            if (!word.match(QString(m.source).remove(option)).hasMatch())
                continue;
            ++found;
            QVERIFY2(term.match(m.translations.join(" ")).hasMatch(),
                     qPrintable(m.source + " | " + m.translations.join(" ")));
        }
        QVERIFY2(found > 0, qPrintable(english));
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

// The terms where a reader meets them: in every room a pause of the mouse and F1 explain the right one, in
// both languages.
#include "tests/ui/whole_program.h"
#include "ui/game/alley.h"
#include "ui/words/glossary.h"

#include <QAbstractItemModel>
#include <QHeaderView>
#include <QHelpEvent>
#include <QSet>
#include <QStackedWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolTip>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

struct Program : WholeProgram {
    using WholeProgram::WholeProgram;
    QWidget& enter(Room room) {
        window.enter(room);
        QCoreApplication::processEvents();
        return *rail().panel(room);
    }
};

// Where in a widget a term is explained.
struct Spot {
    QWidget* widget;
    QPoint at;
    QString term;
};

std::vector<Spot> headingsOf(QHeaderView& header) {
    std::vector<Spot> spots;
    for (int k = 0; header.model() && k < header.count(); ++k) {
        const QString term = header.model()->headerData(k, header.orientation(), termRole).toString();
        const int middle = header.sectionViewportPosition(k) + header.sectionSize(k) / 2;
        if (!term.isEmpty() && !header.isSectionHidden(k))
            spots.push_back({header.viewport(),
                             header.orientation() == Qt::Horizontal ? QPoint(middle, 5) : QPoint(5, middle),
                             term});
    }
    return spots;
}

std::vector<Spot> spotsIn(const QWidget& room) {
    std::vector<Spot> spots;
    for (QWidget* w : room.findChildren<QWidget*>()) {
        if (!w->isVisible())
            continue;
        if (const QString term = w->property(termProperty).toString(); !term.isEmpty())
            spots.push_back({w, w->rect().center(), term});
        if (auto* header = qobject_cast<QHeaderView*>(w))
            for (const Spot& heading : headingsOf(*header))
                spots.push_back(heading);
    }
    return spots;
}

QString explained(const Spot& spot) {
    QHelpEvent pause(QEvent::ToolTip, spot.at, spot.widget->mapToGlobal(spot.at));
    QCoreApplication::sendEvent(spot.widget, &pause);
    const QString text = QToolTip::text();
    QToolTip::hideText();
    return text;
}

} // namespace

class TestTerms : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { keepSettingsIn(m_settings, "ThetaLaneTerms"); }

    void aPauseExplainsEveryTermOfARoom_data() {
        QTest::addColumn<bool>("korean");
        QTest::addColumn<QString>("scene");
        QTest::addColumn<int>("room");
        QTest::addColumn<QStringList>("terms");
        struct Row {
            const char* scene;
            Room room;
            QStringList terms;
        };
        const Row rows[] = {
            {"two-balls", Room::Steps, {"contact", "rotation", "exchange", "digits-left"}},
            {"two-balls", Room::Collisions, {"collision", "impulse", "energy-loss"}},
            {"two-balls", Room::Attributes, {"mass", "radius", "speed", "direction", "restitution"}},
            {"bowling",
             Room::Attributes,
             {"mass", "speed", "direction", "board", "angular-velocity", "axis"}},
            {"two-balls", Room::Game, {"scoring", "oil-pattern", "release"}},
            {"bowling", Room::Chain, {"perfect-strike", "impulse", "leave"}},
            {"rack", Room::Map, {"strike-map", "offset", "entry-angle", "pinfall", "restitution"}},
            {"bowling", Room::Practice, {"spare", "leave", "speed", "pinfall"}},
            {"two-balls", Room::Accuracy, {"tunnelling", "time-step", "floating-point", "sensitivity"}},
        };
        for (const bool korean : {false, true})
            for (const Row& row : rows)
                QTest::addRow("%s: %s, %s", korean ? "ko" : "en", row.scene,
                              roomIds[std::size_t(row.room)].data())
                    << korean << row.scene << int(row.room) << row.terms;
    }

    void aPauseExplainsEveryTermOfARoom() {
        QFETCH(bool, korean);
        QFETCH(QString, scene);
        QFETCH(int, room);
        QFETCH(QStringList, terms);
        Program p(korean ? Language::Code::Korean : Language::Code::English);
        QVERIFY(p.session.openBuiltin(scene));
        if (Room(room) == Room::Steps)
            p.playhead.select(0);
        const QWidget& panel = p.enter(Room(room));
        QSet<QString> met;
        for (const Spot& spot : spotsIn(panel)) {
            const GlossaryEntry* entry = glossaryEntry(spot.term);
            QVERIFY2(entry, qPrintable(spot.term));
            const QString tip = explained(spot);
            QVERIFY2(tip.contains(entry->term.toHtmlEscaped()) && tip.contains(entry->text.toHtmlEscaped()),
                     qPrintable(spot.term + ": " + tip));
            met << spot.term;
        }
        for (const QString& term : terms)
            QVERIFY2(met.contains(term), qPrintable(term));
    }

    void theWordsOfAGameAreExplained() {
        Program p(Language::Code::Korean);
        const QWidget& panel = p.enter(Room::Game);
        p.window.alley().start({{"Ada", 0}}, ScoringRules::Traditional, {});
        for (int ball = 0; ball < 3; ++ball) { // the default throw strikes
            p.window.alley().throwBall();
            p.window.alley().tellScore();
            auto* told = panel.findChild<QWidget*>("announcement");
            QCOMPARE(told->property(termProperty).toString(), QString(ball == 0 ? "strike" : "turkey"));
            p.window.alley().next();
        }
        QVERIFY(explained({panel.findChild<QWidget*>("markFoul"), QPoint(5, 5), {}}).contains(u"파울"));
        QSet<QString> met;
        for (const Spot& spot : spotsIn(p.enter(Room::Statistics)))
            if (const GlossaryEntry* entry = glossaryEntry(spot.term);
                entry && explained(spot).contains(entry->text.toHtmlEscaped()))
                met << spot.term;
        for (const char* term : {"strike", "spare", "split", "open-frame", "pocket"})
            QVERIFY2(met.contains(QLatin1String(term)), term);
        p.window.alley().undo();
        p.window.alley().close();
    }

    void everyWayOfComputingIsExplained() {
        Program p(Language::Code::English);
        auto* combo = p.window.findChild<QWidget*>("engineCombo");
        for (const auto& [kind, term] :
             {std::pair{EngineKind::Event, "next-event"}, std::pair{EngineKind::Stepped, "papers-loop"},
              std::pair{EngineKind::Swept, "swept-steps"}}) {
            EngineSettings settings = p.session.run()->settings;
            settings.kind = kind;
            QVERIFY(!p.session.setEngine(settings));
            const GlossaryEntry* entry = glossaryEntry(term);
            QVERIFY(entry);
            QVERIFY(explained({combo, combo->rect().center(), term}).contains(entry->text.toHtmlEscaped()));
        }
    }

    // What has the focus need not carry the term itself: what it stands in does.
    void f1OpensTheTermOfAField() {
        Program p(Language::Code::Korean);
        QVERIFY(p.session.openBuiltin("bowling"));
        QWidget& panel = p.enter(Room::Attributes);
        auto* field = panel.findChild<QWidget*>("axisField");
        QVERIFY(field);
        field->setFocus(Qt::TabFocusReason);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
        QCOMPARE(p.rail().current(), Room::Glossary);
        auto* text = p.window.findChild<QTextBrowser*>("terms");
        const QString atTop = text->cursorForPosition(QPoint(2, 8)).block().text();
        QVERIFY2(atTop.startsWith(glossaryEntry("axis")->term), qPrintable(atTop));
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestTerms)
#include "test_terms.moc"

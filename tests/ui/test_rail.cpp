// The rail and its rooms, the glossary, the keys: driven by real clicks and keys.
#include "tests/ui/whole_program.h"
#include "ui/help/words_panel.h"
#include "ui/rail/rail_button.h"
#include "ui/words/glossary.h"

#include <QHelpEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSet>
#include <QStackedWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolTip>

#include <cmath>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

struct Program : WholeProgram {
    explicit Program(Language::Code code = Language::Code::English)
        : WholeProgram(code) {}
    RailButton& button(Room room) { return *window.findChild<RailButton*>(QString("room%1").arg(int(room))); }
    QWidget& panels() { return *window.findChild<QStackedWidget*>("panels"); }
};

// WCAG 2: relative luminance, contrast ratio.
double luminance(const QColor& c) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}
double contrast(const QColor& a, const QColor& b) {
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

} // namespace

class TestRail : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { keepSettingsIn(m_settings, "ThetaLaneRail"); }

    void aClickEntersAndAnotherFoldsAway() {
        Program p;
        QVERIFY(p.panels().isVisible());
        const int lane = p.window.findChild<QWidget*>("lanePanel")->width();
        QTest::mouseClick(&p.button(Room::Glossary), Qt::LeftButton);
        QCOMPARE(p.rail().current(), Room::Glossary);
        QTest::mouseClick(&p.button(Room::Glossary), Qt::LeftButton);
        QVERIFY(!p.panels().isVisible());
        QVERIFY(!p.button(Room::Glossary).isChecked());
        QTest::qWait(1);
        QVERIFY(p.window.findChild<QWidget*>("lanePanel")->width() > lane + 200);
        QTest::keyClick(&p.window, Qt::Key_F9);
        QVERIFY(p.panels().isVisible());
        QTest::mouseClick(&p.button(Room::Steps), Qt::LeftButton);
        QCOMPARE(p.rail().current(), Room::Steps);
        QVERIFY(!p.button(Room::Glossary).isChecked());
    }

    void roomsAreFurnishedWhenTheyAreEntered() {
        Program p;
        QVERIFY(!p.rail().isFurnished(Room::Accuracy));
        QTest::mouseClick(&p.button(Room::Accuracy), Qt::LeftButton);
        QVERIFY(p.rail().isFurnished(Room::Accuracy));
    }

    void keysGoThroughTheRooms() {
        Program p;
        int count = 0;
        while (p.rail().offered(count))
            ++count;
        QVERIFY(count >= 5);
        for (int k = 0; k < std::min(count, 9); ++k) {
            QTest::keyClick(&p.window, Qt::Key(Qt::Key_1 + k), Qt::AltModifier);
            QCOMPARE(p.rail().current(), *p.rail().offered(k));
        }
        p.button(*p.rail().offered(0)).setFocus();
        QTest::keyClick(&p.button(*p.rail().offered(0)), Qt::Key_Down);
        QVERIFY(p.button(*p.rail().offered(1)).hasFocus());
        QTest::keyClick(&p.button(*p.rail().offered(1)), Qt::Key_Space);
        QCOMPARE(p.rail().current(), *p.rail().offered(1));
        QVERIFY(!p.playhead.playing());
    }

    void aShortRailShowsIconsAlone() {
        Program p;
        p.appearance.setProjector(true);
        p.window.resize(1024, 600);
        QTest::qWait(1);
        for (int k = 0; p.rail().offered(k); ++k) {
            const RailButton& button = p.button(*p.rail().offered(k));
            QVERIFY(button.height() >= 36);
            QVERIFY(button.geometry().bottom() <= p.rail().height());
            QVERIFY(!button.toolTip().isEmpty() && !button.accessibleName().isEmpty());
        }
    }

    // Every entry in both languages; a Korean explanation holds no English but symbols and units.
    void theGlossaryIsWhole() {
        const auto english = glossary(Language::Code::English), korean = glossary(Language::Code::Korean);
        QVERIFY(english.size() >= 65);
        QCOMPARE(english.size(), korean.size());
        static const QRegularExpression words("[A-Za-z]{4,}"), hangul("[가-힣]");
        QSet<QString> ids;
        for (std::size_t k = 0; k < english.size(); ++k) {
            QCOMPARE(english[k].id, korean[k].id);
            QVERIFY2(!ids.contains(english[k].id), qPrintable(english[k].id));
            ids << english[k].id;
            QCOMPARE(english[k].term, korean[k].otherTerm);
            QVERIFY(!english[k].text.contains(hangul) && english[k].text.endsWith('.'));
            QVERIFY2(!korean[k].text.contains(words), qPrintable(korean[k].text));
            QVERIFY2(korean[k].text.contains(hangul) && korean[k].text.endsWith("다."),
                     qPrintable(korean[k].text));
        }
    }

    void f1OpensTheTermWithTheFocus() {
        Program p;
        p.playhead.select(0);
        auto* header = p.window.findChild<QWidget*>("stepHeader3");
        header->setFocus(Qt::TabFocusReason);
        QTest::keyClick(header, Qt::Key_F1);
        QCOMPARE(p.rail().current(), Room::Glossary);
        auto* text = p.window.findChild<QTextBrowser*>("terms");
        QVERIFY(text->verticalScrollBar()->value() > 0);
        const QString atTop = text->cursorForPosition(QPoint(2, 8)).block().text();
        QVERIFY2(atTop.contains("1-D exchange"), qPrintable(atTop));
    }

    void aPauseOfTheMouseExplains() {
        Program p(Language::Code::Korean);
        p.playhead.select(0);
        auto* header = p.window.findChild<QWidget*>("stepHeader2");
        QHelpEvent pause(QEvent::ToolTip, QPoint(5, 5), header->mapToGlobal(QPoint(5, 5)));
        QCoreApplication::sendEvent(header, &pause);
        QVERIFY2(QToolTip::text().contains(QStringLiteral("좌표축의 회전")), qPrintable(QToolTip::text()));
        QToolTip::hideText();
    }

    void theSearchFindsEitherLanguage() {
        Program p(Language::Code::Korean);
        QTest::keyClick(&p.window, Qt::Key_F1);
        auto* search = p.window.findChild<QLineEdit*>("searchTerms");
        auto* text = p.window.findChild<QTextBrowser*>("terms");
        QVERIFY(text->toPlainText().contains("Ctrl+"));
        search->setFocus();
        QTest::keyClicks(search, "RESTITUTION");
        QVERIFY(text->toPlainText().contains(QStringLiteral("반발 계수")));
        QVERIFY(!text->toPlainText().contains(QStringLiteral("질량 중심")));
        search->clear();
        QTest::keyClicks(search, "qqq");
        QVERIFY(text->toPlainText().contains(QStringLiteral("없습니다")));
    }

    // Text that carries meaning is read on every ground, in every look (WCAG AA: 4.5).
    void coloursOfTextStandOut() {
        Appearance look;
        for (const bool dark : {false, true})
            for (const bool projector : {false, true}) {
                look.setDark(dark);
                look.setProjector(projector);
                for (const QColor& ground : {look.card(), look.window(), look.floor()}) {
                    for (const Ink role :
                         {Ink::First, Ink::Second, Ink::Along, Ink::Across, Ink::Triangle, Ink::Plain})
                        QVERIFY2(contrast(look.textInk(role), ground) >= 4.5,
                                 qPrintable(QString("%1 %2 %3: %4")
                                                .arg(int(role))
                                                .arg(dark)
                                                .arg(ground.name())
                                                .arg(contrast(look.textInk(role), ground))));
                    QVERIFY(contrast(look.text(), ground) >= 7);
                    QVERIFY(contrast(look.quietText(), ground) >= 4.5);
                    QVERIFY(contrast(look.accent(), ground) >= 4.5);
                }
                QVERIFY(contrast(look.error(), look.errorGround()) >= 4.5);
                QVERIFY(contrast(look.accent(), look.card()) >= 4.5); // what is written on it
            }
    }

    void darkIsRemembered() {
        {
            Program p;
            QVERIFY(!p.appearance.dark());
            QTest::keyClick(&p.window, Qt::Key_D);
            QVERIFY(p.appearance.dark());
            QVERIFY(p.window.close());
        }
        Program p;
        p.window.restoreState();
        QVERIFY(p.appearance.dark());
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestRail)
#include "test_rail.moc"

// The tables against sums of the test's own, from the timeline's states just before and just after.
#include "core/timeline/history.h"
#include "long_run_bench.h"
#include "ui/tables/bodies_page.h"
#include "ui/tables/collision_page.h"
#include "ui/tables/collision_sheet.h"
#include "ui/tables/course_page.h"
#include "ui/tables/impulse_page.h"
#include "ui/tables/momentum_figure.h"
#include "ui/tables/sheet_table.h"
#include "ui/tables/tables_panel.h"
#include "ui/tables/time_view.h"

#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <cmath>

using namespace thetalane;
using View = TablesPanel::View;

namespace {

double justBefore(double t) {
    return std::nextafter(t, 0.0);
}

struct OwnSums {
    double px = 0, py = 0, energy = 0;
};
OwnSums ownSums(const Scene& scene, const Timeline& timeline, double t) {
    OwnSums sums;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Vec2d v = timeline.bodyAt(i, t).velocity;
        sums.px += scene.bodies[i].mass * v.x;
        sums.py += scene.bodies[i].mass * v.y;
        sums.energy += 0.5 * scene.bodies[i].mass * (v.x * v.x + v.y * v.y);
    }
    return sums;
}

bool near(double a, double b, double scale = 1) {
    return std::abs(a - b) <= 1e-12 * scale;
}

QList<QStringList> fieldsOf(const QString& text, QChar separator) {
    QList<QStringList> rows;
    for (const QString& line : QString(text).remove(u'\r').split(u'\n', Qt::SkipEmptyParts))
        rows << line.split(separator);
    return rows;
}

QByteArray readAll(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Every label, button and column has the room that its text needs.
QString clipped(QWidget& panel) {
    for (const auto* button : panel.findChildren<QAbstractButton*>())
        if (button->isVisible() && button->width() < button->sizeHint().width())
            return button->objectName() + ": " + button->text();
    for (const auto* label : panel.findChildren<QLabel*>())
        if (label->isVisible() && !label->text().isEmpty() &&
            (label->height() < label->heightForWidth(label->width()) ||
             (!label->wordWrap() && label->width() < label->sizeHint().width())))
            return label->objectName() + ": " + label->text();
    for (const auto* box : panel.findChildren<QComboBox*>())
        if (box->fontMetrics().horizontalAdvance(box->currentText()) > box->width() - 24)
            return box->objectName() + ": " + box->currentText();
    for (const auto* table : panel.findChildren<SheetTable*>())
        if (table->isVisible() && table->naturalWidth() > table->width())
            return table->objectName();
    return {};
}

} // namespace

class TestTables : public QObject {
    Q_OBJECT

private:
    Language m_language;

private slots:
    void cleanup() { useLanguage(m_language, false); }

    void beforeAndAfter_data() {
        QTest::addColumn<QString>("scene");
        QTest::newRow("glancing") << "glancing";
        QTest::newRow("inelastic") << "inelastic";
        QTest::newRow("heavy-light") << "heavy-light";
    }
    void beforeAndAfter() {
        QFETCH(QString, scene);
        PanelBench bench;
        QVERIFY(bench.session.openBuiltin(scene));
        TablesPanel panel(bench.context);
        showPanel(panel, {760, 700});
        bench.playhead.select(0);
        const Scene& s = bench.session.scene();
        const Timeline& timeline = bench.session.timeline();
        const double t = timeline.collisions()[0].time;
        const OwnSums before = ownSums(s, timeline, justBefore(t)), after = ownSums(s, timeline, t);
        const Sheet& sheet = panel.findChild<SheetTable*>("collisionNumbers")->sheet();
        QCOMPARE(sheet.rows.size(), std::size_t(8)); // two blocks of a name, two bodies and a total
        for (const auto& [row, sums] : {std::pair{3, before}, {7, after}}) {
            QVERIFY(near(sheet.rows[row][5].exact.toDouble(), sums.px));
            QVERIFY(near(sheet.rows[row][6].exact.toDouble(), sums.py));
            QVERIFY(near(sheet.rows[row][7].exact.toDouble(), sums.energy));
        }
        for (std::size_t body : {0, 1}) {
            const Vec2d v = timeline.bodyAt(body, t).velocity;
            QVERIFY(near(sheet.rows[5 + body][4].exact.toDouble(), std::hypot(v.x, v.y)));
        }
        const Sheet& checks = panel.findChild<SheetTable*>("collisionChecks")->sheet();
        QVERIFY(near(checks.rows[0][1].exact.toDouble(), before.energy - after.energy));
        // e from the velocities along the line between the centres at that moment
        const Vec2d n = timeline.bodyAt(0, t).position - timeline.bodyAt(1, t).position;
        const auto closing = [&](double time) {
            return dot(timeline.bodyAt(0, time).velocity - timeline.bodyAt(1, time).velocity, n) / norm(n);
        };
        QVERIFY(std::abs(checks.rows[1][1].exact.toDouble() + closing(t) / closing(justBefore(t))) < 1e-9);
        QVERIFY(std::abs(checks.rows[1][1].exact.toDouble() - s.restitution) < 1e-9);
        for (const int row : {2, 3}) {
            QCOMPARE(checks.rows[std::size_t(row)][1].shown, QString("0"));
            QVERIFY(std::abs(checks.rows[std::size_t(row)][1].exact.toDouble()) < 1e-12);
        }
    }

    void aWallTakesUpMomentum() {
        PanelBench bench;
        QVERIFY(bench.session.openBuiltin("two-balls"));
        const auto all = bench.session.timeline().collisions();
        const auto wall = std::find_if(all.begin(), all.end(), [](const auto& c) { return c.isWall(); });
        QVERIFY(wall != all.end());
        const auto index = std::size_t(wall - all.begin());
        const PassSums sums = sumsOf(all.subspan(index, 1));
        const double taken = norm(sums.momentumAfter - sums.momentumBefore);
        QVERIFY(near(taken, std::abs(wall->steps.impulse)));
        const Sheet checks = checkSheet(bench.session.scene(), all, index);
        QVERIFY(
            near(std::hypot(checks.rows[2][1].exact.toDouble(), checks.rows[3][1].exact.toDouble()), taken));
    }

    void csvIsReadBack() {
        PanelBench bench;
        QVERIFY(bench.session.openBuiltin("glancing"));
        TablesPanel panel(bench.context);
        showPanel(panel, {560, 700});
        bench.playhead.select(0);
        QTemporaryDir dir;
        QVERIFY(panel.saveCsv(dir.filePath("table.csv")));
        const QByteArray text = readAll(dir.filePath("table.csv"));
        QVERIFY(text.startsWith("\xEF\xBB\xBF"));
        const auto rows = fieldsOf(QString::fromUtf8(text.mid(3)), u',');
        QCOMPARE(rows[0].size(), 14);
        QCOMPARE(rows[0][1], QString("m [kg]"));
        QCOMPARE(rows[0][2], QString("vx before [m/s]"));
        const Timeline& timeline = bench.session.timeline();
        const double t = timeline.collisions()[0].time;
        QCOMPARE(rows[1][2].toDouble(), timeline.bodyAt(0, justBefore(t)).velocity.x); // every digit
        QCOMPARE(rows[2][9].toDouble(), timeline.bodyAt(1, t).velocity.y);
        QVERIFY(near(rows[3][13].toDouble(), ownSums(bench.session.scene(), timeline, t).energy));
        QVERIFY(!panel.saveCsv(dir.path())); // a directory
        QVERIFY(!message(panel, "tablesMessage").isEmpty());
    }

    void quotesWhatAFileCannotHold() {
        Sheet sheet{{{"a", "m"}}, {{textCell("one, \"two\"")}}};
        QCOMPARE(commaSeparated(sheet), QByteArray("\xEF\xBB\xBF"
                                                   "a [m]\r\n\"one, \"\"two\"\"\"\r\n"));
        sheet.rows = {{textCell("one\ttwo\nthree")}};
        QCOMPARE(tabbed(sheet), QString("a [m]\none two three\n"));
    }

    void copies() {
        PanelBench bench;
        QVERIFY(bench.session.openBuiltin("glancing"));
        TablesPanel panel(bench.context);
        showPanel(panel, {760, 700});
        bench.playhead.select(0);
        click(panel, "copyTable");
        auto rows = fieldsOf(QApplication::clipboard()->text(), u'\t');
        QCOMPARE(rows[0][13], QString("Ek after [J]"));
        auto* table = panel.findChild<SheetTable*>("collisionNumbers");
        table->selectRow(1);
        table->setFocus();
        QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
        rows = fieldsOf(QApplication::clipboard()->text(), u'\t');
        QCOMPARE(rows.size(), 2);
        QCOMPARE(rows[1][2].toDouble(), bench.session.timeline().collisions()[0].steps.before.first.x);
    }

    void drawsAPicture() {
        PanelBench bench;
        TablesPanel panel(bench.context);
        showPanel(panel, {480, 600});
        panel.choose(View::Course);
        QTemporaryDir dir;
        const QSize page = panel.findChild<CoursePage*>()->size();
        QVERIFY(panel.savePicture(dir.filePath("plot.png")));
        const QImage image(dir.filePath("plot.png"));
        QCOMPARE(image.size(), page * 2);
        int dark = 0;
        for (int x = 0; x < image.width(); ++x)
            for (int y = 0; y < image.height(); ++y)
                dark += qGray(image.pixel(x, y)) < 128;
        QVERIFY(dark > 2000);
    }

    void aBarOpensItsCollision() {
        PanelBench bench;
        QVERIFY(bench.session.openBuiltin("rack"));
        TablesPanel panel(bench.context);
        showPanel(panel, {560, 600});
        panel.choose(View::Impulses);
        auto* view = panel.findChild<TimeView*>("impulsePlot");
        const auto all = bench.session.timeline().collisions();
        QCOMPARE(view->bars().size(), all.size());
        std::size_t greatest = 0;
        for (std::size_t k = 0; k < all.size(); ++k)
            if (all[k].steps.impulse > all[greatest].steps.impulse)
                greatest = k;
        const TimeBar bar = view->bars()[greatest];
        QTest::mouseClick(view, Qt::LeftButton, {}, view->at(bar.time, bar.value).toPoint());
        QCOMPARE(bench.playhead.selected(), std::optional(greatest));
        QVERIFY(view->bars()[greatest].open);
    }

    void draggingMovesTheTime() {
        PanelBench bench;
        QVERIFY(bench.session.openBuiltin("glancing"));
        TablesPanel panel(bench.context);
        showPanel(panel, {560, 600});
        panel.choose(View::Course);
        auto* view = panel.findChild<TimeView*>("energyPlot");
        const double end = bench.playhead.end();
        const int y = view->height() / 3;
        const auto x = [&](double t) { return int(std::lround(view->at(t, 0).x())); };
        QTest::mousePress(view, Qt::LeftButton, {}, {x(0.25 * end), y});
        QVERIFY(std::abs(bench.playhead.time() - 0.25 * end) < 0.01 * end);
        QTest::mouseMove(view, {x(0.75 * end), y});
        QVERIFY(std::abs(bench.playhead.time() - 0.75 * end) < 0.01 * end);
        QTest::mouseRelease(view, Qt::LeftButton, {}, {x(0.75 * end), y});
        QCOMPARE(view->cursorTime(), bench.playhead.time());
        QCOMPARE(panel.findChild<TimeView*>("momentumPlot")->cursorTime(), bench.playhead.time());
    }

    // Each event twice, so that a jump is a jump; between them what the timeline says.
    void theCourseIsExact() {
        for (const char* name : {"inelastic", "cradle", "bowling"}) {
            PanelBench bench;
            QVERIFY(bench.session.openBuiltin(name));
            const Scene& scene = bench.session.scene();
            const Timeline& timeline = bench.session.timeline();
            const History h = history(scene, timeline, 0, bench.session.shownUntil(), 4000);
            QVERIFY2(h.everyEvent, name);
            for (const Collision& c : timeline.collisions()) {
                if (c.time >= bench.session.shownUntil())
                    continue;
                double lost = 0;
                for (const Collision& other : timeline.collisions())
                    lost += other.time == c.time ? other.steps.energyLoss : 0;
                const auto after = std::find_if(h.moments.begin(), h.moments.end(),
                                                [&](const SummedMoment& m) { return m.time == c.time; });
                QVERIFY(after != h.moments.end() && after != h.moments.begin());
                const double fell = std::prev(after)->totals.energy - after->totals.energy;
                QVERIFY2(std::abs(fell - lost) < 1e-9 * (1 + h.moments[0].totals.energy), name);
            }
            for (const SummedMoment& m : h.moments) {
                const OwnSums own = ownSums(scene, timeline, m.time);
                QVERIFY(near(m.totals.energy, own.energy, 1e3));
                QVERIFY(near(m.centre.mass * m.centre.velocity.x, own.px, 1e3));
            }
        }
    }

    void bodiesFollowTheTime() {
        PanelBench bench;
        QVERIFY(bench.session.open(gasScene(400)).empty());
        TablesPanel panel(bench.context);
        showPanel(panel, {560, 500});
        panel.choose(View::Bodies);
        const QTableView* table = nullptr;
        for (const auto* one : panel.findChildren<QTableView*>("bodiesTable"))
            if (one->isVisible())
                table = one;
        QVERIFY(table);
        QAbstractItemModel* model = table->model();
        QCOMPARE(model->rowCount(), 401);
        QSignalSpy changed(model, &QAbstractItemModel::dataChanged);
        bench.playhead.setTime(0.05);
        QVERIFY(!changed.empty());
        const auto rows =
            changed.last()[1].value<QModelIndex>().row() - changed.last()[0].value<QModelIndex>().row();
        QVERIFY(rows > 5 && rows < 40); // those that are seen
        const Vec2d v = bench.session.timeline().bodyAt(3, bench.playhead.time()).velocity;
        QCOMPARE(model->index(3, 2).data(Qt::ToolTipRole).toString().section(' ', 0, 0).toDouble(), v.x);
        const OwnSums own = ownSums(bench.session.scene(), bench.session.timeline(), bench.playhead.time());
        QVERIFY(near(model->index(400, 7).data(Qt::ToolTipRole).toString().section(' ', 0, 0).toDouble(),
                     own.energy, 1e3));
    }

    void momentaEndAtOnePoint() {
        PanelBench bench;
        QVERIFY(bench.session.openBuiltin("glancing"));
        const auto all = bench.session.timeline().collisions();
        const MomentumDrawing d =
            momentumDrawing(bench.session.scene(), all, 0, bench.appearance, QSizeF(480, 360));
        QVERIFY(d.scale > 0);
        for (const FigureLabel& label : d.canvas.labels())
            QVERIFY(QRectF(0, 0, 480, 360).contains(label.place));
        const PassSums sums = sumsOf(all.subspan(0, 1));
        const OwnSums own = ownSums(bench.session.scene(), bench.session.timeline(), justBefore(all[0].time));
        QVERIFY(near(sums.momentumBefore.x, own.px) && near(sums.momentumAfter.x, own.px));
        QVERIFY(near(sums.momentumBefore.y, own.py) && near(sums.momentumAfter.y, own.py));
    }

    void longRunsAreBounded() {
        LongRunBench bench(smallChapters(2000), gasScene(100), 20);
        QVERIFY(bench.count() > 4000);
        TablesPanel panel(bench.context);
        showPanel(panel, {560, 600});
        panel.choose(View::Impulses);
        const auto* impulses = panel.findChild<ImpulsePage*>();
        QVERIFY(impulses->shown().size() <= ImpulsePage::mostBars + 1);
        QVERIFY(impulses->shown().size() > 100);
        QVERIFY(message(panel, "impulseNote").contains("2000"));
        bench.playhead.selectNumber(2501);
        const auto open = bench.playhead.selected();
        QVERIFY(open);
        QVERIFY(std::binary_search(impulses->shown().begin(), impulses->shown().end(), *open));
        panel.choose(View::Course);
        const auto* course = panel.findChild<CoursePage*>();
        QVERIFY(course->shown().moments.size() <= CoursePage::mostMoments);
        QVERIFY(course->shown().moments.front().time >= bench.session.part().from);
        QVERIFY(course->shown().moments.back().time <= bench.session.part().to);
        QVERIFY(message(panel, "courseNote").contains("2001"));
    }

    void everythingFits_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<bool>("projector");
        QTest::addColumn<bool>("korean");
        for (const bool korean : {false, true}) {
            for (const int width : {344, 480, 560})
                QTest::addRow("%d %s", width, korean ? "ko" : "en") << width << false << korean;
            for (const int width : {480, 560})
                QTest::addRow("%d projector %s", width, korean ? "ko" : "en") << width << true << korean;
        }
    }
    void everythingFits() {
        QFETCH(int, width);
        QFETCH(bool, projector);
        QFETCH(bool, korean);
        useLanguage(m_language, korean);
        PanelBench bench;
        bench.appearance.setProjector(projector);
        QVERIFY(bench.session.openBuiltin("glancing"));
        TablesPanel panel(bench.context);
        showPanel(panel, {width, 760});
        bench.playhead.select(0);
        for (int view = 0; view < TablesPanel::viewCount; ++view) {
            panel.choose(View(view));
            QCoreApplication::processEvents();
            QTest::qWait(0);
            if (view != int(View::Bodies)) // it scrolls
                QCOMPARE(clipped(panel), QString());
        }
        for (const auto* button : panel.findChildren<QAbstractButton*>())
            if (button->isVisible())
                QVERIFY2(button->height() >= (projector ? 36 : 24), qPrintable(button->objectName()));
    }
};

QTEST_MAIN(TestTables)
#include "test_tables.moc"

// The painted plot: where points lie, what is drawn there, and what the mouse finds.
#include "core/study/study.h"
#include "ui/plot/plot_layout.h"
#include "ui/plot/plot_view.h"
#include "ui/plot/study_plot.h"
#include "ui/words/language.h"

#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace thetalane;

namespace {

PlotStyle styleOf(int pixels = 14) {
    PlotStyle style;
    style.font.setPixelSize(pixels);
    style.locale = QLocale(QLocale::English);
    return style;
}

Plot decades() {
    Plot plot;
    plot.x = {"cost", true, {}, {}};
    plot.y = {"error", true, {}, {}};
    plot.series.push_back({"blue",
                           QColor("#0072B2"),
                           Qt::SolidLine,
                           Marker::Circle,
                           {{1, 1e-12, "a"}, {10, 1e-6, "b"}, {1000, 1, "c"}}});
    plot.series.push_back({"red", QColor("#D55E00"), Qt::DashLine, Marker::Square, {{100, 1e-3, "d"}}});
    return plot;
}

QImage painted(const Plot& plot, QSize size, const PlotStyle& style) {
    QImage image(size, QImage::Format_RGB32);
    QPainter painter(&image);
    paintPlot(painter, image.rect(), plot, style);
    return image;
}

int pixelsLike(const QImage& image, const QRectF& where, const QColor& colour) {
    int count = 0;
    const QRect area = where.toAlignedRect().intersected(image.rect());
    for (int y = area.top(); y <= area.bottom(); ++y)
        for (int x = area.left(); x <= area.right(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                         std::abs(c.blue() - colour.blue()) <
                     30;
        }
    return count;
}

MethodResult measured(const Method& method, double cost, double error) {
    MethodResult r;
    r.method = method;
    r.state = MethodState::Measured;
    r.cases = 10;
    r.costRounds = 3;
    r.cost = {cost * 0.9, cost, cost * 1.1};
    r.errors.back() = {error, error, error};
    r.sameTouched = 0.5;
    return r;
}

StudyResult aStudy() {
    StudyResult result;
    result.truth = referenceMethod();
    result.methods = {measured(eventMethod(), 5, 1e-14), measured(referenceMethod(), 900, 0),
                      measured(steppedMethod(0.001, false), 500, 3),
                      measured(steppedMethod(0.01, false), 50, 5), measured(sweptMethod(0.01, 1), 60, 0.5)};
    MethodResult waiting;
    waiting.method = sweptMethod(0.001, 1);
    result.methods.push_back(waiting);
    return result;
}

} // namespace

class TestPlot : public QObject {
    Q_OBJECT

private slots:
    void decadesAreEvenlyApart() {
        const PlotLayout layout(QRectF(0, 0, 600, 400), decades(), styleOf());
        const double step = layout.xOf(10) - layout.xOf(1);
        QVERIFY(step > 20);
        QVERIFY(std::abs(layout.xOf(1000) - layout.xOf(1) - 3 * step) < 1e-9);
        QVERIFY(layout.yOf(1e-12) > layout.yOf(1)); // up is more
        for (const PlotSeries& s : decades().series)
            for (const PlotPoint& p : s.points)
                QVERIFY(layout.frame.contains(layout.at(p)));
    }

    void ticksAreRoundAndLabelled() {
        Plot plot = decades();
        const PlotLayout log(QRectF(0, 0, 600, 400), plot, styleOf());
        QStringList labels;
        for (const PlotTick& t : log.x.ticks())
            if (!t.label.isEmpty())
                labels << t.label;
        QVERIFY2(labels.contains("1") && labels.contains("1,000"), qPrintable(labels.join(' ')));
        int y = 0;
        for (const PlotTick& t : log.y.ticks())
            y += !t.label.isEmpty();
        QVERIFY(y >= 4 && y <= 10);

        plot.x.logarithmic = false;
        const PlotLayout even(QRectF(0, 0, 600, 400), plot, styleOf());
        for (const PlotTick& t : even.x.ticks())
            QVERIFY(std::fmod(std::abs(t.value) + 1e-9, 100) < 1e-6);
    }

    void pointsArePaintedInTheirColour() {
        const QSize size(600, 400);
        const QImage image = painted(decades(), size, styleOf());
        const PlotLayout layout(QRectF(QPointF(), size), decades(), styleOf());
        for (const PlotSeries& s : decades().series)
            for (const PlotPoint& p : s.points) {
                const QPointF at = layout.at(p);
                QVERIFY(pixelsLike(image, QRectF(at.x() - 3, at.y() - 3, 6, 6), s.colour) >= 12);
            }
        // The line between the first two, and the legend.
        const QPointF middle =
            (layout.at(decades().series[0].points[0]) + layout.at(decades().series[0].points[1])) / 2;
        QVERIFY(pixelsLike(image, QRectF(middle.x() - 3, middle.y() - 3, 6, 6), QColor("#0072B2")) > 0);
        QCOMPARE(int(layout.legend.size()), 2);
    }

    void whatALogarithmCannotShowStandsAtTheEdge() {
        Plot plot = decades();
        plot.series[0].points.push_back({10, 0, {}});
        plot.series[0].points.push_back({10, std::nan(""), {}});
        const PlotLayout layout(QRectF(0, 0, 600, 400), plot, styleOf());
        QCOMPARE(layout.yOf(0), layout.frame.bottom());
        (void)painted(plot, {600, 400}, styleOf());
        for (const QSize tiny : {QSize(1, 1), QSize(40, 30), QSize(2000, 20)})
            (void)painted(plot, tiny, styleOf(40));
        (void)painted(Plot(), {300, 200}, styleOf());
    }

    void theMouseFindsTheNearestPoint() {
        const QRectF area(0, 0, 600, 400);
        const PlotLayout layout(area, decades(), styleOf());
        const QPointF at = layout.at(decades().series[1].points[0]);
        const auto hit = plotPointAt(at + QPointF(3, -2), 10, area, decades(), styleOf());
        QVERIFY(hit && hit->series == 1 && hit->point == 0);
        QVERIFY(!plotPointAt(at + QPointF(40, 40), 10, area, decades(), styleOf()));
    }

    void aViewLightsAndPicks() {
        PlotView view;
        view.resize(600, 400);
        view.setPlot(decades());
        view.setStyle(styleOf());
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        QSignalSpy pointed(&view, &PlotView::pointed), picked(&view, &PlotView::picked);
        const PlotLayout layout(view.rect(), decades(), styleOf());
        const QPoint at = layout.at(decades().series[0].points[1]).toPoint();
        QTest::mouseMove(&view, at);
        QCOMPARE(pointed.count(), 1);
        QCOMPARE(pointed[0][0].value<std::size_t>(), std::size_t(0));
        QCOMPARE(pointed[0][1].value<std::size_t>(), std::size_t(1));
        QTest::mouseClick(&view, Qt::LeftButton, {}, at);
        QCOMPARE(picked.count(), 1);
        QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(2, 2));
        QCOMPARE(picked.count(), 1);
        view.setPlot(Plot());
        QVERIFY(!view.lit());
    }

    void aStudyIsAWorkPrecisionDiagram_data() {
        QTest::addColumn<int>("language");
        QTest::addColumn<QString>("word");
        QTest::addRow("en") << int(Language::Code::English) << "error";
        QTest::addRow("ko") << int(Language::Code::Korean) << QString::fromUtf8("오차");
    }
    void aStudyIsAWorkPrecisionDiagram() {
        QFETCH(int, language);
        QFETCH(QString, word);
        Language words;
        words.use(Language::Code(language));
        const StudyResult study = aStudy();
        const Plot plot = workPrecisionPlot(study, "title", true);
        QVERIFY2(plot.y.title.contains(word), qPrintable(plot.y.title));
        QCOMPARE(int(plot.series.size()), 3); // a family each; neither the truth nor who waits
        QCOMPARE(int(plot.series[1].points.size()), 2);
        QVERIFY(plot.series[1].points[0].x < plot.series[1].points[1].x); // from the cheapest
        QCOMPARE(methodOfPoint(study, 1, 0), std::size_t(3));
        for (std::size_t a = 0; a < plot.series.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                QVERIFY(plot.series[a].colour != plot.series[b].colour);
                QVERIFY(plot.series[a].line != plot.series[b].line);
                QVERIFY(plot.series[a].marker != plot.series[b].marker);
            }
        words.use(Language::Code::English);
    }
};

QTEST_MAIN(TestPlot)
#include "test_plot.moc"

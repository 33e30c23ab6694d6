// What the lane shows after painting parts of it is what painting all of it shows.
#include "panel_bench.h"
#include "ui/aim/aim_tool.h"
#include "ui/lane/changes.h"
#include "ui/lane/lane_panel.h"
#include "ui/lane/lane_view.h"

#include <QRandomGenerator>
#include <QScreen>

#include <algorithm>

using namespace thetalane;

namespace {

struct Room : PanelBench {
    LanePanel panel{context};
    AimTool aim{context};

    Room() {
        appearance.setReducedMotion(true);
        session.openBuiltin("bowling");
        panel.addTool(aim);
        showPanel(panel, {700, 600});
    }
    void settle() {
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
    }
    // Beyond a rounding of colours, where Qt cuts a stroke at the edge of a part.
    int differing() {
        settle();
        const QImage shown =
            panel.screen()->grabWindow(panel.winId()).toImage().convertToFormat(QImage::Format_RGB32);
        const QImage anew = panel.grab().toImage().convertToFormat(QImage::Format_RGB32);
        int count = 0;
        for (int y = 0; y < anew.height(); ++y)
            for (int x = 0; x < anew.width(); ++x) {
                const QRgb a = shown.pixel(x, y), b = anew.pixel(x, y);
                const int most = std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)),
                                           std::abs(qBlue(a) - qBlue(b))});
                count += most > 24;
            }
        return count;
    }
    void drag(AimPart part, QRandomGenerator& random) {
        QWidget* port = panel.view().viewport();
        const Vec2d place = placeOf(part, *session.currentThrow());
        const QPoint at =
            panel.view().viewportTransform().map(QPointF(place.x * 1000, -place.y * 1000)).toPoint();
        if (!port->rect().contains(at))
            return;
        QTest::mousePress(port, Qt::LeftButton, {}, at);
        for (int k = 0; k < 4; ++k) {
            QTest::mouseMove(port, at + QPoint(random.bounded(-20, 20), random.bounded(-20, 20)));
            settle();
        }
        QTest::mouseRelease(port, Qt::LeftButton, {}, at);
    }
};

} // namespace

class TestChanges : public QObject {
    Q_OBJECT

private slots:
    // Only the tiles that a stroke came to, left or touches otherwise; nothing while all is as it was.
    void onlyWhatChangedIsFound() {
        QWidget widget;
        widget.resize(640, 320);
        Changes changes;
        const auto stroke = [&](const QPointF& at, const QColor& colour) {
            return changes.found(widget, [&](QPainter& painter) {
                painter.setPen(Qt::NoPen);
                painter.setBrush(colour);
                painter.drawEllipse(at, 5, 5);
                painter.drawEllipse(QPointF(600, 300), 5, 5);
            });
        };
        constexpr int tile = Changes::tile;
        const QRect first(0, 0, tile, tile), second(tile * 10, tile * 5, tile, tile);
        QCOMPARE(stroke({16, 16}, Qt::red), QRegion(widget.rect()));
        QVERIFY(stroke({16, 16}, Qt::red).isEmpty());
        QCOMPARE(stroke({16, 16}, Qt::blue).boundingRect() & first, first);
        const QRegion moved = stroke(second.center(), Qt::blue);
        QVERIFY(moved.contains(first.center()) && moved.contains(second.center()));
        QVERIFY(!moved.contains(QPoint(600, 300)));
        changes.forget(QRegion(600, 300, 1, 1));
        QVERIFY(stroke(second.center(), Qt::blue).contains(QPoint(600, 300)));
    }

    void partsAreTheWhole() {
        Room room;
        QRandomGenerator random(7);
        QCOMPARE(room.differing(), 0);
        for (int k = 0; k < 60; ++k) {
            const int what = random.bounded(9);
            switch (what) {
            case 0:
                room.panel.view().showFoulLine();
                break;
            case 1:
                room.panel.view().setFollowing(random.bounded(2));
                break;
            case 2:
                room.playhead.setTime(random.bounded(3.0));
                break;
            case 3:
                for (int frame = 0; frame < 4; ++frame, room.settle())
                    room.playhead.advance(1.0 / 60);
                break;
            case 4:
                room.playhead.stepCollisions(random.bounded(2) ? 1 : -1);
                break;
            case 5:
                room.playhead.stepStage(1);
                break;
            case 6:
                QTest::mouseMove(room.panel.view().viewport(),
                                 QPoint(random.bounded(500), random.bounded(500)));
                break;
            case 7:
                room.appearance.setDark(random.bounded(2));
                break;
            default:
                room.playhead.setTime(0);
                room.settle();
                room.drag(AimPart(random.bounded(aimPartCount)), random);
            }
            QVERIFY2(room.differing() == 0, qPrintable(QString("step %1, of kind %2").arg(k).arg(what)));
        }
    }
};

QTEST_MAIN(TestChanges)
#include "test_changes.moc"

// What the tests of editing share: the lane with its tool, the panel, and the desk that keeps what they do.
#pragma once

#include "core/format/scene_file.h"
#include "tests/ui/panel_bench.h"
#include "ui/bench/desk.h"
#include "ui/bench/edit_tool.h"
#include "ui/lane/lane_panel.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_view.h"
#include "ui/panels/bodies_panel.h"
#include "ui/panels/value_slider.h"

#include <QCheckBox>
#include <QTemporaryDir>

namespace thetalane {

inline constexpr std::size_t A = 0, B = 1; // the paper's two balls

struct EditBench : PanelBench {
    Desk desk{session};
    EditOptions options;
    LanePanel lane{context};
    EditTool tool{context, lane, options};
    BodiesPanel panel{context, options};

    explicit EditBench(const Scene& scene = *builtinScene()) {
        session.open(scene);
        appearance.setReducedMotion(true);
        lane.view().addTool(tool);
        showPanel(lane, {900, 600});
        showPanel(panel, {344, 700});
        QCoreApplication::processEvents();
    }
    static std::optional<Scene> builtinScene() {
        Session s;
        s.openBuiltin("two-balls");
        return s.scene();
    }

    const Body& body(std::size_t i) const { return session.scene().bodies[i]; }
    QByteArray bytes() const { return writeScene(session.scene()); }

    QPoint pixel(Vec2d metres) { return lane.view().viewportTransform().map(toUnits(metres)).toPoint(); }
    double metresPerPixel() { return 1 / (lane.view().viewportTransform().m11() * unitsPerMetre); }
    Vec2d tip(std::size_t i) {
        const Body& b = body(i);
        const double speed = norm(b.velocity);
        return b.position + b.velocity * ((b.radius + speed * lane.scene().metresPerSpeed()) / speed);
    }
    void press(Vec2d at) { QTest::mousePress(lane.view().viewport(), Qt::LeftButton, {}, pixel(at)); }
    void move(Vec2d to) { QTest::mouseMove(lane.view().viewport(), pixel(to)); }
    void release(Vec2d at) { QTest::mouseRelease(lane.view().viewport(), Qt::LeftButton, {}, pixel(at)); }
    void drag(Vec2d from, Vec2d to) {
        press(from);
        move((from + to) * 0.5);
        move(to);
        release(to);
        QCoreApplication::processEvents();
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&lane.view(), key, modifiers);
    }
    void slide(const char* name, double from, double to) {
        auto* slider = panel.findChild<ValueSlider*>(QLatin1String(name));
        QVERIFY2(slider, name);
        const int middle = slider->height() / 2;
        QTest::mousePress(slider, Qt::LeftButton, {}, {slider->xOf(from), middle});
        for (int k = 1; k <= 5; ++k)
            QTest::mouseMove(slider, {slider->xOf(from + (to - from) * k / 5), middle});
        QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->xOf(to), middle});
        QCoreApplication::processEvents();
    }
    void check(const char* name) {
        auto* box = panel.findChild<QCheckBox*>(QLatin1String(name));
        QVERIFY2(box, name);
        QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        QCoreApplication::processEvents();
    }
};

// A test program with settings of its own.
template <class Test>
int runWithOwnSettings(int argc, char** argv, int (*other)(const QStringList&) = nullptr) {
    QTemporaryDir settings;
    qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
    QApplication app(argc, argv);
    QCoreApplication::setOrganizationName("ThetaLane");
    QCoreApplication::setApplicationName("ThetaLane tests");
    const QStringList arguments = QCoreApplication::arguments();
    if (other && arguments.size() == 3 && arguments[1].startsWith("--"))
        return other(arguments.mid(1));
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace thetalane

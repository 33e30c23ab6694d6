// Where the focus is can be seen: on everything the Tab key reaches, in every room, light and dark.
#include "tests/ui/whole_program.h"

#include <QApplication>
#include <QScrollArea>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

struct Program : WholeProgram {
    explicit Program(bool dark)
        : WholeProgram(Language::Code::Korean) {
        appearance.setDark(dark);
    }
};

// Around a widget, with the frame that a neighbour may draw for it.
QImage seen(QWidget& window, const QWidget& widget) {
    QCoreApplication::processEvents();
    constexpr int around = 6;
    const QRect place(widget.mapTo(&window, QPoint()), widget.size());
    return window.grab(place.adjusted(-around, -around, around, around)).toImage();
}

int pixelsThatDiffer(const QImage& a, const QImage& b) {
    constexpr int noticeable = 8; // of 255
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > noticeable;
    return count;
}

// What Tab reaches in a panel. The cards of the steps are no field: the arrow keys move a stage that is
// marked.
std::vector<QWidget*> stopsIn(const QWidget& panel) {
    std::vector<QWidget*> stops;
    for (QWidget* w : panel.findChildren<QWidget*>())
        if (w->isVisible() && w->isEnabled() && (w->focusPolicy() & Qt::TabFocus) && !w->focusProxy() &&
            w->objectName() != "stepPanel")
            stops.push_back(w);
    return stops;
}

} // namespace

class TestFocus : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { keepSettingsIn(m_settings, "ThetaLaneFocus"); }

    void theFocusIsSeen_data() {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<int>("room");
        QTest::addColumn<bool>("dark");
        for (const auto& [scene, room] :
             {std::pair{"two-balls", Room::Attributes}, std::pair{"bowling", Room::Attributes},
              std::pair{"two-balls", Room::Collisions}, std::pair{"two-balls", Room::Game},
              std::pair{"bowling", Room::Chain}, std::pair{"rack", Room::Map},
              std::pair{"bowling", Room::Practice}, std::pair{"two-balls", Room::Accuracy}})
            for (const bool dark : {false, true})
                QTest::addRow("%s: %s, %s", dark ? "dark" : "light", scene, roomIds[std::size_t(room)].data())
                    << scene << int(room) << dark;
    }

    void theFocusIsSeen() {
        QFETCH(QString, scene);
        QFETCH(int, room);
        QFETCH(bool, dark);
        Program p(dark);
        QVERIFY(p.session.openBuiltin(scene));
        p.window.enter(Room(room));
        QCoreApplication::processEvents();
        const auto stops = stopsIn(*p.rail().panel(Room(room)));
        QVERIFY(!stops.empty());
        for (QWidget* stop : stops) {
            for (QWidget* up = stop->parentWidget(); up; up = up->parentWidget())
                if (auto* scroll = qobject_cast<QScrollArea*>(up))
                    scroll->ensureWidgetVisible(stop, 8, 8);
            if (QApplication::focusWidget())
                QApplication::focusWidget()->clearFocus();
            const QImage without = seen(p.window, *stop);
            stop->setFocus(Qt::TabFocusReason);
            const QImage with = seen(p.window, *stop);
            if (with.size() == without.size()) // else it moved: that is seen
                QVERIFY2(pixelsThatDiffer(with, without) >= 30,
                         qPrintable(QString(stop->metaObject()->className()) + ' ' + stop->objectName()));
        }
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestFocus)
#include "test_focus.moc"

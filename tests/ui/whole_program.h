// The whole program for a test: as main() puts it together, with settings and files of the test's own.
#pragma once

#include "ui/rail/rail.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

namespace thetalane::testing {

struct WholeProgram {
    Language language;
    Session session;
    Appearance appearance;
    Playhead playhead{session};
    MainWindow window;

    explicit WholeProgram(Language::Code code, QSize size = {1280, 800})
        : window(Context{session, playhead, appearance}, useFirst(language, code)) {
        appearance.setReducedMotion(true);
        window.resize(size);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.activateWindow();
        QTRY_VERIFY(window.isActiveWindow());
        QCoreApplication::processEvents();
    }
    Rail& rail() { return *window.findChild<Rail*>("rail"); }

private:
    static Language& useFirst(Language& language, Language::Code code) {
        language.use(code);
        return language;
    }
};

// Nothing is kept among the user's.
inline void keepSettingsIn(const QTemporaryDir& folder, const char* test) {
    QVERIFY(folder.isValid());
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("ThetaLaneTest");
    QCoreApplication::setApplicationName(test);
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
}

} // namespace thetalane::testing

// What the tests of the panels share: one of everything, in a language, and hands that type and click.
#pragma once

#include "ui/context.h"
#include "ui/words/language.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

namespace thetalane {

struct PanelBench {
    explicit PanelBench(const Session::Limits& limits = {})
        : session(limits) {}

    Session session;
    Playhead playhead{session};
    Appearance appearance;
    Context context{session, playhead, appearance};
};

// Every test function runs once in each language.
inline void addLanguages() {
    QTest::addColumn<bool>("korean");
    QTest::newRow("English") << false;
    QTest::newRow("Korean") << true;
}

inline void useLanguage(Language& language, bool korean) {
    language.use(korean ? Language::Code::Korean : Language::Code::English);
    QCoreApplication::processEvents();
}

inline void showPanel(QWidget& panel, QSize size) {
    panel.resize(size);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    panel.activateWindow();
    QCoreApplication::processEvents();
}

inline void click(QWidget& panel, const char* name) {
    auto* button = panel.findChild<QAbstractButton*>(QLatin1String(name));
    QVERIFY2(button, name);
    QVERIFY2(button->isEnabled(), name);
    QTest::mouseClick(button, Qt::LeftButton);
}

inline QLineEdit& field(QWidget& panel, const QString& name) {
    auto* edit = panel.findChild<QLineEdit*>(name);
    if (!edit)
        qFatal("no field %s", qPrintable(name));
    return *edit;
}

inline void type(QWidget& panel, const QString& name, const QString& text) {
    QLineEdit& edit = field(panel, name);
    edit.setFocus();
    QTest::keyClick(&edit, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(&edit, Qt::Key_Delete);
    QTest::keyClicks(&edit, QString(text).replace(QChar(0x2212), u'-')); // what a keyboard has
    QTest::keyClick(&edit, Qt::Key_Return);
}

inline QString message(QWidget& panel, const QString& name) {
    auto* label = panel.findChild<QLabel*>(name);
    return label && label->isVisible() ? label->text() : QString();
}

} // namespace thetalane

#include "ui/words/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace thetalane {

Language::Language(QObject* parent)
    : QObject(parent) {}

void Language::use(Code code) {
    m_code = code;
    QCoreApplication::removeTranslator(&m_qt);
    QCoreApplication::removeTranslator(&m_own);
    QLocale::setDefault(code == Code::Korean ? QLocale(QLocale::Korean) : QLocale(QLocale::English));
    const QString name = toString(code);
    if (m_qt.load("qtbase_" + name, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    if (m_own.load("thetalane_" + name, ":/i18n"))
        QCoreApplication::installTranslator(&m_own);
    emit changed(code);
}

Language::Code Language::ofSystem() {
    return QLocale::system().language() == QLocale::Korean ? Code::Korean : Code::English;
}

bool Language::parse(const QString& text, Code& code) {
    if (text != "ko" && text != "en")
        return false;
    code = text == "ko" ? Code::Korean : Code::English;
    return true;
}

QString Language::toString(Code code) {
    return code == Code::Korean ? "ko" : "en";
}

} // namespace thetalane

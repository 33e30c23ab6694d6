// The language of everything a person reads, switched while running.
#pragma once

#include <QObject>
#include <QString>
#include <QTranslator>

namespace thetalane {

// One for the program, made after QCoreApplication. use() installs the translators, and Qt sends
// LanguageChange to every widget.
class Language : public QObject {
    Q_OBJECT
public:
    enum class Code { English, Korean };

    explicit Language(QObject* parent = nullptr);

    Code code() const { return m_code; }
    void use(Code code);

    static Code ofSystem();
    static bool parse(const QString& text, Code& code); // "ko", "en"
    static QString toString(Code code);

signals:
    void changed(thetalane::Language::Code code);

private:
    Code m_code = Code::English;
    QTranslator m_own;
    QTranslator m_qt;
};

} // namespace thetalane

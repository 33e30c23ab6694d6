#include "app/options.h"

#include "ui/words/number_text.h"

#include "app/console.h"
#include "app/text_table.h"
#include "core/format/nearest.h"

#include <QCoreApplication>
#include <QLocale>

#include <charconv>
#include <cmath>

namespace thetalane {
namespace {

struct OptionsText {
    Q_DECLARE_TR_FUNCTIONS(OptionsText)
};

QString digits(double value) {
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

bool inside(double v, const Range& r) {
    return (r.lowOpen ? v > r.low : v >= r.low) && (r.highOpen ? v < r.high : v <= r.high);
}

QString outsideText(double v, const Range& r) {
    if (std::isinf(r.high) && !r.lowOpen)
        return OptionsText::tr("must be at least %1, is %2").arg(digits(r.low), digits(v));
    if (std::isinf(r.high))
        return OptionsText::tr("must be greater than %1, is %2").arg(digits(r.low), digits(v));
    if (!r.lowOpen)
        return OptionsText::tr("must be from %1 to %2, is %3").arg(digits(r.low), digits(r.high), digits(v));
    if (!r.highOpen)
        return OptionsText::tr("must be greater than %1 and at most %2, is %3")
            .arg(digits(r.low), digits(r.high), digits(v));
    return OptionsText::tr("must be greater than %1 and less than %2, is %3")
        .arg(digits(r.low), digits(r.high), digits(v));
}

} // namespace

QString didYouMean(const QString& word, std::span<const std::string_view> known) {
    const std::string near = nearest(word.toStdString(), known);
    return near.empty() ? QString()
                        : OptionsText::tr("did you mean \"%1\"?").arg(QString::fromStdString(near));
}

Arguments::Arguments(const QString& usage, const QString& description)
    : m_usage(usage)
    , m_description(description.left(1).toUpper() + description.mid(1)) {
    m_parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    m_parser.addOption(QCommandLineOption("language", QString(), "ko|en"));
    m_parser.addOption(QCommandLineOption(QStringList{"h", "help"}));
    m_names << "language"
            << "help";
}

void Arguments::takesOne(const QString& name, const QString& description) {
    m_positionals.append({name, description});
}

void Arguments::takesFlag(const QString& name, const QString& description) {
    m_parser.addOption(QCommandLineOption(name));
    m_options.append({"--" + name, description});
    m_names << name;
    m_flags << name;
}

void Arguments::takesValue(const QString& name, const QString& valueName, const QString& description) {
    m_parser.addOption(QCommandLineOption(name, QString(), valueName));
    m_options.append({"--" + name + ' ' + valueName, description});
    m_names << name;
}

std::optional<int> Arguments::read(const QStringList& arguments) {
    // The parser takes the first for the program's name.
    const bool understood = m_parser.parse(QStringList{"thetalane"} + arguments);
    if (m_parser.isSet("help")) {
        print(help());
        return finishOutput();
    }
    if (const auto fault = firstFault())
        return wrongCall(*fault);
    if (!understood)
        return wrongCall(valueFault(arguments));
    return std::nullopt;
}

std::optional<QString> Arguments::firstFault() const {
    const QStringList unknown = m_parser.unknownOptionNames();
    if (!unknown.isEmpty())
        return unknownOption(unknown.first());
    const QStringList given = m_parser.positionalArguments();
    if (given.size() < m_positionals.size())
        return OptionsText::tr("%1 is missing; the call is: thetalane %2")
            .arg(m_positionals[given.size()].name, m_usage);
    if (given.size() > m_positionals.size())
        return OptionsText::tr("%1: one argument too many; the call is: thetalane %2")
            .arg(given[m_positionals.size()], m_usage);
    return std::nullopt;
}

// All that the parser minds besides: an option without its value, a flag with one.
QString Arguments::valueFault(const QStringList& arguments) const {
    for (const QString& argument : arguments)
        if (m_flags.contains(argument.section('=', 0, 0).remove(0, 2)) && argument.contains('='))
            return OptionsText::tr("%1: takes no value").arg(argument.section('=', 0, 0));
    return OptionsText::tr("%1: needs a value").arg(arguments.value(arguments.size() - 1));
}

QString Arguments::unknownOption(const QString& name) const {
    std::vector<std::string> names;
    for (const QString& known : m_names)
        names.push_back(known.toStdString());
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string near = nearest(name.toStdString(), views);
    const QString dashed = (name.size() == 1 ? "-" : "--") + name;
    if (!near.empty())
        return OptionsText::tr("%1: there is no such option; did you mean --%2?")
            .arg(dashed, QString::fromStdString(near));
    const QString command = m_usage.section(' ', 0, 0);
    return OptionsText::tr("%1: there is no such option; thetalane %2--help lists them")
        .arg(dashed, command.isEmpty() || command.startsWith('[') ? QString() : command + ' ');
}

double Arguments::number(const QString& option, double unlessSaid, const Range& range) {
    if (!has(option))
        return unlessSaid;
    const auto parsed = parseNumber(value(option));
    if (!parsed)
        note("--" + option + ": " + OptionsText::tr("must be a number, is \"%1\"").arg(value(option)));
    else if (!inside(*parsed, range))
        note("--" + option + ": " + outsideText(*parsed, range));
    return parsed.value_or(unlessSaid);
}

qint64 Arguments::count(const QString& option, qint64 unlessSaid) {
    if (!has(option))
        return unlessSaid;
    bool whole = false;
    const qint64 parsed = value(option).toLongLong(&whole);
    if (!whole || parsed < 1)
        note("--" + option + ": " +
             OptionsText::tr("must be a whole number greater than 0, is \"%1\"").arg(value(option)));
    return parsed;
}

int Arguments::choice(const QString& option, int unlessSaid, std::span<const std::string_view> words) {
    if (!has(option))
        return unlessSaid;
    QStringList allowed;
    for (const std::string_view word : words) {
        allowed << QString::fromUtf8(word.data(), qsizetype(word.size()));
        if (allowed.last() == value(option))
            return int(allowed.size()) - 1;
    }
    note("--" + option + ": " +
         OptionsText::tr("must be one of %1, is \"%2\"").arg(allowed.join(", "), value(option)));
    return unlessSaid;
}

void Arguments::note(const QString& fault) {
    if (m_fault.isEmpty())
        m_fault = fault;
}

std::optional<int> Arguments::faults() const {
    if (m_fault.isEmpty())
        return std::nullopt;
    return wrongCall(m_fault);
}

QString Arguments::help() const {
    QString text = OptionsText::tr("Usage: thetalane %1").arg(m_usage) + "\n\n" + m_description + "\n";
    const QList<Described> options =
        m_options +
        QList<Described>{{"--language ko|en",
                          OptionsText::tr("the language of what is printed; the system's unless said")},
                         {"--help", OptionsText::tr("prints this")}};
    for (const auto* list : {&m_positionals, &options}) {
        QList<QStringList> rows;
        for (const Described& d : *list)
            rows << QStringList{"  " + d.name, d.description};
        text += rows.isEmpty() ? QString() : '\n' + tableText(rows);
    }
    return text;
}

} // namespace thetalane

// The arguments of one command: declared, read strictly, and described by --help. Faults are noted and told
// once, so that a command reads its options one after the other without a branch between.
#pragma once

#include <QCommandLineParser>
#include <QList>
#include <QString>
#include <QStringList>

#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace thetalane {

// Which numbers an option takes; an open end is not taken itself.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool lowOpen = true;
    bool highOpen = true;
};
inline constexpr Range anyNumber{};
inline constexpr Range positive{.low = 0};

class Arguments {
public:
    // usage: what follows the program's name, "run SCENE".
    Arguments(const QString& usage, const QString& description);

    void takesOne(const QString& name, const QString& description); // a positional argument, required
    void takesFlag(const QString& name, const QString& description);
    void takesValue(const QString& name, const QString& valueName, const QString& description);

    // Empty when the command may go on; else the status to leave with: help was asked for, or the call is
    // wrong.
    std::optional<int> read(const QStringList& arguments);

    bool has(const QString& option) const { return m_parser.isSet(option); }
    QString positional() const { return m_parser.positionalArguments().value(0); }
    QString value(const QString& option) const { return m_parser.value(option); }

    // The option's value, or what it is unless said. A value that will not do is noted.
    double number(const QString& option, double unlessSaid, const Range& range = anyNumber);
    qint64 count(const QString& option, qint64 unlessSaid); // a whole number from 1
    int choice(const QString& option, int unlessSaid, std::span<const std::string_view> words);

    void note(const QString& fault);   // only the first is told
    std::optional<int> faults() const; // the status to leave with, where there are any

    QString help() const;

private:
    struct Described {
        QString name;
        QString description;
    };
    std::optional<QString> firstFault() const;
    QString unknownOption(const QString& name) const;
    QString valueFault(const QStringList& arguments) const;

    QString m_usage;
    QString m_description;
    QCommandLineParser m_parser;
    QList<Described> m_positionals;
    QList<Described> m_options;
    QStringList m_names; // of all options
    QStringList m_flags; // of those without a value
    QString m_fault;
};

// " did you mean run?", or nothing where no known word is near.
QString didYouMean(const QString& word, std::span<const std::string_view> known);

} // namespace thetalane

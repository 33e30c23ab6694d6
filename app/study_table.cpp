// thetalane study --table FILE.csv: the measured table of the README.
#include "app/console.h"
#include "app/studies.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>
#include <QFile>
#include <QHash>

namespace thetalane {
namespace {

struct StudyTableText {
    Q_DECLARE_TR_FUNCTIONS(StudyTableText)
};

QStringList cellsOf(const QString& line) {
    QStringList cells{QString()};
    bool quoted = false;
    for (const QChar c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells << QString();
        else
            cells.last() += c;
    }
    return cells;
}

QString digits(const QString& cell, const char* unit = "") {
    return cell.isEmpty() ? QStringLiteral("–") : numberText(cell.toDouble(), 3) + unit;
}

class Csv {
public:
    explicit Csv(const QString& text) {
        const QStringList lines = text.split('\n', Qt::SkipEmptyParts);
        const QStringList names = lines.isEmpty() ? QStringList() : cellsOf(lines.first());
        for (qsizetype i = 0; i < names.size(); ++i)
            m_column[names[i]] = i;
        for (qsizetype i = 1; i < lines.size(); ++i)
            m_rows << cellsOf(lines[i]);
    }
    qsizetype rows() const { return m_rows.size(); }
    bool has(const QString& name) const { return m_column.contains(name); }
    QString at(qsizetype row, const QString& name) const {
        return m_column.contains(name) ? m_rows[row].value(m_column[name]) : QString();
    }

private:
    QHash<QString, qsizetype> m_column;
    QList<QStringList> m_rows;
};

// English as the README is, whatever the language.
QString methodOf(const Csv& csv, qsizetype row) {
    const QString engine = csv.at(row, "engine"), variant = csv.at(row, "variant");
    const QString precision = csv.at(row, "precision");
    QString name = engine == "event" ? "`event`, " + precision : '`' + engine + '`';
    if (!variant.isEmpty())
        name += ", " + QString(variant).replace('-', ' ').replace('+', ", ").replace('=', ' ');
    const double step = csv.at(row, "step_s").toDouble();
    if (step > 0)
        name += QString(", 1/%1 s").arg(QString::number(1 / step, 'f', 0));
    return name;
}

QString markdown(const Csv& csv) {
    QString text =
        "| method | µs a throw | middle half | ratio | same pins touched | error after 2 s, median | "
        "missed | repeated |\n|---|---:|---:|---:|---:|---:|---:|---:|\n";
    for (qsizetype row = 0; row < csv.rows(); ++row) {
        const QString same = csv.at(row, "same_pins_percent");
        const QString middle =
            csv.at(row, "cost_lower_us").isEmpty()
                ? QStringLiteral("–")
                : digits(csv.at(row, "cost_lower_us")) + "–" + digits(csv.at(row, "cost_upper_us"));
        text += "| " +
                QStringList{methodOf(csv, row),
                            digits(csv.at(row, "cost_us")),
                            middle,
                            digits(csv.at(row, "cost_ratio")),
                            same.isEmpty() ? "–" : QString::number(same.toDouble(), 'f', 2) + " %",
                            digits(csv.at(row, "error_m"), " m"),
                            digits(csv.at(row, "missed")),
                            digits(csv.at(row, "repeated"))}
                    .join(" | ") +
                " |\n";
    }
    if (csv.rows() > 0)
        text += QString("\nMeasured %1 on %2: `%3` (%4 cases, seed %5).\n")
                    .arg(csv.at(0, "date"), csv.at(0, "machine"), csv.at(0, "call"), csv.at(0, "cases"),
                         csv.at(0, "seed"));
    return text;
}

} // namespace

int studyTable(const QString& csvPath) {
    QFile file(csvPath);
    if (!file.open(QIODevice::ReadOnly))
        return wrongCall(
            StudyTableText::tr("%1: cannot be read: %2").arg(oneLine(csvPath), file.errorString()));
    constexpr qint64 most = 16 << 20;
    const Csv csv(QString::fromUtf8(file.read(most)));
    if (!csv.has("engine") || !csv.has("cost_us"))
        return wrongCall(
            StudyTableText::tr("%1: is not a table that thetalane study --csv wrote").arg(oneLine(csvPath)));
    print(markdown(csv));
    return finishOutput();
}

} // namespace thetalane

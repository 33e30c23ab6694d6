#include "ui/words/glossary.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <algorithm>
#include <array>

namespace thetalane {
namespace {

QJsonArray entries() {
    QFile file(QStringLiteral(":/words/glossary.json"));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).array() : QJsonArray();
}

QString other(const QString& language) {
    return language == "ko" ? QStringLiteral("en") : QStringLiteral("ko");
}

} // namespace

std::vector<GlossaryEntry> glossary(Language::Code language) {
    const QString code = Language::toString(language);
    std::vector<GlossaryEntry> all;
    for (const QJsonValue& value : entries()) {
        const QJsonObject own = value[code].toObject();
        all.push_back({value["id"].toString(), own["term"].toString(), value[other(code)]["term"].toString(),
                       own["text"].toString()});
    }
    return all;
}

const GlossaryEntry* glossaryEntry(const QString& id) {
    static const std::array both{glossary(Language::Code::English), glossary(Language::Code::Korean)};
    const auto& all = both[QLocale().language() == QLocale::Korean];
    const auto found = std::ranges::find(all, id, &GlossaryEntry::id);
    return found == all.end() ? nullptr : &*found;
}

} // namespace thetalane

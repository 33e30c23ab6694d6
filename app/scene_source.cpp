#include "app/scene_source.h"

#include "app/options.h"
#include "core/format/scene_file.h"
#include "core/scene/builtin.h"
#include "ui/words/scene_text.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <cstdio>
#include <vector>

namespace thetalane {
namespace {

struct SceneSourceText {
    Q_DECLARE_TR_FUNCTIONS(SceneSourceText)
};

QString nameHint(const QString& name) {
    std::vector<std::string_view> known;
    for (const BuiltinScene& scene : builtinScenes())
        known.push_back(scene.id);
    const QString near = didYouMean(name, known);
    const QString list = SceneSourceText::tr("thetalane scenes lists the built-in ones");
    return near.isEmpty() ? list : near + ' ' + list;
}

SceneError unreadable(const QString& reason) {
    return {.code = SceneErrorCode::Unreadable, .path = {}, .other = reason.toStdString()};
}

std::variant<QByteArray, SceneError> readAll(const QString& source) {
    QFile file(source);
    const bool opened =
        source == "-" ? file.open(fileno(stdin), QIODevice::ReadOnly) : file.open(QIODevice::ReadOnly);
    if (!opened)
        return unreadable(file.errorString());
    // One byte more than is allowed tells a file that never ends from one that just fits.
    QByteArray bytes;
    while (bytes.size() <= maxSceneFileSize) {
        const QByteArray piece = file.read(1 << 20);
        if (piece.isEmpty())
            break;
        bytes += piece;
    }
    if (file.error() != QFileDevice::NoError)
        return unreadable(file.errorString());
    if (bytes.size() > maxSceneFileSize)
        return unreadable(
            SceneSourceText::tr("it is larger than %1 MiB").arg(maxSceneFileSize / (1024 * 1024)));
    return bytes;
}

QString told(const QString& source, const std::vector<SceneError>& errors) {
    const QString name = source == "-" ? SceneSourceText::tr("standard input") : source;
    const QString first = name + ": " + sceneErrorText(errors.front());
    if (errors.size() == 1)
        return first;
    return SceneSourceText::tr("%1 (and %n more)", nullptr, int(errors.size()) - 1).arg(first);
}

} // namespace

bool isBuiltin(const QString& name) {
    return builtinScene(name.toStdString()).has_value();
}

std::variant<Scene, QString> loadBuiltin(const QString& name) {
    if (auto scene = builtinScene(name.toStdString()))
        return *scene;
    return SceneSourceText::tr("%1: there is no such built-in scene;").arg(name) + ' ' + nameHint(name);
}

std::variant<Scene, QString> loadScene(const QString& source) {
    if (auto scene = builtinScene(source.toStdString()))
        return *scene;
    if (source != "-" && !QFileInfo::exists(source))
        return SceneSourceText::tr("%1: there is no such scene or file;").arg(source) + ' ' +
               nameHint(source);
    auto bytes = readAll(source);
    if (auto* error = std::get_if<SceneError>(&bytes))
        return told(source, {*error});
    auto scene = readScene(std::get<QByteArray>(bytes));
    if (auto* errors = std::get_if<std::vector<SceneError>>(&scene))
        return told(source, *errors);
    return std::get<Scene>(std::move(scene));
}

void takeScene(Arguments& arguments) {
    arguments.takesOne("SCENE",
                       SceneSourceText::tr("a built-in name, a scene file, or - for standard input"));
}

} // namespace thetalane

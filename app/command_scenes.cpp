// thetalane scenes
#include "app/commands.h"
#include "app/console.h"
#include "app/options.h"
#include "app/text_table.h"
#include "core/scene/builtin.h"
#include "ui/words/scene_text.h"

namespace thetalane {

int scenesCommand(const Call& call) {
    Arguments a("scenes", commandSummary("scenes"));
    if (const auto status = a.read(call.arguments))
        return *status;
    QList<QStringList> rows;
    for (const BuiltinScene& scene : builtinScenes())
        rows << QStringList{QString::fromUtf8(scene.id.data(), qsizetype(scene.id.size())),
                            sceneTitle(scene.make(), call.language)};
    print(tableText(rows));
    return finishOutput();
}

} // namespace thetalane

// thetalane scene NAME
#include "app/commands.h"
#include "app/console.h"
#include "app/options.h"
#include "app/scene_source.h"
#include "core/format/scene_file.h"

#include <QCoreApplication>

namespace thetalane {

int sceneCommand(const Call& call) {
    Arguments a("scene NAME", commandSummary("scene"));
    a.takesOne("NAME",
               QCoreApplication::translate("SceneCommand", "a built-in name; thetalane scenes lists them"));
    if (const auto status = a.read(call.arguments))
        return *status;
    const auto scene = loadBuiltin(a.positional());
    if (const auto* fault = std::get_if<QString>(&scene))
        return wrongCall(*fault);
    standardOutput().write(writeScene(std::get<Scene>(scene)));
    return finishOutput();
}

} // namespace thetalane

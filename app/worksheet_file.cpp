#include "app/worksheet_file.h"

#include "app/off_screen.h"
#include "app/save_file.h"
#include "ui/worksheet/worksheet.h"

#include <QGuiApplication>

namespace thetalane {

int drawWorksheet(int& argc, char** argv, const WorksheetRequest& request) {
    drawOffScreen();
    const QGuiApplication app(argc, argv);
    Language language;
    language.use(request.language);
    return saveFile(request.output,
                    worksheetPdf({request.run.scene, request.run.timeline.collisions(), request.collision,
                                  std::int64_t(request.collision) + 1, request.language}));
}

} // namespace thetalane

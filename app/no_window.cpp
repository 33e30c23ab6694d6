// In place of window.cpp where the program is built without a window.
#include "app/console.h"
#include "app/map_picture.h"
#include "app/studies.h"
#include "app/window.h"
#include "app/worksheet_file.h"

#include <QCoreApplication>

namespace thetalane {

int runWindow(int&, char**, const WindowRequest&) {
    return failure(QCoreApplication::translate(
        "NoWindow", "this program was built without the window; thetalane --help lists the commands"));
}

int drawPicture(int&, char**, const PictureRequest&) {
    return failure(QCoreApplication::translate(
        "NoWindow", "picture: this program was built without the window, and cannot draw it"));
}

int drawMapPicture(int&, char**, const MapPictureRequest&) {
    return failure(QCoreApplication::translate(
        "NoWindow", "--picture: this program was built without the window, and cannot draw it"));
}

int drawWorksheet(int&, char**, const WorksheetRequest&) {
    return failure(QCoreApplication::translate(
        "NoWindow", "worksheet: this program was built without the window, and cannot draw it"));
}

int drawStudyPicture(int&, char**, const StudyPicture&) {
    return failure(QCoreApplication::translate(
        "NoWindow", "picture: this program was built without the window, and cannot draw it"));
}

} // namespace thetalane

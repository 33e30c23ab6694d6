// A strike map drawn into a file. Like the window it needs an application of its own: no other application
// object exists when it is called.
#pragma once

#include "core/study/strike_map.h"
#include "ui/words/language.h"

#include <QString>

namespace thetalane {

struct MapPictureRequest {
    StrikeMap map;
    QString output; // a .png
    Language::Code language = Language::Code::English;
};

int drawMapPicture(int& argc, char** argv, const MapPictureRequest& request);

} // namespace thetalane

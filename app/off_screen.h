// Pictures drawn where there is no display.
#pragma once

#include <QString>

class QImage;

namespace thetalane {

// Before the application is made: sizes are in pixels, whatever the screen; and standard error is for lines
// of ours, though Qt may have something to say about the session or fonts.
void drawOffScreen();

// As PNG, whole or not at all. The status to leave with; what went wrong is told.
int savePicture(const QString& path, const QImage& image);

} // namespace thetalane

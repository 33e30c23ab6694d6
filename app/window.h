// The program as a window, shown or drawn off screen. Both make a QApplication of their own: no other
// application object exists when they are called.
#pragma once

#include "core/scene/scene.h"
#include "ui/rail/rooms.h"
#include "ui/words/language.h"
#include "ui/words/worked_steps.h"

#include <QSize>
#include <QString>

#include <optional>

namespace thetalane {

// What the window opens with; the scene has been read and found sound.
struct WindowRequest {
    QString sceneId; // of a built-in scene; empty for one of a file
    std::optional<Scene> scene;
    std::optional<Language::Code> language; // default: as last time, or the system's
    bool projector = false;
    bool dark = false;
};

// Until the window is closed. Without a display: one line, and 1.
int runWindow(int& argc, char** argv, const WindowRequest& request);

struct PictureRequest {
    WindowRequest window;
    double at = 0;                        // [s]; what is later than the last moment shown shows that
    std::optional<std::size_t> collision; // from 0; there are that many
    Stage stage = Stage::Contact;
    std::optional<Room> room; // to be open
    QString game;             // a game's file to go on with; empty: none
    std::optional<int> lab;   // a question of the accuracy lab, from 0: measured, and open
    QSize size{1280, 800};
    QString output; // a .png
};

int drawPicture(int& argc, char** argv, const PictureRequest& request);

} // namespace thetalane

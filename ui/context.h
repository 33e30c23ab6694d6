// What every panel is given: intents go to the session and the playhead, values come back by their signals.
#pragma once

#include "ui/appearance.h"
#include "ui/playhead.h"
#include "ui/session.h"

namespace thetalane {

struct Context {
    Session& session;
    Playhead& playhead;
    Appearance& appearance;
};

} // namespace thetalane

// What in a view looks otherwise than it did, found by painting it once without pixels: every stroke is noted
// in the tiles that it touches, and a tile whose notes are the same is the same. So nothing has to know its
// rectangle, letters and arrows may keep their size in pixels, and what stands still is not painted again.
#pragma once

#include <QPainter>
#include <QRegion>
#include <QWidget>

#include <cstdint>
#include <functional>
#include <vector>

namespace thetalane {

class Changes {
public:
    // Since the last call [px of the viewport]. paint: as the view paints, over a ground that is its own
    // affair.
    QRegion found(const QWidget& viewport, const std::function<void(QPainter&)>& paint);

    // Painted meanwhile, or standing on another ground: not the same, whatever is noted.
    void forget() { m_size = {}; }
    void forget(const QRegion& region);

    static constexpr int tile = 32; // px

private:
    QSize m_size;                       // of the viewport [px]
    std::vector<std::uint64_t> m_notes; // of each tile, row by row
};

} // namespace thetalane

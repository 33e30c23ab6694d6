#include "ui/lane/changes.h"

#include "ui/lane/stroke_notes.h"

#include <utility>

namespace thetalane {
namespace {

constexpr double most = 0.6; // of the tiles: beyond it many rectangles cost more than one

int tilesAlong(int pixels) {
    return (pixels + Changes::tile - 1) / Changes::tile;
}

} // namespace

QRegion Changes::found(const QWidget& viewport, const std::function<void(QPainter&)>& paint) {
    NoteBoard board(viewport, tile);
    {
        QPainter painter(&board);
        paint(painter);
    }
    const std::vector<std::uint64_t> before = std::exchange(m_notes, std::move(board.engine().notes()));
    if (std::exchange(m_size, viewport.size()) != viewport.size() || before.size() != m_notes.size())
        return viewport.rect();
    const int columns = tilesAlong(m_size.width());
    QRegion region;
    std::size_t changed = 0;
    for (int row = 0; row < tilesAlong(m_size.height()); ++row) {
        const auto differs = [&](int column) {
            const std::size_t k = std::size_t(row) * std::size_t(columns) + std::size_t(column);
            return before[k] != m_notes[k];
        };
        for (int from = 0; from < columns; ++from) {
            int to = from;
            while (to < columns && differs(to))
                ++to;
            if (to == from)
                continue;
            region += QRect(from * tile, row * tile, (to - from) * tile, tile);
            changed += std::size_t(to - from);
            from = to;
        }
    }
    return double(changed) > most * double(m_notes.size()) ? QRegion(viewport.rect())
                                                           : region & viewport.rect();
}

void Changes::forget(const QRegion& region) {
    const int columns = tilesAlong(m_size.width());
    for (const QRect& rect : region& QRect(QPoint(), m_size))
        for (int row = rect.top() / tile; row <= rect.bottom() / tile; ++row)
            for (int column = rect.left() / tile; column <= rect.right() / tile; ++column)
                ++m_notes[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
}

} // namespace thetalane

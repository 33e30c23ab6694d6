// The run as a line: a tick at every collision of the present chapter, and a handle at the present time that
// can be taken anywhere.
#pragma once

#include "ui/context.h"

#include <QPixmap>
#include <QWidget>

#include <optional>

namespace thetalane {

class ScrubBar : public QWidget {
    Q_OBJECT
public:
    explicit ScrubBar(const Context& context, QWidget* parent = nullptr);

    static constexpr int reach = 5; // how near a tick counts as on it [px]

    double xAt(double time) const; // [s] -> [px]
    double timeAt(double x) const; // [px] -> [s]
    QString hintAt(double x) const; // "3: ball → 5, 0.0812 s"; of what is computed, empty away from the ticks
    std::optional<std::size_t> collisionNear(double x) const; // index in the chapter

    void retranslate();
    void hideFuture(bool hidden); // the ticks of what is still to come

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    double margin() const { return m_context.appearance.projector() ? 12 : 8; }
    double middle() const { return height() / 2.0; }
    double tickHeight(bool shared) const;
    const QPixmap& ticks();
    void paintTicks(QPainter& painter) const;
    void paintSelected(QPainter& painter) const;
    void paintLine(QPainter& painter, double thick) const;
    void forgetTicks();
    void showProgress();

    Context m_context;
    QPixmap m_ticks; // drawn once for a chapter and a size: there may be very many
    double m_ticksUntil = 0;
    double m_pressedAt = 0;
    bool m_pressed = false;
    bool m_futureHidden = false;
    bool m_dragging = false;
    int m_wheel = 0;
};

} // namespace thetalane

// Where one is in a lesson: a dot a page, a diamond for the question. A click goes there.
#pragma once

#include "ui/appearance.h"

#include <QWidget>

namespace thetalane {

class ProgressDots : public QWidget {
    Q_OBJECT
public:
    explicit ProgressDots(const Appearance& appearance, QWidget* parent = nullptr);

    void setPages(int count, int question); // question: its page, or -1
    void setPage(int page);
    void retranslate();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void chosen(int page);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    double pitch() const;
    double left() const;

    const Appearance& m_appearance;
    int m_count = 0;
    int m_question = -1;
    int m_page = 0;
};

} // namespace thetalane

// Words for the back row: as large as they fit, never smaller than large text, scrolled where even that is
// too long.
#pragma once

#include "ui/appearance.h"

#include <QScrollArea>

class QLabel;

namespace thetalane {

class BigText : public QScrollArea {
    Q_OBJECT
public:
    explicit BigText(const Appearance& appearance, const QString& name, QWidget* parent = nullptr);

    void setWords(const QString& words);
    QString words() const { return m_words; }
    bool isWhole() const; // all of it is seen without scrolling

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    const Appearance& m_appearance;
    QLabel* m_label;
    QString m_words;
};

} // namespace thetalane

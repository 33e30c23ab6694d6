// A button that is one icon: quiet until pointed at; the prominent one is round and in the accent colour.
#pragma once

#include "ui/appearance.h"
#include "ui/panels/icons.h"

#include <QAbstractButton>

namespace thetalane {

class IconButton : public QAbstractButton {
    Q_OBJECT
public:
    enum class Weight { Quiet, Prominent };

    // name becomes the objectName.
    IconButton(const Appearance& appearance, Icon icon, const char* name, QWidget* parent = nullptr,
               Weight weight = Weight::Quiet);

    void showIcon(Icon icon);
    void setWords(const QString& name, const QString& toolTip);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    const Appearance& m_appearance;
    Icon m_icon;
    Weight m_weight;
};

// An icon that only says something; the mouse goes through it.
class IconMark : public QWidget {
    Q_OBJECT
public:
    IconMark(const Appearance& appearance, Icon icon, QWidget* parent = nullptr);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const Appearance& m_appearance;
    Icon m_icon;
};

} // namespace thetalane

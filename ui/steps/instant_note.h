// What a collision has to do with others of the same instant: its place among them, the rule, and a way to
// each of those resolved together with it.
#pragma once

#include "ui/context.h"
#include "ui/words/instant.h"

#include <QAbstractButton>
#include <QLabel>

#include <vector>

namespace thetalane {

// A word that can be pressed: a contact's name, or the question.
class InstantLink : public QAbstractButton {
    Q_OBJECT
public:
    InstantLink(const Appearance& appearance, const QString& name, QWidget* parent);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }

private:
    const Appearance& m_appearance;
};

class InstantNote : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t mostLinks = 8; // of a hundred contacts, those beside this one

    explicit InstantNote(const Context& context, QWidget* parent = nullptr);

    void showCollision(std::size_t index); // hidden for a collision that was alone
    bool isExplained() const { return m_rule->isVisibleTo(this); }
    void explain(bool on);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

    void retranslate();

signals:
    void grew();

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent*) override;
    void changeEvent(QEvent* event) override;

private:
    void applyAppearance();
    void makeLinks();
    void say();
    int arrange(int width, bool place) const; // the height it takes

    Context m_context;
    std::size_t m_index = 0;
    Instant m_instant;
    QLabel* m_place;
    InstantLink* m_why;
    QLabel* m_rule;
    QLabel* m_with;
    std::vector<InstantLink*> m_links;
};

} // namespace thetalane

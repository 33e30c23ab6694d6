#include "ui/game/saved_games_list.h"

#include "ui/game/game_words.h"
#include "ui/panels/icon_button.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {

QString listStyle(const Appearance& a) {
    return QStringLiteral("QListWidget { background: transparent; border: none; outline: none; }"
                          "QListWidget::item { padding: %1px; border-radius: 4px; color: %2; }"
                          "QListWidget::item:hover { background: %3; }"
                          "QListWidget::item:selected { background: %3; color: %2; }"
                          "QListWidget:focus { border: 1px solid %4; }"
                          "QListWidget::item:disabled { color: %5; }")
        .arg(QString::number(a.unit() / 2), a.text().name(), a.chosen().name(), a.accent().name(),
             a.quietText().name());
}

void markAsChooser(QComboBox& box, const Appearance& appearance) {
    auto* layout = new QHBoxLayout(&box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new IconMark(appearance, Icon::Down, &box), 0, Qt::AlignRight | Qt::AlignVCenter);
    box.setMinimumContentsLength(6);
    box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box.setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

SavedGamesList::SavedGamesList(const Context& context, Alley& alley, QWidget* parent)
    : Panel(context, parent)
    , m_alley(alley)
    , m_heading(new QLabel(this))
    , m_list(new QListWidget(this))
    , m_message(new QLabel(this)) {
    m_list->setObjectName(QStringLiteral("savedGames"));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setFocusPolicy(Qt::TabFocus);
    m_list->setTextElideMode(Qt::ElideRight);
    m_message->setObjectName(QStringLiteral("savedGamesMessage"));
    m_message->setTextFormat(Qt::PlainText);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_heading);
    layout->addWidget(m_message);
    layout->addWidget(m_list);
    // One click opens, as in any list of the window; Enter does for the keyboard.
    connect(m_list, &QListWidget::itemClicked, this, [this](auto* item) { open(m_list->row(item)); });
    connect(m_list, &QListWidget::itemActivated, this, [this](auto* item) { open(m_list->row(item)); });
    restyle();
    retranslate();
}

void SavedGamesList::retranslate() {
    m_heading->setText(tr("Saved games"));
    m_list->setAccessibleName(tr("Saved games"));
    m_list->setToolTip(tr("Opens the game: one that is not over goes on"));
    refresh();
}

void SavedGamesList::restyle() {
    Panel::restyle();
    setStyleSheet(styleSheet() + listStyle(appearance()));
    m_heading->setFont(appearance().font(Appearance::Size::Normal, true));
    m_list->setFont(appearance().font(Appearance::Size::Normal));
    layout()->setSpacing(appearance().unit() / 2);
    makeMessage(*m_message, appearance());
    refresh();
}

void SavedGamesList::refresh() {
    m_list->clear();
    for (const SavedGame& saved : m_alley.store().list()) {
        const QString when = QLocale().toString(saved.modified, QLocale::ShortFormat);
        const QString title = saved.game() ? gameTitle(*saved.game())
                                           : tr("%1: cannot be read").arg(QFileInfo(saved.path).fileName());
        auto* item = new QListWidgetItem(title + u'\n' + when, m_list);
        item->setData(Qt::UserRole, saved.path);
        item->setToolTip(saved.game() ? title : storeFaultText(*saved.fault()));
        if (!saved.game())
            item->setForeground(appearance().error());
    }
    const int rows = std::min(m_list->count(), 6);
    m_list->setFixedHeight(rows > 0 ? rows * (m_list->sizeHintForRow(0) + 1) + 4 : 0);
    setVisible(m_list->count() > 0);
}

// The file of a damaged game stays as it is: perhaps somebody can mend it.
void SavedGamesList::open(int row) {
    const QString path = m_list->item(row)->data(Qt::UserRole).toString();
    const auto fault = m_alley.openSaved(path);
    m_message->setText(fault ? tr("%1 cannot be read and stays as it is. %2")
                                   .arg(QFileInfo(path).fileName(), storeFaultText(*fault))
                             : QString());
    m_message->setVisible(fault.has_value());
}

} // namespace thetalane

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/completion_popup.h"

#include "views/theme.h"

#include <QLabel>
#include <QListWidget>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

constexpr int mostRows = 8;
constexpr int rowHeight = 22;  ///< px
constexpr int narrowest = 180; ///< px
constexpr int docWidth = 380;  ///< px

} // namespace

CompletionPopup::CompletionPopup(QWidget *window)
    : QFrame(window)
    , m_list(new QListWidget)
    , m_doc(new QLabel)
{
    setKind(this, "card");
    setAutoFillBackground(true);
    setFocusPolicy(Qt::NoFocus);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setFont(numericFont());
    m_list->setStyleSheet(QStringLiteral("QListView::item { padding: 0 6px; }"));
    m_list->setUniformItemSizes(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setAccessibleName(tr("Completions"));
    setKind(m_doc, "muted");
    m_doc->setTextFormat(Qt::PlainText);
    m_doc->setContentsMargins(8, 4, 8, 5);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(1, 1, 1, 1);
    column->setSpacing(0);
    column->addWidget(m_list, 1);
    column->addWidget(m_doc);
    connect(m_list, &QListWidget::currentRowChanged, this, &CompletionPopup::showDoc);
    connect(m_list, &QListWidget::itemClicked, this, &CompletionPopup::accepted);
    hide();
}

void CompletionPopup::showWords(const std::vector<ApiWord> &words, const QRect &place)
{
    m_words = words;
    m_list->clear();
    int widest = narrowest;
    const QFontMetrics name(m_list->font());
    const QFontMetrics doc(m_doc->font());
    for (const ApiWord &word : words) {
        auto *item = new QListWidgetItem(word.name, m_list);
        item->setSizeHint({0, scaledByText(rowHeight)});
        widest = std::max(widest, name.horizontalAdvance(word.name) + 40);
        if (!word.doc.isEmpty())
            widest = std::max(widest, std::min(docWidth, doc.horizontalAdvance(word.doc) + 20));
    }
    m_list->setCurrentRow(0);
    const bool documented =
        std::ranges::any_of(words, [](const ApiWord &w) { return !w.doc.isEmpty(); });
    m_doc->setVisible(documented);
    m_doc->setText(QStringLiteral(" ")); // for its height
    const int rows = std::min(mostRows, static_cast<int>(words.size()));
    m_list->setFixedHeight(rows * scaledByText(rowHeight) + 2);
    setGeometry(
        placeBeside(place, {widest, layout()->sizeHint().height()}, parentWidget()->rect(), false));
    showDoc();
    raise();
    show();
}

void CompletionPopup::showDoc()
{
    const int row = m_list->currentRow();
    if (row < 0 || static_cast<std::size_t>(row) >= m_words.size())
        return;
    const ApiWord &word = m_words[static_cast<std::size_t>(row)];
    m_doc->setText(m_doc->fontMetrics().elidedText(word.doc, Qt::ElideRight, width() - 18));
}

void CompletionPopup::move(int rows)
{
    const int count = m_list->count();
    const int row = m_list->currentRow() + rows;
    const bool one = rows == 1 || rows == -1; // goes around the ends
    m_list->setCurrentRow(one ? (row + count) % count : std::clamp(row, 0, count - 1));
}

int CompletionPopup::rowsOnPage() const
{
    return std::max(2, m_list->viewport()->height() / scaledByText(rowHeight) - 1);
}

QString CompletionPopup::chosen() const
{
    const QListWidgetItem *item = m_list->currentItem();
    return item ? item->text() : QString();
}

QStringList CompletionPopup::words() const
{
    QStringList names;
    for (const ApiWord &word : m_words)
        names.append(word.name);
    return names;
}

QRect placeBeside(const QRect &place, QSize size, const QRect &room, bool above)
{
    size = size.boundedTo(room.size());
    const int over = place.top() - size.height() - 2;
    const int under = place.bottom() + 2;
    const bool fitsOver = over >= room.top();
    const bool fitsUnder = under + size.height() <= room.bottom();
    const int y = above ? (fitsOver ? over : under) : (fitsUnder || !fitsOver ? under : over);
    const int x = std::clamp(place.left() - 6, room.left(), room.right() - size.width());
    return {QPoint(x, std::min(y, room.bottom() - size.height())), size};
}

} // namespace cradle

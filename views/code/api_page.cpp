// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/api_page.h"

#include "views/code/api_words.h"
#include "views/markdown_view.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QEvent>
#include <QFile>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QTextBlock>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr int headingRole = Qt::UserRole; ///< number of the heading in the page
constexpr int listWidth = 210;            ///< px
constexpr int narrow = 480;               ///< px; a narrower page has no list of headings
constexpr int chapterLevel = 2;

QString pageText(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

bool isEntry(const QTextBlock &block)
{
    return block.blockFormat().headingLevel() >= chapterLevel;
}

} // namespace

ApiPage::ApiPage(QWidget *parent, FormulaRenderer *renderer)
    : QWidget(parent)
    , m_search(new QLineEdit)
    , m_headings(new QListWidget)
    , m_nothing(new QLabel)
    , m_view(new MarkdownView(nullptr, renderer))
{
    makeLayout();
    keepTranslated(this, &ApiPage::retranslate);
    m_search->installEventFilter(this);
    m_headings->installEventFilter(this);
    connect(m_search, &QLineEdit::textEdited, this, &ApiPage::filter);
    connect(m_headings, &QListWidget::currentRowChanged, this, &ApiPage::goTo);
}

QSize ApiPage::sizeHint() const
{
    return {scaledByText(840), scaledByText(620)};
}

void ApiPage::makeLayout()
{
    m_search->setClearButtonEnabled(true);
    m_headings->setFrameShape(QFrame::NoFrame);
    m_headings->setFixedWidth(scaledByText(listWidth));
    m_headings->setStyleSheet(
        QStringLiteral("QListView::item { padding: 2px 8px; border: none; }"));
    m_headings->setTextElideMode(Qt::ElideNone); // it scrolls
    m_headings->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_nothing->setContentsMargins(12, 4, 12, 4);
    m_nothing->setWordWrap(true);
    m_nothing->setTextFormat(Qt::PlainText);
    m_nothing->hide();
    setKind(m_nothing, "warning");
    auto *top = new QHBoxLayout;
    top->setContentsMargins(8, 8, 8, 6);
    top->addWidget(m_search);
    auto *row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(m_headings);
    row->addWidget(m_view, 1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(top);
    column->addWidget(m_nothing);
    column->addLayout(row, 1);
    setFocusProxy(m_search);
}

void ApiPage::retranslate()
{
    //: The file of the page in your language: docs/lua-api.LANGUAGE.md, if there is one
    m_view->setMarkdown(pageText(tr(":/help/lua-api.md")), {});
    m_view->moveCursor(QTextCursor::Start); // else it stays in sight, at the end of the page
    listHeadings();
    setWindowTitle(tr("API reference"));
    m_search->setPlaceholderText(tr("Search (Return: next place in the text)"));
    m_search->setAccessibleName(tr("Search the API reference"));
    m_headings->setAccessibleName(tr("Entries of the API reference"));
    m_view->setAccessibleName(tr("API reference"));
    m_nothing->setText(tr("Not found in the reference: %1").arg(m_search->text()));
}

void ApiPage::listHeadings()
{
    const int row = m_headings->currentRow();
    m_headings->clear();
    int number = 0;
    const QTextDocument *page = m_view->document();
    for (QTextBlock block = page->begin(); block.isValid(); block = block.next()) {
        if (!isEntry(block))
            continue;
        const bool chapter = block.blockFormat().headingLevel() == chapterLevel;
        auto *item = new QListWidgetItem(
            chapter ? block.text() : QStringLiteral("   ") + block.text(), m_headings);
        QFont itemFont = font();
        itemFont.setWeight(chapter ? QFont::DemiBold : QFont::Normal);
        item->setFont(itemFont);
        item->setToolTip(block.text());
        item->setData(headingRole, number++);
    }
    m_headings->setCurrentRow(row);
}

bool ApiPage::showWord(const QString &word)
{
    m_search->clear();
    filter({});
    if (word.isEmpty())
        return false;
    for (const QString &heading : headingsOf(word)) {
        for (int row = 0; row < m_headings->count(); ++row) {
            const QStringList names =
                m_headings->item(row)->text().trimmed().split(QStringLiteral(", "));
            if (!names.contains(heading))
                continue;
            m_headings->setCurrentRow(row);
            goTo(row);
            return true;
        }
    }
    m_search->setText(word);
    filter(word);
    searchOn(true);
    return false;
}

QString ApiPage::currentHeading() const
{
    const QListWidgetItem *item = m_headings->currentItem();
    return item ? item->text().trimmed() : QString();
}

/// Leaves the headings that have \p text in them; without any, all of them.
void ApiPage::filter(const QString &text)
{
    m_filtering = true;
    int shown = 0;
    for (int row = 0; row < m_headings->count(); ++row) {
        const bool fits = m_headings->item(row)->text().contains(text, Qt::CaseInsensitive);
        m_headings->item(row)->setHidden(!fits);
        shown += fits ? 1 : 0;
    }
    for (int row = 0; shown == 0 && row < m_headings->count(); ++row)
        m_headings->item(row)->setHidden(false);
    m_filtering = false;
    const bool found = text.isEmpty() || shown > 0 || !m_view->document()->find(text).isNull();
    m_nothing->setText(tr("Not found in the reference: %1").arg(text));
    m_nothing->setVisible(!found);
    for (int row = 0; shown > 0 && !text.isEmpty() && row < m_headings->count(); ++row) {
        if (!m_headings->item(row)->isHidden()) {
            m_headings->setCurrentRow(row);
            break;
        }
    }
}

void ApiPage::goTo(int row)
{
    if (row >= 0 && !m_filtering)
        scrollTo(m_headings->item(row)->data(headingRole).toInt());
}

void ApiPage::scrollTo(int heading)
{
    const QTextDocument *page = m_view->document();
    int number = 0;
    for (QTextBlock block = page->begin(); block.isValid(); block = block.next()) {
        if (!isEntry(block) || number++ != heading)
            continue;
        m_view->setTextCursor(QTextCursor(block));
        const QRectF place = page->documentLayout()->blockBoundingRect(block);
        const double margin = block.blockFormat().topMargin() / 2;
        m_view->verticalScrollBar()->setValue(static_cast<int>(place.top() - margin));
        return;
    }
}

/// The next place of what is searched for in the text of the page, around its ends.
void ApiPage::searchOn(bool forward)
{
    const QString text = m_search->text();
    const QTextDocument::FindFlags flags =
        forward ? QTextDocument::FindFlags() : QTextDocument::FindBackward;
    if (text.isEmpty() || m_view->find(text, flags))
        return;
    QTextCursor end = m_view->textCursor();
    end.movePosition(forward ? QTextCursor::Start : QTextCursor::End);
    m_view->setTextCursor(end);
    m_view->find(text, flags);
}

void ApiPage::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_headings->setVisible(width() >= narrow);
    layout()->activate();
    goTo(m_headings->currentRow());
}

void ApiPage::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Find)) {
        m_search->setFocus();
        m_search->selectAll();
    } else if (event->key() == Qt::Key_Escape && isWindow()) {
        close();
    } else {
        QWidget::keyPressEvent(event);
    }
}

/// From the field, Up and Down move among the entries and the page keys in the text.
bool ApiPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress || watched != m_search)
        return QWidget::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    switch (key->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
        QCoreApplication::sendEvent(m_headings, event);
        return true;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        QCoreApplication::sendEvent(m_view, event);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        searchOn(!(key->modifiers() & Qt::ShiftModifier));
        return true;
    case Qt::Key_Escape:
        if (m_search->text().isEmpty())
            break;
        m_search->clear();
        filter({});
        return true;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/find_bar.h"

#include "views/code/code_editor.h"
#include "views/icons.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr int fieldWidth = 220; ///< px, at most
constexpr int countWidth = 76;  ///< px

QToolButton *signButton(const QString &sign, bool checkable)
{
    auto *button = new QToolButton;
    button->setText(sign);
    button->setCheckable(checkable);
    button->setAutoRaise(true);
    button->setFixedSize(30, 26);
    setKind(button, "tiny");
    return button;
}

} // namespace

FindBar::FindBar(CodeEditor &editor, QWidget *parent)
    : QWidget(parent)
    , m_editor(editor)
    , m_find(new QLineEdit)
    , m_replacement(new QLineEdit)
    , m_count(new QLabel)
    , m_previous(signButton(QStringLiteral("↑"), false))
    , m_next(signButton(QStringLiteral("↓"), false))
    , m_matchCase(signButton(QStringLiteral("Aa"), true))
    , m_wholeWord(signButton(QStringLiteral("“w”"), true))
    , m_close(signButton({}, false))
    , m_replaceOne(new QPushButton)
    , m_replaceAll(new QPushButton)
    , m_replaceRow(new QWidget)
{
    makeLayout();
    keepTranslated(this, &FindBar::retranslate);
    hide();
    connect(m_find, &QLineEdit::textChanged, this, &FindBar::search);
    for (QToolButton *option : {m_matchCase, m_wholeWord})
        connect(option, &QToolButton::toggled, this, &FindBar::search);
    connect(m_next, &QToolButton::clicked, this, [this] { findNext(true); });
    connect(m_previous, &QToolButton::clicked, this, [this] { findNext(false); });
    connect(m_close, &QToolButton::clicked, this, &FindBar::close);
    connect(m_replaceOne, &QPushButton::clicked, this, &FindBar::replaceOne);
    connect(m_replaceAll, &QPushButton::clicked, this, &FindBar::replaceAll);
    connect(&editor, &CodeEditor::textEdited, this, &FindBar::refresh);
    for (QLineEdit *field : {m_find, m_replacement})
        field->installEventFilter(this);
}

void FindBar::makeLayout()
{
    setAutoFillBackground(true);
    m_close->setIcon(icon(u"close"));
    m_close->setIconSize(iconSquare(14));
    m_count->setMinimumWidth(countWidth);
    for (QLineEdit *field : {m_find, m_replacement}) {
        field->setMaximumWidth(fieldWidth);
        field->setMinimumWidth(100);
        field->setFont(numericFont());
    }
    for (QPushButton *button : {m_replaceOne, m_replaceAll}) {
        button->setFocusPolicy(Qt::TabFocus);
        setKind(button, "small");
    }
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(12, 5, 8, 5);
    column->setSpacing(5);
    auto *findRow = new QHBoxLayout;
    findRow->setSpacing(4);
    findRow->addWidget(m_find, 1);
    for (QWidget *widget :
         {static_cast<QWidget *>(m_matchCase), static_cast<QWidget *>(m_wholeWord),
          static_cast<QWidget *>(m_previous), static_cast<QWidget *>(m_next)})
        findRow->addWidget(widget);
    findRow->addSpacing(8);
    findRow->addWidget(m_count);
    findRow->addStretch(1);
    findRow->addWidget(m_close);
    auto *replaceRow = new QHBoxLayout(m_replaceRow);
    replaceRow->setContentsMargins(0, 0, 0, 0);
    replaceRow->setSpacing(6);
    replaceRow->addWidget(m_replacement, 1);
    replaceRow->addWidget(m_replaceOne);
    replaceRow->addWidget(m_replaceAll);
    replaceRow->addStretch(1);
    column->addLayout(findRow);
    column->addWidget(m_replaceRow);
}

void FindBar::retranslate()
{
    const auto name = [](QToolButton *button, const QString &text, const QString &keys = {}) {
        button->setAccessibleName(text);
        button->setToolTip(keys.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, keys));
    };
    m_find->setPlaceholderText(tr("Find"));
    m_find->setAccessibleName(tr("Find"));
    m_replacement->setPlaceholderText(tr("Replace by"));
    m_replacement->setAccessibleName(tr("Replace by"));
    name(m_matchCase, tr("Match case"));
    name(m_wholeWord, tr("Whole words only"));
    name(m_previous, tr("Previous match"), tr("Shift+F3"));
    name(m_next, tr("Next match"), tr("F3"));
    name(m_close, tr("Close"), tr("Esc"));
    m_replaceOne->setText(tr("Replace"));
    m_replaceAll->setText(tr("Replace all"));
    refresh();
}

SearchTerm FindBar::term() const
{
    return {m_find->text(), m_matchCase->isChecked(), m_wholeWord->isChecked()};
}

void FindBar::open(bool withReplace)
{
    const QString selected = m_editor.selectedText();
    if (!selected.isEmpty() && !selected.contains(u'\n'))
        m_find->setText(selected);
    m_replaceRow->setVisible(withReplace && !m_editor.isReadOnly());
    show();
    m_find->setFocus();
    m_find->selectAll();
    refresh();
}

void FindBar::close()
{
    hide();
    m_editor.highlight({});
    m_editor.setFocus();
}

void FindBar::findNext(bool forward)
{
    if (m_find->text().isEmpty()) {
        open(false);
        return;
    }
    m_editor.highlight(isVisible() ? term() : SearchTerm{});
    showPlace(m_editor.findNext(term(), forward));
}

/// While the term is typed: from where the selection is.
void FindBar::search()
{
    m_editor.highlight(term());
    showPlace(m_editor.findHere(term()));
}

void FindBar::replaceOne()
{
    const SearchPlace place = m_editor.replaceNext(term(), m_replacement->text());
    m_editor.highlight(term());
    showPlace(place);
}

void FindBar::replaceAll()
{
    const int count = m_editor.replaceAll(term(), m_replacement->text());
    m_editor.highlight(term());
    if (count == 0) {
        showPlace({});
        return;
    }
    setKind(m_count, "muted");
    m_count->setText(tr("%n replaced", nullptr, count));
}

/// The text or the language has changed.
void FindBar::refresh()
{
    if (isVisible())
        showPlace(m_editor.highlight(term()));
}

void FindBar::showPlace(SearchPlace place)
{
    const bool none = place.count == 0 && !m_find->text().isEmpty();
    setKind(m_count, none ? "warning" : "muted");
    if (m_find->text().isEmpty())
        m_count->clear();
    else if (none)
        m_count->setText(tr("no match"));
    else if (place.match > 0)
        m_count->setText(tr("%1 of %2").arg(place.match).arg(place.count));
    else
        m_count->setText(tr("%n match(es)", nullptr, place.count));
    m_find->setAccessibleDescription(m_count->text());
    for (QWidget *widget :
         {static_cast<QWidget *>(m_previous), static_cast<QWidget *>(m_next),
          static_cast<QWidget *>(m_replaceOne), static_cast<QWidget *>(m_replaceAll)})
        widget->setEnabled(place.count > 0);
}

void FindBar::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(theme().border);
    painter.drawLine(0, 0, width(), 0);
}

bool FindBar::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool press = event->type() == QEvent::KeyPress;
        switch (key->key()) {
        case Qt::Key_Escape:
            if (press)
                close();
            event->accept();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (key->modifiers() & Qt::ControlModifier || !press)
                break;
            if (watched == m_replacement)
                replaceOne();
            else
                findNext(!(key->modifiers() & Qt::ShiftModifier));
            return true;
        default:
            break;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/hints_list.h"

#include "views/author/rows_list.h"
#include "views/author/tool_buttons.h"
#include "views/on_change.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QToolButton>

#include <algorithm>

namespace cradle {

namespace {

constexpr int rowsShown = 4;
constexpr int rowHeight = 28; ///< px

} // namespace

HintsList::HintsList(QWidget *parent)
    : QWidget(parent)
    , m_list(makeRowsList(QStringLiteral("hints"), this))
    , m_add(makeIconButton(QStringLiteral("add"), this))
    , m_remove(makeIconButton(QStringLiteral("remove"), this))
    , m_up(makeIconButton(QStringLiteral("up"), this))
    , m_down(makeIconButton(QStringLiteral("down"), this))
{
    setAutoFillBackground(true); // as the rows have it
    setBackgroundRole(QPalette::Base);
    m_list->setFixedHeight(rowsShown * rowHeight);
    setRowKeys(m_list, {.up = m_up, .down = m_down, .remove = m_remove, .rename = {}});
    auto *buttons = new QVBoxLayout;
    buttons->setSpacing(0);
    auto *upper = new QHBoxLayout;
    auto *lower = new QHBoxLayout;
    upper->setSpacing(0);
    lower->setSpacing(0);
    upper->addWidget(m_add);
    upper->addWidget(m_remove);
    lower->addWidget(m_up);
    lower->addWidget(m_down);
    buttons->addLayout(upper);
    buttons->addLayout(lower);
    buttons->addStretch(1);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 6, 0);
    row->addWidget(m_list, 1);
    row->addLayout(buttons);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int hint) {
        enableButtons();
        if (!m_loading)
            emit currentChanged(hint);
    });
    connect(m_add, &QToolButton::clicked, this, &HintsList::add);
    connect(m_remove, &QToolButton::clicked, this, &HintsList::remove);
    connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
    keepTranslated(this, &HintsList::retranslate);
}

void HintsList::showHints(const QStringList &hints)
{
    const int before = std::max(current(), 0);
    m_hints = hints;
    m_loading = true;
    m_list->clear();
    int number = 0;
    for (const QString &hint : hints)
        m_list->addItem(QStringLiteral("%1 · %2").arg(++number).arg(hint.section(u'\n', 0, 0)));
    m_list->setCurrentRow(std::min(before, m_list->count() - 1));
    m_loading = false;
    enableButtons();
}

int HintsList::current() const
{
    return m_list->currentRow();
}

void HintsList::setCurrent(int hint)
{
    m_list->setCurrentRow(hint);
}

void HintsList::setReadOnly(bool readOnly)
{
    m_readOnly = readOnly;
    enableButtons();
}

void HintsList::add()
{
    QStringList hints = m_hints;
    const int at = current() + 1;
    hints.insert(at, tr("A new hint"));
    emit edited(hints, at);
}

void HintsList::remove()
{
    if (current() < 0)
        return;
    QStringList hints = m_hints;
    hints.removeAt(current());
    emit edited(hints, std::min(current(), static_cast<int>(hints.size()) - 1));
}

void HintsList::move(int by)
{
    const int to = current() + by;
    if (m_readOnly || current() < 0 || to < 0 || to >= m_hints.size())
        return;
    QStringList hints = m_hints;
    hints.move(current(), to);
    emit edited(hints, to);
}

void HintsList::enableButtons()
{
    const int at = current();
    m_add->setEnabled(!m_readOnly);
    m_remove->setEnabled(!m_readOnly && at >= 0);
    m_up->setEnabled(!m_readOnly && at > 0);
    m_down->setEnabled(!m_readOnly && at >= 0 && at + 1 < m_list->count());
}

void HintsList::retranslate()
{
    m_list->setAccessibleName(tr("Hints, in the order of opening"));
    nameButton(m_add, tr("Add a hint"));
    nameButton(m_remove, tr("Remove the hint"), tr("Delete"));
    nameButton(m_up, tr("Move the hint up"), tr("Alt+Up"));
    nameButton(m_down, tr("Move the hint down"), tr("Alt+Down"));
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/hints_list.h"

#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/on_change.h"

#include <QGridLayout>
#include <QToolButton>

#include <algorithm>

namespace cradle {

namespace {

constexpr int rowsShown = 4;
constexpr int rowHeight = 28; ///< px

} // namespace

HintsList::HintsList(QWidget *parent)
    : QWidget(parent)
    , m_list(new RowsList(QStringLiteral("hints"), this,
                          {RowsList::Add, RowsList::Remove, RowsList::Up, RowsList::Down}))
{
    setAutoFillBackground(true); // as the rows have it
    setBackgroundRole(QPalette::Base);
    m_list->setFixedHeight(rowsShown * rowHeight);
    auto *buttons = new QGridLayout;
    buttons->setSpacing(0);
    buttons->addWidget(m_list->button(RowsList::Add), 0, 0);
    buttons->addWidget(m_list->button(RowsList::Remove), 0, 1);
    buttons->addWidget(m_list->button(RowsList::Up), 1, 0);
    buttons->addWidget(m_list->button(RowsList::Down), 1, 1);
    buttons->setRowStretch(2, 1);
    layOutRow(this, {0, 0, 6, 0}, -1, {{m_list, 1}, buttons});
    connect(m_list, &RowsList::currentRowChanged, this, &HintsList::currentChanged);
    connect(m_list, &RowsList::addRequested, this, &HintsList::add);
    connect(m_list, &RowsList::removeRequested, this, &HintsList::remove);
    connect(m_list, &RowsList::moveRequested, this, &HintsList::move);
    keepTranslated(this, &HintsList::retranslate);
}

void HintsList::showHints(const QStringList &hints)
{
    m_hints = hints;
    QStringList rows;
    for (const QString &hint : hints)
        rows.append(QStringLiteral("%1 · %2").arg(rows.size() + 1).arg(hint.section(u'\n', 0, 0)));
    m_list->showRows(rows, current());
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
    m_list->enableButtons(!readOnly);
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
    QStringList hints = m_hints;
    hints.removeAt(current());
    emit edited(hints, std::min(current(), static_cast<int>(hints.size()) - 1));
}

void HintsList::move(int from, int to)
{
    QStringList hints = m_hints;
    hints.move(from, to);
    emit edited(hints, to);
}

void HintsList::retranslate()
{
    m_list->setTexts(tr("Hints, in the order of opening"),
                     {{RowsList::Add, tr("Add a hint")},
                      {RowsList::Remove, tr("Remove the hint")},
                      {RowsList::Up, tr("Move the hint up")},
                      {RowsList::Down, tr("Move the hint down")}});
}

} // namespace cradle

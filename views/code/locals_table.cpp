// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/locals_table.h"

#include "views/code/code_colours.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace cradle {

namespace {

constexpr int localsRowHeight = 22; ///< px
constexpr int narrowestTable = 150; ///< px
constexpr int widestTable = 290;    ///< px
constexpr int cellRoom = 44;        ///< px beside the texts of a row

} // namespace

LocalsTable::LocalsTable(QWidget *parent)
    : QWidget(parent)
    , m_heading(new QLabel)
    , m_none(new QLabel)
    , m_table(new QTableWidget(0, 2))
{
    setMinimumWidth(narrowestTable);
    m_heading->setFont(headingFont());
    m_heading->setContentsMargins(12, 7, 12, 5);
    setKind(m_heading, "heading");
    m_none->setContentsMargins(12, 2, 12, 4);
    m_none->setWordWrap(true);
    setKind(m_none, "muted");
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setFont(numericFont());
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setMinimumSectionSize(scaledByText(localsRowHeight));
    m_table->verticalHeader()->setDefaultSectionSize(scaledByText(localsRowHeight));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_heading);
    column->addWidget(m_none);
    column->addWidget(m_table, 1);
    column->addStretch(0);
    setLocals({});
    keepTranslated(this, &LocalsTable::retranslate);
    onChange(this, {QEvent::PaletteChange}, [this] {
        for (int row = 0; row < m_table->rowCount(); ++row)
            m_table->item(row, 0)->setForeground(theme().mutedText);
    });
}

void LocalsTable::setLocals(const std::vector<ProgramValue> &locals)
{
    m_none->setVisible(locals.empty());
    m_table->setVisible(!locals.empty());
    m_table->setRowCount(static_cast<int>(locals.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const ProgramValue &local = locals[static_cast<std::size_t>(row)];
        auto *name = new QTableWidgetItem(QStringLiteral("  ") + local.name);
        auto *value = new QTableWidgetItem(local.value);
        name->setForeground(theme().mutedText);
        value->setToolTip(local.value);
        m_table->setItem(row, 0, name);
        m_table->setItem(row, 1, value);
    }
}

QSize LocalsTable::sizeHint() const
{
    std::array<int, 2> columns{};
    const QFontMetrics metrics(m_table->font());
    for (int row = 0; row < m_table->rowCount(); ++row) {
        for (int c = 0; c < 2; ++c) {
            int &width = columns[static_cast<std::size_t>(c)];
            width = std::max(width, metrics.horizontalAdvance(m_table->item(row, c)->text()));
        }
    }
    return {std::clamp(columns[0] + columns[1] + cellRoom, narrowestTable, widestTable), 160};
}

void LocalsTable::retranslate()
{
    m_heading->setText(tr("Local variables"));
    m_none->setText(tr("None at this line"));
    m_table->setAccessibleName(tr("Local variables at the line that runs next"));
}

} // namespace cradle

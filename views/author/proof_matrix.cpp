// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/proof_matrix.h"

#include "tasks/proof/verified_text.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QHeaderView>
#include <QStyledItemDelegate>

#include <algorithm>

namespace cradle {

namespace {

constexpr int leastName = 230; ///< px
constexpr int mostName = 330;  ///< px
constexpr int saidWidth = 200; ///< px, at least
constexpr int leastCell = 44;  ///< px
constexpr int mostCell = 130;  ///< px
constexpr int cellMargin = 20; ///< px, of a heading

/// Keeps words off the edge of their cell; the style sheet's padding would cost the background.
class IndentedText final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (!option->displayAlignment.testFlag(Qt::AlignHCenter))
            option->text.prepend(QChar(0x2002)); // en space
    }
};

const CheckOutcome *outcomeOf(const CheckReport &report, const QString &check)
{
    const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                    [&](const CheckOutcome &each) { return each.id == check; });
    return found == report.checks.end() ? nullptr : &*found;
}

/// Why a program that should pass does not.
QString firstFailure(const CheckReport &report)
{
    const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                    [](const CheckOutcome &each) { return !each.passed; });
    return found == report.checks.end() ? QString() : found->message;
}

} // namespace

ProofMatrix::ProofMatrix(QWidget *parent)
    : QTableWidget(parent)
{
    setObjectName(QStringLiteral("matrix"));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false); // arrows go from cell to cell
    setSelectionMode(QAbstractItemView::SingleSelection);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(26);
    horizontalHeader()->setDefaultAlignment(Qt::AlignCenter);
    horizontalHeader()->setStretchLastSection(true);
    setKind(this, "matrix");
    setItemDelegate(new IndentedText(this));
    setShowGrid(true);
    setFrameShape(QFrame::NoFrame);
    connect(this, &QTableWidget::cellActivated, this, [this](int row) {
        if (row < static_cast<int>(m_task.programs.size())) // the last is about the checks
            emit programChosen(programPath(m_task.programs[static_cast<std::size_t>(row)]));
    });
    connect(horizontalHeader(), &QHeaderView::sectionClicked, this, [this](int column) {
        if (column >= 1 && column <= m_task.checks.size())
            emit checkChosen(m_task.checks[column - 1]);
    });
    fill();
    onChange(this, {QEvent::LanguageChange, QEvent::PaletteChange}, [this] { fill(); });
}

void ProofMatrix::show(const VerifiedTask &task)
{
    m_task = task;
    fill();
}

void ProofMatrix::fill()
{
    setAccessibleName(tr("Programs and the checks that they fail"));
    clear();
    const auto checks = static_cast<int>(m_task.checks.size());
    const auto programs = static_cast<int>(m_task.programs.size());
    setRowCount(programs == 0 ? 0 : programs + 1);
    setColumnCount(m_task.programs.empty() ? 0 : checks + 2);
    if (m_task.programs.empty())
        return;
    QStringList titles{tr("Program")};
    titles.append(m_task.checks);
    titles.append(tr("Said of it"));
    setHorizontalHeaderLabels(titles);
    for (int i = 0; i < checks; ++i)
        horizontalHeaderItem(i + 1)->setToolTip(tr("Check %1").arg(m_task.checks[i]));
    for (const int column : {0, checks + 1})
        horizontalHeaderItem(column)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    for (int row = 0; row < programs; ++row)
        addRow(row, m_task.programs[static_cast<std::size_t>(row)]);
    addSensitivity(programs);
    fitColumns();
}

/// How wrong is just wrong enough: the least angle in the cell, all of it in its tip.
void ProofMatrix::addSensitivity(int row)
{
    auto *name = new QTableWidgetItem(tr("Just wrong enough"));
    name->setToolTip(tr("By how much a right run must be turned, too fast or adrift, or how wrong "
                        "restitution and masses must be in its first hit, for the check to fail "
                        "it"));
    setItem(row, 0, name);
    for (int i = 0; i < m_task.checks.size(); ++i) {
        const QStringList figures = wrongEnough(m_task, i).split(QStringLiteral(" · "));
        const bool measured = figures.size() >= 3;
        const auto seen = std::find_if(figures.begin(), figures.end(), [](const QString &figure) {
            return figure != QStringLiteral("–");
        });
        auto *cell =
            new QTableWidgetItem(measured && seen != figures.end() ? *seen : QStringLiteral("–"));
        cell->setTextAlignment(Qt::AlignCenter);
        cell->setForeground(theme().mutedText);
        QString tip = measured ? tr("%1: turned by %2, too fast by %3, adrift by %4")
                                     .arg(m_task.checks[i], figures[0], figures[1], figures[2])
                               : tr("%1: not measured").arg(m_task.checks[i]);
        if (figures.size() > 3)
            tip += tr("; a hit with %1").arg(figures.mid(3).join(QStringLiteral(", ")));
        cell->setToolTip(tip);
        cell->setData(Qt::AccessibleTextRole, cell->toolTip());
        setItem(row, i + 1, cell);
    }
    setItem(row, columnCount() - 1, new QTableWidgetItem);
}

/// The checks share what programs and words leave.
void ProofMatrix::fitColumns()
{
    const auto checks = static_cast<int>(m_task.checks.size());
    if (columnCount() == 0)
        return;
    const int nameWidth = std::clamp(sizeHintForColumn(0) + cellMargin, leastName, mostName);
    setColumnWidth(0, nameWidth);
    const int room = (viewport()->width() - nameWidth - saidWidth) / std::max(checks, 1);
    for (int i = 1; i <= checks; ++i) {
        const QTableWidgetItem *figure = item(rowCount() - 1, i);
        const int wanted =
            std::max(horizontalHeader()->fontMetrics().horizontalAdvance(m_task.checks[i - 1]),
                     fontMetrics().horizontalAdvance(figure ? figure->text() : QString()))
            + cellMargin;
        const int width = std::clamp(room, leastCell, std::clamp(wanted, leastCell, mostCell));
        setColumnWidth(i, width);
        // A heading with a style sheet is cut at both ends instead. Columns that are just being
        // inserted have none, and change the height of the headings, and so the size of the rest.
        if (QTableWidgetItem *heading = horizontalHeaderItem(i))
            heading->setText(horizontalHeader()->fontMetrics().elidedText(
                m_task.checks[i - 1], Qt::ElideRight, width - cellMargin + 2));
    }
}

void ProofMatrix::addRow(int row, const VerifiedProgram &program)
{
    const Theme &colours = theme();
    const CheckReport &report = program.reports.front();
    setItem(row, 0, new QTableWidgetItem(programPath(program)));
    for (int i = 0; i < m_task.checks.size(); ++i) {
        const CheckOutcome *outcome = outcomeOf(report, m_task.checks[i]);
        const bool failed = outcome && !outcome->passed;
        auto *cell = new QTableWidgetItem(failed ? QStringLiteral("✗") : QStringLiteral("·"));
        cell->setTextAlignment(Qt::AlignCenter);
        cell->setForeground(failed ? colours.warning : colours.mutedText);
        if (failed)
            cell->setBackground(colours.warningSoft);
        const QString said = failed ? outcome->message : tr("passes");
        cell->setToolTip(QStringLiteral("%1: %2").arg(m_task.checks[i], said));
        cell->setData(Qt::AccessibleTextRole, cell->toolTip());
        setItem(row, i + 1, cell);
    }
    QString said;
    if (report.error)
        said = tr("line %1: %2").arg(report.error->line).arg(report.error->message);
    else if (report.diagnosis())
        said = report.diagnosis()->mistake;
    else if (!report.remarks.empty())
        said = report.remarks.front().id;
    else if (report.passed)
        said = tr("passes");
    else if (program.role == VerifiedProgram::Role::Mistake)
        said = tr("not recognised");
    else if (program.role != VerifiedProgram::Role::Starter)
        said = firstFailure(report);
    auto *last = new QTableWidgetItem(said);
    last->setToolTip(said);
    const auto found =
        std::any_of(m_task.findings.begin(), m_task.findings.end(), [&](const LabFinding &finding) {
            return finding.program == programPath(program);
        });
    if (found)
        last->setForeground(colours.warning);
    setItem(row, columnCount() - 1, last);
}

void ProofMatrix::resizeEvent(QResizeEvent *event)
{
    QTableWidget::resizeEvent(event);
    fitColumns();
}

} // namespace cradle

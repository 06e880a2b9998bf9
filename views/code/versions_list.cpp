// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/versions_list.h"

#include "tasks/text/line_diff.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>

namespace cradle {

namespace {

enum Column { When, What, Change };

QString whatOf(const VersionNote &note)
{
    switch (note.reason) {
    case VersionReason::Typed:
        return VersionsList::tr("Written");
    case VersionReason::Before:
        return VersionsList::tr("Before it was replaced");
    case VersionReason::Outside:
        return VersionsList::tr("By another program");
    case VersionReason::Unsaved:
        return VersionsList::tr("From another window");
    case VersionReason::Checked:
        break;
    }
    return note.passed == true ? VersionsList::tr("✓ passed") : VersionsList::tr("not passed");
}

/// Of today only the time: the column is narrow.
QString whenText(const QDateTime &when)
{
    const QDateTime local = when.toLocalTime();
    const QLocale locale;
    return local.date() == QDate::currentDate()
               ? locale.toString(local.time(), QLocale::ShortFormat)
               : locale.toString(local, QLocale::ShortFormat);
}

/// The first line that is new against the version before, or else the first that is gone.
QString changeOf(const QString &before, const QString &after)
{
    const std::vector<DiffLine> diff = lineDiff(before, after);
    for (const auto kind : {DiffLine::Kind::Added, DiffLine::Kind::Removed}) {
        for (const DiffLine &line : diff) {
            if (line.kind != kind || line.text.trimmed().isEmpty())
                continue;
            return kind == DiffLine::Kind::Added
                       ? VersionsList::tr("line %1: %2").arg(line.after).arg(line.text.trimmed())
                       : VersionsList::tr("without: %1").arg(line.text.trimmed());
        }
    }
    return diff.empty() ? QString() : VersionsList::tr("the same program");
}

} // namespace

VersionsList::VersionsList(QWidget *parent)
    : QTreeWidget(parent)
{
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setColumnCount(3);
    header()->setStretchLastSection(true);
}

void VersionsList::fill(const std::vector<ShownVersion> &versions)
{
    clear();
    for (std::size_t i = 0; i < versions.size(); ++i) {
        const auto &[version, text] = versions[i];
        const QString before = i + 1 < versions.size() ? versions[i + 1].text : QString();
        auto *row = new QTreeWidgetItem(this);
        row->setText(When, whenText(version.when));
        row->setText(What, whatOf(version.note));
        row->setText(Change, changeOf(before, text));
        row->setToolTip(Change, row->text(Change));
    }
    fitColumns();
}

/// The last column takes what is left, or else the list scrolls.
void VersionsList::fitColumns()
{
    resizeColumnToContents(When);
    resizeColumnToContents(What);
    QHeaderView &columns = *header();
    const int needed = columns.sectionSizeHint(Change);
    const int left = viewport()->width() - columns.sectionPosition(Change);
    columns.setStretchLastSection(left >= needed);
    if (left < needed)
        columns.resizeSection(Change, needed);
}

void VersionsList::resizeEvent(QResizeEvent *event)
{
    QTreeWidget::resizeEvent(event);
    fitColumns();
}

void VersionsList::changeEvent(QEvent *event)
{
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) // the columns have it a little later
        QMetaObject::invokeMethod(this, &VersionsList::fitColumns, Qt::QueuedConnection);
}

void VersionsList::retranslate()
{
    setHeaderLabels({tr("When"), tr("Version"), tr("First difference")});
    setAccessibleName(tr("Versions of this step's program"));
}

} // namespace cradle

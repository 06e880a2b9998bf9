// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export_menu.h"

#include "app/main_window.h"
#include "app/menu_entries.h"
#include "views/charts/chart_pane.h"
#include "views/charts/phase_chart.h"
#include "views/menu.h"

#include <QCoreApplication>

namespace cradle {

namespace {

/// A submenu that is filled when it is opened, so that it knows what can be done.
void addExportOf(Menu *exports, const QString &name, PlotPane *chart)
{
    Menu *formats = exports->addMenu(name);
    QObject::connect(formats, &QMenu::aboutToShow, chart, [chart, formats] {
        formats->clear();
        chart->addExports(*formats);
    });
}

void fillExport(MainWindow &window, Menu *exports)
{
    for (ChartPane *chart : window.panes().charts())
        addExportOf(exports, chart->name(), chart);
    addExportOf(exports, window.panes().phase->windowTitle(), window.panes().phase);
    exports->addSeparator();
    RunDesk *desk = &window.runDesk();
    const std::pair<RunTable, QString> tables[] = {
        {RunTable::States, MenuText::tr("&States of the run as CSV…")},
        {RunTable::Totals, MenuText::tr("&Totals of the run as CSV…")},
        {RunTable::Events, MenuText::tr("&Hits of the run as CSV…")}};
    for (const auto &[table, text] : tables)
        exports->addAction(text, desk, [desk, kind = table] { desk->exportRun(kind); });
}

} // namespace

void addExport(MainWindow &window, Menu *menu)
{
    Menu *exports = menu->addMenu(MenuText::tr("E&xport"));
    // The charts learn of another language after the window.
    QObject::connect(exports, &QMenu::aboutToShow, &window, [w = &window, exports] {
        qDeleteAll(exports->findChildren<Menu *>(Qt::FindDirectChildrenOnly));
        exports->clear();
        fillExport(*w, exports);
    });
}

} // namespace cradle

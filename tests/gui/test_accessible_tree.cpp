// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/announcer.h"
#include "app/main_window.h"
#include "tests/gui/calm.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "views/charts/chart_plot.h"
#include "views/markdown_view.h"
#include "views/spoken_formula.h"

#include <QAccessible>

using namespace cradle;
using namespace cradle::windows;

/// The window as a screen reader finds it.
class TestAccessibleTree final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void sceneTellsItsCircles();
    void chartsTellTheirCurves();
    void chartsAreSteppedThroughByKeys();
    void verdictsAreAnnounced();
    void hitsAreAnnounced();
    void formulasAreSpoken_data();
    void formulasAreSpoken();
    void textsHaveNoHoles();

private:
    QTemporaryDir m_folder;
};

void TestAccessibleTree::sceneTellsItsCircles()
{
    OpenWindow open(m_folder);
    open.bench.openTask(QStringLiteral("L42T11"));
    open.bench.setMode(Mode::Explore);
    calm(open.window);
    QAccessibleInterface *scene = QAccessible::queryAccessibleInterface(&open.window.scene());
    QVERIFY(scene);
    QCOMPARE(scene->role(), QAccessible::Canvas);
    const QString told = scene->text(QAccessible::Value);
    QVERIFY2(told.contains(QStringLiteral("circle 1 at (−2.00, 2.00) m with (2.00, 0.00) m/s, "
                                          "radius 0.2 m")),
             qPrintable(told));
}

void TestAccessibleTree::chartsAreSteppedThroughByKeys()
{
    QTemporaryDir folder;
    OpenWindow open(folder);
    QVERIFY(open.bench.openTask(QStringLiteral("L42T12")));
    open.bench.setMode(Mode::Explore);
    open.window.resize(1440, 900);
    open.simulation().goTo(30);
    ChartPlot *plot = nullptr;
    const auto find = [&] {
        for (auto *each : open.window.findChildren<ChartPlot *>()) {
            const bool seen = each->isVisible() && !each->viewport()->visibleRegion().isEmpty();
            if (seen && each->curves().size() >= 2 && !plot)
                plot = each;
        }
        return plot != nullptr;
    };
    QTRY_VERIFY(find());
    QVERIFY(plot->told().isEmpty());
    const auto value = [plot] {
        return QAccessible::queryAccessibleInterface(plot)->text(QAccessible::Value);
    };
    plot->setFocus(Qt::TabFocusReason);
    const QString first = plot->told();
    QVERIFY(first.startsWith(plot->curves().front().label + QStringLiteral(": ")));
    QVERIFY2(value().startsWith(first), qPrintable(value()));
    QTest::keyClick(plot, Qt::Key_Up); // there is none before it
    QCOMPARE(plot->told(), first);
    QTest::keyClick(plot, Qt::Key_Down);
    const QString second = plot->told();
    QVERIFY(second.startsWith(plot->curves()[1].label + QStringLiteral(": ")));
    QVERIFY2(value().startsWith(second), qPrintable(value()));
    // The window's keys go on from the chart: a step, and with it the value told.
    QTest::keyClick(plot, Qt::Key_Right);
    QCOMPARE(open.simulation().current(), qint64{31});
    QTest::keyClick(plot, Qt::Key_N);
    QVERIFY(open.simulation().current() > 31);
    QTRY_VERIFY(value().startsWith(plot->told()));
    QTest::keyClick(plot, Qt::Key_Up);
    QVERIFY(plot->told().startsWith(plot->curves().front().label));
}

void TestAccessibleTree::verdictsAreAnnounced()
{
    QTemporaryDir folder;
    OpenWindow open(folder);
    QAccessibleInterface *live = QAccessible::queryAccessibleInterface(&open.window.announcer());
    QVERIFY(live);
    QCOMPARE(live->role(), QAccessible::AlertMessage);
    QVERIFY(live->text(QAccessible::Name).isEmpty());
    QVERIFY(open.bench.openTask(QStringLiteral("L42T1")));
    open.bench.setMode(Mode::Explore);
    open.check();
    QVERIFY2(live->text(QAccessible::Name).startsWith(QStringLiteral("Not yet: ")),
             qPrintable(live->text(QAccessible::Name)));
    QVERIFY(open.bench.document().edit(QStringLiteral("solve"), open.solution()));
    open.check();
    QCOMPARE(live->text(QAccessible::Name), QStringLiteral("Check passed."));
}

void TestAccessibleTree::hitsAreAnnounced()
{
    QTemporaryDir folder;
    OpenWindow open(folder);
    QVERIFY(open.bench.openTask(QStringLiteral("L42T12")));
    open.bench.setMode(Mode::Explore);
    QVERIFY(open.bench.document().edit(QStringLiteral("solve"), open.solution()));
    const Announcer &live = open.window.announcer();
    QVERIFY(live.said().isEmpty());
    open.simulation().seekNextHit();
    const Hit &hit = open.simulation().recording().hits().front();
    QVERIFY2(
        live.said().startsWith(
            QStringLiteral("Hit at %1 s: circle 1 and ").arg(QString::number(hit.time, 'f', 3))),
        qPrintable(live.said()));
    QVERIFY(live.said().endsWith(QStringLiteral("N s")));
    open.window.choices().announceHits(false);
    const QString before = live.said();
    open.simulation().seekNextHit();
    QCOMPARE(live.said(), before);
}

void TestAccessibleTree::chartsTellTheirCurves()
{
    OpenWindow open(m_folder);
    open.bench.openTask(QStringLiteral("L42T11"));
    open.bench.setMode(Mode::Explore);
    open.simulation().goTo(30);
    calm(open.window);
    int charts = 0;
    for (QWidget *widget : open.window.findChildren<QWidget *>()) {
        if (!widget->isVisible() || !widget->inherits("cradle::ChartPlot"))
            continue;
        QAccessibleInterface *chart = QAccessible::queryAccessibleInterface(widget);
        QCOMPARE(chart->role(), QAccessible::Chart);
        ++charts;
        QVERIFY2(chart->text(QAccessible::Value).contains(QStringLiteral("circle 1"))
                     || chart->text(QAccessible::Value).contains(QStringLiteral("kinetic")),
                 qPrintable(chart->text(QAccessible::Value)));
    }
    QVERIFY(charts >= 1);
}

void TestAccessibleTree::formulasAreSpoken_data()
{
    QTest::addColumn<QString>("tex");
    QTest::addColumn<QString>("spoken");
    const auto row = [](const char *tex, const char *spoken) {
        QTest::newRow(tex) << QString::fromUtf8(tex) << QString::fromUtf8(spoken);
    };
    row("v_x = 2", "v sub x equals 2");
    row("x=-2", "x equals minus 2");
    row("E = \\frac{1}{2} m v^2", "E equals 1 over 2 m v squared");
    row("\\sqrt{x^3}", "the square root of x cubed");
    row("\\Delta t \\le 0.5", "Delta t is at most 0.5");
    row("\\vec{v}_{1}\\cdot\\hat n", "vector v sub 1 times unit vector n");
    row("e^{-kt}", "e to the power of minus k t");
    row("5\\,\\text{m/s}", "5 m/s");
    row("\\left(a + b\\right)", "( a plus b )");
}

void TestAccessibleTree::formulasAreSpoken()
{
    QFETCH(QString, tex);
    QFETCH(QString, spoken);
    QCOMPARE(spokenFormula(tex), spoken);
}

/// In none of the steps is there a formula that is told as U+FFFC, or as TeX.
void TestAccessibleTree::textsHaveNoHoles()
{
    OpenWindow open(m_folder);
    for (const Task &task : open.bench.lab().tasks) {
        MarkdownView view;
        view.setMarkdown(task.instructions, QUrl::fromLocalFile(task.folder));
        const QAccessibleInterface *text = QAccessible::queryAccessibleInterface(&view);
        const QString told = text->text(QAccessible::Name);
        QVERIFY2(!told.contains(QChar::ObjectReplacementCharacter), qPrintable(task.id));
        QVERIFY2(!told.contains(QChar(0xE000)), qPrintable(task.id));
        QVERIFY2(!told.contains(QLatin1Char('\\')), qPrintable(task.id + told));
    }
}

QTEST_MAIN(TestAccessibleTree)

#include "test_accessible_tree.moc"

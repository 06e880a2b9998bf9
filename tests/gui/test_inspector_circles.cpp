// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cpu_timer.h"
#include "tests/gui/open_inspector.h"
#include "tests/patience.h"
#include "views/inspector/circle_table_model.h"
#include "views/shortcut_guard.h"

#include <QAction>
#include <QScrollBar>
#include <QSignalSpy>

#include <memory>

using namespace cradle;

class TestInspectorCircles final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init();
    void cleanup() { m_open.reset(); }
    void cellTakesANumber();
    void massIsAPlainNumber();
    void cellKeepsEditingWhatIsImpossible();
    void cellSpins();
    void refusedNumberStaysInSight();
    void spaceBelongsToTheShortcut();
    void addingDoesNotScrollSideways();
    void addsDuplicatesAndRemoves();
    void selectionIsToldOnce();
    void editingACircleEndsTheFill();
    void duplicateStaysOnlyWhereCirclesPass();
    void manyCirclesAreCheap();

private:
    std::unique_ptr<OpenInspector> m_open;
};

void TestInspectorCircles::init()
{
    m_open = std::make_unique<OpenInspector>();
    QVERIFY(m_open->show());
}

void TestInspectorCircles::cellTakesANumber()
{
    NumberField *cell = m_open->editCell(0, CircleTableModel::VelocityX);
    QVERIFY(cell);
    m_open->type(cell, QStringLiteral("1/3"), Qt::Key_Return);
    QCOMPARE(m_open->preset().circles[0].body.velocity.x, 1.0 / 3.0);
    QCOMPARE(m_open->document.undoStack().undoText(),
             QStringLiteral("Change velocity of circle 1"));
}

/// 7800 · 4/3 π r³ kg
void TestInspectorCircles::massIsAPlainNumber()
{
    const auto massWith = [this](double radius) {
        Preset preset = inspectedScene();
        preset.circles[0].body.radius = radius;
        m_open->document.edit(QStringLiteral("Radius"), preset);
        const QModelIndex cell = m_open->table()->model()->index(0, CircleTableModel::Mass);
        return cell.data().toString();
    };
    QCOMPARE(massWith(0.2), QStringLiteral("261.38"));
    QCOMPARE(massWith(1.6), QStringLiteral("133827")); // as in Piston drop, not 1.3383e+05
    QCOMPARE(massWith(0.002), QStringLiteral("0.00026138"));
}

void TestInspectorCircles::cellKeepsEditingWhatIsImpossible()
{
    NumberField *cell = m_open->editCell(1, CircleTableModel::X);
    m_open->type(cell, QStringLiteral("-1.9"), Qt::Key_Return); // into circle 1
    QVERIFY(cell->isVisible());
    QVERIFY(cell->isRefused());
    QCOMPARE(cell->text(), QStringLiteral("-1.9"));
    QVERIFY(m_open->says(QStringLiteral("overlap")));
    QCOMPARE(m_open->preset().circles[1].body.position.x, 2.0);
    QTest::keyClick(cell, Qt::Key_Escape);
    QVERIFY(!m_open->says(QStringLiteral("overlap")));
    QCOMPARE(m_open->table()->model()->index(1, CircleTableModel::X).data().toString(),
             QStringLiteral("2"));
}

void TestInspectorCircles::cellSpins()
{
    NumberField *cell = m_open->editCell(1, CircleTableModel::Y);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(cell, Qt::Key_Up);
    QCOMPARE(m_open->preset().circles[1].body.position.y, 0.3);
    QCOMPARE(m_open->document.undoStack().count(), 1);
}

void TestInspectorCircles::refusedNumberStaysInSight()
{
    NumberField *cell = m_open->editCell(0, CircleTableModel::Radius);
    m_open->type(cell, QStringLiteral("-1"), Qt::Key_Return);
    QVERIFY(cell->isRefused());
    QCOMPARE(cell->text(), QStringLiteral("-1"));
    QVERIFY(m_open->says(QStringLiteral("Not possible")));
    QTest::keyClick(cell, Qt::Key_Tab); // leads nowhere as long as it is impossible
    QCOMPARE(cell->text(), QStringLiteral("-1"));
    m_open->field(QStringLiteral("Restitution"))->setFocus();
    QVERIFY(!m_open->says(QStringLiteral("Not possible")));
    QCOMPARE(m_open->preset(), inspectedScene());
}

void TestInspectorCircles::spaceBelongsToTheShortcut()
{
    guardShortcuts();
    QAction run;
    run.setShortcut(Qt::Key_Space);
    m_open->inspector.addAction(&run);
    QSignalSpy runs(&run, &QAction::triggered);
    NumberField *cell = m_open->editCell(0, CircleTableModel::VelocityX);
    m_open->type(cell, QStringLiteral("2"), Qt::Key_Return);
    QTableView *table = m_open->table();
    QTRY_VERIFY(table->hasFocus());
    const auto editors = [table] { return table->viewport()->findChildren<QLineEdit *>().size(); };
    QTRY_COMPARE(editors(), 0);
    for (const int column : {CircleTableModel::VelocityX, CircleTableModel::Name}) {
        table->setCurrentIndex(table->model()->index(0, column));
        QTest::keyClick(table, Qt::Key_Space);
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(editors(), 0);
    }
    QCOMPARE(runs.size(), 2);
    run.setEnabled(false);
    QTest::keyClick(table, Qt::Key_Space);
    QCOMPARE(editors(), 0);
    for (const char typed : {'7', '-', '.'}) {
        table->setCurrentIndex(table->model()->index(0, CircleTableModel::VelocityX));
        QTest::keyClick(table, typed);
        auto *editor = table->viewport()->findChild<NumberField *>();
        QVERIFY(editor);
        QCOMPARE(editor->text(), QString(QLatin1Char(typed)));
        QTest::keyClick(editor, Qt::Key_Escape);
        QTRY_COMPARE(editors(), 0);
    }
}

void TestInspectorCircles::addingDoesNotScrollSideways()
{
    m_open->inspector.resize(300, 400);
    QCoreApplication::processEvents();
    QScrollBar *sideways = m_open->table()->horizontalScrollBar();
    QVERIFY(sideways->maximum() > 60);
    for (const int left : {0, 60, sideways->maximum()}) {
        sideways->setValue(left);
        QTest::mouseClick(m_open->button(QStringLiteral("Add circle")), Qt::LeftButton);
        QCoreApplication::processEvents();
        QCOMPARE(sideways->value(), left);
    }
    QCOMPARE(m_open->inspector.selected(), 4);
}

void TestInspectorCircles::addsDuplicatesAndRemoves()
{
    QTest::mouseClick(m_open->button(QStringLiteral("Add circle")), Qt::LeftButton);
    QCOMPARE(m_open->preset().circles.size(), 3U);
    QCOMPARE(m_open->preset().circles[2].name, QStringLiteral("circle 3"));
    QVERIFY(m_open->preset().circles[2].colour != m_open->preset().circles[0].colour);
    QCOMPARE(m_open->inspector.selected(), 2);
    QTest::mouseClick(m_open->button(QStringLiteral("Duplicate")), Qt::LeftButton);
    QCOMPARE(m_open->preset().circles.size(), 4U);
    QVERIFY(!findFault(m_open->preset()));
    m_open->table()->setFocus();
    QTest::keyClick(m_open->table(), Qt::Key_Delete);
    QTest::mouseClick(m_open->button(QStringLiteral("Remove")), Qt::LeftButton);
    QCOMPARE(m_open->preset(), inspectedScene());
}

void TestInspectorCircles::selectionIsToldOnce()
{
    QSignalSpy told(&m_open->inspector, &Inspector::selectionChanged);
    m_open->inspector.select(1);
    QCOMPARE(told.size(), 1);
    QCOMPARE(m_open->inspector.selected(), 1);
    m_open->type(m_open->field(QStringLiteral("Gravity upward")), QStringLiteral("-1"),
                 Qt::Key_Return);
    QCOMPARE(m_open->inspector.selected(), 1);
    m_open->inspector.select(-1);
    QCOMPARE(m_open->inspector.selected(), -1);
    QCOMPARE(told.size(), 2);
}

void TestInspectorCircles::editingACircleEndsTheFill()
{
    Preset filled = m_open->preset();
    filled.fill = CircleFill{.count = 20};
    filled.circles = *makeCircles(*filled.fill, filled.halfWidth);
    m_open->document.open(filled);
    m_open->type(m_open->editCell(3, CircleTableModel::VelocityX), QStringLiteral("1"),
                 Qt::Key_Return);
    QVERIFY(!m_open->preset().fill);
    QCOMPARE(m_open->preset().circles.size(), 20U);
}

void TestInspectorCircles::duplicateStaysOnlyWhereCirclesPass()
{
    Preset passing = inspectedScene();
    passing.laws.circles = CircleLaw::None;
    QCOMPARE(withDuplicate(passing, 1).circles[2].body, passing.circles[1].body);
    const Preset beside = withDuplicate(inspectedScene(), 1);
    QVERIFY(!findFault(beside));
    QVERIFY(length(beside.circles[2].body.position - beside.circles[1].body.position) < 0.6);
    QCOMPARE(withAddedCircle(passing, Vec2{1.0, 2.0}).circles[2].body.position, (Vec2{1.0, 2.0}));
    QCOMPARE(withoutCircle(passing, 0).circles.front().name, QStringLiteral("circle 2"));
    QCOMPARE(withoutCircle(passing, 7), passing);
}

void TestInspectorCircles::manyCirclesAreCheap()
{
    Preset crowd = m_open->preset();
    crowd.halfWidth = 100.0;
    crowd.fill = CircleFill{.count = 20'000};
    crowd.circles = *makeCircles(*crowd.fill, crowd.halfWidth);
    const CpuTimer watch;
    m_open->document.open(crowd);
    QCoreApplication::processEvents();
    QCOMPARE(m_open->table()->model()->rowCount(), 20'000);
    QVERIFY2(watch.elapsed() < 1000.0, qPrintable(QString::number(watch.elapsed())));
}

QTEST_MAIN(TestInspectorCircles)
#include "test_inspector_circles.moc"

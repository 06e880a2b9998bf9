// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/circle_edits.h"
#include "views/inspector/circle_table_model.h"
#include "views/inspector/inspector.h"
#include "views/inspector/number_field.h"
#include "views/inspector/number_text.h"
#include "views/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include <memory>

using namespace cradle;

namespace {

Preset twoCircles()
{
    Preset preset;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete};
    PresetCircle first;
    first.name = QStringLiteral("circle 1");
    first.body.position = {-2.0, 0.0};
    PresetCircle second = first;
    second.name = QStringLiteral("circle 2");
    second.colour = QStringLiteral("#e03131");
    second.body.position = {2.0, 0.0};
    preset.circles = {first, second};
    return preset;
}

} // namespace

class TestInspector final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init();
    void cleanup();
    void readsNumbersAsTyped_data();
    void readsNumbersAsTyped();
    void writesFractionsAndCleanSpins();
    void typedGravityIsUndoable();
    void spinsAreOneUndoStep();
    void timestepTakesFractions();
    void impossibleNumberIsRefusedAndTakenBack();
    void textThatIsNoNumberIsRefused();
    void lawsAreChosen();
    void refusedLawGoesBack();
    void cellTakesANumber();
    void cellKeepsEditingWhatIsImpossible();
    void cellSpins();
    void addsDuplicatesAndRemoves();
    void resetsToTheStepsScene();
    void selectionIsToldOnce();
    void editingACircleEndsTheFill();
    void duplicateStaysOnlyWhereCirclesPass();
    void noteAppearsAwayFromTheStart();
    void manyCirclesAreCheap();
    void fitsItsPane_data();
    void fitsItsPane();

private:
    NumberField *field(const QString &name) const;
    QComboBox *law(const QString &name) const;
    QPushButton *button(const QString &name) const;
    QTableView *table() const { return m_inspector->findChild<QTableView *>(); }
    NumberField *editCell(int row, int column) const;
    bool says(const QString &part) const;
    void type(NumberField *into, const QString &text, int key) const;
    const Preset &preset() const { return m_document->preset(); }

    std::unique_ptr<Simulation> m_simulation;
    std::unique_ptr<PresetDocument> m_document;
    std::unique_ptr<Inspector> m_inspector;
};

void TestInspector::init()
{
    m_simulation = std::make_unique<Simulation>(twoCircles());
    m_document = std::make_unique<PresetDocument>(*m_simulation);
    m_inspector = std::make_unique<Inspector>(*m_document);
    m_inspector->resize(700, 400);
    m_inspector->show();
    m_inspector->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_inspector.get()));
}

void TestInspector::cleanup()
{
    m_inspector.reset();
    m_document.reset();
    m_simulation.reset();
}

NumberField *TestInspector::field(const QString &name) const
{
    for (auto *each : m_inspector->findChildren<NumberField *>()) {
        if (each->accessibleName().startsWith(name))
            return each;
    }
    return nullptr;
}

QComboBox *TestInspector::law(const QString &name) const
{
    for (auto *each : m_inspector->findChildren<QComboBox *>()) {
        if (each->accessibleName() == QStringLiteral("Law: ") + name)
            return each;
    }
    return nullptr;
}

QPushButton *TestInspector::button(const QString &name) const
{
    for (auto *each : m_inspector->findChildren<QPushButton *>()) {
        if (each->accessibleName() == name)
            return each;
    }
    return nullptr;
}

NumberField *TestInspector::editCell(int row, int column) const
{
    table()->setFocus();
    table()->setCurrentIndex(table()->model()->index(row, column));
    table()->edit(table()->currentIndex());
    return table()->viewport()->findChild<NumberField *>();
}

bool TestInspector::says(const QString &part) const
{
    for (const auto *label : m_inspector->findChildren<QLabel *>()) {
        if (label->isVisible() && label->text().contains(part))
            return true;
    }
    return false;
}

void TestInspector::type(NumberField *into, const QString &text, int key) const
{
    into->setFocus();
    into->selectAll();
    QTest::keyClicks(into, text);
    QTest::keyClick(into, static_cast<Qt::Key>(key));
}

void TestInspector::readsNumbersAsTyped_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("number");
    QTest::newRow("point") << QStringLiteral("0.5") << 0.5;
    QTest::newRow("comma") << QStringLiteral("0,5") << 0.5;
    QTest::newRow("exponent") << QStringLiteral(" 1e-3 ") << 0.001;
    QTest::newRow("fraction") << QStringLiteral("1/240") << 1.0 / 240.0;
    QTest::newRow("minus sign") << QStringLiteral("−9.81") << -9.81;
    QTest::newRow("with unit") << QStringLiteral("9.81 m/s²") << 9.81;
    QTest::newRow("no number") << QStringLiteral("fast") << qQNaN();
    QTest::newRow("nothing") << QString() << qQNaN();
    QTest::newRow("over zero") << QStringLiteral("1/0") << qQNaN();
    QTest::newRow("infinite") << QStringLiteral("inf") << qQNaN();
    QTest::newRow("grouped") << QStringLiteral("1,234.5") << qQNaN();
}

void TestInspector::readsNumbersAsTyped()
{
    QFETCH(QString, text);
    QFETCH(double, number);
    const std::optional<double> read = readNumber(text, QStringLiteral("m/s²"));
    QCOMPARE(read.has_value(), !qIsNaN(number));
    if (read)
        QCOMPARE(*read, number);
}

void TestInspector::writesFractionsAndCleanSpins()
{
    QCOMPARE(fractionOrNumber(1.0 / 60.0), QStringLiteral("1/60"));
    QCOMPARE(fractionOrNumber(0.01), QStringLiteral("0.01"));
    QCOMPARE(fractionOrNumber(0.017), QStringLiteral("0.017"));
    QCOMPARE(spun(0.2, 0.1, 1), 0.3);
    QCOMPARE(spun(0.1, 0.1, -1), 0.0);
    QCOMPARE(spun(-9.81, 0.1, 10), -8.81);
}

void TestInspector::typedGravityIsUndoable()
{
    NumberField *gravity = field(QStringLiteral("Gravity upward"));
    type(gravity, QStringLiteral("-9,81"), Qt::Key_Return);
    QCOMPARE(preset().gravity.y, -9.81);
    QCOMPARE(gravity->text(), QStringLiteral("-9.81"));
    QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Change gravity"));
    m_document->undoStack().undo();
    QCOMPARE(preset().gravity.y, 0.0);
    QCOMPARE(gravity->text(), QStringLiteral("0"));
    type(gravity, QStringLiteral("0.1234567890123456"), Qt::Key_Tab);
    QCOMPARE(preset().gravity.y, 0.1234567890123456);
}

void TestInspector::spinsAreOneUndoStep()
{
    NumberField *e = field(QStringLiteral("Restitution"));
    e->setFocus();
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(e, Qt::Key_Down);
    QCOMPARE(preset().restitution, 0.85);
    QCOMPARE(m_document->undoStack().count(), 1);
    for (int i = 0; i < 9; ++i)
        QTest::keyClick(e, Qt::Key_Up);
    QCOMPARE(preset().restitution, 1.0); // and no further
    QVERIFY(!e->isRefused());
}

void TestInspector::timestepTakesFractions()
{
    NumberField *step = field(QStringLiteral("Timestep"));
    QCOMPARE(step->text(), QStringLiteral("1/60"));
    QVERIFY(says(QStringLiteral("0.0167 s")));
    type(step, QStringLiteral("1/240"), Qt::Key_Return);
    QCOMPARE(preset().timestep, 1.0 / 240.0);
    QTest::keyClick(step, Qt::Key_Up);
    QCOMPARE(preset().timestep, 1.0 / 120.0);
    QCOMPARE(step->text(), QStringLiteral("1/120"));
}

void TestInspector::impossibleNumberIsRefusedAndTakenBack()
{
    NumberField *e = field(QStringLiteral("Restitution"));
    type(e, QStringLiteral("2"), Qt::Key_Return);
    QVERIFY(e->isRefused());
    QCOMPARE(e->text(), QStringLiteral("2"));
    QCOMPARE(preset().restitution, 1.0);
    QVERIFY(says(QStringLiteral("Not possible")));
    QTest::keyClick(e, Qt::Key_Escape);
    QVERIFY(!e->isRefused());
    QCOMPARE(e->text(), QStringLiteral("1"));
    QVERIFY(!says(QStringLiteral("Not possible")));
    type(e, QStringLiteral("2"), Qt::Key_Return);
    field(QStringLiteral("Half width"))->setFocus();
    QCOMPARE(e->text(), QStringLiteral("1"));
    QVERIFY(!e->isRefused());
}

void TestInspector::textThatIsNoNumberIsRefused()
{
    NumberField *width = field(QStringLiteral("Half width"));
    type(width, QStringLiteral("wide"), Qt::Key_Return);
    QVERIFY(width->isRefused());
    QVERIFY(says(QStringLiteral("is not a number")));
    type(width, QStringLiteral("5"), Qt::Key_Return);
    QCOMPARE(preset().halfWidth, 5.0);
    QVERIFY(!says(QStringLiteral("is not a number")));
}

void TestInspector::lawsAreChosen()
{
    QComboBox *circles = law(QStringLiteral("Circles"));
    QCOMPARE(circles->currentText(), QStringLiteral("Impulse"));
    circles->setFocus();
    QTest::keyClick(circles, Qt::Key_Up);
    QCOMPARE(preset().laws.circles, CircleLaw::SwapNormal);
    QVERIFY(!circles->toolTip().isEmpty());
    m_document->undoStack().undo();
    QCOMPARE(circles->currentText(), QStringLiteral("Impulse"));
    QComboBox *timing = law(QStringLiteral("Timing"));
    QTest::keyClick(timing, Qt::Key_Down);
    QCOMPARE(preset().laws.timing, Timing::Continuous);
}

void TestInspector::refusedLawGoesBack()
{
    Preset outside = preset();
    outside.laws.walls = WallLaw::None;
    outside.circles[1].body.position = {40.0, 0.0};
    QVERIFY(m_document->edit(QStringLiteral("out"), outside));
    QComboBox *walls = law(QStringLiteral("Walls"));
    QTest::keyClick(walls, Qt::Key_Down);
    QCOMPARE(preset().laws.walls, WallLaw::None);
    QCOMPARE(walls->currentIndex(), 0);
    QVERIFY(says(QStringLiteral("circle 2")));
}

void TestInspector::cellTakesANumber()
{
    NumberField *cell = editCell(0, CircleTableModel::VelocityX);
    QVERIFY(cell);
    type(cell, QStringLiteral("1/3"), Qt::Key_Return);
    QCOMPARE(preset().circles[0].body.velocity.x, 1.0 / 3.0);
    QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Change velocity of circle 1"));
}

void TestInspector::cellKeepsEditingWhatIsImpossible()
{
    NumberField *cell = editCell(1, CircleTableModel::X);
    type(cell, QStringLiteral("-1.9"), Qt::Key_Return); // into circle 1
    QVERIFY(cell->isVisible());
    QVERIFY(cell->isRefused());
    QVERIFY(says(QStringLiteral("overlap")));
    QCOMPARE(preset().circles[1].body.position.x, 2.0);
    QTest::keyClick(cell, Qt::Key_Escape);
    QVERIFY(!says(QStringLiteral("overlap")));
    QCOMPARE(table()->model()->index(1, CircleTableModel::X).data().toString(),
             QStringLiteral("2"));
}

void TestInspector::cellSpins()
{
    NumberField *cell = editCell(1, CircleTableModel::Y);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(cell, Qt::Key_Up);
    QCOMPARE(preset().circles[1].body.position.y, 0.3);
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TestInspector::addsDuplicatesAndRemoves()
{
    QTest::mouseClick(button(QStringLiteral("Add circle")), Qt::LeftButton);
    QCOMPARE(preset().circles.size(), 3U);
    QCOMPARE(preset().circles[2].name, QStringLiteral("circle 3"));
    QVERIFY(preset().circles[2].colour != preset().circles[0].colour);
    QCOMPARE(m_inspector->selected(), 2);
    QTest::mouseClick(button(QStringLiteral("Duplicate")), Qt::LeftButton);
    QCOMPARE(preset().circles.size(), 4U);
    QVERIFY(!findFault(preset()));
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_Delete);
    QTest::mouseClick(button(QStringLiteral("Remove")), Qt::LeftButton);
    QCOMPARE(preset(), twoCircles());
}

void TestInspector::resetsToTheStepsScene()
{
    QPushButton *reset = button(QStringLiteral("Reset to the step's scene"));
    QVERIFY(!reset->isEnabled());
    type(field(QStringLiteral("Gravity upward")), QStringLiteral("-1"), Qt::Key_Return);
    QVERIFY(reset->isEnabled());
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(preset(), twoCircles());
    QVERIFY(!reset->isEnabled());
    m_document->undoStack().undo();
    QCOMPARE(preset().gravity.y, -1.0);
}

void TestInspector::selectionIsToldOnce()
{
    QSignalSpy told(m_inspector.get(), &Inspector::selectionChanged);
    m_inspector->select(1);
    QCOMPARE(told.size(), 1);
    QCOMPARE(m_inspector->selected(), 1);
    type(field(QStringLiteral("Gravity upward")), QStringLiteral("-1"), Qt::Key_Return);
    QCOMPARE(m_inspector->selected(), 1);
    m_inspector->select(-1);
    QCOMPARE(m_inspector->selected(), -1);
    QCOMPARE(told.size(), 2);
}

void TestInspector::editingACircleEndsTheFill()
{
    Preset filled = preset();
    filled.fill = CircleFill{.count = 20};
    filled.circles = *makeCircles(*filled.fill, filled.halfWidth);
    m_document->open(filled);
    type(editCell(3, CircleTableModel::VelocityX), QStringLiteral("1"), Qt::Key_Return);
    QVERIFY(!preset().fill);
    QCOMPARE(preset().circles.size(), 20U);
}

void TestInspector::duplicateStaysOnlyWhereCirclesPass()
{
    Preset passing = twoCircles();
    passing.laws.circles = CircleLaw::None;
    QCOMPARE(withDuplicate(passing, 1).circles[2].body, passing.circles[1].body);
    const Preset beside = withDuplicate(twoCircles(), 1);
    QVERIFY(!findFault(beside));
    QVERIFY(length(beside.circles[2].body.position - beside.circles[1].body.position) < 0.6);
    QCOMPARE(withAddedCircle(passing, Vec2{1.0, 2.0}).circles[2].body.position, (Vec2{1.0, 2.0}));
    QCOMPARE(withoutCircle(passing, 0).circles.front().name, QStringLiteral("circle 2"));
    QCOMPARE(withoutCircle(passing, 7), passing);
}

void TestInspector::noteAppearsAwayFromTheStart()
{
    QVERIFY(!says(QStringLiteral("start of the run")));
    m_simulation->stepForward();
    QVERIFY(says(QStringLiteral("start of the run")));
    m_simulation->restart();
    QVERIFY(!says(QStringLiteral("start of the run")));
}

void TestInspector::manyCirclesAreCheap()
{
    Preset crowd = preset();
    crowd.halfWidth = 100.0;
    crowd.fill = CircleFill{.count = 20'000};
    crowd.circles = *makeCircles(*crowd.fill, crowd.halfWidth);
    QElapsedTimer watch;
    watch.start();
    m_document->open(crowd);
    QCoreApplication::processEvents();
    QCOMPARE(table()->model()->rowCount(), 20'000);
    QVERIFY2(watch.elapsed() < 1000, qPrintable(QString::number(watch.elapsed())));
}

void TestInspector::fitsItsPane_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("the mock's") << QSize(724, 260);
    QTest::newRow("at 1280") << QSize(600, 240);
    QTest::newRow("wide") << QSize(1500, 220);
}

void TestInspector::fitsItsPane()
{
    QFETCH(QSize, size);
    m_inspector->resize(size);
    QCoreApplication::processEvents();
    QCOMPARE(m_inspector->size(), size);
    for (const QWidget *each : m_inspector->findChildren<QWidget *>()) {
        if (!each->isVisible()
            || (!qobject_cast<const QComboBox *>(each) && !qobject_cast<const QPushButton *>(each)))
            continue;
        QVERIFY(each->width() >= each->minimumSizeHint().width());
        const int right = each->mapTo(m_inspector.get(), QPoint(each->width(), 0)).x();
        QVERIFY2(right <= size.width(), qPrintable(each->accessibleName()));
    }
}

QTEST_MAIN(TestInspector)
#include "test_inspector.moc"

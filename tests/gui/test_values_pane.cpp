// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/chart_scenes.h"
#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "views/values/hits_model.h"
#include "views/values/values_model.h"
#include "views/values/values_table.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTest>

using namespace cradle;

class TestValuesPane final : public QObject
{
    Q_OBJECT
private slots:
    void valuesAreThoseOfTheMoment();
    void cellsTellAllDigits();
    void sentenceTellsTheLastHit();
    void momentumIsTold_data();
    void momentumIsTold();
    void sentenceLeavesTheTableFree();
    void emptyHitsSayWhatToDo();
    void hitsAreBounded();
    void hitSeeksToItsFrame();
    void tableIsCopied();
};

void TestValuesPane::valuesAreThoseOfTheMoment()
{
    Simulation simulation(glancing());
    ValuesModel model(simulation);
    run(simulation, 60);
    model.refresh(0, 2);
    QCOMPARE(model.rowCount(), 3); // two circles and their sum
    QCOMPARE(model.index(0, ValuesModel::X).data().toString(), QStringLiteral("0.000"));
    QCOMPARE(model.index(0, ValuesModel::VelocityX).data().toString(), QStringLiteral("2.000"));
    QCOMPARE(model.index(2, ValuesModel::MomentumX).data().toString(), QStringLiteral("522.76"));
    QCOMPARE(model.index(2, ValuesModel::X).data().toString(), QString());
    simulation.seek(0);
    QCOMPARE(model.index(0, ValuesModel::X).data().toString(), QStringLiteral("-2.000"));
}

void TestValuesPane::cellsTellAllDigits()
{
    Preset preset = glancing();
    preset.circles[0].body.position.x = -1.99731234567;
    Simulation simulation(preset);
    const ValuesModel model(simulation);
    const QModelIndex x = model.index(0, ValuesModel::X);
    QCOMPARE(x.data().toString(), QStringLiteral("-1.997"));
    QCOMPARE(x.data(Qt::ToolTipRole).toString(), QStringLiteral("−1.99731234567 m"));
    QCOMPARE(model.index(0, ValuesModel::Mass).data().toString(), QStringLiteral("261.4"));
    const QModelIndex mass = model.index(2, ValuesModel::Mass);
    QVERIFY(mass.data(Qt::ToolTipRole).toString().startsWith(QStringLiteral("522.7610")));
}

void TestValuesPane::sentenceTellsTheLastHit()
{
    Simulation simulation(glancing());
    ValuesPane pane(simulation);
    QCOMPARE(pane.hitSentence(), QStringLiteral("No hit so far."));
    run(simulation, 120);
    QCOMPARE(pane.hitSentence(), QStringLiteral("Hit 1 at 1.868 s: momentum before 522.8, "
                                                "after 522.8, change 0 kg m/s."));
}

void TestValuesPane::momentumIsTold_data()
{
    QTest::addColumn<Hit>("hit");
    QTest::addColumn<QString>("wanted");
    const Hit level{.time = 1.0, .b = 1, .beforeA = {-1.0, 0.0}, .afterB = {-1.0, 0.0}};
    QTest::newRow("along x") << level
                             << QStringLiteral("momentum before −261.4, after −261.4, "
                                               "change 0 kg m/s.");
    Hit slanting = level;
    slanting.beforeA = slanting.afterB = {-1.0, 2.0};
    QTest::newRow("kept") << slanting
                          << QStringLiteral("momentum before (−261.4, 522.8), "
                                            "after (−261.4, 522.8), change (0, 0) kg m/s.");
    const Hit wall{.kind = Hit::Kind::Wall,
                   .b = static_cast<int>(Wall::Right),
                   .beforeA = {1.0, 0.0},
                   .afterA = {-1.0, 0.0}};
    QTest::newRow("wall") << wall
                          << QStringLiteral("momentum before 261.4, after −261.4, "
                                            "change −522.8 kg m/s.");
}

void TestValuesPane::momentumIsTold()
{
    QFETCH(Hit, hit);
    QFETCH(QString, wanted);
    const std::vector<Circle> circles(2, Circle{});
    const QString sentence = describeHit(1, hit, circles);
    QVERIFY2(sentence.endsWith(wanted), qPrintable(sentence));
}

void TestValuesPane::sentenceLeavesTheTableFree()
{
    Simulation simulation(glancing());
    ValuesPane pane(simulation);
    run(simulation, 130);
    auto *table = pane.tabs().widget(0)->findChild<QTableView *>();
    auto *sentence = pane.tabs().widget(0)->findChild<QLabel *>();
    for (const int height : {400, 260, 200, 160, 140}) {
        pane.resize(356, height);
        pane.show();
        settle();
        QVERIFY2(!sentence->geometry().intersects(table->geometry()),
                 qPrintable(QString::number(height)));
        const bool isWhole = sentence->text() == pane.hitSentence();
        QCOMPARE(sentence->toolTip(), isWhole ? QString() : pane.hitSentence());
        QVERIFY(isWhole || height < 400);
        QVERIFY(!isWhole || height > 160);
    }
}

void TestValuesPane::emptyHitsSayWhatToDo()
{
    Simulation simulation(glancing());
    ValuesPane pane(simulation);
    pane.tabs().setCurrentIndex(1);
    pane.show();
    const auto *hint = pane.tabs().widget(1)->findChild<QLabel *>();
    QVERIFY(hint);
    QCOMPARE(hint->text(), QStringLiteral("No hits yet: press Run or Next hit"));
    QTRY_VERIFY(hint->isVisible());
    run(simulation, 130);
    QTRY_VERIFY(!hint->isVisible());
}

void TestValuesPane::hitsAreBounded()
{
    Preset preset;
    preset.halfWidth = 0.3;
    preset.laws.walls = WallLaw::Reflect;
    preset.laws.timing = Timing::Continuous;
    preset.circles = {{QStringLiteral("fast"), {{0.0, 0.0}, {60.0, 0.0}}}};
    Simulation simulation(preset);
    HitsModel model(simulation);
    for (int i = 0; i < 40; ++i) {
        run(simulation, 10);
        model.update();
        QVERIFY(model.rowCount() <= HitsModel::mostRows);
        QCOMPARE(model.hitCount(), static_cast<qint64>(simulation.recording().hits().size()));
    }
    QCOMPARE(model.rowCount(), static_cast<int>(HitsModel::mostRows));
    QCOMPARE(model.hit(model.rowCount() - 1), simulation.recording().hits().back());
    simulation.restart();
    QCOMPARE(model.rowCount(), 0);
}

void TestValuesPane::hitSeeksToItsFrame()
{
    Simulation simulation(glancing());
    ValuesPane pane(simulation);
    pane.resize(340, 300);
    pane.show();
    run(simulation, 130);
    pane.tabs().setCurrentIndex(1);
    settle();
    QCOMPARE(pane.tabs().tabText(1), QStringLiteral("Hits 1"));
    auto *table = qobject_cast<QTableView *>(pane.tabs().currentWidget());
    QSignalSpy asked(&pane, &ValuesPane::seekRequested);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                      table->visualRect(table->model()->index(0, 0)).center());
    QVERIFY(asked.count() >= 1);
    const auto frame = asked.takeFirst().at(0).toLongLong();
    QCOMPARE(simulation.recording().step(frame), simulation.recording().hits().front().step);
}

void TestValuesPane::tableIsCopied()
{
    Simulation simulation(glancing());
    ValuesPane pane(simulation);
    pane.show();
    QVERIFY(QTest::qWaitForWindowExposed(&pane, patience));
    auto *table = pane.tabs().widget(0)->findChild<QTableView *>();
    table->setFocus();
    table->selectionModel()->select({table->model()->index(0, 0), table->model()->index(1, 1)},
                                    QItemSelectionModel::ClearAndSelect);
    pane.copySelection();
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("-2.000\t2.300\n2.000\t2.000\n"));
    pane.copyAll();
    const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n');
    QCOMPARE(lines.size(), 5);
    QVERIFY(lines[0].startsWith(QStringLiteral("number\tx (m)\ty (m)\tv_x (m/s)")));
    QVERIFY(lines[1].startsWith(QStringLiteral("1\t-2.000\t2.300\t2.000")));
    QVERIFY(lines[3].startsWith(QStringLiteral("Σ\t")));
}

QTEST_MAIN(TestValuesPane)

#include "test_values_pane.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"
#include "tests/cpu_timer.h"
#include "tests/scene_lists.h"
#include "tests/showing_program.h"
#include "views/scene/program_drawings.h"
#include "views/scene/raster_painter.h"
#include "views/theme.h"

#include <QPainter>
#include <QTest>

using namespace cradle;
using namespace cradle::scenes;

namespace {

const SceneOptions bare{
    .velocities = false, .trails = false, .grid = false, .names = false, .hitParts = false};

Drawing arrow(Vec2 from, Vec2 to, const char *colour = "", const char *text = "")
{
    return {Drawing::Kind::Arrow, from, to, QString::fromLatin1(colour), QString::fromLatin1(text)};
}

/// The scene after one step of a program that draws \p drawings.
DrawList listOf(const std::vector<Drawing> &drawings, const SceneOptions &options = bare)
{
    ShowingProgram program([&](World &, ProgramOutput &output) { output.drawings = drawings; });
    Simulation simulation(twoCircles());
    simulation.setProgram(&program);
    simulation.stepForward();
    return buildScene(SceneMoment(simulation), options, lookAt(twoCircles()));
}

} // namespace

class TestProgramDrawings : public QObject
{
    Q_OBJECT
private slots:
    void eachKindIsDrawn();
    void drawingsAreThoseOfTheStepShown();
    void optionLeavesThemOut();
    void coloursCanBeSeen_data();
    void coloursCanBeSeen();
    void unknownColourIsThatOfText_data();
    void unknownColourIsThatOfText();
    void textsKeepTheirColourAndCoverNothing();
    void farPlacesAreCutOff_data();
    void farPlacesAreCutOff();
    void manyDrawingsAreDrawnInTime();
};

void TestProgramDrawings::eachKindIsDrawn()
{
    const QString red = QStringLiteral("red");
    const DrawList list = listOf({arrow({0.0, 0.0}, {1.0, 2.0}, "red", "n"),
                                  {Drawing::Kind::Line, {-1.0, 0.0}, {0.0, -1.0}, red, {}},
                                  {Drawing::Kind::Point, {3.0, -3.0}, {}, red, {}},
                                  {Drawing::Kind::Text, {0.0, -3.0}, {}, {}, QStringLiteral("t")}});
    QCOMPARE(list.arrows.size(), std::size_t{2});
    QVERIFY(near(list.arrows[0].to, {1.0, 2.0}));
    QVERIFY(list.arrows[0].head > 0.0);
    QCOMPARE(list.arrows[0].colour, QColor(Qt::red));
    QCOMPARE(list.arrows[1].head, 0.0); // a line that lies over the circles
    QVERIFY(near(list.arrows[1].from, {-1.0, 0.0}));
    QCOMPARE(list.discs.size(), std::size_t{3}); // two circles and the point
    QCOMPARE(list.discs[2].centre, (Vec2{3.0, -3.0}));
    QCOMPARE(texts(list), (QStringList{QStringLiteral("t"), QStringLiteral("n")}));
    QCOMPARE(list.labels[0].anchor, (Vec2{0.0, -3.0}));
    QCOMPARE(list.labels[0].colour, theme().text);
    QCOMPARE(list.labels[1].anchor, (Vec2{1.0, 2.0}));
}

void TestProgramDrawings::drawingsAreThoseOfTheStepShown()
{
    ShowingProgram program([](World &world, ProgramOutput &output) {
        const double x = 0.1 * static_cast<double>(world.step + 1);
        if (world.step % 2 == 0)
            output.drawings = {{Drawing::Kind::Point, {x, 0.0}, {}, {}, {}}};
    });
    Simulation simulation(twoCircles());
    simulation.setProgram(&program);
    for (int i = 0; i < 9; ++i)
        simulation.stepForward();
    const auto points = [&](qint64 index) {
        simulation.seek(index);
        const DrawList list = buildScene(SceneMoment(simulation), bare, lookAt(twoCircles()));
        return std::vector<DrawList::Disc>(list.discs.begin() + 2, list.discs.end());
    };
    QCOMPARE(points(0).size(), std::size_t{0});
    QCOMPARE(points(5).size(), std::size_t{1});
    QVERIFY(near(points(5)[0].centre, {0.5, 0.0}));
    QCOMPARE(points(6).size(), std::size_t{0});
}

void TestProgramDrawings::optionLeavesThemOut()
{
    SceneOptions options = bare;
    options.programDrawings = false;
    const DrawList list = listOf({arrow({}, {1.0, 1.0}, "", "n")}, options);
    QVERIFY(list.arrows.empty());
    QVERIFY(list.labels.empty());
}

void TestProgramDrawings::coloursCanBeSeen_data()
{
    QTest::addColumn<ThemeChoice>("choice");
    QTest::addColumn<QString>("name");
    for (const char *name : {"orange", "red", "yellow", "white", "black", "navy", "#00ff00"}) {
        QTest::addRow("%s, light", name) << ThemeChoice::Light << QString::fromLatin1(name);
        QTest::addRow("%s, dark", name) << ThemeChoice::Dark << QString::fromLatin1(name);
    }
}

void TestProgramDrawings::coloursCanBeSeen()
{
    QFETCH(ThemeChoice, choice);
    QFETCH(QString, name);
    applyTheme(choice);
    const QColor colour = drawingColour(name);
    QVERIFY(contrast(colour, theme().scene) >= (theme().dark ? 3.0 : 2.0));
    // As it is given where it can be.
    if (contrast(QColor(name), theme().scene) >= 3.0)
        QCOMPARE(colour, QColor(name));
    const DrawList list = listOf({{Drawing::Kind::Text, {}, {}, name, QStringLiteral("text")}});
    QVERIFY(contrast(list.labels.at(0).colour, theme().scene) >= 4.5);
    applyTheme(ThemeChoice::Light);
}

void TestProgramDrawings::unknownColourIsThatOfText_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("none") << QString();
    QTest::newRow("unknown") << QStringLiteral("sky-blue-pink");
    QTest::newRow("half a number") << QStringLiteral("#12");
    QTest::newRow("transparent") << QStringLiteral("transparent");
}

void TestProgramDrawings::unknownColourIsThatOfText()
{
    QFETCH(QString, name);
    QCOMPARE(drawingColour(name), theme().text);
}

void TestProgramDrawings::textsKeepTheirColourAndCoverNothing()
{
    std::vector<Drawing> drawings;
    for (int i = 0; i < 12; ++i)
        drawings.push_back({Drawing::Kind::Text,
                            {2.0, 2.0 + 0.01 * i},
                            {},
                            QStringLiteral("red"),
                            QStringLiteral("text %1").arg(i)});
    drawings.push_back({Drawing::Kind::Text, {}, {}, {}, QString(5000, u'x') + u'\n'});
    const DrawList list = listOf(drawings, {});
    const SceneLook look = lookAt(twoCircles());
    QVERIFY(!textOverText(list, look.camera, look.font));
    const QColor red = readableOn(drawingColour(QStringLiteral("red")), theme().scene);
    int shown = 0;
    for (const DrawList::Label &label : list.labels) {
        QVERIFY(label.text.size() <= 60);
        shown += label.colour == red ? 1 : 0;
    }
    QVERIFY2(shown >= 5, qPrintable(QString::number(shown)));
}

void TestProgramDrawings::farPlacesAreCutOff_data()
{
    QTest::addColumn<Vec2>("from");
    QTest::addColumn<Vec2>("to");
    QTest::addColumn<int>("arrows");
    QTest::newRow("tip far off") << Vec2{} << Vec2{1e200, 1e199} << 1;
    QTest::newRow("across") << Vec2{-1e12, 0.0} << Vec2{1e12, 0.0} << 1;
    QTest::newRow("beside") << Vec2{1e12, 0.0} << Vec2{1e12, 1.0} << 0;
    QTest::newRow("further than numbers reach") << Vec2{-1.7e308, 0.0} << Vec2{1.7e308, 0.0} << 0;
}

void TestProgramDrawings::farPlacesAreCutOff()
{
    QFETCH(Vec2, from);
    QFETCH(Vec2, to);
    const DrawList list = listOf(
        {arrow(from, to, "red", "far"), {Drawing::Kind::Text, to, {}, {}, QStringLiteral("far")}});
    QTEST(static_cast<int>(list.arrows.size()), "arrows");
    QVERIFY(list.labels.empty());
    for (const DrawList::Arrow &one : list.arrows) {
        QVERIFY(length(one.from) < 20.0 && length(one.to) < 20.0);
        QCOMPARE(one.head, 0.0); // the tip is not there
    }
}

void TestProgramDrawings::manyDrawingsAreDrawnInTime()
{
    std::vector<Drawing> drawings;
    for (int i = 0; i < 1024; ++i) // as many as a step may have
        drawings.push_back(arrow({-3.0, 0.0}, {3.0, 0.005 * i - 2.5}, "orange", "n"));
    const CpuTimer time;
    const DrawList list = listOf(drawings, {});
    QVERIFY2(time.elapsed() < 500.0, qPrintable(QString::number(time.elapsed())));
    QCOMPARE(list.arrows.size(), std::size_t{1024 + 1}); // and a velocity
    QVERIFY(list.labels.size() > 5);
    QImage image(700, 700, QImage::Format_RGB32);
    QPainter painter(&image);
    paintShapes(painter, list, lookAt(twoCircles()).camera);
}

QTEST_MAIN(TestProgramDrawings)
#include "test_program_drawings.moc"

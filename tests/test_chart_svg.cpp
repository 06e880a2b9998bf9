// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/chart_svg.h"
#include "tests/drawn_svg.h"

#include <QTest>

#include <cmath>

using namespace cradle;

/// Charts of a report, read back from their SVG.
class TestChartSvg : public QObject
{
    Q_OBJECT
private slots:
    void axesAreInRoundNumbers_data();
    void axesAreInRoundNumbers();
    void pointsLieWhereTheAxesSay();
    void emptyChartHasItsAxes();
    void longCurveKeepsItsExtremes();
    void namesStandAtTheirCurvesAndApart();
    void namesMakeRoomWhereTheyWouldTouch_data();
    void namesMakeRoomWhereTheyWouldTouch();
    void namesStayInTheirField();
};

namespace {

const QString red = QStringLiteral("#ff0000");

ChartLine line(const QString &name, std::vector<Vec2> points, const QString &colour = red)
{
    return {name, std::move(points), {.colour = colour}};
}

double numberOf(const QString &text)
{
    QString plain = text;
    plain.replace(QChar(0x2212), QLatin1Char('-')).remove(QLatin1String(" s"));
    return plain.toDouble();
}

} // namespace

void TestChartSvg::axesAreInRoundNumbers_data()
{
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<QString>("numbers");
    const auto row = [](double low, double high, const char *numbers) {
        QTest::addRow("%g to %g", low, high) << low << high << QString::fromUtf8(numbers);
    };
    row(0, 9.3, "0|5|10");
    row(0, 8, "0|2|4|6|8");
    row(0, 4, "0|1|2|3|4");
    row(0, 4.1, "0|2|4|6");
    row(-1, 1, "−1.0|−0.5|0.0|0.5|1.0");
    row(0.25, 0.7, "0.2|0.4|0.6|0.8");
    row(0, 0.021, "0.00|0.01|0.02|0.03");
    row(1200, 2100, "1000|1500|2000|2500");
    row(0, 0.00004, "0|1e−05|2e−05|3e−05|4e−05");
    row(0, 300000, "0|1e+05|2e+05|3e+05");
    row(-0.2, 0.4, "−0.2|0.0|0.2|0.4");
    row(-0.3, 0.9, "−0.5|0.0|0.5|1.0");
    row(1000, 1000 + 5e-7, "800|900|1000|1100|1200");
    row(0, 1.2e-9, "0|5e−10|1e−09|1.5e−09");
    row(0, 0.8e-9, "−0.001|0.000|0.001|0.002");
    row(5, 5, "4.5|5.0|5.5");
    row(0, 0, "−0.0010|−0.0005|0.0000|0.0005|0.0010");
}

/// In steps of 1, 2 or 5 times a power of ten, at most four from the least to the greatest.
void TestChartSvg::axesAreInRoundNumbers()
{
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(QString, numbers);
    const Drawn drawn(chartSvg(400, 200, {}, {line({}, {{0, low}, {1, high}})}));
    QVERIFY(drawn.isSound);
    QCOMPARE(drawn.texts(true).join(QLatin1Char('|')), numbers);
    QCOMPARE(drawn.texts(false),
             QStringLiteral("0.0|0.2|0.4|0.6|0.8|1.0 s").split(QLatin1Char('|')));
}

void TestChartSvg::pointsLieWhereTheAxesSay()
{
    const std::vector<Vec2> points{{0.0, -3.0}, {0.5, 1.0}, {2.0, 7.5}, {2.5, 0.0}};
    const Drawn drawn(chartSvg(500, 300, {}, {line({}, points)}));
    const auto axis = [&](bool ofY, double value) {
        const std::vector<Label> numbers = drawn.numbers(ofY);
        const auto at = [&](const Label &label) {
            return ofY ? label.place.y - 3.5 : label.place.x; // in the middle of its line
        };
        const double first = numberOf(numbers.front().text);
        const double last = numberOf(numbers.back().text);
        return at(numbers.front())
               + (value - first) / (last - first) * (at(numbers.back()) - at(numbers.front()));
    };
    const std::vector<Vec2> places = drawn.curve(red);
    QCOMPARE(places.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        QVERIFY(std::abs(places[i].x - axis(false, points[i].x)) < 0.02);
        QVERIFY(std::abs(places[i].y - axis(true, points[i].y)) < 0.02);
    }
    // Upward is up, and a line of the grid goes through every number.
    QVERIFY(places[2].y < places[0].y);
    const std::size_t all = drawn.numbers(true).size() + drawn.numbers(false).size();
    QCOMPARE(drawn.lines.size(), all + 1);
    for (const Label &label : drawn.numbers(true))
        QVERIFY(std::any_of(drawn.lines.begin(), drawn.lines.end(), [&](const auto &grid) {
            return grid.second.size() == 2 && grid.second[0].y == grid.second[1].y
                   && std::abs(grid.second[0].y - (label.place.y - 3.5)) < 0.02
                   && grid.second[1].x - grid.second[0].x > 300.0;
        }));
}

void TestChartSvg::emptyChartHasItsAxes()
{
    const Drawn drawn(chartSvg(400, 200, QStringLiteral("Nothing"), {line({}, {})}));
    QVERIFY(drawn.isSound);
    QVERIFY(!drawn.numbers(true).empty() && !drawn.numbers(false).empty());
    QVERIFY(drawn.curve(red).empty());
    const Drawn both(chartSvg(400, 200, {}, {line({}, {}), line({}, {{0, 1.0}, {1, 2.0}})}));
    QCOMPARE(both.curve(red).size(), std::size_t{2});
    QCOMPARE(drawn.labels.front().text, QStringLiteral("Nothing"));
}

/// Of a thousand points that rise evenly some are left, among them one high above the others and
/// one far below beside it.
void TestChartSvg::longCurveKeepsItsExtremes()
{
    for (const bool lowFirst : {false, true}) {
        std::vector<Vec2> points;
        for (int i = 0; i < 1000; ++i)
            points.push_back({0.001 * i, 0.001 * i});
        points[lowFirst ? 537 : 536].y = 40.0;
        points[lowFirst ? 536 : 537].y = -40.0;
        const Drawn drawn(chartSvg(4000, 2000, {}, {line({}, points)}));
        const std::vector<Vec2> places = drawn.curve(red);
        QVERIFY(places.size() > 300 && places.size() <= 400);
        QVERIFY(
            std::is_sorted(places.begin(), places.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; }));
        const auto [top, bottom] = std::minmax_element(places.begin(), places.end(),
                                                       [](Vec2 a, Vec2 b) { return a.y < b.y; });
        const auto numbers = drawn.numbers(true);
        QCOMPARE(numbers.front().text, QString::fromUtf8("−40"));
        QVERIFY(std::abs(bottom->y - (numbers.front().place.y - 3.5)) < 0.02);
        QVERIFY(std::abs(top->y - (numbers.back().place.y - 3.5)) < 0.02);
        QCOMPARE(top < bottom, !lowFirst);
        // Both ends are there, but for a group of five.
        QVERIFY(places.front().x < 53.0 && places.back().x > 4000.0 - 64.0 - 24.0);
    }
    std::vector<Vec2> few;
    for (int i = 0; i < 400; ++i)
        few.push_back({0.001 * i, 0.01 * (i % 7)});
    const Drawn whole(chartSvg(4000, 2000, {}, {line({}, few)}));
    QCOMPARE(whole.curve(red).size(), std::size_t{400});
    few.push_back({0.4, 0.0});
    QVERIFY(Drawn(chartSvg(4000, 2000, {}, {line({}, few)})).curve(red).size() <= 400);
    std::vector<Vec2> hundred;
    for (int i = 0; i < 100; ++i)
        hundred.push_back({0.01 * i, 0.01 * i});
    QCOMPARE(Drawn(chartSvg(4000, 2000, {}, {line({}, hundred)})).curve(red).size(),
             std::size_t{100});
}

void TestChartSvg::namesStandAtTheirCurvesAndApart()
{
    std::vector<ChartLine> lines;
    const double ends[] = {5.0, 5.1, 4.9, 9.0, 0.0};
    for (int i = 0; i < 5; ++i)
        lines.push_back(line(QString::number(i), {{0, 1.0}, {1, ends[i]}},
                             QStringLiteral("#%1%1%1").arg(10 * (i + 1))));
    const Drawn drawn(chartSvg(400, 400, {}, lines));
    std::vector<Label> names;
    for (const Label &label : drawn.labels) {
        if (label.anchor == QLatin1String("start") && !label.text.isEmpty())
            names.push_back(label);
    }
    QStringList order; // from the top
    for (const Label &name : names) {
        order.append(name.text);
        QVERIFY(name.place.x > 336.0 && name.place.x < 400.0);
    }
    QCOMPARE(order, (QStringList{QStringLiteral("3"), QStringLiteral("1"), QStringLiteral("0"),
                                 QStringLiteral("2"), QStringLiteral("4")}));
    for (std::size_t i = 1; i < names.size(); ++i)
        QVERIFY(names[i].place.y - names[i - 1].place.y >= 9.99);
    const auto endOf = [&](int i) {
        return drawn.curve(lines[std::size_t(i)].pen.colour).back().y;
    };
    // Those alone stand at their curve, the three around its middle.
    for (const std::size_t alone : {0U, 4U})
        QVERIFY(std::abs(names[alone].place.y - 3.5 - endOf(names[alone].text.toInt())) < 0.02);
    QVERIFY(std::abs(names[2].place.y - 3.5 - (endOf(0) + endOf(1) + endOf(2)) / 3.0) < 0.02);
    QVERIFY(std::abs(names[2].place.y - names[1].place.y - 10.0) < 0.02);
}

void TestChartSvg::namesMakeRoomWhereTheyWouldTouch_data()
{
    QTest::addColumn<std::vector<double>>("ends");   ///< of curves, px from the first one's down
    QTest::addColumn<std::vector<double>>("places"); ///< of their names
    using Px = std::vector<double>;
    QTest::newRow("apart") << Px{0, 11} << Px{0, 11};
    QTest::newRow("nearly apart") << Px{0, 9} << Px{-0.5, 9.5};
    QTest::newRow("at one place, as they are told") << Px{0, 0, 0} << Px{-10, 0, 10};
    // The second and the third make room, and so come to the first.
    QTest::newRow("one after the other") << Px{0, 11, 13} << Px{-2, 8, 18};
    QTest::newRow("two pairs apart") << Px{0, 2, 40, 42} << Px{-4, 6, 36, 46};
    QTest::newRow("two pairs that meet") << Px{0, 2, 12, 14} << Px{-8, 2, 12, 22};
}

void TestChartSvg::namesMakeRoomWhereTheyWouldTouch()
{
    QFETCH(std::vector<double>, ends);
    QFETCH(std::vector<double>, places);
    // From 0 to 8 on 362 px, those between the title and the numbers.
    std::vector<ChartLine> lines{line({}, {{0, 0.0}, {0.5, 8.0}})};
    for (std::size_t i = 0; i < ends.size(); ++i)
        lines.push_back(
            line(QStringLiteral("n%1").arg(i), {{0, 1.0}, {1, 4.0 - ends[i] * 8.0 / 362.0}}));
    const Drawn drawn(chartSvg(400, 400, {}, lines));
    std::vector<Label> names;
    for (const Label &label : drawn.labels) {
        if (label.text.startsWith(QLatin1Char('n')))
            names.push_back(label);
    }
    QCOMPARE(names.size(), ends.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        QCOMPARE(names[i].text, QStringLiteral("n%1").arg(i));
        QVERIFY2(std::abs(names[i].place.y - 3.5 - (20.0 + 181.0) - places[i]) < 0.02,
                 QByteArray::number(names[i].place.y).constData());
    }
}

/// However many end at its edge.
void TestChartSvg::namesStayInTheirField()
{
    for (const double end : {0.0, 8.0}) {
        std::vector<ChartLine> lines{line(QStringLiteral("all"), {{0, 0.0}, {0.5, 8.0}, {1, 4.0}})};
        for (int i = 0; i < 6; ++i)
            lines.push_back(line(QStringLiteral("edge"), {{0, 1.0}, {1, end}}));
        const Drawn drawn(chartSvg(400, 200, {}, lines));
        double last = 0.0;
        for (const Label &label : drawn.labels) {
            if (label.anchor != QLatin1String("start") || label.text.isEmpty())
                continue;
            QVERIFY2(label.place.y >= 20.0 && label.place.y <= 200.0 - 18.0 + 4.0,
                     QByteArray::number(label.place.y).constData());
            QVERIFY(last == 0.0 || label.place.y >= last + 9.99);
            last = label.place.y;
        }
        QVERIFY(last > 0.0);
    }
}

QTEST_GUILESS_MAIN(TestChartSvg)
#include "test_chart_svg.moc"

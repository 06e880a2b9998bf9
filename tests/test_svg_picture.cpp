// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/svg_picture.h"
#include "tests/drawn_svg.h"

#include <QTest>

#include <cmath>

using namespace cradle;

/// What a drawing is asked for, read back from its SVG.
class TestSvgPicture : public QObject
{
    Q_OBJECT
private slots:
    void arrowEndsWhereItPoints_data();
    void arrowEndsWhereItPoints();
    void whatHasNoLengthIsNotDrawn();
    void textsAreEscaped();
};

namespace {

const QString red = QStringLiteral("#ff0000");

} // namespace

void TestSvgPicture::arrowEndsWhereItPoints_data()
{
    QTest::addColumn<Vec2>("way");
    QTest::addColumn<double>("head"); // its length, px
    QTest::newRow("long") << Vec2{30.0, 40.0} << 7.0;
    QTest::newRow("short") << Vec2{-3.0, 0.0} << 3.0;
    QTest::newRow("upward") << Vec2{0.0, -20.0} << 7.0;
}

void TestSvgPicture::arrowEndsWhereItPoints()
{
    QFETCH(Vec2, way);
    QFETCH(double, head);
    SvgPicture picture(200, 200, {});
    const Vec2 from{100.0, 90.0};
    picture.arrow(from, from + way, red);
    const Drawn drawn(picture.toSvg());
    QCOMPARE(drawn.heads.size(), std::size_t{1});
    const std::vector<Vec2> &tip = drawn.heads.front();
    QCOMPARE(tip.size(), std::size_t{3});
    QVERIFY(length(tip[0] - (from + way)) < 0.02);
    const Vec2 neck = 0.5 * (tip[1] + tip[2]);
    QVERIFY(length(neck - (from + way - head * normalized(way))) < 0.02);
    // As wide as 5.5 px where it is 7 px long, to both sides.
    QVERIFY(std::abs(length(tip[1] - tip[2]) - 5.5 * head / 7.0) < 0.03);
    QVERIFY(std::abs(dot(tip[1] - tip[2], normalized(way))) < 0.03);
    if (length(way) > head) {
        QCOMPARE(drawn.lines.size(), std::size_t{1});
        QVERIFY(length(drawn.lines[0].second[0] - from) < 0.02);
        QVERIFY(length(drawn.lines[0].second[1] - neck) < 0.02);
    }
}

void TestSvgPicture::whatHasNoLengthIsNotDrawn()
{
    SvgPicture picture(200, 200, {});
    picture.arrow({10, 10}, {10.6, 10.6}, red);
    picture.line({10, 10}, {10.001, 10.001}, {.colour = red});
    picture.polyline({{5, 5}}, {.colour = red});
    const Drawn nothing(picture.toSvg());
    QVERIFY(nothing.isSound && nothing.heads.empty() && nothing.lines.empty());
    // Nor what is no number, or far away.
    picture.line({std::nan(""), 1e9}, {3, 4}, {.colour = red});
    const Drawn drawn(picture.toSvg());
    QCOMPARE(drawn.lines.size(), std::size_t{1});
    QVERIFY((drawn.lines[0].second[0] == Vec2{0.0, 1e5}));
    QVERIFY(picture.toSvg().contains("points=\"0,100000 3,4\""));
}

void TestSvgPicture::textsAreEscaped()
{
    SvgPicture picture(20, 30, QStringLiteral("<a> & b"));
    picture.text({1, 2}, QStringLiteral("<script>"), 9, red, SvgPicture::Anchor::End);
    picture.rectangle({1, 2}, {3, 4}, {}, {});
    picture.circle({1.5, 2.25}, 3.25, red,
                   {.colour = red, .width = 0.5, .dash = {}, .opacity = 0.25});
    const QByteArray svg = picture.toSvg();
    QVERIFY(svg.contains("<title>&lt;a&gt; &amp; b</title>"));
    QVERIFY(svg.contains("width=\"20\" height=\"30\" viewBox=\"0 0 20 30\""));
    QVERIFY(svg.contains("text-anchor=\"end\">&lt;script&gt;</text>"));
    QVERIFY(svg.contains("<rect x=\"1\" y=\"2\" width=\"3\" height=\"4\" fill=\"none\" "
                         "stroke=\"none\"/>"));
    QVERIFY(svg.contains("<circle cx=\"1.5\" cy=\"2.25\" r=\"3.25\" fill=\"#ff0000\" "
                         "stroke=\"#ff0000\" stroke-width=\"0.5\" stroke-opacity=\"0.25\"/>"));
}

QTEST_GUILESS_MAIN(TestSvgPicture)
#include "test_svg_picture.moc"

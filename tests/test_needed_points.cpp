// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/needed_points.h"

#include <QTest>
#include <rapidcheck.h>

#include <cmath>

using namespace cradle;

class TestNeededPoints final : public QObject
{
    Q_OBJECT
private slots:
    void levelAndSlopingLinesNeedTheirEnds();
    void uprightStepsStay();
    void fewPointsStay();
    void noneLeftOutIsFartherOffThanTheTolerance();
};

void TestNeededPoints::levelAndSlopingLinesNeedTheirEnds()
{
    // Level, up, level.
    const QList<QPointF> pixels{{0, 5}, {1, 5}, {2, 5}, {3, 6}, {4, 7}, {5, 8}, {6, 8}, {7, 8}};
    QCOMPARE(neededPoints(pixels, 0.05), QList<qsizetype>({0, 2, 5, 7}));
    // A bump of less than the tolerance is none.
    QCOMPARE(neededPoints({{0, 5}, {1, 5.04}, {2, 5}}, 0.05), QList<qsizetype>({0, 2}));
    QCOMPARE(neededPoints({{0, 5}, {1, 5.2}, {2, 5}}, 0.05), QList<qsizetype>({0, 1, 2}));
}

void TestNeededPoints::uprightStepsStay()
{
    const QList<QPointF> pixels{{0, 5}, {1, 5}, {2, 5}, {2, 9}, {3, 9}, {4, 9}};
    QCOMPARE(neededPoints(pixels, 0.05), QList<qsizetype>({0, 2, 3, 5}));
}

void TestNeededPoints::fewPointsStay()
{
    QVERIFY(neededPoints({}, 0.05).isEmpty());
    QCOMPARE(neededPoints({{1, 1}}, 0.05), QList<qsizetype>({0}));
    QCOMPARE(neededPoints({{1, 1}, {1, 1}}, 0.05), QList<qsizetype>({0, 1}));
}

void TestNeededPoints::noneLeftOutIsFartherOffThanTheTolerance()
{
    QVERIFY(rc::check([] {
        const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
            rc::gen::pair(rc::gen::inRange(0, 3), rc::gen::inRange(-2, 3)));
        QList<QPointF> pixels{{0.0, 0.0}};
        for (const auto &[right, up] : steps)
            pixels.append(pixels.last() + QPointF(right, 0.1 * up));
        const double tolerance = 0.25;
        const QList<qsizetype> needed = neededPoints(pixels, tolerance);
        RC_ASSERT(needed.first() == 0);
        RC_ASSERT(needed.last() == pixels.size() - 1);
        for (qsizetype k = 1; k < needed.size(); ++k) {
            const QPointF from = pixels[needed[k - 1]];
            const QPointF to = pixels[needed[k]];
            RC_ASSERT(needed[k] > needed[k - 1]);
            for (qsizetype i = needed[k - 1] + 1; i < needed[k]; ++i) {
                const double part = (pixels[i].x() - from.x()) / (to.x() - from.x());
                const double line = from.y() + part * (to.y() - from.y());
                RC_ASSERT(std::abs(pixels[i].y() - line) <= tolerance + 1e-9);
            }
        }
    }));
}

QTEST_MAIN(TestNeededPoints)

#include "test_needed_points.moc"

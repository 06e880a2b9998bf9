// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cpu_timer.h"
#include "views/charts/min_max_pyramid.h"

#include <rapidcheck.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>

using namespace cradle;

namespace {

struct Column {
    double least;
    double greatest;
};

/// Least and greatest value of each column, found the long way.
std::map<qint64, Column> columnsOf(const QList<QPointF> &samples, double t0, double t1, int count)
{
    const double width = (t1 - t0) / count;
    std::map<qint64, Column> columns;
    for (const QPointF &s : samples) {
        if (s.x() < t0 || s.x() > t1)
            continue;
        const auto key = static_cast<qint64>(
            std::min(std::floor(s.x() / width), std::floor(t0 / width) + count));
        auto [found, isNew] = columns.try_emplace(key, Column{s.y(), s.y()});
        found->second.least = std::min(found->second.least, s.y());
        found->second.greatest = std::max(found->second.greatest, s.y());
    }
    return columns;
}

/// A curve whose neighbours differ, so that no sample is left out; times are exact in binary.
QList<QPointF> makeSamples(const std::vector<int> &values)
{
    QList<QPointF> samples;
    for (std::size_t i = 0; i < values.size(); ++i)
        samples.append({0.25 * double(i), 2.0 * values[i] + double(i % 2)});
    return samples;
}

MinMaxPyramid pyramidOf(const QList<QPointF> &samples)
{
    MinMaxPyramid pyramid;
    for (const QPointF &s : samples)
        pyramid.append(s.x(), s.y());
    return pyramid;
}

} // namespace

class TestMinMaxPyramid final : public QObject
{
    Q_OBJECT
private slots:
    void equalsBruteForce();
    void equalsBruteForceAfterDropping();
    void putsNoSampleBetweenColumns();
    void keepsFewSamplesAsTheyAre();
    void keepsAnUprightStepSharp();
    void joinsLevelSamples();
    void startsALevelLineWhereItWasDropped();
    void leavesOutWhatIsNotFinite();
    void answersAnEmptyRange();
    void goesOnInAWindowAsIfItWereNew();
    void costsNoMoreForLongRuns();
};

void TestMinMaxPyramid::equalsBruteForce()
{
    QVERIFY(rc::check([](const std::vector<int> &values) {
        const QList<QPointF> samples = makeSamples(values);
        const MinMaxPyramid pyramid = pyramidOf(samples);
        const int count = *rc::gen::inRange(1, 12);
        const double t0 = 0.25 * *rc::gen::inRange(0, 40);
        const double t1 = t0 + 0.25 * *rc::gen::inRange(1, 200);
        const QList<QPointF> points = pyramid.decimate(t0, t1, count);
        RC_ASSERT(points.size() <= 2 * (count + 2));
        RC_ASSERT(std::is_sorted(points.begin(), points.end(),
                                 [](QPointF a, QPointF b) { return a.x() < b.x(); }));
        const auto wanted = columnsOf(samples, t0, t1, count);
        const auto got = columnsOf(points, t0, t1, count);
        RC_ASSERT(got.size() == wanted.size());
        for (const auto &[key, column] : wanted) {
            RC_ASSERT(got.at(key).least == column.least);
            RC_ASSERT(got.at(key).greatest == column.greatest);
        }
    }));
}

void TestMinMaxPyramid::equalsBruteForceAfterDropping()
{
    QVERIFY(rc::check([](const std::vector<int> &seed) {
        std::vector<int> values;
        for (int i = 0; i < 40; ++i)
            values.insert(values.end(), seed.begin(), seed.end());
        QList<QPointF> samples = makeSamples(values);
        MinMaxPyramid pyramid;
        // Dropping in between: groups that are closed later have lost some samples.
        qsizetype dropped = 0;
        for (qsizetype i = 0; i < samples.size(); ++i) {
            pyramid.append(samples[i].x(), samples[i].y());
            if (i % 61 == 60) {
                dropped = *rc::gen::inRange(dropped, i);
                pyramid.dropBefore(samples[dropped].x());
            }
        }
        samples.remove(0, dropped);
        const double end = samples.isEmpty() ? 1.0 : samples.back().x() + 1.0;
        const auto wanted = columnsOf(samples, 0.0, end, 7);
        const auto got = columnsOf(pyramid.decimate(0.0, end, 7), 0.0, end, 7);
        RC_ASSERT(got.size() == wanted.size());
        for (const auto &[key, column] : wanted) {
            RC_ASSERT(got.at(key).least == column.least);
            RC_ASSERT(got.at(key).greatest == column.greatest);
        }
        const auto all = columnsOf(samples, 0.0, end, 1);
        RC_ASSERT(pyramid.minimum() == (all.empty() ? 0.0 : all.begin()->second.least));
        RC_ASSERT(pyramid.maximum() == (all.empty() ? 0.0 : all.begin()->second.greatest));
    }));
}

void TestMinMaxPyramid::putsNoSampleBetweenColumns()
{
    // Columns are 9/7 s wide; 9 s is the edge of one, but 9/(9/7) rounds to less than 7. From 0.5
    // to 9.5 s there are 37 samples in 8 columns, and one more beyond each end.
    const QList<QPointF> points =
        pyramidOf(makeSamples(std::vector<int>(50))).decimate(0.5, 9.5, 7);
    QCOMPARE(points.size(), 2 * 8 + 2);
}

void TestMinMaxPyramid::keepsFewSamplesAsTheyAre()
{
    const QList<QPointF> samples = makeSamples({3, 1, 4, 1, 5, 9, 2, 6});
    QCOMPARE(pyramidOf(samples).decimate(0.0, 2.0, 4), samples);
    // One neighbour beyond each end, so that the line reaches the edges of the plot.
    QCOMPARE(pyramidOf(samples).decimate(0.5, 0.75, 4), samples.mid(1, 4));
}

void TestMinMaxPyramid::keepsAnUprightStepSharp()
{
    MinMaxPyramid pyramid;
    for (int i = 0; i < 10'000; ++i)
        pyramid.append(i, i % 2 == 0 ? 1.0 : 1.5);
    pyramid.append(10'000.0, 100.0);
    for (int i = 10'000; i < 20'000; ++i)
        pyramid.append(i + 1, i % 2 == 0 ? 101.0 : 100.0);
    const QList<QPointF> points = pyramid.decimate(0.0, 20'000.0, 100);
    for (const QPointF &p : points)
        QVERIFY(p.x() < 10'000.0 ? p.y() <= 1.5 : p.y() >= 100.0);
}

void TestMinMaxPyramid::joinsLevelSamples()
{
    MinMaxPyramid pyramid;
    for (int i = 0; i <= 1000; ++i)
        pyramid.append(i, 7.0);
    QCOMPARE(pyramid.decimate(0.0, 1000.0, 300), QList<QPointF>({{0.0, 7.0}, {1000.0, 7.0}}));
    QCOMPARE(pyramid.valueAt(500.0), 7.0);
    QVERIFY(pyramid.bytes() < 100);
}

void TestMinMaxPyramid::startsALevelLineWhereItWasDropped()
{
    MinMaxPyramid pyramid = pyramidOf({{0.0, 2.0}, {10.0, 2.0}, {10.0, 5.0}, {11.0, 5.0}});
    pyramid.dropBefore(4.0);
    QCOMPARE(pyramid.firstTime(), 4.0);
    QCOMPARE(pyramid.valueAt(9.0), 2.0);
    pyramid.dropBefore(10.5);
    QCOMPARE(pyramid.firstTime(), 10.5);
    QCOMPARE(pyramid.minimum(), 5.0);
    pyramid.dropBefore(100.0);
    QVERIFY(pyramid.isEmpty());
}

void TestMinMaxPyramid::leavesOutWhatIsNotFinite()
{
    MinMaxPyramid pyramid = pyramidOf({{0.0, 2.0}});
    pyramid.append(1.0, std::nan(""));
    pyramid.append(2.0, std::numeric_limits<double>::infinity());
    QCOMPARE(pyramid.lastTime(), 0.0);
}

void TestMinMaxPyramid::answersAnEmptyRange()
{
    const MinMaxPyramid none;
    QVERIFY(none.decimate(0.0, 1.0, 10).isEmpty());
    QCOMPARE(none.valueAt(1.0), 0.0);
    QCOMPARE(none.maximum(), 0.0);
    const MinMaxPyramid some = pyramidOf(makeSamples({1, 2, 3}));
    QVERIFY(some.decimate(1.0, 1.0, 10).isEmpty());
    QVERIFY(some.decimate(0.0, 1.0, 0).isEmpty());
}

void TestMinMaxPyramid::goesOnInAWindowAsIfItWereNew()
{
    QVERIFY(rc::check([](const std::vector<int> &seed) {
        std::vector<int> values;
        for (int i = 0; i < 12; ++i)
            values.insert(values.end(), seed.begin(), seed.end());
        const QList<QPointF> samples = makeSamples(values);
        const double t0 = 0.25 * *rc::gen::inRange(0, 20);
        const double t1 = t0 + 0.25 * *rc::gen::inRange(1, 300);
        const int columns = *rc::gen::inRange(1, 12);
        MinMaxPyramid pyramid;
        MinMaxPyramid::Window window;
        for (qsizetype i = 0; i < samples.size(); ++i) {
            pyramid.append(samples[i].x(), samples[i].y());
            if (i % 97 == 96)
                pyramid.dropBefore(samples[i - 60].x());
            if (i == *rc::gen::inRange<qsizetype>(0, 400)) { // another run at the same place
                pyramid.clear();
                pyramid.append(samples[i].x(), samples[i].y() + 1.0);
            }
            if (i % 3 == 0)
                pyramid.decimate(window, t0, i % 30 == 0 ? t1 + 1.0 : t1, columns);
            pyramid.decimate(window, t0, t1, columns);
            RC_ASSERT(window.points() == pyramid.decimate(t0, t1, columns));
        }
    }));
}

void TestMinMaxPyramid::costsNoMoreForLongRuns()
{
    MinMaxPyramid pyramid;
    for (int i = 0; i < 2'000'000; ++i)
        pyramid.append(i, std::sin(0.001 * i));
    const CpuTimer timer;
    for (int i = 0; i < 10; ++i)
        QVERIFY(pyramid.decimate(0.0, 2e6, 400).size() <= 804);
    // About 0.5 ms each; the bound leaves room for sanitizers.
    QVERIFY2(timer.elapsed() < 1000.0, qPrintable(QString::number(timer.elapsed())));
}

QTEST_APPLESS_MAIN(TestMinMaxPyramid)

#include "test_min_max_pyramid.moc"

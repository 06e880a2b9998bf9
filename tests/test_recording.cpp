// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/recording.h"

#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// The state of frame \p index: each value tells the frame and the circle.
World frame(qint64 index, int circles = 2)
{
    World world{.time = static_cast<double>(index) * 0.25, .step = index};
    for (int i = 0; i < circles; ++i)
        world.circles.push_back({.position = {static_cast<double>(index), static_cast<double>(i)}});
    return world;
}

Hit hitAt(qint64 step, int a = 0)
{
    return {.time = static_cast<double>(step) * 0.25, .step = step, .a = a};
}

Recording recordingOf(qint64 frames, int circles = 2, qint64 maxBytes = Recording::defaultBytes)
{
    Recording recording(maxBytes);
    for (qint64 i = 0; i < frames; ++i)
        recording.append(frame(i, circles));
    return recording;
}

/// Room for a few hundred frames of two circles: a frame holds a time, a step and the circles.
constexpr qint64 smallBytes = 500 * qint64{16 + 2 * sizeof(Circle)};

} // namespace

class TestRecording : public QObject
{
    Q_OBJECT
private slots:
    void beginsEmpty();
    void givesBackWhatWasAppended_data();
    void givesBackWhatWasAppended();
    void findsTheFrameOfATime_data();
    void findsTheFrameOfATime();
    void findsTimesThatAreNotEven();
    void memoryIsBounded();
    void oldestFramesAreDroppedAndIndicesStay();
    void aCrowdKeepsItsNewestFrames();
    void hitsAreDroppedWithTheirFrames();
    void hitsOfOneStepAreDroppedTogether();
    void truncatesAfter_data();
    void truncatesAfter();
    void truncatingKeepsTheHitsUpToThere();
    void goesOnAfterTruncating();
    void truncatesAfterHavingDropped();
    void clearForgetsAll();
    void keepsFramesWithoutCircles();
    void aSecondRunMayHaveAnotherNumberOfCircles();
};

void TestRecording::beginsEmpty()
{
    const Recording recording;
    QVERIFY(recording.isEmpty());
    QVERIFY(!recording.hasDropped());
    QVERIFY(recording.hits().empty());
    QCOMPARE(recording.bytes(), qint64{0});
}

void TestRecording::givesBackWhatWasAppended_data()
{
    QTest::addColumn<qint64>("frames");
    for (const qint64 frames : {1, 2, 127, 128, 129, 256, 1000})
        QTest::addRow("%lld frames", static_cast<long long>(frames)) << frames;
}

void TestRecording::givesBackWhatWasAppended()
{
    QFETCH(qint64, frames);
    const Recording recording = recordingOf(frames);
    QVERIFY(!recording.isEmpty());
    QCOMPARE(recording.first(), qint64{0});
    QCOMPARE(recording.last(), frames - 1);
    QCOMPARE(recording.circleCount(), std::size_t{2});
    for (qint64 i = frames - 1; i >= 0; --i) { // at random places as well as in order
        QCOMPARE(recording.time(i), static_cast<double>(i) * 0.25);
        QCOMPARE(recording.step(i), i);
        QVERIFY(recording.world(i) == frame(i));
        QCOMPARE(recording.circles(i).size(), std::size_t{2});
        QVERIFY(recording.circles(i)[1] == frame(i).circles[1]);
    }
}

void TestRecording::findsTheFrameOfATime_data()
{
    QTest::addColumn<double>("moment");
    QTest::addColumn<qint64>("index"); // of 1000 frames a quarter second apart
    QTest::newRow("before the start") << -1.0 << qint64{0};
    QTest::newRow("start") << 0.0 << qint64{0};
    QTest::newRow("between") << 0.3 << qint64{1};
    QTest::newRow("just at a frame") << 50.0 << qint64{200};
    QTest::newRow("a hair before a frame") << std::nextafter(50.0, 0.0) << qint64{199};
    QTest::newRow("the last") << 249.75 << qint64{999};
    QTest::newRow("after the end") << 1e9 << qint64{999};
}

void TestRecording::findsTheFrameOfATime()
{
    QFETCH(double, moment);
    QFETCH(qint64, index);
    QCOMPARE(recordingOf(1000).indexAt(moment), index);
}

void TestRecording::findsTimesThatAreNotEven()
{
    Recording recording;
    const double times[] = {0.0, 0.5, 0.5, 0.75, 3.0};
    for (qint64 i = 0; i < 5; ++i) {
        World world = frame(i);
        world.time = times[i];
        recording.append(world);
    }
    QCOMPARE(recording.indexAt(0.5), qint64{2}); // the last of the frames at that time
    QCOMPARE(recording.indexAt(2.9), qint64{3});
}

void TestRecording::memoryIsBounded()
{
    Recording recording(smallBytes);
    for (qint64 i = 0; i < 10'000; ++i) {
        recording.append(frame(i));
        QVERIFY(recording.bytes() <= smallBytes);
    }
    QVERIFY(recording.last() - recording.first() >= 250);
}

void TestRecording::oldestFramesAreDroppedAndIndicesStay()
{
    const Recording recording = recordingOf(10'000, 2, smallBytes);
    QVERIFY(recording.hasDropped());
    QCOMPARE(recording.last(), qint64{9999});
    QVERIFY(recording.first() > 9000);
    for (qint64 i = recording.first(); i <= recording.last(); ++i)
        QVERIFY(recording.world(i) == frame(i));
    QCOMPARE(recording.indexAt(0.0), recording.first());
    QCOMPARE(recording.indexAt(2499.0), qint64{9996});
}

void TestRecording::aCrowdKeepsItsNewestFrames()
{
    // More circles than fit: a block at least stays, however little is allowed.
    const Recording recording = recordingOf(1000, 50, 1);
    QVERIFY(recording.last() == 999);
    QVERIFY(recording.last() - recording.first() >= 100);
    QVERIFY(recording.last() - recording.first() < 300);
    QVERIFY(recording.world(999) == frame(999, 50));
    // A full one, beside that which begins.
    QCOMPARE(recordingOf(129, 50, 1).first(), qint64{0});
    QCOMPARE(recordingOf(256, 50, 1).first(), qint64{0});
    QCOMPARE(recordingOf(257, 50, 1).first(), qint64{128});
}

void TestRecording::hitsAreDroppedWithTheirFrames()
{
    Recording recording(smallBytes);
    for (qint64 i = 0; i < 10'000; ++i) {
        if (i % 10 == 3) {
            const Hit hit = hitAt(i);
            recording.append(frame(i), std::span(&hit, 1));
        } else {
            recording.append(frame(i));
        }
        QCOMPARE(recording.droppedHits() + static_cast<qint64>(recording.hits().size()),
                 (i + 7) / 10);
        // Ten steps apart each is a contact of its own.
        QCOMPARE(recording.droppedEncounters(), recording.droppedHits());
    }
    QVERIFY(recording.droppedHits() > 0);
    QVERIFY(!recording.hits().empty());
    QVERIFY(recording.hits().front().step >= recording.first());
    // An index into all hits ever: hit k happened in step 10 k + 3.
    for (std::size_t i = 0; i < recording.hits().size(); ++i) {
        QCOMPARE(recording.hits()[i].step,
                 10 * (recording.droppedHits() + static_cast<qint64>(i)) + 3);
    }
}

void TestRecording::hitsOfOneStepAreDroppedTogether()
{
    Recording recording(smallBytes);
    for (qint64 i = 0; i < 3000; ++i) {
        const Hit hits[] = {hitAt(i, 0), hitAt(i, 1), hitAt(i, 2)};
        recording.append(frame(i, 3), hits);
    }
    QVERIFY(recording.hasDropped());
    QCOMPARE(recording.droppedHits(), 3 * recording.first());
    QCOMPARE(recording.hits().front().a, 0);
    QCOMPARE(static_cast<qint64>(recording.hits().size()),
             3 * (recording.last() - recording.first() + 1));
}

void TestRecording::truncatesAfter_data()
{
    QTest::addColumn<qint64>("index"); // of 400 frames
    for (const qint64 index : {0, 1, 126, 127, 128, 255, 256, 398, 399})
        QTest::addRow("after %lld", static_cast<long long>(index)) << index;
}

void TestRecording::truncatesAfter()
{
    QFETCH(qint64, index);
    Recording recording = recordingOf(400);
    recording.truncateAfter(index);
    QCOMPARE(recording.first(), qint64{0});
    QCOMPARE(recording.last(), index);
    for (qint64 i = 0; i <= index; ++i)
        QVERIFY(recording.world(i) == frame(i));
    QCOMPARE(recording.indexAt(1e9), index);
}

void TestRecording::truncatingKeepsTheHitsUpToThere()
{
    Recording recording;
    for (qint64 i = 0; i < 300; ++i) {
        const Hit hits[] = {hitAt(i, 0), hitAt(i, 1)};
        recording.append(frame(i), hits);
    }
    recording.truncateAfter(100);
    QCOMPARE(recording.hits().size(), std::size_t{202});
    QCOMPARE(recording.hits().back().step, qint64{100});
    QCOMPARE(recording.droppedHits(), qint64{0});
}

void TestRecording::goesOnAfterTruncating()
{
    Recording recording = recordingOf(400);
    for (const qint64 from : {300, 128, 127}) {
        recording.truncateAfter(from);
        for (qint64 i = from + 1; i < 400; ++i)
            recording.append(frame(i + 10'000));
        QCOMPARE(recording.last(), qint64{399});
        QVERIFY(recording.world(from) == frame(from));
        QVERIFY(recording.world(from + 1) == frame(from + 1 + 10'000));
        QVERIFY(recording.world(399) == frame(399 + 10'000));
    }
}

void TestRecording::truncatesAfterHavingDropped()
{
    Recording recording = recordingOf(10'000, 2, smallBytes);
    const qint64 first = recording.first();
    recording.truncateAfter(first + 5);
    QCOMPARE(recording.first(), first);
    QCOMPARE(recording.last(), first + 5);
    for (qint64 i = first; i <= first + 5; ++i)
        QVERIFY(recording.world(i) == frame(i));
    recording.append(frame(77));
    QVERIFY(recording.world(first + 6) == frame(77));
    recording.truncateAfter(first);
    QCOMPARE(recording.last(), first);
    QVERIFY(recording.world(first) == frame(first));
}

void TestRecording::clearForgetsAll()
{
    Recording recording = recordingOf(10'000, 2, smallBytes);
    recording.clear();
    QVERIFY(recording.isEmpty());
    QVERIFY(!recording.hasDropped());
    QVERIFY(recording.hits().empty());
    QCOMPARE(recording.droppedHits(), qint64{0});
    QCOMPARE(recording.bytes(), qint64{0});
    for (qint64 i = 0; i < 10'000; ++i) // and the bound of memory stays
        recording.append(frame(i));
    QVERIFY(recording.bytes() <= smallBytes);
    QVERIFY(recording.hasDropped());
}

void TestRecording::keepsFramesWithoutCircles()
{
    const Recording recording = recordingOf(300, 0);
    QCOMPARE(recording.circleCount(), std::size_t{0});
    QVERIFY(recording.circles(200).empty());
    QVERIFY(recording.world(299) == frame(299, 0));
}

void TestRecording::aSecondRunMayHaveAnotherNumberOfCircles()
{
    Recording recording = recordingOf(200, 2);
    recording.clear();
    recording.append(frame(0, 5));
    QCOMPARE(recording.circleCount(), std::size_t{5});
    QVERIFY(recording.world(0) == frame(0, 5));
}

QTEST_APPLESS_MAIN(TestRecording)
#include "test_recording.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sound/sound_output.h"

#include "app/notice_bar.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "views/charts/chart_plot.h"
#include "views/sound/hit_sounds.h"

#include <QSignalSpy>
#include <QTest>

/// A machine without sound, as every test is to be: that is said once, and all goes on.
class TestSoundOutput : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void machineWithoutSoundIsToldOfOnce();
    void endsBeforeTheServerAnswers();
    void windowSaysItOnceAndGoesOn();
    void returnPlaysTheCurveTold();
};

using namespace cradle;
using cradle::windows::OpenWindow;

void TestSoundOutput::initTestCase()
{
    // Nobody answers there, and no server of this machine is asked.
    qputenv("PULSE_SERVER", "unix:/nowhere/at/all");
}

void TestSoundOutput::machineWithoutSoundIsToldOfOnce()
{
    SoundOutput output;
    QSignalSpy failed(&output, &SoundOutput::failed);
    output.play({0.0F});
    QTRY_COMPARE(failed.size(), 1);
    output.play({0.0F});
    QTest::qWait(50);
    QCOMPARE(failed.size(), 1);
}

void TestSoundOutput::endsBeforeTheServerAnswers()
{
    for (int i = 0; i < 20; ++i) {
        SoundOutput output;
        output.play({0.0F});
    }
}

void TestSoundOutput::windowSaysItOnceAndGoesOn()
{
    QTemporaryDir folder;
    OpenWindow open(folder);
    QVERIFY(!open.window.sounds().hits().isOn());
    open.window.choices().soundHits(true);
    emit open.window.sounds().hits().struck({Tone{440.0, 0.5}});
    QTRY_VERIFY(open.window.notice().text().contains(QStringLiteral("no sound")));
    open.window.notice().retract(open.window.notice().text());
    emit open.window.sounds().hits().struck({Tone{440.0, 0.5}});
    QTest::qWait(50);
    QVERIFY(!open.window.notice().text().contains(QStringLiteral("no sound")));
}

void TestSoundOutput::returnPlaysTheCurveTold()
{
    QTemporaryDir folder;
    OpenWindow open(folder);
    open.bench.setMode(Mode::Explore);
    QVERIFY(open.bench.openTask(QStringLiteral("L42T5")));
    for (int i = 0; i < 30; ++i)
        open.simulation().stepForward();
    ChartPlot *plot = nullptr;
    const auto find = [&] {
        for (auto *each : open.window.findChildren<ChartPlot *>()) {
            if (each->isVisible() && !each->curves().empty() && !plot)
                plot = each;
        }
        return plot != nullptr;
    };
    QTRY_VERIFY(find());
    QSignalSpy played(plot, &Plot::played);
    QTest::keyClick(plot, Qt::Key_Return); // no curve was told yet
    QCOMPARE(played.size(), 0);
    plot->setFocus(Qt::TabFocusReason);
    QTest::keyClick(plot, Qt::Key_Return);
    QCOMPARE(played.size(), 1);
    const auto values = played[0][0].value<std::vector<double>>();
    const MinMaxPyramid &samples = *plot->curves().front().samples;
    QCOMPARE(values.front(), samples.valueAt(samples.firstTime()));
    QCOMPARE(values.back(), samples.lastValue());
}

QTEST_MAIN(TestSoundOutput)
#include "test_sound_output.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reference_run.h"

#include "tests/patience.h"
#include "tests/scenes.h"

#include <QSignalSpy>
#include <QThreadPool>
#include <QTimer>

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr const char *drift = R"(
function on_update(timestep)
  circles[1].position = circles[1].position + timestep * circles[1].velocity
end
)";

Variant variant(double duration)
{
    return {QStringLiteral("preset"),
            scene({circle({-2, 2}, {2, 0})}, {WallLaw::Reflect, CircleLaw::None, {}}), duration};
}

} // namespace

/// The run beside the student's is made while the window lives on.
class TestReferenceRun : public QObject
{
    Q_OBJECT
private slots:
    void tellsTheStatesOfTheProgram();
    void eventsAreHandledWhileItRuns();
    void tellsTheLastThatWasAskedFor();
    void programThatStopsTellsNothing();
};

void TestReferenceRun::tellsTheStatesOfTheProgram()
{
    ReferenceRun reference;
    QSignalSpy finished(&reference, &ReferenceRun::finished);
    reference.start(variant(1.0), QLatin1String(drift));
    QTRY_COMPARE(finished.size(), 1);
    const auto states = finished[0][0].value<std::shared_ptr<const Recording>>();
    const Observation expected = observe(variant(1.0), nullptr); // the laws do the same
    QCOMPARE(states->last(), qint64{60});
    for (qint64 k = 0; k <= 60; ++k)
        COMPARE_NEAR(states->circles(k)[0].position.x, expected.circle(0, k).position.x, 1e-12);
}

/// A million seconds of the scene: nobody waits for that.
void TestReferenceRun::eventsAreHandledWhileItRuns()
{
    ReferenceRun reference;
    QSignalSpy finished(&reference, &ReferenceRun::finished);
    reference.start(variant(1e6), QLatin1String(drift));
    int turns = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&turns] { ++turns; });
    timer.start(0);
    QTRY_VERIFY(turns >= 3);
    QCOMPARE(finished.size(), 0);
    reference.cancel();
    QVERIFY(QThreadPool::globalInstance()->waitForDone(patience)); // it ends soon
    QCoreApplication::processEvents();
    QCOMPARE(finished.size(), 0);
}

void TestReferenceRun::tellsTheLastThatWasAskedFor()
{
    ReferenceRun reference;
    QSignalSpy finished(&reference, &ReferenceRun::finished);
    reference.start(variant(1e6), QLatin1String(drift));
    reference.start(variant(0.5), QLatin1String(drift));
    QTRY_COMPARE(finished.size(), 1);
    QCOMPARE(finished[0][0].value<std::shared_ptr<const Recording>>()->last(), qint64{30});
}

void TestReferenceRun::programThatStopsTellsNothing()
{
    ReferenceRun reference;
    QSignalSpy finished(&reference, &ReferenceRun::finished);
    reference.start(variant(1.0), QStringLiteral("function on_update() error('no') end"));
    QThreadPool::globalInstance()->waitForDone();
    QCoreApplication::processEvents();
    QCOMPARE(finished.size(), 0);
}

QTEST_GUILESS_MAIN(TestReferenceRun)
#include "test_reference_run.moc"

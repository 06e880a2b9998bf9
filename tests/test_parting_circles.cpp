// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/judgement.h"

#include "tests/lab_test.h"
#include "tests/other_forms.h"

using namespace cradle;
using namespace cradle::programs;

/// Whether a program must ask if circles approach depends on where its hits leave them.
class TestPartingCircles : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void testIsNeededWhereHitsLeaveCirclesInside_data();
    void testIsNeededWhereHitsLeaveCirclesInside();
    void hitMayBeRememberedInstead_data();
    void hitMayBeRememberedInstead();
};

namespace {

/// Without asking whether they approach.
QString blind(QString answer)
{
    return answer.replace(QStringLiteral("if closing > 0 then"), QStringLiteral("do"));
}

const QString back1 = QStringLiteral(" p.position = p.before ");
const QString back2 = QStringLiteral(" q.position = q.before ");
const QString apart = QStringLiteral(" local deep = reach - (q.position - p.position):length() "
                                     "p.position = p.position - deep / 2 * n "
                                     "q.position = q.position + deep / 2 * n ");

} // namespace

void TestPartingCircles::testIsNeededWhereHitsLeaveCirclesInside_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("after"); ///< what a hit does to the places
    QTest::addColumn<bool>("asks");
    QTest::addColumn<bool>("passes");
    QTest::addColumn<bool>("remarked");
    for (const char *step : {"L42T10", "L42T12", "L42T14", "L42T16"}) {
        const auto row = [&](const char *name, const QString &after, bool asks, bool passes) {
            QTest::addRow("%s, %s", step, name)
                << parts::lab(step) << after << asks << passes << (passes && !asks);
        };
        row("both back, no test", back1 + back2, false, true);
        row("pushed apart, no test", apart, false, true);
        row("both left, no test", {}, false, false);
        row("both left, with the test", {}, true, true);
        if (parts::lab(step) == QLatin1String("L42T16")) // e = 0 keeps them inside
            continue;
        row("one back, no test", back1, false, false);
        row("one back, with the test", back1, true, true);
    }
}

void TestPartingCircles::testIsNeededWhereHitsLeaveCirclesInside()
{
    QFETCH(QString, step);
    QFETCH(QString, after);
    QFETCH(bool, asks);
    QFETCH(bool, passes);
    QFETCH(bool, remarked);
    OtherForm form = otherForm(step);
    form.integrate.prepend(QStringLiteral("c.before = c.position "));
    form.answer =
        (asks ? form.answer : blind(form.answer))
        + (asks ? QStringLiteral(" if closing > 0 then ") + after + QStringLiteral(" end") : after);
    for (qint64 seed = 1; seed <= 2; ++seed) {
        const CheckReport report =
            *judgeTask(m_lab, task(step), Submission(task(step).preset, form.source()), seed);
        QVERIFY2(report.passed == passes, say(report).constData());
        QCOMPARE(!report.remarks.empty(), remarked);
    }
}

void TestPartingCircles::hitMayBeRememberedInstead_data()
{
    QTest::addColumn<QString>("step");
    for (const char *step : {"L42T12", "L42T14"})
        QTest::newRow(step) << parts::lab(step);
}

/// It is answered once, and forgotten when they have parted: what it cannot know of is a hit before
/// the scene began.
void TestPartingCircles::hitMayBeRememberedInstead()
{
    QFETCH(QString, step);
    OtherForm form = otherForm(step);
    form.start += QStringLiteral(" together = false");
    form.integrate.prepend(
        QStringLiteral("if c.index == 1 and (circle2.position - circle1.position):length() >= "
                       "circle1.radius + circle2.radius then together = false end "));
    form.answer = QStringLiteral("if not together then together = true ") + blind(form.answer)
                  + QStringLiteral(" end");
    const CheckReport report =
        *judgeTask(m_lab, task(step), Submission(task(step).preset, form.source()), 1);
    QVERIFY2(report.passed, say(report).constData());
}

QTEST_GUILESS_MAIN(TestPartingCircles)
#include "test_parting_circles.moc"

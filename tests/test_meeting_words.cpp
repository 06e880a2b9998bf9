// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tests/made_contacts.h"

#include <QTest>

using namespace cradle;
using namespace cradle::made;

/// What is said of circles that part, that meet again, and that come slowly or fast, of meetings
/// that were made up.
class TestMeetingWords : public QObject
{
    Q_OBJECT
private slots:
    void meetingIsTold_data();
    void meetingIsTold();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

} // namespace

void TestMeetingWords::meetingIsTold_data()
{
    QTest::addColumn<Spoil>("spoil");
    QTest::addColumn<QString>("headline"); // empty: nothing is said
    QTest::addColumn<QString>("body");
    int rows = 0;
    const auto row = [&](const char *headline, const Spoil &spoil, const char *body = "") {
        QTest::addRow("%d. %s", ++rows, headline) << spoil << utf8(headline) << utf8(body);
    };
    const char *const again = "Circles that already part are hit again";
    const auto part = [](bool isAgain, qint64 step, bool PairHit::*inside,
                         bool isAfterRest = true) -> Spoil {
        return [=](BothPairs &p) {
            PairHit hit = contactAt(21.0, 0.2, 0.2, 0.39);
            hit.again = isAgain;
            hit.afterRest = isAfterRest;
            hit.step = step;
            p.own.partings = {unanswered(hit), hit};
            p.right.partings = {unanswered(hit), unanswered(hit)};
            p.own.contacts[4].*inside = true;
        };
    };
    row(again, part(true, 1, &PairHit::partsInside), "turned them to (-0.");
    row("", part(false, 1, &PairHit::partsInside));
    row("", part(true, 2, &PairHit::partsInside));
    row("", part(true, 1, &PairHit::answered));
    row("", part(true, 1, &PairHit::partsInside, false));
    row(again, [](BothPairs &p) { p.own.twice = contactAt(33.0, 0.2, 0.2, 0.39); });
    row("", [](BothPairs &p) { p.own.twice = p.right.twice = contactAt(33.0, 0.2, 0.2, 0.39); });
    const auto twice = [](double distance, bool isAnew) -> Spoil {
        return [=](BothPairs &p) {
            p.own.twice = contactAt(33.0, 0.2, 0.2, 0.39);
            p.own.twice->before = distance;
            p.own.twice->anew = isAnew;
        };
    };
    row(again, twice(0.39, true), "They overlapped and moved apart with ");
    row(again, twice(0.39, true), "ask whether they come nearer");
    row(again, twice(0.45, true), "with 0.05 m between their rims; the next step");
    row(again, twice(0.39, false), "A run that begins so leaves them alone");
    // Of those that meet none is answered.
    row("The circles answer when they part, not when they meet", [](BothPairs &p) {
        forgetAll(p.own.equals);
        PairHit hit = contactAt(21.0, 0.2, 0.2, 0.39);
        hit.step = 1;
        p.own.partings = {hit};
        p.right.partings = {unanswered(hit)};
    });
    row("A later hit is not answered", [](BothPairs &p) { p.own.ranThrough = true; });
    row("", [](BothPairs &p) {
        p.own.ranThrough = true;
        p.right.ownContacts = 1;
    });
    row("A hit soon after another is not answered",
        [](BothPairs &p) { p.own.ranThrough = p.own.ranThroughAtOnce = true; });
    row(
        "Nothing happens when it is circle 2 that comes nearer",
        [](BothPairs &p) {
            p.own.ranThrough = true;
            p.own.returning = unanswered(contactAt(33.0, 0.2, 0.2, 0.4));
        },
        "circle 1 had 0.7 m/s and circle 2 -0.5 m/s, so they came nearer with 1.2 m/s");
    row("Not every meeting is answered", [](BothPairs &p) {
        p.own.ranThrough = true;
        p.own.ranThroughAnew = unanswered(contactAt(33.0, 0.2, 0.2, 0.4));
    });
    for (const bool isFast : {false, true}) {
        const auto speed = [isFast](bool isHeld, double share) -> Spoil {
            return [=](BothPairs &p) {
                PairHit hit = contactAt(33.0, 0.2, 0.2, 0.4);
                hit.slowness = share;
                (isFast ? p.right.fast : p.right.slow) = hit;
                hit.moved1 = isHeld;
                (isFast ? p.own.fast : p.own.slow) = unanswered(hit);
            };
        };
        const char *const headline = isFast ? "Circles that come nearer fast are not answered"
                                            : "Circles that come nearer slowly are not answered";
        row(headline, speed(false, 0.5), "They came nearer with 0.6 m/s and ran into each other");
        row(headline, speed(true, 0.5), "with 0.6 m/s, touched and kept their velocities");
    }
}

void TestMeetingWords::meetingIsTold()
{
    QFETCH(Spoil, spoil);
    QFETCH(QString, headline);
    QFETCH(QString, body);
    const auto found = contactsFound(spoil);
    QCOMPARE(headlinesOf(found), headline.isEmpty() ? QStringList() : QStringList(headline));
    for (const LawDeviation &each : found)
        QVERIFY2(each.message.contains(body), qPrintable(each.message));
}

QTEST_GUILESS_MAIN(TestMeetingWords)
#include "test_meeting_words.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tests/made_contacts.h"

#include <QTest>

using namespace cradle;
using namespace cradle::made;

/// What is said of when circles are answered, of six meetings that were made up: circles of 0.4 and
/// 0.55 m that come nearer with 1.2 m/s.
class TestContactWords : public QObject
{
    Q_OBJECT
private slots:
    void faultIsTold_data();
    void faultIsTold();
    void ownSceneIsToldBeyondAStep();
    void oldRadiiAreSuspected();
    void placesAreToldBeyondTwoSteps();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

/// None is answered in time; what else is done to them.
Spoil missedBy(const std::function<void(PairHit &)> &change)
{
    return [change](BothPairs &pairs) {
        forgetAll(pairs.own.contacts);
        std::for_each(pairs.own.contacts.begin(), pairs.own.contacts.end(), change);
    };
}

} // namespace

void TestContactWords::faultIsTold_data()
{
    QTest::addColumn<Spoil>("spoil");
    QTest::addColumn<QString>("headline"); // empty: nothing is said
    QTest::addColumn<QString>("body");
    int rows = 0;
    const auto row = [&](const char *headline, const Spoil &spoil, const char *body = "") {
        QTest::addRow("%d. %s", ++rows, headline) << spoil << utf8(headline) << utf8(body);
    };
    row("", [](BothPairs &) {});
    row("", [](BothPairs &p) {
        forgetAll(p.own.contacts);
        p.own.isJudged = false;
    });
    row("", [](BothPairs &p) {
        forgetAll(p.own.contacts);
        p.right.isJudged = false;
    });
    row("The circles run through each other", missedBy([](PairHit &) {}), "From all 6 directions");
    // With e = 1 a hit may come to nothing.
    row("", [](BothPairs &p) {
        forgetAll(p.own.contacts);
        forgetAll(p.own.equals);
        p.own.rebounds = p.right.rebounds = {contactAt(33.0, 0.2, 0.2, 0.4)};
    });
    row("The circles act on each other", [](BothPairs &p) { forgetAll(p.right.contacts); });
    for (const double push : {0.5e-9, 2e-9}) {
        const bool alone = push < 1e-9;
        row(alone ? "Circle 1 answers where it meets circle 2" : "The circles act on each other",
            [push](BothPairs &p) {
                forgetAll(p.right.contacts);
                for (PairHit &hit : p.own.contacts)
                    hit.left2 = hit.came2 + push * hit.normal;
                forget(p.own.contacts[1]);
            });
        row(alone ? "Circle 2 answers where it meets circle 1" : "The circles act on each other",
            [push](BothPairs &p) {
                forgetAll(p.right.contacts);
                for (PairHit &hit : p.own.contacts)
                    hit.left1 = hit.came1 - push * hit.normal;
            });
    }
    const char *const back = "The circles are held and keep their velocities";
    row(back, missedBy([](PairHit &h) { h.moved1 = true; }), "circle 1 did not move on");
    row(back, missedBy([](PairHit &h) { h.moved2 = true; }), "circle 2 did not move on");
    row(back, missedBy([](PairHit &h) { h.moved1 = h.moved2 = true; }), "neither moved on");
    row("A hit changes the places of the circles, not their velocities", missedBy([](PairHit &h) {
            h.moved2 = true;
            h.leaper = 1;
            h.landed = {1.0, 2.0};
        }),
        "circle 2 was put to (1, 2) m");
    const auto ownAlone = [](double distance) -> Spoil {
        return [distance](BothPairs &p) {
            forgetAll(p.own.contacts);
            p.own.contacts[3].meeting.velocities.along1 = 1.4;
            p.own.own = contactAt(10.0, 0.2, 0.2, distance);
        };
    };
    row("No hit tried is answered but that of your own scene", ownAlone(0.4),
        "with up to 1.9 m/s along the line of centres, neither of them changed its velocity. In "
        "your own scene, with 1.2 m/s, they");
    row("The circles are answered much too late, or not at all", ownAlone(0.2),
        "between 0.19 and 0.21 m apart; rims touch there at 0.4 m");
    const char *const parting = "The circles answer when they part, not when they meet";
    row(
        parting,
        [](BothPairs &p) {
            for (PairHit &hit : p.own.contacts)
                hit.parting = true;
        },
        "until their centres were 0.41 m apart");
    row(
        parting,
        [](BothPairs &p) {
            for (PairHit &hit : p.own.contacts)
                hit.parting = hit.moved1 = true;
        },
        "They touched, their places were changed");
    row(
        "The circles are answered long after they meet",
        [](BothPairs &p) {
            for (PairHit &hit : p.own.contacts)
                hit.parting = true;
            p.own.partings = {contactAt(21.0, 0.2, 0.2, 0.39)};
            p.own.partings.front().answered = false;
        },
        "move apart are not answered at once");
    row("", [](BothPairs &p) {
        for (PairHit &hit : p.own.contacts)
            hit.parting = hit.meeting.degrees > 200.0;
    });
    const auto at = [](double share) -> Spoil {
        return [share](BothPairs &p) { p.own.contacts = contactsAt(share); };
    };
    row("The circles answer too late", at(0.65), "they answered when their centres were between");
    row("The circles answer before they touch", at(1.3));
    row(
        "The test of contact acts as if a number stood for r₁ + r₂",
        [](BothPairs &p) {
            for (PairHit &hit : p.own.contacts)
                hit =
                    contactAt(hit.meeting.degrees, hit.meeting.radius1, hit.meeting.radius2, 0.48);
        },
        "between 0.47 and 0.49 m");
    const auto some = [](double first, double second) -> Spoil {
        return [=](BothPairs &p) {
            p.own.contacts[0] = contactAt(3.0, 0.2, 0.2, first * 0.4);
            p.own.contacts[1] = contactAt(88.0, 0.2, 0.2, second * 0.4);
        };
    };
    row("Some meetings are answered before they touch", some(1.3, 1.2),
        "Of 6 meetings tried, 4 were answered in time.");
    row("Some meetings are answered too late", some(0.7, 1.0),
        "Of 6 meetings tried, 5 were answered in time.");
    row("Some meetings are answered before they touch, others too late", some(0.7, 1.3));
    row(
        "The circles are answered too late, or not at all",
        [](BothPairs &p) {
            p.own.contacts = contactsAt(0.65);
            forget(p.own.contacts[0]);
            forget(p.own.contacts[3]);
        },
        "Of the 6 meetings that were tried 0 were answered in time; in 2 no velocity was changed.");
    row(
        "A hit puts circle 2 somewhere else",
        [](BothPairs &p) {
            p.own.contacts[2].leaper = 1;
            p.own.contacts[2].landed = {-1.0, 0.5};
        },
        "it was put to (-1, 0.5) m");
    const auto misplaced = [](Misplacement::Where where) -> Spoil {
        return [where](BothPairs &p) {
            p.own.contacts[1].misplaced = Misplacement{where, 0.003};
            p.own.contacts[2].misplaced = Misplacement{where, 0.015};
            p.own.contacts[2].misplacedCircle = 1;
        };
    };
    row("A hit pushes circle 2 into the other one", misplaced(Misplacement::Where::Into),
        "to 0.39 m from each other the hit put circle 2 0.015 m nearer");
    row("A hit puts circle 2 too far away", misplaced(Misplacement::Where::Away),
        "0.015 m farther from the other one");
    row("A hit moves circle 2 to the side", misplaced(Misplacement::Where::Aside),
        "0.015 m to the side");
    row("", [](BothPairs &p) {
        p.own.contacts[2].misplaced = p.right.contacts[2].misplaced = Misplacement{};
    });
    row("", [](BothPairs &p) { p.own.contacts[2].leaper = p.right.contacts[2].leaper = 1; });
}

void TestContactWords::faultIsTold()
{
    QFETCH(Spoil, spoil);
    QFETCH(QString, headline);
    QFETCH(QString, body);
    const auto found = contactsFound(spoil);
    QCOMPARE(headlinesOf(found), headline.isEmpty() ? QStringList() : QStringList(headline));
    for (const LawDeviation &each : found)
        QVERIFY2(each.message.contains(body), qPrintable(each.message));
}

/// A step late may be who glances off: 2 cm in a step, so from 6 cm on it is told.
void TestContactWords::ownSceneIsToldBeyondAStep()
{
    const auto said = [](double distance) {
        return headlinesOf(contactsFound([distance](BothPairs &p) {
            p.right.own = contactAt(10.0, 0.2, 0.2, 0.4);
            p.own.own = contactAt(10.0, 0.2, 0.2, distance);
        }));
    };
    QVERIFY(said(0.4).isEmpty() && said(0.351).isEmpty() && said(0.409).isEmpty());
    QCOMPARE(said(0.349), QStringList(utf8("In your own scene the circles answer too late")));
    QCOMPARE(said(0.411),
             QStringList(utf8("In your own scene the circles answer before they touch")));
}

void TestContactWords::oldRadiiAreSuspected()
{
    Preset scene;
    scene.circles.resize(2);
    for (const auto &[radius, isOld] : {std::pair(0.1, true), std::pair(0.12, false)}) {
        scene.circles[0].body.radius = scene.circles[1].body.radius = radius;
        const auto found = contactsFound(
            [](BothPairs &p) {
                p.right.own = contactAt(10.0, 0.2, 0.2, 0.4);
                p.own.own = contactAt(10.0, 0.2, 0.2, 0.2);
            },
            scene);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.front().suspect, isOld ? Suspect::Copy : Suspect::Question);
        QCOMPARE(found.front().message.contains(utf8("when your program reads the radii")), isOld);
    }
}

/// They fly 2 cm in a step before a hit and after it; far is what is twice as much, 8 cm, farther
/// than they were; and in each other who is nearer than half of that.
void TestContactWords::placesAreToldBeyondTwoSteps()
{
    const auto said = [](double after) {
        return headlinesOf(
            contactsFound([after](BothPairs &p) { p.own.contacts[1].after = after; }));
    };
    QVERIFY(said(0.489).isEmpty());
    QCOMPARE(said(0.491), QStringList(utf8("A hit puts the circles too far apart")));
    QVERIFY(said(0.196).isEmpty());
    QCOMPARE(said(0.194), QStringList(utf8("A hit puts the circles into each other")));
    // Who flies on so far by a wrong velocity was put nowhere.
    const auto flown = contactsFound([](BothPairs &p) {
        PairHit &hit = p.own.contacts[1];
        hit.after = 0.194;
        hit.left2 = hit.left1 - 12.0 * hit.normal;
    });
    QVERIFY(headlinesOf(flown).filter(utf8("into each other")).isEmpty());
}

QTEST_GUILESS_MAIN(TestContactWords)
#include "test_contact_words.moc"

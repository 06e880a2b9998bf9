// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/nearest_name.h"

#include <QTest>
#include <rapidcheck.h>

using namespace cradle;

namespace {

QString text(const char *latin)
{
    return QString::fromLatin1(latin);
}

const QStringList &fields()
{
    static const QStringList names{text("position"), text("velocity"), text("radius"),
                                   text("density"), text("index")};
    return names;
}

QString anyWord()
{
    return QString::fromStdString(*rc::gen::resize(8, rc::gen::string<std::string>()));
}

} // namespace

class TestNearestName : public QObject
{
    Q_OBJECT
private slots:
    void distanceCountsTheSlips_data();
    void distanceCountsTheSlips();
    void distanceIsAMeasure();
    void nearestIsFound_data();
    void nearestIsFound();
    void slipsAreBorneByLength();
    void firstOfEquallyNearIsTaken();
    void nothingKnownSuggestsNothing();
};

void TestNearestName::distanceCountsTheSlips_data()
{
    QTest::addColumn<QString>("a");
    QTest::addColumn<QString>("b");
    QTest::addColumn<int>("distance");
    QTest::newRow("equal") << text("radius") << text("radius") << 0;
    QTest::newRow("both empty") << QString() << QString() << 0;
    QTest::newRow("from nothing") << QString() << text("abc") << 3;
    QTest::newRow("to nothing") << text("abc") << QString() << 3;
    QTest::newRow("letter left out") << text("radus") << text("radius") << 1;
    QTest::newRow("letter too many") << text("raddius") << text("radius") << 1;
    QTest::newRow("another letter") << text("rodius") << text("radius") << 1;
    QTest::newRow("neighbours exchanged") << text("raduis") << text("radius") << 1;
    QTest::newRow("exchanged at the start") << text("ardius") << text("radius") << 1;
    QTest::newRow("exchanged at the end") << text("radisu") << text("radius") << 1;
    QTest::newRow("two slips") << text("velosity2") << text("velocity") << 2;
    QTest::newRow("all other") << text("abc") << text("xyz") << 3;
    QTest::newRow("other case") << text("Radius") << text("radius") << 1;
    // Optimal string alignment, not Damerau: no letter is touched twice.
    QTest::newRow("exchanged and one between") << text("ca") << text("abc") << 3;
}

void TestNearestName::distanceCountsTheSlips()
{
    QFETCH(QString, a);
    QFETCH(QString, b);
    QFETCH(int, distance);
    QCOMPARE(editDistance(a, b), distance);
    QCOMPARE(editDistance(b, a), distance);
}

void TestNearestName::distanceIsAMeasure()
{
    QVERIFY(rc::check("symmetric, zero for equals only, bounded by the lengths", [] {
        const QString a = anyWord();
        const QString b = anyWord();
        const int distance = editDistance(a, b);
        RC_ASSERT(distance == editDistance(b, a));
        RC_ASSERT((distance == 0) == (a == b));
        RC_ASSERT(distance <= std::max(a.size(), b.size()));
        RC_ASSERT(distance >= std::abs(a.size() - b.size()));
    }));
}

void TestNearestName::nearestIsFound_data()
{
    QTest::addColumn<QString>("nearest");
    const auto row = [](const char *name, const char *nearest) {
        QTest::newRow(name) << text(nearest);
    };
    row("velocty", "velocity");
    row("Velocity", "velocity");
    row("VELOCITY", "velocity");
    row("positon", "position");
    row("postion", "position");
    row("pos", "position");
    row("vel", "velocity");
    row("rad", "radius");
    row("dens", "density");
    row("desnity", "density");
    row("indx", "index");
    row("ve", "");
    row("speed", "");
    row("mass", "");
    row("colour", "");
    row("x", "");
    row("a very long name that nobody meant", "");
}

void TestNearestName::nearestIsFound()
{
    QFETCH(QString, nearest);
    QCOMPARE(nearestName(text(QTest::currentDataTag()), fields()), nearest);
}

/// One letter in three, at least one, at most three, and never all.
void TestNearestName::slipsAreBorneByLength()
{
    const int most[] = {0, 0, 1, 1, 1, 1, 2, 2, 2, 3, 3, 3, 3, 3}; // of so many letters
    for (int letters = 1; letters < 14; ++letters) {
        const QString known = text("abcdefghijklmnopq").left(letters);
        for (int slips = 1; slips <= std::min(letters, 5); ++slips) {
            const QString name = QString(slips, QLatin1Char('z')) + known.mid(slips);
            QCOMPARE(nearestName(name, {known}), slips <= most[letters] ? known : QString());
        }
    }
}

void TestNearestName::firstOfEquallyNearIsTaken()
{
    const QStringList known{text("circle2"), text("circle1"), text("circles")};
    QCOMPARE(nearestName(text("circle"), known), text("circle2"));
    QCOMPARE(nearestName(text("circle1"), known), text("circle1"));
    QCOMPARE(nearestName(text("Circle1"), known), text("circle1"));
}

void TestNearestName::nothingKnownSuggestsNothing()
{
    QVERIFY(nearestName(text("velocity"), {}).isEmpty());
    QVERIFY(nearestName(QString(), fields()).isEmpty());
    QVERIFY(nearestName(text("x"), {text("y")}).isEmpty());
    QCOMPARE(nearestName(text("X"), {text("y"), text("x")}), text("x"));
}

QTEST_GUILESS_MAIN(TestNearestName)
#include "test_nearest_name.moc"

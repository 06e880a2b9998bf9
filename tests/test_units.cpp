// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/unit.h"
#include "model/files/unit_number.h"

#include <QTest>

#include <cmath>

using namespace cradle;

/// Every unit, alone and with every prefix, and what becomes of units in a product or a power.
class TestUnits : public QObject
{
    Q_OBJECT
private slots:
    void eachUnitIsKnownWithItsPrefixes_data();
    void eachUnitIsKnownWithItsPrefixes();
    void powersAreRead_data();
    void powersAreRead();
    void numbersAreReadWithTheirUnit_data();
    void numbersAreReadWithTheirUnit();
    void powersHaveNames_data();
    void powersHaveNames();
    void powersAreRaisedUpToTheNinth();
    void whatHasAUnitTellsThatOfASum();
    void askedUnitsHaveAFactor();
};

namespace {

using Kind = UnitNumber::Kind;

QString u(const char *text)
{
    return QString::fromUtf8(text);
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= 1e-12 * std::abs(b);
}

} // namespace

void TestUnits::eachUnitIsKnownWithItsPrefixes_data()
{
    QTest::addColumn<double>("scale");
    QTest::addColumn<UnitPowers>("powers");
    QTest::addColumn<bool>("takesPrefix");
    const auto row = [](const char *unit, double scale, UnitPowers powers, bool takesPrefix) {
        QTest::newRow(unit) << scale << powers << takesPrefix;
    };
    row("m", 1.0, {1, 0, 0}, true);
    row("g", 0.001, {0, 1, 0}, true);
    row("s", 1.0, {0, 0, 1}, true);
    row("N", 1.0, {1, 1, -2}, true);
    row("J", 1.0, {2, 1, -2}, true);
    row("W", 1.0, {2, 1, -3}, true);
    row("Pa", 1.0, {-1, 1, -2}, true);
    row("Hz", 1.0, {0, 0, -1}, true);
    row("min", 60.0, {0, 0, 1}, false);
    row("h", 3600.0, {0, 0, 1}, false);
    row("t", 1000.0, {0, 1, 0}, false);
    row("rad", 1.0, {}, false);
    row("%", 0.01, {}, false);
    row("1", 1.0, {}, false);
    row("°", 0.017453292519943295, {}, false);
}

void TestUnits::eachUnitIsKnownWithItsPrefixes()
{
    QFETCH(double, scale);
    QFETCH(UnitPowers, powers);
    QFETCH(bool, takesPrefix);
    const QString name = u(QTest::currentDataTag());
    const auto alone = unitFrom(name);
    QVERIFY(alone && isNear(alone->scale, scale));
    QVERIFY(alone->powers == powers);
    const std::pair<const char *, double> prefixes[] = {
        {"n", 1e-9}, {"µ", 1e-6}, {"u", 1e-6}, {"m", 1e-3}, {"c", 1e-2},
        {"d", 1e-1}, {"h", 1e2},  {"k", 1e3},  {"M", 1e6},  {"G", 1e9}};
    for (const auto &[prefix, factor] : prefixes) {
        const auto unit = unitFrom(u(prefix) + name);
        QCOMPARE(unit.has_value(), takesPrefix);
        QVERIFY(!unit || (isNear(unit->scale, factor * scale) && unit->powers == powers));
    }
    for (const char *prefix : {"T", "K", "da", "kk"})
        QVERIFY(!unitFrom(u(prefix) + name));
}

void TestUnits::powersAreRead_data()
{
    QTest::addColumn<bool>("isUnit");
    QTest::addColumn<double>("scale");
    QTest::addColumn<UnitPowers>("powers");
    const auto row = [](const char *unit, double scale, UnitPowers powers) {
        QTest::newRow(unit) << true << scale << powers;
    };
    const auto noUnit = [](const char *unit) {
        QTest::newRow(unit) << false << 0.0 << UnitPowers{};
    };
    row(" ", 1.0, {});
    row("km^9", 1e27, {9, 0, 0});
    row("s⁻⁹", 1.0, {0, 0, -9});
    row("s^-9", 1.0, {0, 0, -9});
    row("cm²", 1e-4, {2, 0, 0});
    row("m⁰", 1.0, {});
    row("h/km", 3.6, {-1, 0, 1});
    row("m/s/s kg", 1.0, {1, -1, -2});
    row(" kg · m ⋅ m * m × m ", 1.0, {4, 1, 0});
    for (const char *unit :
         {"m^10", "s⁻¹⁰", "m^", "m^x", "m^2²", "m/", "/", "/s", "m//s", "x", "²", "^2", "kg-m"})
        noUnit(unit);
}

void TestUnits::powersAreRead()
{
    QFETCH(bool, isUnit);
    QFETCH(double, scale);
    QFETCH(UnitPowers, powers);
    const auto unit = unitFrom(u(QTest::currentDataTag()));
    QCOMPARE(unit.has_value(), isUnit);
    QVERIFY(!unit || (isNear(unit->scale, scale) && unit->powers == powers));
}

void TestUnits::numbersAreReadWithTheirUnit_data()
{
    QTest::addColumn<bool>("isNumber");
    QTest::addColumn<double>("number");
    QTest::addColumn<QString>("unit");
    const auto row = [](const char *text, double number, const char *unit) {
        QTest::newRow(text) << true << number << u(unit);
    };
    row("9.9 m/s", 9.9, "m/s");
    row(" -3,2e-3kg ", -0.0032, "kg");
    row("−2", -2.0, "");
    row("+.5E+2%", 50.0, "%");
    row("5.", 5.0, "");
    row("1e", 1.0, "e");
    for (const char *text : {"", "m", ".", "-", "- 1", "1e999", "--1"})
        QTest::newRow(text) << false << 0.0 << QString();
}

void TestUnits::numbersAreReadWithTheirUnit()
{
    QFETCH(bool, isNumber);
    QFETCH(double, number);
    QFETCH(QString, unit);
    const auto quantity = quantityFrom(u(QTest::currentDataTag()));
    QCOMPARE(quantity.has_value(), isNumber);
    QVERIFY(!quantity || (quantity->number == number && quantity->unit == unit));
}

void TestUnits::powersHaveNames_data()
{
    QTest::addColumn<UnitPowers>("powers");
    const auto row = [](const char *name, UnitPowers powers) { QTest::newRow(name) << powers; };
    row("1", {0, 0, 0});
    row("m", {1, 0, 0});
    row("kg", {0, 1, 0});
    row("s", {0, 0, 1});
    row("kg m", {1, 1, 0});
    row("kg m² s³", {2, 1, 3});
    row("kg^4", {0, 4, 0});
    row("1/kg", {0, -1, 0});
    row("1/m² s^4", {-2, 0, -4});
    row("kg m²/s²", {2, 1, -2});
}

void TestUnits::powersHaveNames()
{
    QFETCH(UnitPowers, powers);
    QCOMPARE(nameOf(powers), u(QTest::currentDataTag()));
}

void TestUnits::powersAreRaisedUpToTheNinth()
{
    const UnitNumber three = UnitNumber::measured(3.0, {1, 0, -2});
    const auto to = [](double power) { return UnitNumber{power, Kind::Bare, {}}; };
    const auto square = raised(three, to(2.0));
    QVERIFY(square && square->number == 9.0 && square->powers == (UnitPowers{2, 0, -4}));
    QVERIFY(raised(three, to(4.0)) && raised(three, to(-4.0)));
    QVERIFY(!raised(three, to(5.0)) && !raised(three, to(-5.0)));
    const auto root = raised(UnitNumber::measured(4.0, {2, 0, -4}), to(0.5));
    QVERIFY(root && root->number == 2.0 && root->powers == (UnitPowers{1, 0, -2}));
    QVERIFY(!raised(three, to(0.5)));
    // To the power of 0 it is a number like any other, and ninth powers are the highest.
    const auto one = raised(three, to(0.0));
    QVERIFY(one && one->number == 1.0 && one->kind == Kind::Bare);
    const UnitNumber metre = UnitNumber::measured(1.0, {1, 0, 0});
    QVERIFY(raised(metre, to(9.0)) && !raised(metre, to(10.0)) && !raised(metre, to(-10.0)));
    QVERIFY(!raised(to(2.0), metre));
    const auto any = raised({2.0, Kind::Any, {}}, to(3.0));
    QVERIFY(any && any->number == 8.0 && any->kind == Kind::Any);
}

void TestUnits::whatHasAUnitTellsThatOfASum()
{
    const UnitNumber bare{2.0, Kind::Bare, {}};
    const UnitNumber any{3.0, Kind::Any, {}};
    const UnitNumber way = UnitNumber::measured(5.0, {1, 0, 0});
    const UnitNumber time = UnitNumber::measured(4.0, {0, 0, 1});
    QVERIFY(!way.fits(time) && way.fits(way) && way.fits(any) && any.fits(time) && bare.fits(way));
    for (const auto &[a, b] : {std::pair(way, bare), std::pair(bare, way), std::pair(way, any),
                               std::pair(any, way), std::pair(way, way)}) {
        const UnitNumber sum = likeBoth(a, b, 7.0);
        QVERIFY(sum.number == 7.0 && sum.kind == Kind::Measured && sum.powers == way.powers);
    }
    // A value may have a unit, which nobody knows.
    QVERIFY(likeBoth(bare, any, 1.0).kind == Kind::Any);
    QVERIFY(likeBoth(any, bare, 1.0).kind == Kind::Any);
    QVERIFY(likeBoth(bare, bare, 1.0).kind == Kind::Bare);
    const UnitNumber speed = timesPower(way, time, -1);
    QVERIFY(speed.number == 1.25 && speed.powers == (UnitPowers{1, 0, -1}));
    const UnitNumber product = timesPower(way, time, 1);
    QVERIFY(product.number == 20.0 && product.powers == (UnitPowers{1, 0, 1}));
    QVERIFY(timesPower(way, way, -1).kind == Kind::Bare);
    QVERIFY(timesPower(way, any, 1).kind == Kind::Any && timesPower(any, way, 1).number == 15.0);
}

void TestUnits::askedUnitsHaveAFactor()
{
    const auto numberOf = [](const char *unit) {
        const auto asked = askedUnit(u(unit));
        return asked ? asked->number : 0.0;
    };
    QCOMPARE(numberOf("m/s"), 1.0);
    QCOMPARE(numberOf("· 1000 kg/m³"), 1000.0);
    QCOMPARE(numberOf(" 20 cm"), 0.2);
    QVERIFY(askedUnit(u("1000 kg/m³"))->powers == (UnitPowers{-3, 1, 0}));
    for (const char *none : {"", "%", "rad", "px", "m/m"})
        QVERIFY(!askedUnit(u(none)));
}

QTEST_MAIN(TestUnits)
#include "test_units.moc"

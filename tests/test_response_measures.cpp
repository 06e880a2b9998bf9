// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/judging/response_reading.h"
#include "tests/text.h"

#include <functional>

using namespace cradle;
using namespace cradle::programs;

/// What is measured of the answer to a hit is what the program does: masses, e.
class TestResponseMeasures : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void massesAreMeasured_data();
    void massesAreMeasured();
    void reboundIsMeasured_data();
    void reboundIsMeasured();
};

namespace {

using Law = std::function<double(double)>; ///< of e

const QString e = QStringLiteral("restitution");

} // namespace

void TestResponseMeasures::massesAreMeasured_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("density");
    const auto rows = [](const char *mass, double radius, double density) {
        for (std::size_t i = 0; i < std::size(hitWays); ++i)
            QTest::addRow("%s, %s, %s", mass, hitWays[i].name, structures[i].name)
                << written(withHit(hitOf(hitWays[i], {.mass = text(mass), .e = e})), structures[i])
                << radius << density;
    };
    rows("c.density * c.radius ^ 3", 3.0, 1.0);
    rows("1000 * c.density * 4 / 3 * math.pi * c.radius ^ 3", 3.0, 1.0);
    rows("c.density * math.pi * c.radius ^ 2", 2.0, 1.0);
    rows("c.density * c.radius", 1.0, 1.0);
    rows("c.radius ^ 3", 3.0, 0.0);
    rows("c.radius ^ 3 / c.density", 3.0, -1.0);
    rows("1 / (c.density * c.radius ^ 3)", -3.0, -1.0);
    rows("1", 0.0, 0.0);
}

void TestResponseMeasures::massesAreMeasured()
{
    QFETCH(QString, program);
    QFETCH(double, radius);
    QFETCH(double, density);
    const LawBench step(task(QStringLiteral("L42T16")));
    const MeasuredLaws own(&program, step.ground);
    const MassExponents p(own.pair());
    QVERIFY(p.radius && std::abs(*p.radius - radius) < 0.005);
    QVERIFY(p.density && std::abs(*p.density - density) < 0.005);
    QVERIFY(!fixedMassRatio(own.pair()));
}

void TestResponseMeasures::reboundIsMeasured_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<Law>("law");
    const auto rows = [](const char *factor, const Law &law) {
        for (std::size_t i = 0; i < std::size(hitWays); ++i)
            QTest::addRow("%s, %s", factor, hitWays[i].name)
                << written(withHit(hitOf(hitWays[i], {.e = text(factor)})), structures[3 - i])
                << law;
    };
    rows("restitution", [](double value) { return value; });
    rows("restitution ^ 2", [](double value) { return value * value; });
    rows("1 - restitution", [](double value) { return 1.0 - value; });
    rows("0.6", [](double) { return 0.6; });
}

void TestResponseMeasures::reboundIsMeasured()
{
    QFETCH(QString, program);
    QFETCH(Law, law);
    const LawBench step(task(QStringLiteral("L42T16")));
    const MeasuredLaws own(&program, step.ground);
    QVERIFY(own.pair().rebounds.size() >= 3);
    for (const PairHit &hit : own.pair().rebounds) {
        QVERIFY(hit.isMet() && hit.isAligned());
        const PairVelocities in = hit.cameParts();
        const PairVelocities out = hit.leftParts();
        const double rebound = (out.along2 - out.along1) / (in.along1 - in.along2);
        QVERIFY(std::abs(rebound - law(hit.meeting.restitution)) < 0.005);
        QVERIFY(std::abs(out.across1 - in.across1) < 0.005);
    }
}

QTEST_GUILESS_MAIN(TestResponseMeasures)
#include "test_response_measures.moc"

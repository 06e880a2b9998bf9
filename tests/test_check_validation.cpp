// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/check_validation.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

using namespace cradle;

/// What is said of checks that the catalogue does not know so.
class TestCheckValidation : public QObject
{
    Q_OBJECT
private slots:
    void soundCheckIsAccepted_data();
    void soundCheckIsAccepted();
    void faultIsNamed_data();
    void faultIsNamed();
    void remarksAreJudgedToo();
    void idsAreTheirOwn();
    void listsAreOfAHundredAtMost();
    void everyBoundHolds_data();
    void everyBoundHolds();
};

namespace {

/// The faults of a step with that one check and a scene of \p circles circles.
QStringList faultsOf(const QByteArray &check, std::size_t circles = 2)
{
    const QJsonDocument task = QJsonDocument::fromJson(R"({"checks": [)" + check + "]}");
    if (!task.isObject())
        return {QStringLiteral("not JSON")};
    QStringList lines;
    for (const Error &fault : findCheckFaults(task.object(), circles, QStringLiteral("task.json")))
        lines.append(fault.toString());
    return lines;
}

} // namespace

void TestCheckValidation::soundCheckIsAccepted_data()
{
    QTest::addColumn<QByteArray>("check");
    QTest::newRow("no parameters, no scene") << QByteArray(R"({"kind": "bounces"})");
    QTest::newRow("all of them") << QByteArray(
        R"({"kind": "collides", "circles": [1, 2], "parameters":
            {"laws": ["impulse"], "restitution": 0, "contacts": 0, "gravity": [0, -9.81],
             "tolerance": 1e-9}, "scene": {"kind": "encounters", "count": 200, "duration": 600,
             "timesteps": [1e-6, 0.1], "speeds": [0, 3], "radii": [0.01, 1], "offset": 0.95,
             "both_move": true, "densities": [0.001, 1000], "gravity": [0, 0],
             "restitutions": [0, 1], "seed": 0}})");
    QTest::newRow("a moment at the end")
        << QByteArray(R"({"kind": "ends_at", "parameters": {"time": 2, "positions": [[1, 2]]},
                          "scene": {"kind": "own", "duration": 2}})");
    QTest::newRow("one speed") << QByteArray(
        R"({"kind": "start", "scene": {"kind": "flight", "speeds": [2, 2]}})");
    QTest::newRow("how many circles")
        << QByteArray(R"({"kind": "start", "parameters": {"count": 2, "radius": 0.2}})");
}

void TestCheckValidation::soundCheckIsAccepted()
{
    QFETCH(QByteArray, check);
    QCOMPARE(faultsOf(check), QStringList());
}

void TestCheckValidation::faultIsNamed_data()
{
    QTest::addColumn<QByteArray>("check");
    QTest::addColumn<QByteArray>("fault");
    const auto row = [](const char *name, const QByteArray &check, const QByteArray &fault) {
        QTest::newRow(name) << check << "task.json: /checks/0/" + fault;
    };
    row("unknown kind", R"({"kind": "teleports"})",
        "kind: \"teleports\" is not right here; right would be one of start, integrates");
    // Of what is not right the first sixty letters are shown, and of a name the first 64.
    row("long, but no longer", R"({"kind": ")" + QByteArray(58, 'a') + R"("})",
        "kind: \"" + QByteArray(58, 'a') + "\" is not right here");
    row("longer", R"({"kind": ")" + QByteArray(59, 'a') + R"("})",
        "kind: \"" + QByteArray(59, 'a') + "… is not right here");
    row("long name", R"({"kind": "start", "parameters": {")" + QByteArray(70, 'a') + R"(": 1}})",
        "parameters/" + QByteArray(70, 'a') + ": start has no parameter \"" + QByteArray(64, 'a')
            + "\"; it has");
    row("text in a vector", R"({"kind": "start", "parameters": {"position": ["a", 1]}})",
        "parameters/position: [\"a\",1] is not right here");
    row("unknown parameter", R"({"kind": "start", "parameters": {"colour": 1}})",
        "parameters/colour: start has no parameter \"colour\"; it has position, velocity, radius");
    row("parameter of another kind", R"({"kind": "loses_energy", "parameters": {"laws": []}})",
        "parameters/laws: loses_energy has no parameter \"laws\"; it has gravity");
    row("key with a slash", R"({"kind": "start", "parameters": {"a/b~c": 1}})",
        "parameters/a~1b~0c: start has no parameter");
    row("missing", R"({"kind": "after_contact"})",
        "parameters: \"velocities\" is missing; right would be a list of lists [x, y], each a "
        "number in m/s");
    row("text for a number", R"({"kind": "bounces", "parameters": {"restitution": "1"}})",
        "parameters/restitution: \"1\" is not right here; right would be a number from 0 to 1");
    row("too small", R"({"kind": "bounces", "parameters": {"restitution": -0.1}})",
        "parameters/restitution: -0.1 is not right here");
    row("too large", R"({"kind": "bounces", "parameters": {"restitution": 1.5}})",
        "parameters/restitution: 1.5 is not right here");
    row("part of a number", R"({"kind": "collides", "parameters": {"contacts": 1.5}})",
        "parameters/contacts: 1.5 is not right here; right would be a whole number from 0 to 1000");
    row("number for a flag", R"({"kind": "conserves", "parameters": {"energy": 1}})",
        "parameters/energy: 1 is not right here; right would be true or false");
    row("unknown choice", R"({"kind": "integrates", "parameters": {"integrators": ["midpoint"]}})",
        "parameters/integrators: [\"midpoint\"] is not right here; right would be a list out of "
        "euler, symplectic_euler, verlet, rk4");
    row("no choice", R"({"kind": "integrates", "parameters": {"integrators": []}})",
        "parameters/integrators: [] is not right here");
    row("one choice without a list", R"({"kind": "collides", "parameters": {"laws": "impulse"}})",
        "parameters/laws: \"impulse\" is not right here");
    row("half a vector", R"({"kind": "start", "parameters": {"position": [1]}})",
        "parameters/position: [1] is not right here; right would be a list [x, y], each a number "
        "in m");
    row("half a vector in a list",
        R"({"kind": "ends_at", "parameters": {"positions": [[0, 1], [2]]}})",
        "parameters/positions: [[0,1],[2]] is not right here");
    row("range the wrong way round", R"({"kind": "start", "scene": {"kind": "flight",
        "speeds": [3, 1]}})",
        "scene/speeds: [3,1] is not right here; right would be a list [least, most], each a number "
        "in m/s from 0 to 20");
    row("list with a text", R"({"kind": "start", "scene": {"kind": "drop",
        "restitutions": [0.5, "e"]}})",
        "scene/restitutions: [0.5,\"e\"] is not right here");
    row("unknown scene", R"({"kind": "start", "scene": {"kind": "moon"}})",
        "scene/kind: \"moon\" is not right here; right would be one of own, flight");
    row("parameter of another scene", R"({"kind": "start", "scene": {"kind": "own", "count": 2}})",
        "scene/count: own has no parameter \"count\"; it has duration, timesteps");
    row("moment after the end", R"({"kind": "ends_at", "parameters": {"time": 3},
        "scene": {"kind": "own", "duration": 2}})",
        "parameters/time: the moment 3 s is after the end of the scene; at most its duration of 2 "
        "s is right");
    row("circle that there is not", R"({"kind": "start", "circles": [1, 3]})",
        "circles/1: there is no circle 3; the scene of the step has 2");
}

void TestCheckValidation::faultIsNamed()
{
    QFETCH(QByteArray, check);
    QFETCH(QByteArray, fault);
    const QStringList faults = faultsOf(check);
    QCOMPARE(faults.size(), 1);
    QVERIFY2(faults.first().startsWith(QString::fromUtf8(fault)), qPrintable(faults.first()));
}

void TestCheckValidation::remarksAreJudgedToo()
{
    const QJsonDocument task = QJsonDocument::fromJson(
        R"({"remarks": [{"circles": [2], "scene": {"kind": "encounters"}}]})");
    const auto faults = findCheckFaults(task.object(), 1, {});
    QCOMPARE(faults.size(), 2U);
    QCOMPARE(faults[0].pointer, QStringLiteral("/remarks/0/circles/0"));
    QCOMPARE(faults[1].pointer, QStringLiteral("/remarks/0/scene/kind"));
}

void TestCheckValidation::idsAreTheirOwn()
{
    const QJsonDocument task = QJsonDocument::fromJson(
        R"({"checks": [{"id": "a", "kind": "bounces"}, {"id": "b", "kind": "bounces"},
                       {"id": "a", "kind": "bounces"}]})");
    const auto faults = findCheckFaults(task.object(), 1, {});
    QCOMPARE(faults.size(), 1U);
    QCOMPARE(faults[0].pointer, QStringLiteral("/checks/2/id"));
}

void TestCheckValidation::listsAreOfAHundredAtMost()
{
    const auto faults = [](int count) {
        const QByteArray list = QByteArray("0.5, ").repeated(count - 1) + "1";
        return faultsOf(R"({"kind": "start", "scene": {"kind": "drop", "restitutions": [)" + list
                        + "]}}");
    };
    QCOMPARE(faults(100), QStringList());
    QCOMPARE(faults(101).size(), 1);
}

void TestCheckValidation::everyBoundHolds_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("parameter");
    for (const KindInfo &kind : checkKinds()) {
        for (const ParameterInfo &p : kind.parameters) {
            if (p.least && p.most)
                QTest::addRow("%s.%s", qPrintable(kind.name), qPrintable(p.name))
                    << kind.name << p.name;
        }
    }
}

/// Every number of the catalogue is refused just beyond its bounds and taken at them.
void TestCheckValidation::everyBoundHolds()
{
    QFETCH(QString, kind);
    QFETCH(QString, parameter);
    const auto kinds = checkKinds();
    const ParameterInfo &p = *findParameter(*findKind(kinds, kind), parameter);
    const auto accepted = [&](double number) {
        QJsonValue value = number;
        if (p.type == ParameterInfo::Type::Vector)
            value = QJsonArray{number, number};
        else if (p.type == ParameterInfo::Type::Vectors)
            value = QJsonArray{QJsonValue(QJsonArray{number, number})};
        QJsonObject parameters{{parameter, value}};
        if (kind == QLatin1String("after_contact") && parameter != QLatin1String("velocities"))
            parameters.insert(QStringLiteral("velocities"),
                              QJsonArray{QJsonValue(QJsonArray{0, 0})});
        const QJsonObject check{{QStringLiteral("kind"), kind},
                                {QStringLiteral("parameters"), parameters}};
        return findCheckFaults({{QStringLiteral("checks"), QJsonArray{check}}}, 2, {}).empty();
    };
    QVERIFY(accepted(*p.least));
    QVERIFY(accepted(*p.most));
    QVERIFY(!accepted(*p.least - 1.0));
    QVERIFY(!accepted(*p.most + 1.0));
}

QTEST_GUILESS_MAIN(TestCheckValidation)
#include "test_check_validation.moc"

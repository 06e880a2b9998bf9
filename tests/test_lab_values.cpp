// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab_with_values.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/grading/judging_request.h"
#include "tasks/lab_report/lab_report.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/values/values_of_file.h"

#include <QJsonArray>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace cradle;

/// Values that a lab names, in everything that is made of them.
class TestLabValues : public QObject
{
    Q_OBJECT
private slots:
    void valuesAreMadeOfOneAnother();
    void faultsAreNamedWithTheirPlace();
    void faultsOfALabAreToldOnce();
    void textsProgramsAndScenesHaveThem();
    void unitsOfASceneAreChecked();
    void labWithoutValuesIsAsItIs();
    void unknownNameIsAFaultOfItsFile();
    void editOfASceneKeepsItsExpressions();
    void filesOfALabHaveItsValues();
};

void TestLabValues::valuesAreMadeOfOneAnother()
{
    const LabFiles files = labWith(values({{QStringLiteral("a"), QStringLiteral("2*b")},
                                           {QStringLiteral("b"), QStringLiteral("c + 1")},
                                           {QStringLiteral("c"), 0.5}}));
    std::vector<Error> faults;
    const Values all = valuesOf(files, QStringLiteral("S1"), {}, &faults);
    QVERIFY(faults.empty());
    QCOMPARE(all.value(QStringLiteral("a")), 3.0);
}

void TestLabValues::faultsAreNamedWithTheirPlace()
{
    const LabFiles files = labWith(values({{QStringLiteral("a"), QStringLiteral("2*b")},
                                           {QStringLiteral("b"), QStringLiteral("2*a")},
                                           {QStringLiteral("pi"), 3.0}}));
    std::vector<Error> faults;
    (void)valuesOf(files, {}, {}, &faults);
    QCOMPARE(faults.size(), std::size_t(3));
    QSet<QString> places;
    for (const Error &fault : faults)
        places.insert(fault.pointer);
    QCOMPARE(places, (QSet<QString>{QStringLiteral("/values/a"), QStringLiteral("/values/b"),
                                    QStringLiteral("/values/pi")}));
}

/// Though every step has them, beside its own.
void TestLabValues::faultsOfALabAreToldOnce()
{
    LabFiles files = labWith(values({{QStringLiteral("pi"), 3.0}}));
    edit(files, "S1/task.json", [](QJsonObject &task) {
        task.insert(QStringLiteral("values"),
                    QJsonObject{{QStringLiteral("half"), QStringLiteral("nobody / 2")}});
    });
    std::vector<Error> faults;
    (void)withValues(files, {}, &faults);
    QStringList places;
    for (const Error &fault : faults)
        places.append(fault.file + fault.pointer);
    QCOMPARE(places, (QStringList{QStringLiteral("lab.json/values/pi"),
                                  QStringLiteral("S1/task.json/values/half")}));
}

void TestLabValues::textsProgramsAndScenesHaveThem()
{
    LabFiles files = labWith(values({{QStringLiteral("g"), 9.81}, {QStringLiteral("d"), 0.42}}),
                             "# Fall\n\nBy {{g}} m/s², twice {{2*g}}.\n");
    files.contents[QStringLiteral("S1/solution.lua")] += "\n-- {{g}} {{1, 2}} {{nobody}}\n";
    edit(files, "S1/task.json", [](QJsonObject &task) {
        task.insert(QStringLiteral("title"), QStringLiteral("Fall by {{g}}"));
        task.insert(QStringLiteral("values"),
                    QJsonObject{{QStringLiteral("half"), QStringLiteral("d/2")}});
        QJsonArray checks = task.value(QStringLiteral("checks")).toArray();
        QJsonObject check = checks[0].toObject();
        check.insert(QStringLiteral("title"), QStringLiteral("Half is {{half}}"));
        checks[0] = check;
        task.insert(QStringLiteral("checks"), checks);
        task.insert(QStringLiteral("questions"),
                    QJsonArray{QJsonObject{{QStringLiteral("id"), QStringLiteral("q")},
                                           {QStringLiteral("kind"), QStringLiteral("number")},
                                           {QStringLiteral("title"), QStringLiteral("Q")},
                                           {QStringLiteral("right"), QStringLiteral("2*g")}}});
    });
    edit(files, "S1/preset.json", [](QJsonObject &scene) {
        QJsonArray circles = scene.value(QStringLiteral("circles")).toArray();
        QJsonObject circle = circles[0].toObject();
        circle.insert(QStringLiteral("position"),
                      QJsonArray{QStringLiteral("1 + d*cos(pi/6)"), QStringLiteral("{{half}}")});
        circles[0] = circle;
        scene.insert(QStringLiteral("circles"), circles);
    });
    const auto lab = readLab(files, QStringLiteral("here"));
    QVERIFY(lab.ok());
    QVERIFY2(lab->findings.empty(),
             lab->findings.empty() ? "" : qPrintable(lab->findings[0].toString()));
    const Task &task = lab->tasks[0];
    QVERIFY(task.instructions.contains(QStringLiteral("By 9.81 m/s², twice 19.62.")));
    QCOMPARE(task.title, QStringLiteral("Fall by 9.81"));
    QCOMPARE(task.checks[0].title, QStringLiteral("Half is 0.21"));
    QCOMPARE(task.preset.circles[0].body.position.x, 1.0 + 0.42 * std::sqrt(0.75));
    QCOMPARE(task.preset.circles[0].body.position.y, 0.21);
    QVERIFY(task.solution.contains(QStringLiteral("-- 9.81 {{1, 2}} {{nobody}}")));
    QCOMPARE(task.questions[0].number, 19.62);
    QVERIFY(!lab->drawsValues);
}

/// Lengths in cm, a timestep as 1/60 s; and a time is no radius.
void TestLabValues::unitsOfASceneAreChecked()
{
    LabFiles files = labWith({}, "# Units\n");
    const auto put = [&](const QString &key, const QJsonValue &value) {
        edit(files, "S1/preset.json", [&](QJsonObject &scene) {
            QJsonArray circles = scene.value(QStringLiteral("circles")).toArray();
            QJsonObject circle = circles[0].toObject();
            circle.insert(key, value);
            circles[0] = circle;
            scene.insert(QStringLiteral("circles"), circles);
            scene.insert(QStringLiteral("timestep"), QStringLiteral("1/60 s"));
        });
    };
    put(QStringLiteral("velocity"), QJsonArray{QStringLiteral("36 km/h"), 0});
    put(QStringLiteral("radius"), QStringLiteral("35 cm"));
    put(QStringLiteral("density"), QStringLiteral("7800 kg/m³"));
    const auto lab = readLab(files, QStringLiteral("here"));
    QVERIFY2(lab->findings.empty(),
             lab->findings.empty() ? "" : qPrintable(lab->findings[0].toString()));
    const Preset &scene = lab->tasks[0].preset;
    QCOMPARE(scene.timestep, 1.0 / 60.0);
    QCOMPARE(scene.circles[0].body.velocity.x, 10.0);
    QCOMPARE(scene.circles[0].body.radius, 0.35);
    QCOMPARE(scene.circles[0].body.density, 7.8);
    put(QStringLiteral("radius"), QStringLiteral("2 s"));
    const auto wrong = readLab(files, QStringLiteral("here"));
    QVERIFY(!wrong->findings.empty());
    QCOMPARE(wrong->findings[0].pointer, QStringLiteral("/circles/0/radius"));
    QVERIFY(wrong->findings[0].message.contains(QStringLiteral("it is in s; m is right here")));
}

void TestLabValues::labWithoutValuesIsAsItIs()
{
    const LabFiles files = labWith({}, "# A {{brace}} $\\frac{{a}}{{b}}$\n");
    QCOMPARE(withValues(files, QStringLiteral("1")), files);
    const auto lab = readLab(files, QStringLiteral("here"));
    QVERIFY(lab->findings.empty());
}

void TestLabValues::unknownNameIsAFaultOfItsFile()
{
    LabFiles files = labWith(values({{QStringLiteral("g"), 9.81}}), "# By {{gg}}\n");
    const auto lab = readLab(files, QStringLiteral("here"));
    QCOMPARE(lab->findings.size(), std::size_t(1));
    QCOMPARE(lab->findings[0].file, QStringLiteral("here/S1/instructions.md"));
    QVERIFY(lab->findings[0].message.contains(QStringLiteral("no value called gg")));
    QCOMPARE(lab->tasks.size(), std::size_t(1)); // the rest is there
}

void TestLabValues::editOfASceneKeepsItsExpressions()
{
    LabFiles files = labWith(values({{QStringLiteral("d"), 0.5}}));
    edit(files, "S1/preset.json", [](QJsonObject &scene) {
        scene.insert(QStringLiteral("restitution"), QStringLiteral("d + 0.25"));
    });
    const auto scene = presetOf(files, QStringLiteral("S1"));
    QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
    QCOMPARE(scene->restitution, 0.75);
    Preset changed = *scene;
    changed.timestep = 0.01;
    const auto written = withPreset(files, QStringLiteral("S1"), changed);
    QVERIFY(written.ok());
    const QByteArray text = written->contents.value(QStringLiteral("S1/preset.json"));
    QVERIFY2(text.contains("d + 0.25"), text.constData());
    QCOMPARE(*presetOf(*written, QStringLiteral("S1")), changed);
}

void TestLabValues::filesOfALabHaveItsValues()
{
    const QTemporaryDir folder;
    LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    files.contents[QStringLiteral("S1/mistakes/stiff.lua")] = "local k = {{k}}\n";
    files.contents[QStringLiteral("S1/answers.json")] = R"({"why": "none"})";
    QVERIFY(!saveLabFiles(files, {}, folder.path()));
    const QString path = folder.filePath(QStringLiteral("S1/mistakes/stiff.lua"));
    QCOMPARE(*withValuesOfItsStep(path, "local k = {{k}}\n", {}), QByteArray("local k = 0.6\n"));
    const QByteArray own = QByteArray::number(k(files, QStringLiteral("4711")));
    QCOMPARE(*withValuesOfItsStep(path, "{{k}}", QStringLiteral("4711")), own);
    // A table in a table is Lua; and what lies elsewhere is nobody's.
    QCOMPARE(*withValuesOfItsStep(path, "{{1, 2}}", {}), QByteArray("{{1, 2}}"));
    const QTemporaryDir elsewhere;
    QCOMPARE(*withValuesOfItsStep(elsewhere.filePath(QStringLiteral("a.lua")), "{{k}}", {}),
             QByteArray("{{k}}"));
    // Nor is a drawing a text of the lab.
    QCOMPARE(*withValuesOfItsStep(folder.filePath(QStringLiteral("S1/spring.svg")),
                                  "<text>{{k}}</text>", {}),
             QByteArray("<text>{{k}}</text>"));
    // Other JSON in the folder is no scene.
    const auto lab = readLab(folder.path());
    for (const Error &finding : lab->findings)
        QVERIFY2(!finding.file.contains(QStringLiteral("answers")), qPrintable(finding.toString()));
}

QTEST_GUILESS_MAIN(TestLabValues)

#include "test_lab_values.moc"

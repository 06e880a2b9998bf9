// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_edits.h"
#include "tasks/grading/judging_request.h"
#include "tasks/lab_report/lab_report.h"
#include "tasks/proof/lab_verifier.h"
#include "tasks/questions/answers.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/values/put_values.h"
#include "tasks/values/value_ranges.h"
#include "tasks/values/values_of_file.h"
#include "tasks/workspace/workspace_info.h"

#include <QJsonArray>
#include <QJsonDocument>
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
    void textsProgramsAndScenesHaveThem();
    void unitsOfASceneAreChecked();
    void labWithoutValuesIsAsItIs();
    void unknownNameIsAFaultOfItsFile();
    void editOfASceneKeepsItsExpressions();
    void drawnValueLiesOnItsGridAndStays();
    void everybodyWhoJudgesDrawsTheSame();
    void numberDrawsTheSameHoweverWritten();
    void rosterDecidesWhoseValuesAreDrawn();
    void verifyTriesTenStudents();
    void everyValueOfARangeIsTried();
    void whatIsNoNumberForSomeIsFound();
    void filesOfALabHaveItsValues();
};

namespace {

/// The template's lab with members of lab.json and a text of its step.
LabFiles labWith(const QJsonObject &members, const QByteArray &text = {})
{
    LabFiles files =
        newLab(QStringLiteral("valued"), QStringLiteral("Valued"), QStringLiteral("en"));
    QJsonObject json = QJsonDocument::fromJson(files.contents[QStringLiteral("lab.json")]).object();
    for (auto it = members.begin(); it != members.end(); ++it)
        json.insert(it.key(), it.value());
    files.contents[QStringLiteral("lab.json")] = QJsonDocument(json).toJson();
    if (!text.isEmpty())
        files.contents[QStringLiteral("S1/instructions.md")] = text;
    return files;
}

QJsonObject values(const QJsonObject &all)
{
    return {{QStringLiteral("values"), all}};
}

const QJsonObject range{
    {QStringLiteral("from"), 0.6}, {QStringLiteral("to"), 0.9}, {QStringLiteral("step"), 0.05}};

void edit(LabFiles &files, const char *path, const std::function<void(QJsonObject &)> &change)
{
    QByteArray &bytes = files.contents[QLatin1String(path)];
    QJsonObject json = QJsonDocument::fromJson(bytes).object();
    change(json);
    bytes = QJsonDocument(json).toJson();
}

double k(const LabFiles &files, const QString &student)
{
    return valuesOf(files, {}, student).value(QStringLiteral("k"));
}

} // namespace

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

void TestLabValues::drawnValueLiesOnItsGridAndStays()
{
    const LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    QVERIFY(drawsValues(files));
    QSet<QString> drawn;
    for (int i = 0; i < 200; ++i) {
        const double value = k(files, QString::number(i));
        const double steps = (value - 0.6) / 0.05;
        QVERIFY(value >= 0.6 && value <= 0.9);
        QVERIFY(std::abs(steps - std::round(steps)) < 1e-9);
        drawn.insert(QString::number(value));
        QCOMPARE(k(files, QString::number(i)), value);
    }
    QCOMPARE(drawn.size(), 7); // 0.6, 0.65 … 0.9, written so
    QVERIFY(drawn.contains(QStringLiteral("0.75")));
    QCOMPARE(k(files, {}), 0.6);
    LabFiles other = files;
    edit(other, "lab.json",
         [](QJsonObject &lab) { lab.insert(QStringLiteral("draw"), QStringLiteral("next year")); });
    int different = 0;
    for (int i = 0; i < 50; ++i)
        different += k(files, QString::number(i)) != k(other, QString::number(i)) ? 1 : 0;
    QVERIFY(different > 25);
}

void TestLabValues::everybodyWhoJudgesDrawsTheSame()
{
    LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    edit(files, "S1/task.json", [](QJsonObject &task) {
        task.insert(QStringLiteral("questions"),
                    QJsonArray{QJsonObject{{QStringLiteral("id"), QStringLiteral("k")},
                                           {QStringLiteral("kind"), QStringLiteral("number")},
                                           {QStringLiteral("title"), QStringLiteral("k")},
                                           {QStringLiteral("right"), QStringLiteral("100*k")}}});
    });
    const Lab lab = *readLab(files, QStringLiteral("here"));
    QVERIFY(lab.drawsValues);
    QString number = QStringLiteral("1");
    for (int i = 2; k(files, number) == 0.6; ++i)
        number = QString::number(i);
    const QString answer = QString::number(100.0 * k(files, number));
    const Lab own = forStudent(lab, number);
    QCOMPARE(own.hash, lab.hash);
    QCOMPARE(own.tasks[0].questions[0].number, 100.0 * k(files, number));
    WorkspaceInfo info;
    info.studentId = number;
    WorkFiles work{{QStringLiteral("cradle.json"), textOf(info)},
                   {QStringLiteral("steps/S1.lua"), own.tasks[0].solution.toUtf8()},
                   {QStringLiteral("answers.json"),
                    answersText({{QStringLiteral("S1"), {{QStringLiteral("k"), answer}}}})}};
    StepResult result;
    JudgingRequest request{.seed = 1, .steps = {own.tasks[0].id}, .files = work};
    judgeWork(
        lab, request, [] {}, [&](const StepResult &step) { result = step; });
    QCOMPARE(result.status, StepResult::Status::Passed);
    const LabReport told = makeLabReport(lab, workFrom(work, lab), 1, {});
    QCOMPARE(told.steps[0].verdict, StepVerdict::Passed);
    work.remove(QStringLiteral("cradle.json")); // nobody's: k is 0.6
    request.files = work;
    judgeWork(
        lab, request, [] {}, [&](const StepResult &step) { result = step; });
    QCOMPARE(result.status, StepResult::Status::Failed);
}

void TestLabValues::numberDrawsTheSameHoweverWritten()
{
    const LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    for (int i = 1; i < 50; ++i) {
        const QString number = QStringLiteral("a%1b").arg(i);
        for (const QString &written :
             {QStringLiteral(" A%1 B "), QStringLiteral("00a%1-b"), QStringLiteral("a.%1/B")})
            QCOMPARE(k(files, written.arg(i)), k(files, number));
    }
}

/// Whoever hands in the work of a neighbour, number and all, has the values of the own number.
void TestLabValues::rosterDecidesWhoseValuesAreDrawn()
{
    LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    edit(files, "S1/task.json", [](QJsonObject &task) {
        task.insert(QStringLiteral("questions"),
                    QJsonArray{QJsonObject{{QStringLiteral("id"), QStringLiteral("k")},
                                           {QStringLiteral("kind"), QStringLiteral("number")},
                                           {QStringLiteral("title"), QStringLiteral("k")},
                                           {QStringLiteral("right"), QStringLiteral("100*k")}}});
    });
    const Lab lab = *readLab(files, QStringLiteral("here"));
    const QString neighbours = QStringLiteral("1");
    int other = 2;
    while (k(files, QString::number(other)) == k(files, neighbours))
        ++other;
    const QString own = QString::number(other);
    WorkspaceInfo info;
    info.studentId = neighbours;
    const QString answer = QString::number(100.0 * k(files, neighbours));
    const auto judged = [&](const QStringList &numbers) {
        const WorkFiles work{
            {QStringLiteral("cradle.json"), textOf(info)},
            {QStringLiteral("steps/S1.lua"),
             forStudent(lab, neighbours).tasks[0].solution.toUtf8()},
            {QStringLiteral("answers.json"),
             answersText({{QStringLiteral("S1"), {{QStringLiteral("k"), answer}}}})}};
        StepResult result;
        judgeWork(
            lab, {.seed = 1, .steps = {lab.tasks[0].id}, .files = work, .numbers = numbers}, [] {},
            [&](const StepResult &step) { result = step; });
        return result;
    };
    StepResult result = judged({own, QStringLiteral("ada")});
    QCOMPARE(result.status, StepResult::Status::Failed);
    QCOMPARE(result.drawnBy, own);
    QCOMPARE(result.ownNumber, neighbours);
    QVERIFY(result.hasForeignNumber());
    for (const QStringList &numbers :
         {QStringList(), QStringList{QStringLiteral("0001")}, QStringList{own, neighbours}}) {
        result = judged(numbers);
        QCOMPARE(result.status, StepResult::Status::Passed);
        QCOMPARE(result.drawnBy, neighbours);
        QVERIFY(!result.hasForeignNumber());
    }
    info.studentId.clear(); // as a lone program has none
    QCOMPARE(judged({neighbours}).status, StepResult::Status::Passed);
}

void TestLabValues::verifyTriesTenStudents()
{
    // With k = 0.6, which nobody's number draws, all is well; the starter moves with others.
    LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    files.contents[QStringLiteral("S1/solution.lua")] +=
        "\nif {{k}} > 0.7 then error('too stiff') end\n";
    const auto lab = readLab(files, QStringLiteral("here"));
    QVERIFY(lab.ok());
    int last = 0;
    int all = 0;
    // One bar, which does not begin anew for every student.
    const JudgeHooks hooks{.progress = [&](int done, int total) {
        QVERIFY(done >= last && done <= total);
        QVERIFY(all == 0 || all == total);
        last = done;
        all = total;
    }};
    const auto verified = verifyLab(*lab, {}, hooks);
    QCOMPARE(last, all);
    QVERIFY(!verified[0].findings.empty());
    bool told = false;
    for (const LabFinding &finding : verified[0].findings)
        told = told || finding.message.startsWith(QStringLiteral("with the values of the student"));
    QVERIFY(told);
}

void TestLabValues::everyValueOfARangeIsTried()
{
    // 0.6, 0.65 … 0.9 are seven; students 1 to 10 draw only some of them.
    const LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    QStringList ten;
    for (int i = 1; i <= 10; ++i)
        ten.append(QString::number(i));
    QCOMPARE(triedRanges(files, ten)[0].count, 7);
    const QStringList tried = studentsToTry(files, 10, 24);
    QVERIFY(tried.size() >= 10);
    QCOMPARE(triedRanges(files, tried),
             (std::vector<TriedRange>{{QString(), QStringLiteral("k"), 7, 7, 0.6, 0.9}}));
    // The ends come first where there is no room for all.
    const std::vector<TriedRange> few = triedRanges(files, studentsToTry(files, 1, 1));
    QCOMPARE(few[0].least, 0.6);
    QCOMPARE(few[0].most, 0.9);
    QVERIFY(studentsToTry(labWith(values({{QStringLiteral("k"), 2}})), 10, 24).isEmpty());
    // The reference fails for the largest alone.
    LabFiles last = files;
    last.contents[QStringLiteral("S1/solution.lua")] +=
        "\nif {{k}} > 0.88 then error('stiff') end\n";
    const auto verified = verifyLab(*readLab(last, QStringLiteral("here")));
    QVERIFY(
        std::any_of(verified[0].findings.begin(), verified[0].findings.end(),
                    [](const LabFinding &f) { return f.program == QLatin1String("solution"); }));
}

void TestLabValues::whatIsNoNumberForSomeIsFound()
{
    const LabFiles files = labWith(
        values({{QStringLiteral("k"), range}, {QStringLiteral("a"), QStringLiteral("1/(k-0.75)")}}),
        "a is {{a}}");
    const auto lab = readLab(files, QStringLiteral("here"));
    QVERIFY(lab && lab->findings.empty()); // of the first, 0.6
    const auto verified = verifyLab(*lab);
    const auto found =
        std::find_if(verified[0].findings.begin(), verified[0].findings.end(),
                     [](const LabFinding &f) { return f.kind == LabFinding::Kind::ValueFails; });
    QVERIFY(found != verified[0].findings.end());
    QVERIFY2(found->message.contains(QStringLiteral("no finite number")),
             qPrintable(found->message));
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
    // Other JSON in the folder is no scene.
    const auto lab = readLab(folder.path());
    for (const Error &finding : lab->findings)
        QVERIFY2(!finding.file.contains(QStringLiteral("answers")), qPrintable(finding.toString()));
}

QTEST_GUILESS_MAIN(TestLabValues)

#include "test_lab_values.moc"

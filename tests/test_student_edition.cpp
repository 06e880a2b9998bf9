// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/student_edition.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/judging/asked_laws.h"
#include "tasks/judging/judgement.h"
#include "tasks/reading/lab_reader.h"
#include "tests/sanitized.h"
#include "tests/test_paths.h"

#include <QJsonArray>
#include <QTest>

using namespace cradle;

/// The edition of a lab for students: what is left out of it, and that it judges as before.
class TestStudentEdition : public QObject
{
    Q_OBJECT
private slots:
    void solutionsAndMistakesAreLeftOut_data();
    void solutionsAndMistakesAreLeftOut();
    void filesThatNoStepUsesAreLeftOut();
    void editionBelongsToTheWholeLab();
    void editionJudgesAsTheWholeLab_data();
    void editionJudgesAsTheWholeLab();
    void onlyWhatChecksSayIsRight_data();
    void onlyWhatChecksSayIsRight();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

LabFiles filesOf(const char *folder)
{
    return *readLabFiles(sourcePath(folder));
}

QStringList codeLines(const QString &program)
{
    QStringList lines;
    for (const QString &line : program.split(QLatin1Char('\n'))) {
        // A short line like "end" is nobody's secret.
        if (const QString code = line.trimmed(); code.size() > 30)
            lines.append(code);
    }
    return lines;
}

CheckReport judged(const Lab &lab, const Task &task, const QString &program)
{
    return *judgeTask(lab, task, Submission(task.preset, program), 1);
}

} // namespace

void TestStudentEdition::solutionsAndMistakesAreLeftOut_data()
{
    QTest::addColumn<QString>("folder");
    QTest::newRow("bouncing ball") << QStringLiteral("tasks/labs/bouncing-ball");
    QTest::newRow("Lab 4.2") << QStringLiteral("tasks/labs/lab-4.2");
}

void TestStudentEdition::solutionsAndMistakesAreLeftOut()
{
    QFETCH(QString, folder);
    const LabFiles whole = filesOf(qPrintable(folder));
    const Result<StudentEdition> edition = studentEdition(whole);
    QVERIFY2(edition, edition ? "" : qPrintable(edition.error().toString()));
    QCOMPARE(edition->left,
             static_cast<int>(whole.contents.size() - edition->files.contents.size()));
    QByteArray all;
    for (auto it = edition->files.contents.begin(); it != edition->files.contents.end(); ++it) {
        QVERIFY2(!it.key().contains(QLatin1String("solution"))
                     && !it.key().contains(QLatin1String("mistakes/"))
                     && !it.key().contains(QLatin1String("remarks/")),
                 qPrintable(it.key()));
        all += *it;
    }
    const QString text = QString::fromUtf8(all);
    for (auto it = whole.contents.begin(); it != whole.contents.end(); ++it) {
        if (!it.key().contains(QLatin1String("mistakes/")))
            continue;
        for (const QByteArray &line : it->split('\n')) {
            // What the student reads of a mistake stands in front of its difference.
            if (line.size() > 50 && line.front() >= 'A' && line.front() <= 'z')
                QVERIFY2(!all.contains(line), line.constData());
        }
    }
    const Result<Lab> lab = readLab(whole, {});
    const Result<Lab> part = readLab(edition->files, {});
    QCOMPARE(part->tasks.size(), lab->tasks.size());
    QString shown; // what starters have, or texts quote, is there for students
    for (const Task &task : part->tasks)
        shown += task.starter + task.instructions + task.hints.join(QLatin1Char('\n'))
                 + task.codeHints.join(QLatin1Char('\n'));
    int lines = 0;
    for (const Task &task : lab->tasks) {
        for (const QString &line : codeLines(task.solution)) {
            if (shown.contains(line) || line.startsWith(QLatin1String("--")))
                continue;
            QVERIFY2(!text.contains(line), qPrintable(line));
            ++lines;
        }
    }
    QVERIFY2(lines > 5, "hardly anything was looked at");
}

void TestStudentEdition::filesThatNoStepUsesAreLeftOut()
{
    LabFiles whole = filesOf("tasks/labs/bouncing-ball");
    whole.contents[utf8("notes.md")] = "the e is 0.89";
    whole.contents[utf8("BALL2/exam.txt")] = "the e is 0.89";
    whole.contents[utf8("BALL2/checks/old.lua")] = "-- the e is 0.89";
    whole.contents[utf8("LICENSE")] = "CC BY";
    const Result<StudentEdition> edition = studentEdition(whole);
    QVERIFY(edition);
    const auto has = [&](const char *path) { return edition->files.contents.contains(utf8(path)); };
    QVERIFY(!has("notes.md") && !has("BALL2/exam.txt") && !has("BALL2/checks/old.lua"));
    QVERIFY(has("LICENSE") && has("BALL2/floor.svg") && has("BALL3/checks/half-height.lua"));
    QVERIFY(has("BALL1/starter.lua") && has("BALL2/instructions.de.md"));
    QVERIFY(!edition->files.contents[utf8("BALL2/task.json")].contains("\"remarks\""));
}

void TestStudentEdition::editionBelongsToTheWholeLab()
{
    const LabFiles whole = filesOf("tasks/labs/bouncing-ball");
    const Result<StudentEdition> edition = studentEdition(whole);
    const Result<Lab> lab = readLab(edition->files, {});
    QVERIFY(lab->findings.empty());
    QVERIFY(lab->forStudents);
    QCOMPARE(lab->hash, readLab(whole, {})->hash);
    QCOMPARE(studentEdition(edition->files)->files, edition->files);
    // A step without a starter begins with what students have, not with the solution.
    QCOMPARE(lab->tasks[1].starter, lab->tasks[0].starter);
}

void TestStudentEdition::editionJudgesAsTheWholeLab_data()
{
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QString>("step");
    int count = 0;
    for (const char *folder : {"tasks/labs/bouncing-ball", "tasks/labs/lab-4.2"}) {
        const Result<Lab> lab = readLab(filesOf(folder), {});
        for (const Task &task : lab->tasks) {
            if (++count % oneOf(4) != 0)
                continue;
            QTest::newRow(qPrintable(task.id)) << utf8(folder) << task.id;
        }
    }
}

/// The same verdicts; and of what goes wrong it says nothing that the whole lab does not say.
void TestStudentEdition::editionJudgesAsTheWholeLab()
{
    QFETCH(QString, folder);
    QFETCH(QString, step);
    const LabFiles files = filesOf(qPrintable(folder));
    const Result<Lab> whole = readLab(files, {});
    const Result<Lab> part = readLab(studentEdition(files)->files, {});
    const Task &asked = whole->tasks[static_cast<std::size_t>(whole->indexOf(step))];
    const Task &task = part->tasks[static_cast<std::size_t>(part->indexOf(step))];
    QVERIFY2(judged(*part, task, asked.solution).passed, qPrintable(step));
    int explained = 0;
    for (const KnownScript &mistake : asked.mistakes) {
        const CheckReport right = judged(*whole, asked, mistake.source);
        const CheckReport told = judged(*part, task, mistake.source);
        QVERIFY2(!told.passed, qPrintable(mistake.name));
        QCOMPARE(told.checks, right.checks);
        explained += told.findings.empty() ? 0 : 1;
        for (const Finding &finding : told.findings) {
            const bool isSo =
                std::any_of(right.findings.begin(), right.findings.end(),
                            [&](const Finding &f) { return f.aspect == finding.aspect; });
            QVERIFY2(isSo, qPrintable(mistake.name + QStringLiteral(": ") + finding.message));
        }
    }
    const AskedLaws laws = askedLaws(task);
    qInfo("%s: %d of %d explained; motion %d, walls %d, pair %d", qPrintable(step), explained,
          static_cast<int>(asked.mistakes.size()), laws.motion, laws.walls, laws.pair);
    if (laws.motion)
        QVERIFY(explained > 0);
}

void TestStudentEdition::onlyWhatChecksSayIsRight_data()
{
    QTest::addColumn<QByteArray>("checks");
    QTest::addColumn<bool>("motion");
    QTest::addColumn<bool>("pair");
    const QByteArray flight = R"({"id": "a", "kind": "integrates", "title": "A",
        "parameters": {"gravity": [0, -9.81]}, "scene": {"kind": "own"}})";
    QTest::newRow("gravity is named") << flight << true << false;
    QTest::newRow("gravity is the student's")
        << QByteArray(R"({"id": "a", "kind": "integrates", "title": "A"})") << false << false;
    QTest::newRow("gravity is named for another scene")
        << QByteArray(R"({"id": "a", "kind": "integrates", "title": "A",
              "parameters": {"gravity": [0, -1.62]},
              "scene": {"kind": "flight", "gravity": [0, -1.62]}})")
        << false << false;
    QTest::newRow("a check in Lua may ask for any force")
        << flight + R"(, {"id": "b", "kind": "script", "title": "B",
              "parameters": {"script": "b.lua"}})"
        << false << false;
    QTest::newRow("a circle of which nothing is told")
        << flight + R"(, {"id": "b", "kind": "collides", "title": "B", "circles": [1, 2]})" << false
        << false;
    const QByteArray both =
        QByteArray(flight).replace("\"title\"", "\"circles\": [1, 2], \"title\"");
    QTest::newRow("one law of hits")
        << both + R"(, {"id": "b", "kind": "collides", "title": "B", "circles": [1, 2]})" << true
        << true;
    QTest::newRow("any of two laws")
        << both + R"(, {"id": "b", "kind": "collides", "title": "B", "circles": [1, 2],
              "parameters": {"laws": ["stop", "impulse"]}})"
        << true << false;
}

void TestStudentEdition::onlyWhatChecksSayIsRight()
{
    QFETCH(QByteArray, checks);
    QFETCH(bool, motion);
    QFETCH(bool, pair);
    LabFiles files = newLab(utf8("l"), utf8("L"), utf8("en"));
    files.contents[utf8("S1/checks/b.lua")] = "function check(run) return true end";
    QByteArray &task = files.contents[utf8("S1/task.json")];
    const auto from = task.indexOf("\"checks\": [");
    QVERIFY(from > 0);
    task = task.left(from) + "\"checks\": [" + checks + "]}";
    const Result<StudentEdition> edition = studentEdition(files);
    QVERIFY2(edition, edition ? "" : qPrintable(edition.error().toString()));
    const Result<Lab> lab = readLab(edition->files, {});
    QCOMPARE(lab->tasks.size(), std::size_t(1));
    const AskedLaws laws = askedLaws(lab->tasks.front());
    QCOMPARE(laws.motion, motion);
    QCOMPARE(laws.pair, pair);
    QCOMPARE(edition->unexplained.isEmpty(), motion);
}

QTEST_GUILESS_MAIN(TestStudentEdition)
#include "test_student_edition.moc"

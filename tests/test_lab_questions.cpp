// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed_question.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/questions_form.h"
#include "tasks/authoring/task_form.h"
#include "tasks/grading/judging_request.h"
#include "tasks/grading/points.h"
#include "tasks/proof/lab_verifier.h"
#include "tasks/questions/answers.h"
#include "tasks/questions/question_json.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/report/report_formats.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include <numbers>

using namespace cradle;

/// Questions that count are part of a lab: read, graded, proven and translated with it.
class TestLabQuestions : public QObject
{
    Q_OBJECT
private slots:
    void faultsAreNamedWithTheirPlace_data();
    void faultsAreNamedWithTheirPlace();
    void countInPointsAndInTheVerdict();
    void everyFormatTellsThem_data();
    void everyFormatTellsThem();
    void handedInAnswersAreGraded();
    void verifyAnswersRightly();
    void textsFollowTheirQuestionInAllLanguages();
    void noTextsOfAQuestionThatIsGone();
};

namespace {

QJsonArray manyQuestions()
{
    return {QJsonObject{{QStringLiteral("id"), QStringLiteral("speed")},
                        {QStringLiteral("kind"), QStringLiteral("number")},
                        {QStringLiteral("title"), QStringLiteral("Speed at the floor")},
                        {QStringLiteral("text"), QStringLiteral("How fast is it?")},
                        {QStringLiteral("right"), QStringLiteral("2*10")},
                        {QStringLiteral("unit"), QStringLiteral("m/s")},
                        {QStringLiteral("tolerance"), 0.1},
                        {QStringLiteral("points"), 2}},
            QJsonObject{{QStringLiteral("id"), QStringLiteral("kept")},
                        {QStringLiteral("kind"), QStringLiteral("several")},
                        {QStringLiteral("title"), QStringLiteral("What is kept")},
                        {QStringLiteral("answers"),
                         QJsonArray{QStringLiteral("momentum"), QStringLiteral("speed"),
                                    QStringLiteral("energy")}},
                        {QStringLiteral("right"), QJsonArray{1, 3}}},
            QJsonObject{{QStringLiteral("id"), QStringLiteral("why")},
                        {QStringLiteral("kind"), QStringLiteral("text")},
                        {QStringLiteral("title"), QStringLiteral("Why")},
                        {QStringLiteral("points"), 3}}};
}

/// The lab of the template, with questions.
LabFiles labWith(const QJsonArray &questions)
{
    LabFiles files = newLab(QStringLiteral("asks"), QStringLiteral("Asks"), QStringLiteral("en"));
    const QString path = stepsOf(files).value(0) + QStringLiteral("/task.json");
    QJsonObject task = QJsonDocument::fromJson(files.contents[path]).object();
    task.insert(QStringLiteral("questions"), questions);
    files.contents[path] = QJsonDocument(task).toJson();
    return files;
}

Lab readOf(const LabFiles &files)
{
    const auto lab = readLab(files, QStringLiteral("asks"));
    return lab ? *lab : Lab{};
}

const CheckOutcome *outcomeOf(const CheckReport &report, const QString &id)
{
    for (const CheckOutcome &each : report.checks) {
        if (each.id == id)
            return &each;
    }
    return nullptr;
}

CheckReport judgedWith(const Lab &lab, const Answers &answers)
{
    Submission work(lab.tasks[0].preset, lab.tasks[0].solution);
    work.answers = answers;
    return *judgeTask(lab, lab.tasks[0], work, 1);
}

const Answers allRight{{QStringLiteral("speed"), QStringLiteral("72 km/h")},
                       {QStringLiteral("kept"), QJsonArray{3, 1}},
                       {QStringLiteral("why"), QStringLiteral("It falls.")}};

} // namespace

void TestLabQuestions::faultsAreNamedWithTheirPlace_data()
{
    QTest::addColumn<QJsonObject>("question");
    QTest::addColumn<QString>("said");
    const QJsonObject base{{QStringLiteral("id"), QStringLiteral("q")},
                           {QStringLiteral("kind"), QStringLiteral("one")},
                           {QStringLiteral("title"), QStringLiteral("Q")}};
    auto with = [&](const QJsonObject &more) {
        QJsonObject json = base;
        for (auto it = more.begin(); it != more.end(); ++it)
            json.insert(it.key(), it.value());
        return json;
    };
    const QJsonArray two{QStringLiteral("a"), QStringLiteral("b")};
    QTest::newRow("no answers") << with({{QStringLiteral("right"), 1}})
                                << QStringLiteral("two to eight answers");
    QTest::newRow("no right one") << with({{QStringLiteral("answers"), two}})
                                  << QStringLiteral("are missing");
    QTest::newRow("none there is")
        << with({{QStringLiteral("answers"), two}, {QStringLiteral("right"), 3}})
        << QStringLiteral("from 1 to 2");
    QTest::newRow("two right ones")
        << with({{QStringLiteral("answers"), two}, {QStringLiteral("right"), QJsonArray{1, 2}}})
        << QStringLiteral("the kind is several");
    QTest::newRow("no number") << with({{QStringLiteral("kind"), QStringLiteral("number")}})
                               << QStringLiteral("the right number is missing");
    QTest::newRow("no expression") << with({{QStringLiteral("kind"), QStringLiteral("number")},
                                            {QStringLiteral("right"), QStringLiteral("2*")}})
                                   << QStringLiteral("something is missing at its end");
    QTest::newRow("no unit") << with({{QStringLiteral("kind"), QStringLiteral("number")},
                                      {QStringLiteral("right"), 1},
                                      {QStringLiteral("unit"), QStringLiteral("furlong")}})
                             << QStringLiteral("furlong is no unit");
    QTest::newRow("id of a check") << with({{QStringLiteral("id"), QStringLiteral("falls")},
                                            {QStringLiteral("kind"), QStringLiteral("text")}})
                                   << QStringLiteral("has the id falls");
}

void TestLabQuestions::faultsAreNamedWithTheirPlace()
{
    QFETCH(QJsonObject, question);
    QFETCH(QString, said);
    const QJsonObject task{
        {QStringLiteral("checks"),
         QJsonArray{QJsonObject{{QStringLiteral("id"), QStringLiteral("falls")}}}},
        {QStringLiteral("questions"), QJsonArray{question}}};
    const auto faults = questionFaults(task);
    QCOMPARE(faults.size(), std::size_t(1));
    QVERIFY(faults.front().pointer.startsWith(QStringLiteral("/questions/0")));
    QVERIFY2(faults.front().message.contains(said), qPrintable(faults.front().message));
}

void TestLabQuestions::countInPointsAndInTheVerdict()
{
    const Lab lab = readOf(labWith(manyQuestions()));
    QVERIFY2(lab.findings.empty(), lab.findings.empty() ? "" : qPrintable(lab.findings[0].message));
    const Task &task = lab.tasks[0];
    // The checks of the template, and 2 + 1; the text's 3 are the teacher's.
    const double checks = mostPoints(readOf(labWith({})).tasks[0]);
    QCOMPARE(mostPoints(task), checks + 3.0);
    const CheckReport right = judgedWith(lab, allRight);
    QVERIFY(right.passed);
    const CheckReport half = judgedWith(lab, {{QStringLiteral("speed"), QStringLiteral("20")},
                                              {QStringLiteral("kept"), QJsonArray{1, 3}}});
    QVERIFY(!half.passed);
    QVERIFY(half.findings.empty()); // nothing is wrong with the program
    const StepResult result{
        .taskId = task.id, .status = StepResult::Status::Failed, .report = half};
    QCOMPARE(*pointsOf(result, task).earned, checks + 1.0);
}

void TestLabQuestions::everyFormatTellsThem_data()
{
    QTest::addColumn<QString>("format");
    for (const QString &name : reportFormatNames())
        QTest::newRow(qPrintable(name)) << name;
}

void TestLabQuestions::everyFormatTellsThem()
{
    QFETCH(QString, format);
    const Lab lab = readOf(labWith(manyQuestions()));
    Answers answers = allRight;
    answers.insert(QStringLiteral("speed"), QStringLiteral("20 m"));
    const CheckReport report = judgedWith(lab, answers);
    const QString text = QString::fromUtf8(writeReport(report, *reportFormatFromName(format),
                                                       QStringLiteral("lab.lua"), &lab.tasks[0]));
    QString words = text;
    words.replace(QLatin1Char('\n'), QLatin1Char(' ')).replace(QLatin1Char('#'), QLatin1Char(' '));
    words = words.simplified();
    QVERIFY2(words.contains(QStringLiteral("Speed at the floor")), qPrintable(text));
    QVERIFY2(words.contains(QStringLiteral("the number is right, but not its unit")),
             qPrintable(text));
    if (format != QStringLiteral("exercism")) // it has no place for what passes
        QVERIFY2(words.contains(QStringLiteral("It falls.")), qPrintable(text));
}

void TestLabQuestions::handedInAnswersAreGraded()
{
    const Lab lab = readOf(labWith(manyQuestions()));
    const QString id = lab.tasks[0].id;
    JudgingRequest request{.seed = 1, .steps = {id}};
    request.files = {
        {QStringLiteral("steps/") + id + QStringLiteral(".lua"), lab.tasks[0].solution.toUtf8()},
        {QStringLiteral("answers.json"), answersText({{id, allRight}})}};
    StepResult result;
    judgeWork(
        lab, request, [] {}, [&](const StepResult &step) { result = step; });
    QCOMPARE(result.status, StepResult::Status::Passed);
    request.files[QStringLiteral("answers.json")] = "[nonsense";
    judgeWork(
        lab, request, [] {}, [&](const StepResult &step) { result = step; });
    QCOMPARE(result.status, StepResult::Status::Failed);
    QCOMPARE(outcomeOf(*result.report, QStringLiteral("speed"))->message,
             QString(QStringLiteral("not answered yet")));
}

void TestLabQuestions::verifyAnswersRightly()
{
    const auto verified = verifyLab(readOf(labWith(manyQuestions())));
    QVERIFY(verified[0].findings.empty());
}

void TestLabQuestions::textsFollowTheirQuestionInAllLanguages()
{
    LabFiles files = labWith(manyQuestions());
    const QString step = stepsOf(files).value(0);
    TaskForm german = *taskForm(files, step, QStringLiteral("de"));
    german.questions[1].title = QStringLiteral("Was bleibt");
    german.questions[1].answers = {QStringLiteral("Impuls"), QStringLiteral("Tempo"),
                                   QStringLiteral("Energie")};
    files = *withTask(files, step, german, QStringLiteral("de"));
    QCOMPARE(taskForm(files, step)->questions[1].title, QString(QStringLiteral("What is kept")));
    TaskForm english = *taskForm(files, step);
    english.questions[1].id = QStringLiteral("constant");
    files = *withTask(files, step, english);
    english.questions[1].answers.insert(1, QStringLiteral("mass"));
    english.questions[1].chosen = {0, 1, 3};
    files = *withTask(files, step, english);
    german = *taskForm(files, step, QStringLiteral("de"));
    QCOMPARE(german.questions[1].title, QString(QStringLiteral("Was bleibt")));
    QCOMPARE(german.questions[1].answers,
             QStringList({QStringLiteral("Impuls"), QStringLiteral("mass"), QStringLiteral("Tempo"),
                          QStringLiteral("Energie")}));
    QCOMPARE(german.questions[0].expression, QString(QStringLiteral("2*10")));
    english.questions.erase(english.questions.begin() + 1);
    files = *withTask(files, step, english);
    QVERIFY(!files.contents.value(step + QStringLiteral("/task.de.json")).contains("Impuls"));
}

/// Where there are fewer questions, one with another id takes no place: it is a new one.
void TestLabQuestions::noTextsOfAQuestionThatIsGone()
{
    const auto asked = [](std::initializer_list<const char *> ids, const char *title) {
        std::vector<Question> all;
        for (const char *id : ids) {
            all.emplace_back();
            all.back().id = QLatin1String(id);
            all.back().title = QLatin1String(title);
        }
        return all;
    };
    const auto before = asked({"a", "b", "c"}, "English");
    const auto german = asked({"a", "b", "c"}, "German");
    const auto after = withTextsOf(german, before, asked({"d", "c"}, "New"));
    QCOMPARE(after[0].title, QString(QStringLiteral("New")));
    QCOMPARE(after[1].title, QString(QStringLiteral("German")));
    QCOMPARE(withTextsOf(german, before, asked({"a", "b"}, "New")).size(), std::size_t(2));
}

QTEST_GUILESS_MAIN(TestLabQuestions)

#include "test_lab_questions.moc"

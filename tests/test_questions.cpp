// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/unit.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/task_form.h"
#include "tasks/grading/judging_request.h"
#include "tasks/grading/points.h"
#include "tasks/proof/lab_verifier.h"
#include "tasks/questions/answers.h"
#include "tasks/questions/question_json.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/report/report_formats.h"

#include <QJsonArray>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace cradle;

/// Questions that count beside the checks.
class TestQuestions : public QObject
{
    Q_OBJECT
private slots:
    void unitsAreWhatTheyAreMadeOf_data();
    void unitsAreWhatTheyAreMadeOf();
    void numberIsJudgedWithItsUnit_data();
    void numberIsJudgedWithItsUnit();
    void choicesAndOrdersAreJudged_data();
    void choicesAndOrdersAreJudged();
    void orderIsNeverShownRight();
    void faultsAreNamedWithTheirPlace_data();
    void faultsAreNamedWithTheirPlace();
    void countInPointsAndInTheVerdict();
    void everyFormatTellsThem_data();
    void everyFormatTellsThem();
    void handedInAnswersAreGraded();
    void verifyAnswersRightly();
    void textsFollowTheirQuestionInAllLanguages();
};

namespace {

Question speed()
{
    return {.id = QStringLiteral("speed"),
            .kind = Question::Kind::Number,
            .title = QStringLiteral("Speed at the floor"),
            .text = {},
            .number = 20.0,
            .tolerance = 0.1,
            .unit = QStringLiteral("m/s")};
}

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

void TestQuestions::unitsAreWhatTheyAreMadeOf_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("known");
    QTest::addColumn<double>("scale");
    QTest::addColumn<QList<int>>("powers"); // of m, kg and s
    QTest::newRow("none") << QStringLiteral("") << true << 1.0 << QList<int>{0, 0, 0};
    QTest::newRow("km/h") << QStringLiteral("km/h") << true << 1000.0 / 3600.0
                          << QList<int>{1, 0, -1};
    QTest::newRow("raised") << QStringLiteral("m/s\u00b2") << true << 1.0 << QList<int>{1, 0, -2};
    QTest::newRow("caret") << QStringLiteral("m s^-2") << true << 1.0 << QList<int>{1, 0, -2};
    QTest::newRow("newton second")
        << QStringLiteral("N\u00b7s") << true << 1.0 << QList<int>{1, 1, -1};
    QTest::newRow("momentum") << QStringLiteral("kg*m/s") << true << 1.0 << QList<int>{1, 1, -1};
    QTest::newRow("gram") << QStringLiteral("mg") << true << 1e-6 << QList<int>{0, 1, 0};
    QTest::newRow("minute, not milli-inch")
        << QStringLiteral("min") << true << 60.0 << QList<int>{0, 0, 1};
    QTest::newRow("two slashes") << QStringLiteral("J/kg/s") << true << 1.0 << QList<int>{2, 0, -3};
    QTest::newRow("degree") << QStringLiteral("\u00b0") << true << std::numbers::pi / 180.0
                            << QList<int>{0, 0, 0};
    QTest::newRow("no unit") << QStringLiteral("furlong") << false << 0.0 << QList<int>{};
    QTest::newRow("half a unit") << QStringLiteral("m/") << false << 0.0 << QList<int>{};
    QTest::newRow("empty power") << QStringLiteral("m^") << false << 0.0 << QList<int>{};
}

void TestQuestions::unitsAreWhatTheyAreMadeOf()
{
    QFETCH(QString, text);
    QFETCH(bool, known);
    const auto unit = unitFrom(text);
    QCOMPARE(unit.has_value(), known);
    if (!known)
        return;
    QTEST(unit->scale, "scale");
    QTEST(QList<int>(unit->powers.begin(), unit->powers.end()), "powers");
}

void TestQuestions::numberIsJudgedWithItsUnit_data()
{
    QTest::addColumn<QString>("answer");
    QTest::addColumn<QString>("said"); // empty: right
    QTest::newRow("right") << QStringLiteral("20 m/s") << QStringLiteral("");
    QTest::newRow("within the tolerance") << QStringLiteral("19.91m/s") << QStringLiteral("");
    QTest::newRow("beyond it") << QStringLiteral("19.89 m/s")
                               << QStringLiteral("19.89 m/s is not right");
    QTest::newRow("comma") << QStringLiteral("20,05 m/s") << QStringLiteral("");
    QTest::newRow("other unit, converted") << QStringLiteral("72 km/h") << QStringLiteral("");
    QTest::newRow("right number, other scale")
        << QStringLiteral("20 km/h") << QStringLiteral("the number is right, but not in km/h");
    QTest::newRow("right number, no unit")
        << QStringLiteral("20") << QStringLiteral("the number is right; its unit is missing");
    QTest::newRow("right number, other kind")
        << QStringLiteral("20 m")
        << QStringLiteral(
               "the number is right, but not its unit: what is asked for is not measured in m");
    QTest::newRow("wrong number, other kind")
        << QStringLiteral("3 m") << QStringLiteral("is not measured in m");
    QTest::newRow("wrong number, no unit")
        << QStringLiteral("3") << QStringLiteral("3 is not right, and its unit is missing");
    QTest::newRow("unknown unit") << QStringLiteral("20 knots")
                                  << QStringLiteral("is no unit that is known");
    QTest::newRow("no number") << QStringLiteral("fast")
                               << QStringLiteral("is no number with a unit");
    QTest::newRow("nothing") << QStringLiteral("  ") << QStringLiteral("not answered yet");
}

void TestQuestions::numberIsJudgedWithItsUnit()
{
    QFETCH(QString, answer);
    QFETCH(QString, said);
    const auto outcome = judgeAnswers({speed()}, {{QStringLiteral("speed"), answer}}).front();
    QCOMPARE(outcome.passed, said.isEmpty());
    QVERIFY2(outcome.message.contains(said), qPrintable(outcome.message));
    QVERIFY(!outcome.expected); // what is right is not told
}

void TestQuestions::choicesAndOrdersAreJudged_data()
{
    using Kind = Question::Kind;
    QTest::addColumn<int>("kind");
    QTest::addColumn<QJsonValue>("answer");
    QTest::addColumn<QString>("said");
    QTest::newRow("the one") << int(Kind::One) << QJsonValue(1) << QStringLiteral("");
    QTest::newRow("another") << int(Kind::One) << QJsonValue(2) << QStringLiteral("is not right");
    QTest::newRow("none there is")
        << int(Kind::One) << QJsonValue(9) << QStringLiteral("not answered yet");
    QTest::newRow("all") << int(Kind::Several) << QJsonValue(QJsonArray{3, 1})
                         << QStringLiteral("");
    QTest::newRow("twice the same") << int(Kind::Several) << QJsonValue(QJsonArray{1, 1})
                                    << QStringLiteral("not all that is right is chosen");
    QTest::newRow("one too many") << int(Kind::Several) << QJsonValue(QJsonArray{1, 2, 3})
                                  << QStringLiteral("one that is chosen is not right");
    QTest::newRow("wrong and missing") << int(Kind::Several) << QJsonValue(QJsonArray{2, 3})
                                       << QStringLiteral("and a right one is missing");
    QTest::newRow("in order") << int(Kind::Order) << QJsonValue(QJsonArray{1, 2, 3})
                              << QStringLiteral("");
    QTest::newRow("end swapped") << int(Kind::Order) << QJsonValue(QJsonArray{1, 3, 2})
                                 << QStringLiteral("right up to number 1");
    QTest::newRow("reversed") << int(Kind::Order) << QJsonValue(QJsonArray{3, 2, 1})
                              << QStringLiteral("does not begin");
    QTest::newRow("text") << int(Kind::Text) << QJsonValue(QStringLiteral("Because."))
                          << QStringLiteral(
                                 "for the teacher to read, who may give up to 1 points: Because.");
    QTest::newRow("no text") << int(Kind::Text) << QJsonValue(QStringLiteral(""))
                             << QStringLiteral("not answered yet");
}

void TestQuestions::choicesAndOrdersAreJudged()
{
    QFETCH(int, kind);
    QFETCH(QJsonValue, answer);
    QFETCH(QString, said);
    Question question{.id = QStringLiteral("q"),
                      .kind = static_cast<Question::Kind>(kind),
                      .title = QStringLiteral("Q"),
                      .text = {},
                      .answers = {QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")}};
    question.chosen = {0};
    if (question.kind == Question::Kind::Several)
        question.chosen = {0, 2};
    const auto outcome = judgeAnswers({question}, {{QStringLiteral("q"), answer}}).front();
    const bool forTeacher = question.kind == Question::Kind::Text;
    QCOMPARE(outcome.passed,
             said.isEmpty() || (forTeacher && answer.toString() != QStringLiteral("")));
    QCOMPARE(outcome.forTeacher, forTeacher);
    QVERIFY2(outcome.message.contains(said), qPrintable(outcome.message));
}

void TestQuestions::orderIsNeverShownRight()
{
    for (int i = 0; i < 50; ++i) {
        const Question question{.id = QString::number(i),
                                .kind = Question::Kind::Order,
                                .title = {},
                                .text = {},
                                .answers = {QStringLiteral("a"), QStringLiteral("b")}};
        QCOMPARE(shownOrder(question), (std::vector<int>{1, 0}));
    }
}

void TestQuestions::faultsAreNamedWithTheirPlace_data()
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

void TestQuestions::faultsAreNamedWithTheirPlace()
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

void TestQuestions::countInPointsAndInTheVerdict()
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

void TestQuestions::everyFormatTellsThem_data()
{
    QTest::addColumn<QString>("format");
    for (const QString &name : reportFormatNames())
        QTest::newRow(qPrintable(name)) << name;
}

void TestQuestions::everyFormatTellsThem()
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

void TestQuestions::handedInAnswersAreGraded()
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

void TestQuestions::verifyAnswersRightly()
{
    const auto verified = verifyLab(readOf(labWith(manyQuestions())));
    QVERIFY(verified[0].findings.empty());
}

void TestQuestions::textsFollowTheirQuestionInAllLanguages()
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

QTEST_GUILESS_MAIN(TestQuestions)

#include "test_questions.moc"

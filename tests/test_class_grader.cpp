// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/json_schema.h"
#include "tasks/grading/class_grader.h"
#include "tasks/grading/student_result_json.h"
#include "tasks/reading/lab_reader.h"
#include "tests/made_class.h"
#include "tests/test_paths.h"

#include <csignal>

using namespace cradle;
using namespace cradle::classes;

/// A class is judged by processes that somebody may kill, and that are not believed who they are.
class TestClassGrader : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void studentIsJudgedAndCounted();
    void reportsAreOfTheLabThatIsGraded();
    void whatIsKilledIsBegunAnew_data();
    void whatIsKilledIsBegunAnew();
    void whoIsKilledAllTheTimeEndsIt();
    void whoStopsItLeavesTheRest();

private:
    Lab m_lab;
};

namespace {

using Started = Result<std::unique_ptr<Workers>>;

Started started(const Lab &lab)
{
    return Workers::start(lab, {}, {}, {}, {});
}

/// Kills the processes that fork workers, all of this one's.
void killServers()
{
    QFile children(text("/proc/thread-self/children"));
    QVERIFY(children.open(QIODevice::ReadOnly));
    for (const QByteArray &child : children.readAll().split(' ')) {
        if (!child.trimmed().isEmpty())
            ::kill(child.toInt(), SIGKILL);
    }
}

Started killed(const Lab &lab)
{
    auto workers = started(lab);
    killServers();
    return workers;
}

/// Ada has solved the first of three steps, has the second wrong and lacks the third.
class Graded
{
public:
    Graded()
    {
        m_class.file("ada/steps/BALL1.lua", solutionOf("BALL1"));
        m_class.file("ada/steps/BALL2.lua", solutionOf("BALL1"));
    }

    /// What it was stopped by.
    QString run(const Lab &lab, Started workers, ClassGrader::Hooks hooks = {})
    {
        auto journal = ClassJournal::open(m_results.path());
        if (!journal || journal->begin(m_known) || !workers)
            return text("not begun");
        const ClassFolder found = m_class.read();
        ClassGrader grader(lab, found.root, "secret", *journal, std::move(hooks));
        const auto error = grader.run(found.students, 1, std::move(*workers));
        progress = grader.progress();
        m_known = journal->manifest();
        const auto bytes = readFile(journal->studentPath(text("ada")), mostResultBytes);
        const auto read = bytes ? readStudentResult(*bytes, {}) : Error{.message = text("none")};
        result = read ? *read : StudentResult{};
        return error ? error->message : QString();
    }
    /// Their first letters: passed, failed, missing or not graded.
    [[nodiscard]] QString verdicts() const
    {
        QString letters;
        for (const StepResult &step : result.steps)
            letters += QLatin1Char("pfmn"[static_cast<int>(step.status)]);
        return letters;
    }

    ClassProgress progress{};
    StudentResult result{};

private:
    static QByteArray solutionOf(const char *step)
    {
        QFile file(QLatin1String(bouncingBallLab) + u'/' + QLatin1String(step)
                   + text("/solution.lua"));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    Made m_class;
    QTemporaryDir m_results;
    Manifest m_known{};
};

} // namespace

void TestClassGrader::initTestCase()
{
    const auto lab = readLab(QLatin1String(bouncingBallLab));
    QVERIFY(lab.ok());
    m_lab = *lab;
}

void TestClassGrader::studentIsJudgedAndCounted()
{
    Graded made;
    QCOMPARE(made.run(m_lab, started(m_lab)), QString());
    QCOMPARE(made.verdicts(), text("pfm"));
    QCOMPARE(made.progress.students, 1);
    QCOMPARE(made.progress.done, 1);
    QCOMPARE(made.progress.kept, 0);
    QCOMPARE(made.progress.steps, 3);
    QCOMPARE(made.progress.passed, 1);
    QCOMPARE(made.progress.failed, 1);
    QCOMPARE(made.progress.notGraded, 0);

    QCOMPARE(made.run(m_lab, started(m_lab)), QString()); // nothing is left to do
    QCOMPARE(made.progress.kept, 1);
    QCOMPARE(made.progress.steps, 0);
}

void TestClassGrader::reportsAreOfTheLabThatIsGraded()
{
    Lab other = m_lab;
    other.id = text("other");
    other.hash = text("of other files");
    Graded made;
    QCOMPARE(made.run(m_lab, started(other)), QString());
    QCOMPARE(made.verdicts(), text("pfm"));
    const auto &report = made.result.steps.front().report;
    QVERIFY(report.has_value());
    QCOMPARE(report->labId, m_lab.id);
    QCOMPARE(report->labHash, m_lab.hash);
    QCOMPARE(report->taskId, text("BALL1"));
    QCOMPARE(report->seed, made.result.seed);
}

void TestClassGrader::whatIsKilledIsBegunAnew_data()
{
    QTest::addColumn<int>("kills");
    QTest::addColumn<QString>("verdicts");
    QTest::newRow("once") << 1 << text("pfm");
    QTest::newRow("four times at a step") << 4 << text("pfm");
    QTest::newRow("five times at a step") << 5 << text("nfm");
    QTest::newRow("eight times") << 8 << text("nfm");
}

void TestClassGrader::whatIsKilledIsBegunAnew()
{
    QFETCH(int, kills);
    QFETCH(QString, verdicts);
    Graded made;
    const auto next = [&, left = kills - 1]() mutable {
        return left-- > 0 ? killed(m_lab) : started(m_lab);
    };
    QCOMPARE(made.run(m_lab, killed(m_lab), {.startWorkers = next}), QString());
    QCOMPARE(made.verdicts(), verdicts);
    QCOMPARE(made.progress.notGraded, int(verdicts.count(u'n')));
}

void TestClassGrader::whoIsKilledAllTheTimeEndsIt()
{
    Graded made;
    int starts = 0;
    const auto next = [&] {
        ++starts;
        return killed(m_lab);
    };
    QVERIFY(!made.run(m_lab, killed(m_lab), {.startWorkers = next}).isEmpty());
    QCOMPARE(starts, 10);
    QCOMPARE(made.progress.done, 0);
}

void TestClassGrader::whoStopsItLeavesTheRest()
{
    Graded made;
    QCOMPARE(made.run(m_lab, started(m_lab), {.stopped = [] { return true; }}), QString());
    QCOMPARE(made.progress.done, 0);
    int told = 0;
    const auto done = [&](const ClassProgress &progress, const StudentResult &student) {
        ++told;
        QCOMPARE(progress.done, 1);
        QCOMPARE(student.id, text("ada"));
    };
    QCOMPARE(made.run(m_lab, started(m_lab), {.done = done}), QString());
    QCOMPARE(told, 1);
}

QTEST_GUILESS_MAIN(TestClassGrader)
#include "test_class_grader.moc"

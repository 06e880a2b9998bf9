// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_programs.h"
#include "tests/lab_test.h"
#include "tests/sanitized.h"
#include "tests/told_report.h"

#include "tasks/judging/judgement.h"

#include <map>

using namespace cradle;

/// What students are told, word by word: programs as they write them, and the reports of these.
/// tests/approved/STEP has whole programs (NAME.lua), what is other in a wrong one
/// (NAME.FAULT.diff, below what is wrong in it) and scenes that are handed in alone (NAME.json);
/// STEP.txt has the reports. Where a line "N = …" gives values, the program has each in turn in
/// place of N: just not wrong enough for something to be told, and just wrong enough.
class TestApprovedReports : public LabTest
{
    Q_OBJECT
private slots:
    void reportIsAsApproved_data();
    void reportIsAsApproved();
    void everyReportHasAProgram();
    void cleanupTestCase();

private:
    struct Step {
        const Lab *lab = nullptr;
        const Task *task = nullptr;
        std::map<QString, QString> reports{}; ///< by the name of what was handed in
        QStringList handedIn{};
    };

    Lab m_labs[2];
    std::map<QString, Step> m_steps;
};

namespace {

const QString mark = QStringLiteral("== ");

std::map<QString, QString> sections(const QString &text)
{
    std::map<QString, QString> all;
    for (const QString &section : text.split(QLatin1Char('\n') + mark, Qt::SkipEmptyParts)) {
        const QString whole = section.startsWith(mark) ? section.mid(mark.size()) : section;
        const auto end = whole.indexOf(QLatin1Char('\n'));
        all[whole.left(end)] = whole.mid(end + 1).trimmed() + QLatin1Char('\n');
    }
    return all;
}

} // namespace

void TestApprovedReports::reportIsAsApproved_data()
{
    m_labs[0] = *readLab(QLatin1String(shippedLab));
    m_labs[1] = *readLab(QLatin1String(bouncingBallLab));
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("value");
    for (const Lab &lab : m_labs) {
        for (const Task &task : lab.tasks) {
            Step &step = m_steps[task.id];
            step = {&lab, &task, sections(approved::read(task.id + QStringLiteral(".txt"))), {}};
            for (const QString &file :
                 QDir(approved::path(task.id)).entryList(QDir::Files, QDir::Name)) {
                for (const QString &value : approved::valuesOf(task.id + QLatin1Char('/') + file)) {
                    step.handedIn.append(approved::nameOf(file, value));
                    if (step.handedIn.size() % oneOf(8) != 0)
                        continue;
                    QTest::addRow("%s/%s", qPrintable(task.id),
                                  qPrintable(approved::nameOf(file, value)))
                        << task.id << file << value;
                }
            }
        }
    }
}

void TestApprovedReports::reportIsAsApproved()
{
    QFETCH(QString, step);
    QFETCH(QString, file);
    QFETCH(QString, value);
    approved::failOnWarnings();
    Step &of = m_steps[step];
    Submission submission(of.task->preset);
    if (file.endsWith(QLatin1String(".json"))) {
        const Result<Preset> scene = readPreset(approved::path(step + QLatin1Char('/') + file));
        QVERIFY2(scene.ok(), scene ? "" : qPrintable(scene.error().toString()));
        submission.preset = *scene;
    } else {
        submission.script = approved::readProgram(step, file, value);
        QVERIFY2(!submission.script->isEmpty(), "the difference does not fit its program");
    }
    JudgeHooks hooks;
    hooks.provesLines = value.isEmpty(); // the others of one program have the same line
    const QString told = toldReport(*judgeTask(*of.lab, *of.task, submission, 1, hooks));
    if (approved::isApproving()) {
        of.reports[approved::nameOf(file, value)] = told;
    } else {
        const QString difference =
            approved::difference(told, of.reports[approved::nameOf(file, value)]);
        QVERIFY2(difference.isEmpty(), qPrintable(difference));
    }
}

void TestApprovedReports::everyReportHasAProgram()
{
    for (auto &[id, step] : m_steps) {
        for (auto report = step.reports.begin(); report != step.reports.end();) {
            const bool isThere = step.handedIn.contains(report->first);
            if (!isThere && !approved::isApproving())
                QFAIL(qPrintable(report->first));
            report = isThere ? std::next(report) : step.reports.erase(report);
        }
    }
}

void TestApprovedReports::cleanupTestCase()
{
    if (!approved::isApproving())
        return;
    for (const auto &[id, step] : m_steps) {
        QStringList all;
        for (const auto &[name, report] : step.reports)
            all.append(mark + name + QLatin1Char('\n') + report);
        if (!all.isEmpty())
            approved::write(id + QStringLiteral(".txt"), all.join(QLatin1Char('\n')));
    }
}

QTEST_GUILESS_MAIN(TestApprovedReports)
#include "test_approved_reports.moc"

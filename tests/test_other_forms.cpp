// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/other_forms.h"

#include "tasks/judging/checker.h"
#include "tasks/reading/lab_reader.h"

#include <QTest>

using namespace cradle;
using namespace cradle::programs;

/// Correct work in other forms than the lab's own: it passes, and nothing is found in it.
class TestOtherForms : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void correctWorkOfAnotherFormPasses_data();
    void correctWorkOfAnotherFormPasses();

private:
    [[nodiscard]] CheckReport judged(const QString &step, const OtherForm &form) const;

    Lab m_lab;
};

void TestOtherForms::initTestCase()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    m_lab = *lab;
}

CheckReport TestOtherForms::judged(const QString &step, const OtherForm &form) const
{
    const Task &task = m_lab.tasks.at(static_cast<std::size_t>(m_lab.indexOf(step)));
    return *judgeTask(m_lab, task, Submission(task.preset, form.source()), 1);
}

void TestOtherForms::correctWorkOfAnotherFormPasses_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<OtherForm>("form");
    using namespace parts;
    for (const char *step :
         {"L42T1", "L42T2", "L42T3", "L42T4", "L42T5", "L42T7", "L42T8", "L42T9", "L42T10",
          "L42T11", "L42T12", "L42T13", "L42T14", "L42T15", "L42T16", "L42T17"})
        QTest::newRow(step) << lab(step) << otherForm(lab(step));
    const auto row = [](const char *step, const char *name, const FormChange &change) {
        OtherForm form = otherForm(lab(step));
        change(form);
        QTest::newRow(name) << lab(step) << form;
    };
    row("L42T2", "step 2, clamped", [](OtherForm &f) { f.walls = clamp; });
    row("L42T12", "step 12, circles before walls", [](OtherForm &f) { f.circlesFirst = true; });
    row("L42T12", "step 12, Euler", [](OtherForm &f) { f.integrate = euler; });
    row("L42T14", "step 14, centre of mass", [](OtherForm &f) { f.answer = aboutCentre; });
    row("L42T16", "step 16, centre of mass", [](OtherForm &f) { f.answer = aboutCentre; });
    row("L42T17", "step 17, Euler", [](OtherForm &f) { f.integrate = euler; });
    row("L42T17", "step 17, circles before walls", [](OtherForm &f) {
        f.circlesFirst = true;
        f.integrate = symplectic;
    });
}

void TestOtherForms::correctWorkOfAnotherFormPasses()
{
    QFETCH(QString, step);
    QFETCH(OtherForm, form);
    const CheckReport report = judged(step, form);
    QVERIFY2(report.passed, say(report).constData());
    QVERIFY2(!report.diagnosis(), say(report).constData());
    QVERIFY2(report.remarks.empty(),
             report.remarks.empty() ? "" : report.remarks.front().id.toUtf8().constData());
}

QTEST_GUILESS_MAIN(TestOtherForms)
#include "test_other_forms.moc"

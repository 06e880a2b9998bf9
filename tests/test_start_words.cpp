// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/start_words.h"

#include "tests/lab_test.h"

#include <algorithm>

using namespace cradle;

/// What is said of values that a scene of the student's own starts with.
class TestStartWords : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void anotherRestitutionIsTold_data();
    void anotherRestitutionIsTold();
};

void TestStartWords::anotherRestitutionIsTold_data()
{
    QTest::addColumn<QString>("restitution");
    QTest::addColumn<bool>("told");
    QTest::newRow("not set") << QString() << true;
    QTest::newRow("none is lost") << QStringLiteral("1") << true;
    QTest::newRow("as asked") << QStringLiteral("0.5") << false;
}

/// Whatever other checks come first.
void TestStartWords::anotherRestitutionIsTold()
{
    QFETCH(QString, restitution);
    QFETCH(bool, told);
    Task step = task(QStringLiteral("L42T16"));
    QString program = step.solution;
    program.replace(QStringLiteral("restitution = 0.5"),
                    restitution.isEmpty() ? QString()
                                          : QStringLiteral("restitution = ") + restitution);
    const Submission submission(step.preset, program);
    for (std::size_t turn = 0; turn < step.checks.size(); ++turn) {
        const auto found = otherRestitution(step, submission, {});
        QCOMPARE(found.has_value(), told);
        if (found)
            QCOMPARE(found->moment.start, Assignment::Field::Restitution);
        std::rotate(step.checks.begin(), step.checks.begin() + 1, step.checks.end());
    }
}

QTEST_GUILESS_MAIN(TestStartWords)
#include "test_start_words.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_reader.h"

#include "tests/authoring_labs.h"

using namespace cradle;
using namespace cradle::authoring;

namespace {

const QString masses = text("L42T14"); // it has remarks

} // namespace

/// Edits of the list of checks.
class TestLabCheckEdits : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void checksAreAddedMovedAndRemoved();

private:
    LabFiles m_lab;
};

void TestLabCheckEdits::initTestCase()
{
    TAKE(m_lab, readLabFiles(shippedFolder));
    QVERIFY(m_lab.contents.size() > 200);
}

void TestLabCheckEdits::checksAreAddedMovedAndRemoved()
{
    const QString path = masses + text("/task.json");
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses));
    const std::vector<CheckForm> checks = form.checks;
    form.checks.insert(form.checks.begin() + 1,
                       CheckForm{.id = text("new"),
                                 .kind = text("settles"),
                                 .title = text("It comes to rest"),
                                 .circles = {1},
                                 .parameters = {{text("tolerance"), 1e-3}},
                                 .scene = {{text("kind"), text("drop")}, {text("count"), 5}}});
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form));
    QCOMPARE(
        newLines(m_lab.contents[path], lab.contents[path]),
        (QList<QByteArray>{"    {\"id\": \"new\", \"kind\": \"settles\", \"title\": \"It comes to "
                           "rest\", \"circles\": [2], \"parameters\": {\"tolerance\": 0.001}, "
                           "\"scene\": {\"kind\": \"drop\", \"count\": 5}},"}));
    std::swap(form.checks[0], form.checks[2]);
    TAKE(lab, withTask(lab, masses, form));
    TaskForm again;
    TAKE(again, taskForm(lab, masses));
    QVERIFY(again == form);
    form.checks = checks;
    TAKE(lab, withTask(lab, masses, form));
    QCOMPARE(differences(m_lab, lab), QStringList());
    form.checks.clear();
    TAKE(lab, withTask(lab, masses, form));
    QVERIFY(lab.contents[path].contains("\"checks\": []"));
    form.checks = {checks[0]};
    TAKE(lab, withTask(lab, masses, form));
    QVERIFY(lab.contents[path].contains("\"checks\": [\n    {\"id\": \"start-1\", "));
}

QTEST_GUILESS_MAIN(TestLabCheckEdits)
#include "test_lab_check_edits.moc"

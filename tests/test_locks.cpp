// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/locks.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/judging/judgement.h"
#include "tasks/reading/lab_reader.h"

#include <QTest>

using namespace cradle;

/// What a step fixes: which fields, which change breaks which, and that a check refuses it.
class TestLocks : public QObject
{
    Q_OBJECT
private slots:
    void everyFieldTellsItsOwnChange_data();
    void everyFieldTellsItsOwnChange();
    void circlesThatThereAreNotAreAlike();
    void namesAreThoseOfTheFields();
    void checkRefusesAChangedLock();
    void readerRefusesAFieldThatThereIsNot();
};

namespace {

Preset scene()
{
    Preset preset;
    PresetCircle circle;
    circle.name = QStringLiteral("circle 1");
    preset.circles = {circle, circle};
    preset.circles[1].name = QString();
    preset.circles[1].body.position = {1.0, 0.0};
    return preset;
}

using Change = void (*)(Preset &);

} // namespace

void TestLocks::everyFieldTellsItsOwnChange_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<QStringList>("fields"); // that tell it
    const auto row = [](const char *name, Change change, const QStringList &fields) {
        QTest::newRow(name) << change << fields;
    };
    const auto list = [](const char *names) {
        return QString::fromLatin1(names).split(QLatin1Char(' '));
    };
    row(
        "gravity", [](Preset &p) { p.gravity.y = -1.0; }, list("gravity"));
    row(
        "restitution", [](Preset &p) { p.restitution = 0.5; }, list("restitution"));
    row(
        "timestep", [](Preset &p) { p.timestep = 0.01; }, list("timestep"));
    row(
        "half width", [](Preset &p) { p.halfWidth = 5.0; }, list("half_width"));
    row(
        "walls", [](Preset &p) { p.laws.walls = WallLaw::Reflect; }, list("laws/walls"));
    row(
        "circles", [](Preset &p) { p.laws.circles = CircleLaw::Stop; }, list("laws/circles"));
    row(
        "timing", [](Preset &p) { p.laws.timing = Timing::Exact; }, list("laws/timing"));
    row(
        "position", [](Preset &p) { p.circles[0].body.position.x = 3.0; },
        list("circles/1/position"));
    row(
        "velocity", [](Preset &p) { p.circles[1].body.velocity.y = 3.0; },
        list("circles/2/velocity"));
    row(
        "radius", [](Preset &p) { p.circles[0].body.radius = 0.3; },
        list("circles/1/radius circles/1/mass"));
    row(
        "density", [](Preset &p) { p.circles[0].body.density = 1.0; },
        list("circles/1/density circles/1/mass"));
    row(
        "integrator", [](Preset &p) { p.circles[0].integrator = Integrator::Verlet; },
        list("circles/1/integrator"));
    row("colour", [](Preset &p) { p.circles[0].colour = QStringLiteral("#000000"); }, {});
    row(
        "one circle less", [](Preset &p) { p.circles.pop_back(); },
        list("circles circles/2/position circles/2/velocity circles/2/radius circles/2/density "
             "circles/2/mass circles/2/integrator"));
}

void TestLocks::everyFieldTellsItsOwnChange()
{
    QFETCH(const Change, change);
    QFETCH(const QStringList, fields);
    const Preset original = scene();
    Preset changed = original;
    change(changed);
    for (const QString &field : lockableFields(original)) {
        QCOMPARE(firstChangedLock(original, changed, {field}).has_value(), fields.contains(field));
        QCOMPARE(firstChangedLock(changed, original, {field}).has_value(), fields.contains(field));
    }
    QCOMPARE(firstChangedLock(original, original, lockableFields(original)), std::nullopt);
}

/// What neither scene has is alike in both, and of many circles ten are offered.
void TestLocks::circlesThatThereAreNotAreAlike()
{
    Preset many = scene();
    const Preset two = scene();
    for (const char *field : {"circles/3/position", "circles/4/mass", "circles/0/mass"})
        QCOMPARE(firstChangedLock(two, two, {QLatin1String(field)}), std::nullopt);
    many.circles.resize(12, many.circles.front());
    const QStringList fields = lockableFields(many);
    QVERIFY(fields.contains(QStringLiteral("circles/10/mass")));
    QVERIFY(!fields.contains(QStringLiteral("circles/11/mass")));
    QVERIFY(!lockableFields(two).contains(QStringLiteral("circles/3/mass")));
}

void TestLocks::namesAreThoseOfTheFields()
{
    const Preset preset = scene();
    QCOMPARE(lockedName(QStringLiteral("gravity"), preset), QStringLiteral("gravity"));
    QCOMPARE(lockedName(QStringLiteral("circles/1/mass"), preset),
             QStringLiteral("mass of circle 1"));
    QCOMPARE(lockedName(QStringLiteral("circles/2/velocity"), preset),
             QStringLiteral("velocity of circle 2")); // it has no name of its own
    QVERIFY(lockReason(QStringLiteral("laws/timing"), preset).contains(QStringLiteral("timing")));
}

void TestLocks::checkRefusesAChangedLock()
{
    const LabFiles files = newLab(QStringLiteral("lab"), QStringLiteral("Lab"), {});
    const QString step = stepsOf(files).front();
    Result<TaskForm> form = taskForm(files, step);
    form->locked = {QStringLiteral("timestep")};
    const Result<Lab> lab = readLab(*withTask(files, step, *form), QStringLiteral("/lab"));
    QVERIFY(lab.ok());
    const Task &task = lab->tasks.front();
    QCOMPARE(task.locked, form->locked);
    Submission submission(task.preset, task.solution);
    QVERIFY(judgeTask(*lab, task, submission, 1)->passed);
    submission.preset.timestep *= 0.5;
    const auto report = judgeTask(*lab, task, submission, 1);
    QVERIFY(!report->passed);
    QCOMPARE(report->checks.front().id, QStringLiteral("locked"));
    QVERIFY(report->checks.front().message.contains(QStringLiteral("timestep")));
}

void TestLocks::readerRefusesAFieldThatThereIsNot()
{
    const LabFiles files = newLab(QStringLiteral("lab"), QStringLiteral("Lab"), {});
    const QString path = stepsOf(files).front() + QStringLiteral("/task.json");
    QString text = textOf(files, path);
    text.insert(text.lastIndexOf(QLatin1Char('}')),
                QStringLiteral(", \"locked\": [\"gravitas\"]\n"));
    const Result<Lab> lab = readLab(withText(files, path, text), QStringLiteral("/lab"));
    QVERIFY(lab.ok());
    QCOMPARE(lab->findings.size(), std::size_t{1});
    QCOMPARE(lab->findings.front().pointer, QStringLiteral("/locked/0"));
    QVERIFY(lab->findings.front().message.contains(QStringLiteral("gravity")));
}

QTEST_GUILESS_MAIN(TestLocks)
#include "test_locks.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/told_step_bytes.h"

#include "tasks/reading/lab_reader.h"

#include <QTest>

using namespace cradle;

/// What a process that ran a student's program tells of a step: read as it was, or not at all.
class TestToldStepBytes final : public QObject
{
    Q_OBJECT
private slots:
    void comesBackAsItWas();
    void titleIsNotWhatIsAsked();
    void brokenBytesAreNone();
    void onlyPlainDrawingsAreTaken_data();
    void onlyPlainDrawingsAreTaken();

private:
    static ToldStep told();
};

ToldStep TestToldStepBytes::told()
{
    const auto lab = readLab(QLatin1String(bouncingBallLab));
    StudentWork work;
    work.steps[lab->tasks[0].id].program = lab->tasks[0].solution;
    ToldStep step = tellStep(*lab, work, 0, 1);
    step.report.met.push_back({QStringLiteral("It fell"), 3});
    step.report.attempts = 4;
    return step;
}

void TestToldStepBytes::comesBackAsItWas()
{
    const ToldStep step = told();
    QCOMPARE(step.report.verdict, StepVerdict::Passed);
    QVERIFY(!step.report.scene.isEmpty() && !step.curve.points.empty());
    const QByteArray bytes = bytesOf(step);
    const auto read = toldStepFrom(bytes);
    QVERIFY(read);
    QCOMPARE(bytesOf(*read), bytes);
    QCOMPARE(read->report.id, step.report.id);
    QCOMPARE(read->report.scene, step.report.scene);
    QCOMPARE(read->report.change.size(), step.report.change.size());
    QVERIFY(read->report.met == step.report.met);
    QCOMPARE(read->report.attempts, 4);
    QVERIFY(read->curve.points == step.curve.points);
}

/// Also where the title has a no-break space, as French titles have.
void TestToldStepBytes::titleIsNotWhatIsAsked()
{
    auto lab = readLab(QLatin1String(bouncingBallLab));
    Task &task = lab->tasks[0];
    task.title = QStringLiteral("Jeu\u00a0: la balle");
    task.instructions = QStringLiteral("# %1\n\nIt falls. It bounces.\n").arg(task.title);
    QCOMPARE(tellStep(*lab, {}, 0, 1).report.asked, QStringLiteral("It falls."));
}

void TestToldStepBytes::brokenBytesAreNone()
{
    const QByteArray bytes = bytesOf(told());
    QVERIFY(!toldStepFrom({}));
    QVERIFY(!toldStepFrom(bytes + 'x'));
    for (qsizetype size = 0; size < bytes.size(); size += 97)
        QVERIFY(!toldStepFrom(bytes.left(size)));
    // Whatever it is then, reading it ends.
    for (qsizetype at = 0; at < bytes.size(); at += 31) {
        QByteArray broken = bytes;
        broken[at] = static_cast<char>(broken[at] ^ 0xff);
        (void)toldStepFrom(broken);
    }
}

void TestToldStepBytes::onlyPlainDrawingsAreTaken_data()
{
    QTest::addColumn<QByteArray>("svg");
    QTest::addColumn<bool>("taken");
    const auto row = [](const char *name, const QByteArray &inside, bool taken) {
        QTest::newRow(name) << "<svg xmlns=\"http://www.w3.org/2000/svg\">" + inside + "</svg>"
                            << taken;
    };
    QTest::newRow("none") << QByteArray() << true;
    row("a circle", "<title>x</title><circle cx=\"1\" cy=\"1\" r=\"1\" fill=\"#fff\"/>", true);
    row("a script", "<script>alert(1)</script>", false);
    row("a handler", "<circle onclick=\"alert(1)\"/>", false);
    row("a picture", "<image href=\"http://example.org/\"/>", false);
    row("a link", "<circle xlink:href=\"x\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"/>", false);
    row("a style", "<circle style=\"fill: red\"/>", false);
    row("an address", "<circle fill=\"url(http://example.org)\"/>", false);
    row("a page", "<foreignObject><p/></foreignObject>", false);
    row("an entity", "&x;", false);
    row("no end", "<circle", false);
    QTest::newRow("more than one") << QByteArray("<svg/><svg/>") << false;
    QTest::newRow("text") << QByteArray("hello") << false;
}

void TestToldStepBytes::onlyPlainDrawingsAreTaken()
{
    QFETCH(QByteArray, svg);
    QFETCH(bool, taken);
    QCOMPARE(isPlainDrawing(svg), taken);
}

QTEST_GUILESS_MAIN(TestToldStepBytes)
#include "test_told_step_bytes.moc"

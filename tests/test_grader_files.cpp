// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "class_of_three.h"
#include "tasks/grading/grader_files.h"
#include "test_paths.h"
#include "tool_run.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;
using namespace cradle::classes;

/// What other graders read of a student; each is read back by a program of its kind.
class TestGraderFiles : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void gradescopeAddsUp();
    void stepIsWorthWhatTheLabSays();
    void gitHubAddsUp();
    void whatHasNoVerdictIsNoFile();
    void junitIsValid();
    void proveReadsTap();
    void exercismShowsWhatIsAsked();

private:
    QTemporaryDir m_folder;
    Lab m_lab = smallLab();
    ClassFacts m_facts = facts();
};

namespace {

QJsonObject parsed(const QByteArray &text)
{
    return QJsonDocument::fromJson(text).object();
}

} // namespace

void TestGraderFiles::init()
{
    for (const StudentResult &student : {ada(m_lab), bob(m_lab), mallory(m_lab)})
        QVERIFY(!writeGraderFiles(m_folder.path(), student, m_lab, m_facts));
}

void TestGraderFiles::gradescopeAddsUp()
{
    const QJsonObject json = parsed(gradescopeFile(mallory(m_lab), m_lab, m_facts));
    QCOMPARE(json.value(QStringLiteral("score")).toDouble(), 1.0);
    double score = 0.0;
    double most = 0.0;
    for (const QJsonValue &test : json.value(QStringLiteral("tests")).toArray()) {
        score += test.toObject().value(QStringLiteral("score")).toDouble();
        most += test.toObject().value(QStringLiteral("max_score")).toDouble();
        QVERIFY(test.toObject().value(QStringLiteral("name")).toString().startsWith(u'S'));
    }
    QCOMPARE(score, 1.0);
    QCOMPARE(most, 5.5);
    QVERIFY(!json.contains(QStringLiteral("execution_time")));
}

void TestGraderFiles::stepIsWorthWhatTheLabSays()
{
    Lab lab = smallLab();
    lab.tasks[0].points = 30.0; // its checks are worth 1 and 2
    QCOMPARE(*pointsOf(mallory(lab), lab).earned, 10.0);
    QCOMPARE(pointsOf(mallory(lab), lab).most, 32.5);
    const QJsonObject json = parsed(gradescopeFile(mallory(lab), lab, {}));
    QCOMPARE(json.value(QStringLiteral("score")).toDouble(), 10.0);
    double score = 0.0;
    double most = 0.0;
    for (const QJsonValue &test : json.value(QStringLiteral("tests")).toArray()) {
        score += test.toObject().value(QStringLiteral("score")).toDouble();
        most += test.toObject().value(QStringLiteral("max_score")).toDouble();
    }
    QCOMPARE(score, 10.0);
    QCOMPARE(most, 32.5);
    lab.tasks[0].points = 0.0;
    QCOMPARE(*pointsOf(mallory(lab), lab).earned, 0.0);
}

void TestGraderFiles::gitHubAddsUp()
{
    const QJsonObject json = parsed(gitHubFile(ada(m_lab), m_lab));
    QCOMPARE(json.value(QStringLiteral("version")), QJsonValue(1));
    QCOMPARE(json.value(QStringLiteral("status")), QJsonValue(QStringLiteral("pass")));
    QCOMPARE(json.value(QStringLiteral("max_score")), QJsonValue(5.5));
    double score = 0.0;
    for (const QJsonValue &test : json.value(QStringLiteral("tests")).toArray()) {
        score += test.toObject().value(QStringLiteral("score")).toDouble();
        QVERIFY(!test.toObject().value(QStringLiteral("test_code")).toString().isEmpty());
    }
    QCOMPARE(score, 5.5);
    QCOMPARE(parsed(gitHubFile(mallory(m_lab), m_lab)).value(QStringLiteral("status")),
             QJsonValue(QStringLiteral("fail")));
}

void TestGraderFiles::whatHasNoVerdictIsNoFile()
{
    QVERIFY(gradescopeFile(bob(m_lab), m_lab, m_facts).isEmpty());
    QVERIFY(gitHubFile(bob(m_lab), m_lab).isEmpty());
    QVERIFY(!QFile::exists(m_folder.filePath(QStringLiteral("gradescope/bob.json"))));
    // One of an earlier grading would still say what is no longer so.
    QVERIFY(!writeFile(m_folder.filePath(QStringLiteral("gradescope/bob.json")), "{}"));
    QVERIFY(!writeGraderFiles(m_folder.path(), bob(m_lab), m_lab, m_facts));
    QVERIFY(!QFile::exists(m_folder.filePath(QStringLiteral("gradescope/bob.json"))));
}

void TestGraderFiles::junitIsValid()
{
    for (const char *id : {"ada", "bob", "mallory"}) {
        const ToolRun ended =
            runTool(QStringLiteral("xmllint"),
                    {QStringLiteral("--noout"), QStringLiteral("--nonet"),
                     QStringLiteral("--schema"), fixturePath("junit-10.xsd"),
                     m_folder.filePath(QStringLiteral("junit/%1.xml").arg(QLatin1String(id)))});
        QVERIFY2(ended.code == 0, ended.out);
    }
    QVERIFY(junitFile(bob(m_lab), m_lab).contains("<skipped message=\"the machine &amp; all"));
}

void TestGraderFiles::proveReadsTap()
{
    const auto prove = [&](const char *id) {
        return runTool(QStringLiteral("prove"),
                       {QStringLiteral("-e"), QStringLiteral("cat"),
                        m_folder.filePath(QStringLiteral("tap/%1.tap").arg(QLatin1String(id)))});
    };
    ToolRun ended = prove("ada");
    QVERIFY2(ended.code == 0 && ended.out.contains("Tests=4"), ended.out);
    ended = prove("bob"); // skipped is not failed
    QVERIFY2(ended.code == 0 && ended.out.contains("Tests=3"), ended.out);
    ended = prove("mallory");
    QVERIFY2(ended.code == 1 && ended.out.contains("Failed tests:  2-3"), ended.out);
}

void TestGraderFiles::exercismShowsWhatIsAsked()
{
    const QJsonObject json = parsed(exercismFile(mallory(m_lab).steps[0], m_lab.tasks[0]));
    QCOMPARE(json.value(QStringLiteral("version")), QJsonValue(3));
    const QJsonArray tests = json.value(QStringLiteral("tests")).toArray();
    QCOMPARE(tests.size(), 2);
    QCOMPARE(parsed(tests[1].toObject().value(QStringLiteral("test_code")).toString().toUtf8())
                 .value(QStringLiteral("kind")),
             QJsonValue(QStringLiteral("integrates")));
    QVERIFY(exercismFile(mallory(m_lab).steps[1], m_lab.tasks[1]).isEmpty());
}

QTEST_APPLESS_MAIN(TestGraderFiles)
#include "test_grader_files.moc"

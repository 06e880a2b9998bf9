// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/reading/lab_reader.h"
#include "tests/programs.h"

#include <QTest>

#include <set>

using namespace cradle;

/// The catalogue from which forms are made and by which files are judged.
class TestCheckKinds : public QObject
{
    Q_OBJECT
private slots:
    void everyKindCanBeJudged();
    void everyParameterIsDescribed_data();
    void everyParameterIsDescribed();
    void theShippedLabUsesWhatTheCatalogueHas();
};

void TestCheckKinds::everyKindCanBeJudged()
{
    // Two circles that rest upon nothing: some kinds find that right, others say what is wrong.
    const Observation run = programs::observed(
        programs::scene({{.position = {-1, 0}}, {.position = {1, 0}}}, {0, -9.81}), 0.5,
        [](programs::Circles &, double) {});
    std::set<QString> names;
    std::size_t faults = 0;
    for (const KindInfo &kind : checkKinds()) {
        QVERIFY2(names.insert(kind.name).second, qPrintable(kind.name));
        QVERIFY2(kind.circles == 1 || kind.circles == 2, qPrintable(kind.name));
        const CheckSpec check =
            programs::check(qPrintable(kind.name),
                            kind.circles == 2 ? std::vector<int>{0, 1} : std::vector<int>{0});
        const std::optional<Fault> fault = judge(check, run);
        QVERIFY2(!fault || !fault->message.isEmpty(), qPrintable(kind.name));
        faults += fault ? 1 : 0;
    }
    QVERIFY(faults > 0 && faults < names.size());
}

void TestCheckKinds::everyParameterIsDescribed_data()
{
    QTest::addColumn<bool>("scenes");
    QTest::newRow("checks") << false;
    QTest::newRow("scenes") << true;
}

void TestCheckKinds::everyParameterIsDescribed()
{
    QFETCH(bool, scenes);
    for (const KindInfo &kind : scenes ? sceneKinds() : checkKinds()) {
        QVERIFY2(!kind.title.isEmpty() && !kind.purpose.isEmpty(), qPrintable(kind.name));
        std::set<QString> names;
        for (const ParameterInfo &p : kind.parameters) {
            const QByteArray place = (kind.name + QLatin1Char('.') + p.name).toUtf8();
            QVERIFY2(!p.label.isEmpty() && !p.help.isEmpty(), place);
            QVERIFY2(names.insert(p.name).second, place);
            QVERIFY2(p.least.has_value() == p.most.has_value(), place);
            QVERIFY2(!p.least || *p.least < *p.most, place);
            const bool chosen =
                p.type == ParameterInfo::Type::Choice || p.type == ParameterInfo::Type::Choices;
            QCOMPARE(p.choices.isEmpty(), !chosen);
            QVERIFY2(!p.required || p.standard.isUndefined(), place);
        }
    }
}

void TestCheckKinds::theShippedLabUsesWhatTheCatalogueHas()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    const auto kinds = checkKinds();
    const auto scenes = sceneKinds();
    for (const Task &task : lab->tasks) {
        for (const CheckSpec &check : task.checks) {
            const KindInfo *kind = findKind(kinds, check.kind);
            QVERIFY2(kind, qPrintable(check.kind));
            for (const QString &key : check.parameters.keys())
                QVERIFY2(findParameter(*kind, key), qPrintable(task.id + check.id + key));
            const KindInfo *scene =
                findKind(scenes, check.scene.value(QStringLiteral("kind")).toString());
            QVERIFY(scene);
            for (const QString &key : check.scene.keys())
                QVERIFY2(key == QLatin1String("kind") || findParameter(*scene, key),
                         qPrintable(task.id + check.id + key));
        }
    }
}

QTEST_GUILESS_MAIN(TestCheckKinds)
#include "test_check_kinds.moc"

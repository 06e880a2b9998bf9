// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/check_library.h"
#include "tasks/reading/lab_reader.h"

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
    std::set<QString> names;
    for (const KindInfo &kind : checkKinds()) {
        QVERIFY2(isCheckKind(kind.name), qPrintable(kind.name));
        QVERIFY2(names.insert(kind.name).second, qPrintable(kind.name));
        QVERIFY2(kind.circles == 1 || kind.circles == 2, qPrintable(kind.name));
    }
    QCOMPARE(names.size(), checkKindNames().size());
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

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/parameter_text.h"
#include "views/author/text_names.h"

#include "tasks/reading/lab_reader.h"
#include "tests/gui/open_inspector.h"

#include <QJsonArray>

using namespace cradle;

/// What an author types: names in texts, values in forms; and what a student meets of locks.
class TestAuthorTexts : public QObject
{
    Q_OBJECT
private slots:
    void unknownNamesAreFound_data();
    void unknownNamesAreFound();
    void shippedTextsNameWhatThereIs();
    void valuesAreReadAsTheyAreShown_data();
    void valuesAreReadAsTheyAreShown();
    void expressionsAreValues();
    void otherTextsAreNoValues_data();
    void otherTextsAreNoValues();
    void lockedFieldsCannotBeEdited();
};

void TestAuthorTexts::unknownNamesAreFound_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("names");
    const auto row = [](const char *text, const QStringList &names) {
        QTest::newRow(text) << QString::fromLatin1(text) << names;
    };
    row("Set `circle1.velocity` in `on_load`.", {});
    row("Set `circle3.velocity`.", {QStringLiteral("circle3.velocity")});
    row("Set `circle1.velocitty`.", {QStringLiteral("circle1.velocitty")});
    row("`bounce()` and `jump()`", {QStringLiteral("jump()")});
    row("an expression: `a + unknown * 2`", {});
    row("```\nunknown_here\n`also_here`\n```", {});
    row("`one_x` then\nline two `two_x`", {QStringLiteral("one_x"), QStringLiteral("two_x")});
}

void TestAuthorTexts::unknownNamesAreFound()
{
    QFETCH(const QString, text);
    QFETCH(const QStringList, names);
    Task task;
    task.preset = inspectedScene();
    task.solution = QStringLiteral("local function bounce() end");
    QStringList found;
    for (const UnknownName &name : unknownNames(text, textNames(task))) {
        QCOMPARE(text.mid(name.start, name.length), name.name);
        QCOMPARE(name.line, text.left(name.start).count(QLatin1Char('\n')) + 1);
        found.append(name.name);
    }
    QCOMPARE(found, names);
}

/// A warning that cries wolf is not read.
void TestAuthorTexts::shippedTextsNameWhatThereIs()
{
    for (const QString &language : {QStringLiteral("en"), QStringLiteral("de")}) {
        const Result<Lab> lab = readLab(QLatin1String(shippedLab), language);
        QVERIFY(lab.ok());
        for (const Task &task : lab->tasks) {
            QStringList found;
            for (const UnknownName &name : unknownNames(task.instructions, textNames(task)))
                found.append(name.name);
            QVERIFY2(found.isEmpty(),
                     qPrintable(task.id + found.join(QStringLiteral(", ")) + language));
        }
    }
}

namespace {

ParameterInfo info(ParameterInfo::Type type)
{
    ParameterInfo made;
    made.name = QStringLiteral("value");
    made.label = QStringLiteral("Value");
    made.type = type;
    made.least = -10.0;
    made.most = 10.0;
    return made;
}

} // namespace

void TestAuthorTexts::valuesAreReadAsTheyAreShown_data()
{
    using Type = ParameterInfo::Type;
    QTest::addColumn<ParameterInfo::Type>("type");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QJsonValue>("value");
    QTest::newRow("number") << Type::Number << QStringLiteral("0.5") << QJsonValue(0.5);
    QTest::newRow("fraction") << Type::Number << QStringLiteral("1/30") << QJsonValue(1.0 / 30.0);
    QTest::newRow("fractions") << Type::Numbers << QStringLiteral("1/60, 0.02, 1/3")
                               << QJsonValue(QJsonArray{1.0 / 60.0, 0.02, 1.0 / 3.0});
    QTest::newRow("count") << Type::Count << QStringLiteral("3") << QJsonValue(3);
    QTest::newRow("vector") << Type::Vector << QStringLiteral("2, -1")
                            << QJsonValue(QJsonArray{2, -1});
    QTest::newRow("range") << Type::Range << QStringLiteral("0.5, 2")
                           << QJsonValue(QJsonArray{0.5, 2});
    QTest::newRow("numbers") << Type::Numbers << QStringLiteral("0, 0.5, 1")
                             << QJsonValue(QJsonArray{0, 0.5, 1});
    QTest::newRow("vectors") << Type::Vectors << QStringLiteral("2, 0; 0, 0")
                             << QJsonValue(QJsonArray{QJsonArray{2, 0}, QJsonArray{0, 0}});
    QTest::newRow("short fraction")
        << Type::Number << QStringLiteral("1/20") << QJsonValue(QStringLiteral("{{1/20}}"));
    QTest::newRow("expression") << Type::Number << QStringLiteral("1 + 0.42*cos(pi/6)")
                                << QJsonValue(QStringLiteral("{{1 + 0.42*cos(pi/6)}}"));
    QTest::newRow("of a value") << Type::Number << QStringLiteral("{{2*k}}")
                                << QJsonValue(QStringLiteral("{{2*k}}"));
    QTest::newRow("two expressions")
        << Type::Vector << QStringLiteral("max(1, 2), -1/4")
        << QJsonValue(QJsonArray{QStringLiteral("{{max(1, 2)}}"), QStringLiteral("{{-1/4}}")});
    QTest::newRow("turned round") << Type::Number << QStringLiteral("-2/3")
                                  << QJsonValue(-2.0 / 3.0);
    QTest::newRow("left out") << Type::Number << QString() << QJsonValue(QJsonValue::Undefined);
    QTest::newRow("script") << Type::Script << QStringLiteral("rises.lua")
                            << QJsonValue(QStringLiteral("rises.lua"));
}

void TestAuthorTexts::valuesAreReadAsTheyAreShown()
{
    QFETCH(const ParameterInfo::Type, type);
    QFETCH(const QString, text);
    QFETCH(const QJsonValue, value);
    const Result<QJsonValue> read = parameterFromText(info(type), text);
    QVERIFY(read.ok());
    QCOMPARE(*read, value);
    QCOMPARE(textOfParameter(info(type), value), text);
}

/// Expressions have spaces, commas and units; lists may be written with spaces alone.
void TestAuthorTexts::expressionsAreValues()
{
    using Type = ParameterInfo::Type;
    const auto read = [](Type type, const char *text) {
        ParameterInfo made = info(type);
        made.unit = QStringLiteral("m/s");
        return parameterFromText(made, QString::fromUtf8(text));
    };
    QCOMPARE(*read(Type::Number, "7.0"), QJsonValue(7.0));
    QCOMPARE(*read(Type::Number, "36 km/h - 8 m/s"), QJsonValue(2.0));
    QCOMPARE(*read(Type::Vector, "2, 36 km/h"), QJsonValue(QJsonArray{2, 10}));
    QCOMPARE(*read(Type::Vector, "2 -1"), QJsonValue(QJsonArray{2, -1}));
    QCOMPARE(*read(Type::Numbers, "1 2 3"), QJsonValue(QJsonArray{1, 2, 3}));
    QVERIFY(!read(Type::Count, "5/2").ok());
    QVERIFY(!read(Type::Number, "2 s").ok());
    QVERIFY(!read(Type::Number, "1 2").ok());
}

void TestAuthorTexts::otherTextsAreNoValues_data()
{
    using Type = ParameterInfo::Type;
    QTest::addColumn<ParameterInfo::Type>("type");
    QTest::addColumn<QString>("text");
    QTest::newRow("word") << Type::Number << QStringLiteral("two");
    QTest::newRow("two numbers") << Type::Number << QStringLiteral("1, 2");
    QTest::newRow("too much") << Type::Number << QStringLiteral("11");
    QTest::newRow("too little") << Type::Vector << QStringLiteral("0, -11");
    QTest::newRow("half a count") << Type::Count << QStringLiteral("1.5");
    QTest::newRow("one of a vector") << Type::Vector << QStringLiteral("1");
    QTest::newRow("three of a range") << Type::Range << QStringLiteral("1, 2, 3");
    QTest::newRow("infinite") << Type::Number << QStringLiteral("inf");
    QTest::newRow("division by zero") << Type::Number << QStringLiteral("1/0");
    QTest::newRow("odd vectors") << Type::Vectors << QStringLiteral("1, 2; 3");
}

void TestAuthorTexts::otherTextsAreNoValues()
{
    QFETCH(const ParameterInfo::Type, type);
    QFETCH(const QString, text);
    const Result<QJsonValue> read = parameterFromText(info(type), text);
    QVERIFY(!read.ok());
    QVERIFY(read.error().message.contains(QStringLiteral("Value")));
}

void TestAuthorTexts::lockedFieldsCannotBeEdited()
{
    OpenInspector open;
    open.document.open(open.preset());
    open.document.setLocked({QStringLiteral("gravity"), QStringLiteral("laws/timing"),
                             QStringLiteral("circles"), QStringLiteral("circles/1/mass")});
    QVERIFY(open.show());
    QVERIFY(!open.field(QStringLiteral("Gravity upward"))->isEnabled());
    QVERIFY(open.field(QStringLiteral("Gravity upward"))
                ->toolTip()
                .contains(QStringLiteral("gravity")));
    QVERIFY(open.field(QStringLiteral("Timestep"))->isEnabled());
    QVERIFY(!open.law(QStringLiteral("Timing"))->isEnabled());
    QVERIFY(!open.button(QStringLiteral("Add circle"))->isEnabled());
    const QAbstractItemModel *model = open.table()->model();
    QVERIFY(!model->flags(model->index(0, 6)).testFlag(Qt::ItemIsEditable)); // radius
    QVERIFY(model->flags(model->index(1, 6)).testFlag(Qt::ItemIsEditable));

    // By whatever way, with the reason.
    Preset changed = open.preset();
    changed.gravity.y = -1.0;
    QVERIFY(!open.document.edit(QStringLiteral("edit"), changed));
    QVERIFY(open.says(QStringLiteral("Fixed in this step: gravity")));
    QCOMPARE(open.preset().gravity.y, 0.0);
    changed = open.preset();
    changed.circles[1].body.radius = 0.3;
    QVERIFY(open.document.edit(QStringLiteral("edit"), changed));
}

QTEST_MAIN(TestAuthorTexts)
#include "test_author_texts.moc"

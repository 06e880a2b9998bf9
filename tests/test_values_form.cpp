// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab_with_values.h"
#include "tasks/authoring/values_form.h"

#include <QTest>

using namespace cradle;

/// The named values of a lab and its steps as a form edits them.
class TestValuesForm : public QObject
{
    Q_OBJECT
private slots:
    void whatIsWrittenIsReadBack();
    void numbersAreWrittenAsNumbers();
    void noneLeavesNothingBehind();
    void rangesAreCounted_data();
    void rangesAreCounted();
    void numbersOfARangeAreThoseThatAreDrawn();
    void faultIsThatOfTheValue();
    void usesAreFound_data();
    void usesAreFound();
    void valueOfAStepHidesThatOfTheLab();
    void drawIsKept();
};

namespace {

const QString step = QStringLiteral("S1");
const ValueForm number{.name = QStringLiteral("a"), .expression = QStringLiteral("2.5")};
const ValueForm made{.name = QStringLiteral("b"), .expression = QStringLiteral("2*a")};
const ValueForm drawn{
    .name = QStringLiteral("c"), .drawn = true, .from = 0.6, .to = 0.9, .step = 0.05};

QJsonObject jsonIn(const LabFiles &files, const char *path)
{
    return QJsonDocument::fromJson(files.contents.value(QLatin1String(path))).object();
}

} // namespace

void TestValuesForm::whatIsWrittenIsReadBack()
{
    const std::vector<ValueForm> all{number, made, drawn};
    const LabFiles files = labWith({});
    QVERIFY(valueForms(files, {}).empty() && valueForms(files, step).empty());
    for (const QString &where : {QString(), step}) {
        const auto written = withValueForms(files, where, {drawn, made, number});
        QVERIFY(written.ok());
        QVERIFY(valueForms(*written, where) == all); // by the alphabet
        QVERIFY(valueForms(*written, where.isEmpty() ? step : QString()).empty());
    }
}

void TestValuesForm::numbersAreWrittenAsNumbers()
{
    ValueForm odd = number;
    odd.expression = QStringLiteral("inf");
    for (const auto &[form, isNumber] :
         {std::pair(number, true), std::pair(made, false), std::pair(odd, false)}) {
        const auto written = withValueForms(labWith({}), {}, {form});
        QVERIFY(written.ok());
        const QJsonValue value = jsonIn(*written, "lab.json")
                                     .value(QStringLiteral("values"))
                                     .toObject()
                                     .value(form.name);
        QCOMPARE(value.isDouble(), isNumber);
        QCOMPARE(value.isString(), !isNumber);
        QVERIFY(valueForms(*written, {}) == std::vector<ValueForm>{form});
    }
}

void TestValuesForm::noneLeavesNothingBehind()
{
    const auto written = withValueForms(labWith({}), step, {number});
    QVERIFY(jsonIn(*written, "S1/task.json").contains(QStringLiteral("values")));
    const auto without = withValueForms(*written, step, {});
    QVERIFY(!jsonIn(*without, "S1/task.json").contains(QStringLiteral("values")));
}

void TestValuesForm::rangesAreCounted_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<double>("apart");
    QTest::addColumn<int>("count");
    QTest::newRow("seven") << 0.6 << 0.9 << 0.05 << 7;
    QTest::newRow("one") << 2.0 << 2.0 << 0.1 << 1;
    QTest::newRow("the last beyond the end") << 0.0 << 1.0 << 0.3 << 4;
    QTest::newRow("downward") << 1.0 << 0.5 << 0.1 << 0;
    QTest::newRow("without a step") << 0.0 << 1.0 << 0.0 << 0;
    QTest::newRow("backward") << 0.0 << 1.0 << -0.1 << 0;
    QTest::newRow("backward from above") << 1.0 << 0.0 << -0.1 << 0;
    QTest::newRow("a million") << 0.0 << 999999.0 << 1.0 << 1000000;
    QTest::newRow("more") << 0.0 << 1000000.0 << 1.0 << 0;
}

void TestValuesForm::rangesAreCounted()
{
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(double, apart);
    QFETCH(int, count);
    ValueForm form{
        .name = QStringLiteral("k"), .drawn = true, .from = from, .to = to, .step = apart};
    QCOMPARE(countOf(form), count);
    QCOMPARE(numbersOf(form, 3).size(), std::size_t(std::min(count, 3)));
    form.drawn = false;
    QCOMPARE(countOf(form), 0);
    QVERIFY(numbersOf(form, 3).empty());
}

/// To the last digit: 0.6 + 3 · 0.05 is 0.75.
void TestValuesForm::numbersOfARangeAreThoseThatAreDrawn()
{
    QCOMPARE(numbersOf(drawn, 100), (std::vector<double>{0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9}));
    QCOMPARE(numbersOf(drawn, 2), (std::vector<double>{0.6, 0.65}));
    const LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    for (int student = 0; student < 20; ++student) {
        const double is = k(files, QString::number(student));
        const auto all = numbersOf(valueForms(files, {}).front(), 100);
        QVERIFY(std::find(all.begin(), all.end(), is) != all.end());
    }
}

void TestValuesForm::faultIsThatOfTheValue()
{
    LabFiles files = labWith(values({{QStringLiteral("a"), QStringLiteral("nobody")},
                                     {QStringLiteral("b"), 2.0},
                                     {QStringLiteral("pi"), 3.0}}));
    edit(files, "S1/task.json", [](QJsonObject &task) {
        task.insert(QStringLiteral("values"),
                    QJsonObject{{QStringLiteral("b"), QStringLiteral("1/")}});
    });
    QVERIFY(faultOfValue(files, {}, QStringLiteral("a")).contains(QLatin1String("nobody")));
    QVERIFY(faultOfValue(files, {}, QStringLiteral("b")).isEmpty());
    QVERIFY(faultOfValue(files, {}, QStringLiteral("pi")).contains(QLatin1String("a name")));
    QVERIFY(!faultOfValue(files, step, QStringLiteral("b")).isEmpty());
    QVERIFY(faultOfValue(files, step, QStringLiteral("a")).isEmpty()); // that of the lab
}

void TestValuesForm::usesAreFound_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("used"); // the value called g
    const auto row = [](const char *name, const char *file, const char *text, bool used) {
        QTest::newRow(name) << QString::fromUtf8(file) << QString::fromUtf8(text) << used;
    };
    row("between braces", "S1/instructions.md", "By {{g}} m/s².", true);
    row("in an expression", "S1/instructions.md", "Twice {{2*g + 1}}.", true);
    row("a word of the text", "S1/instructions.md", "The g of {{gravity}}.", false);
    row("part of a name", "S1/instructions.md", "{{g2}} {{_g}} {{ag}}", false);
    row("over two lines", "S1/instructions.md", "{{\ng\n}}", false);
    row("in a program", "S1/solution.lua", "local a = {{g}}", true);
    row("its own name there", "S1/solution.lua", "local g = \"g\"", false);
    row("in a scene", "S1/preset.json", "{\"restitution\": \"g / 2\"}", true);
    row("a key of a scene", "S1/preset.json", "{\"g\": 2}", false);
    row("a circle's name", "S1/preset.json", "{\"name\": \"g\", \"radius\": 1}", false);
    row("a circle's name, close", "S1/preset.json", "{\"name\":\"g\",\"radius\":1}", false);
    row("no scene", "S1/other.json", "{\"restitution\": \"g / 2\"}", false);
    row("like a scene", "S1/preset.md", "\"g\"", false);
}

void TestValuesForm::usesAreFound()
{
    QFETCH(QString, file);
    QFETCH(QString, text);
    QFETCH(bool, used);
    LabFiles files = labWith(values({{QStringLiteral("g"), 9.81}}));
    files.contents[file] = text.toUtf8();
    const QStringList expected = used ? QStringList{file} : QStringList{};
    QCOMPARE(filesUsing(files, {}, QStringLiteral("g")), expected);
    QCOMPARE(filesUsing(files, step, QStringLiteral("g")), expected);
    QVERIFY(filesUsing(files, QStringLiteral("S2"), QStringLiteral("g")).isEmpty());
}

void TestValuesForm::valueOfAStepHidesThatOfTheLab()
{
    LabFiles files = labWith(
        values({{QStringLiteral("g"), 9.81}, {QStringLiteral("h"), QStringLiteral("g / 2")}}),
        "# By {{g}}\n");
    const QStringList all{QStringLiteral("S1/instructions.md"), QStringLiteral("lab.json")};
    QCOMPARE(filesUsing(files, {}, QStringLiteral("g")), all);
    QVERIFY(filesUsing(files, {}, QStringLiteral("h")).isEmpty());
    edit(files, "S1/task.json", [](QJsonObject &task) {
        task.insert(
            QStringLiteral("values"),
            QJsonObject{{QStringLiteral("g"), 1.62}, {QStringLiteral("k"), QStringLiteral("g^2")}});
    });
    QCOMPARE(filesUsing(files, {}, QStringLiteral("g")), QStringList{QStringLiteral("lab.json")});
    QCOMPARE(filesUsing(files, step, QStringLiteral("g")),
             (QStringList{QStringLiteral("S1/instructions.md"), QStringLiteral("S1/task.json")}));
}

void TestValuesForm::drawIsKept()
{
    const LabFiles files = labWith({});
    QVERIFY(drawOf(files).isEmpty());
    const auto written = withDraw(files, QStringLiteral("autumn"));
    QCOMPARE(drawOf(*written), QStringLiteral("autumn"));
    const auto without = withDraw(*written, {});
    QVERIFY(!jsonIn(*without, "lab.json").contains(QStringLiteral("draw")));
}

QTEST_GUILESS_MAIN(TestValuesForm)
#include "test_values_form.moc"

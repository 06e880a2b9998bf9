// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/formula_text.h"

#include <QTest>

#include <initializer_list>

using cradle::findFormulas;

class TestFormulaText : public QObject
{
    Q_OBJECT

private slots:
    void findsFormulas_data();
    void findsFormulas();
    void findsWhatTouchesAnIsolate();
    void findsTheUnitOfAFormula();
};

void TestFormulaText::findsFormulas_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QStringList>("formulas"); // as TeX, "D " before those on their own line
    const auto row = [](const char *name, const char *markdown,
                        std::initializer_list<const char *> formulas) {
        QStringList list;
        for (const char *formula : formulas)
            list += QString::fromUtf8(formula);
        QTest::newRow(name) << QString::fromUtf8(markdown) << list;
    };
    row("inline", "the $p_x$ and $p_y$.", {"p_x", "p_y"});
    row("display", "so\n$$\na = b\n$$\nthen", {"D a = b"});
    row("prices", "$5 and $6", {});
    row("digit after", "$5 or US$20", {});
    row("space after opening", "a $ x$ b", {});
    row("space before closing", "a $x $ b", {});
    row("escaped", "\\$x$ and \\$y\\$", {});
    row("dollar within", "$a \\$ b$", {"a \\$ b"});
    row("code span", "`$a$` and ``x ` $b$``", {});
    row("unmatched backtick", "a ` and $x$", {"x"});
    row("fenced block", "```lua\n$a$\n```\n$b$", {"b"});
    row("tilde block", "~~~\n$a$\n```\n$b$\n~~~\n$c$", {"c"});
    row("open block", "```\n$a$\n", {});
    row("block in list", "- x\n\n  ```\n  $a$\n  ```\n", {});
    row("two paragraphs", "a $x\n\ny$ b", {});
    row("two lines", "a $x\n+ y$ b", {"x\n+ y"});
    row("no end", "$$ a", {});
    row("isolate", "قيمة \u2066$x$\u2069، و\u2066$y_1$\u2069.", {"x", "y_1"});
    row("isolate with a unit", "عند \u2066$x = 2$ m\u2069، ثم", {"x = 2"});
    row("nothing inside", "$$$$ and $$ $$", {});
}

void TestFormulaText::findsFormulas()
{
    QFETCH(QString, markdown);
    QFETCH(QStringList, formulas);
    const cradle::FormulaText text = findFormulas(markdown);
    QStringList found;
    for (const cradle::FormulaSource &formula : text.formulas)
        found += formula.display ? QStringLiteral("D ") + formula.tex : formula.tex;
    QCOMPARE(found, formulas);

    QString restored = text.markdown;
    for (size_t i = 0; i < text.formulas.size(); ++i) {
        const QString mark = QChar(0xE000) + QString::number(i) + QChar(0xE001);
        restored.replace(mark, text.formulas[i].markdown);
    }
    QCOMPARE(restored, markdown);
}

/// No line may break between an Arabic "and" and its formula, nor between that and a comma.
void TestFormulaText::findsWhatTouchesAnIsolate()
{
    const cradle::FormulaText text = findFormulas(
        QStringLiteral("قيمة و\u2066$x$\u2069، ثم (\u2066$y$\u2069) عند \u2066$z$ m\u2069."));
    QCOMPARE(text.formulas.size(), size_t(3));
    QCOMPARE(text.formulas[0].before, QStringLiteral("و"));
    QCOMPARE(text.formulas[0].after, QStringLiteral("،"));
    QVERIFY(text.formulas[0].fromRight);
    QCOMPARE(text.formulas[1].before, QStringLiteral("("));
    QCOMPARE(text.formulas[1].after, QStringLiteral(")"));
    QCOMPARE(text.formulas[2].before, QString()); // its unit needs the isolate
    QVERIFY(!text.formulas[2].fromRight);
}

/// No line may break there: a picture ends a line whatever space follows it.
void TestFormulaText::findsTheUnitOfAFormula()
{
    const cradle::FormulaText text = findFormulas(
        QStringLiteral("to $g$ m/s², $v$ m/s. Then $p$ kg m/s; $t$ seconds, $n$ stones, $x$ m"));
    QStringList after;
    for (const cradle::FormulaSource &formula : text.formulas)
        after += formula.after;
    QCOMPARE(after,
             QStringList({QStringLiteral(" m/s²,"), QStringLiteral(" m/s."),
                          QStringLiteral(" kg m/s;"), QString(), QString(), QStringLiteral(" m")}));
}

QTEST_MAIN(TestFormulaText)
#include "test_formula_text.moc"

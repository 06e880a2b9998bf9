// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/formula_text.h"

#include <QTest>

#include <initializer_list>

using cradle::findFormulas;

class TestFormulaText : public QObject
{
    Q_OBJECT

private slots:
    void findsFormulas_data();
    void findsFormulas();
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

QTEST_MAIN(TestFormulaText)
#include "test_formula_text.moc"

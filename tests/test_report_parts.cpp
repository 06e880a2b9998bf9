// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/change_table.h"
#include "tasks/lab_report/markdown_html.h"
#include "tasks/lab_report/set_formulas.h"

#include <QTest>

using namespace cradle;

/// The parts of a report that are text: changes, notes and formulas as HTML and JSON.
class TestReportParts : public QObject
{
    Q_OBJECT
private slots:
    void changedLinesAreMarked();
    void longChangesEnd();
    void notesBecomeHtml_data();
    void notesBecomeHtml();
    void formulasAreSet();
    void formulasAreReadBack();
    void whatIsNoFormulaIsLeftOut();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

} // namespace

void TestReportParts::changedLinesAreMarked()
{
    using Kind = DiffLine::Kind;
    const DiffHunk one{.lines = {{Kind::Same, text("\tif a < b then"), 1, 1},
                                 {Kind::Removed, text("  x = 1"), 2, 0},
                                 {Kind::Added, text("  x = 2"), 0, 2}}};
    const DiffHunk two{.lines = {{Kind::Same, text("end"), 9, 9}}};
    const QString table = changeTable({one, two});
    const QString space(QChar::Nbsp);
    QVERIFY(table.contains(text("<tr class=\"same\"><td class=\"number\" width=\"28\">1</td>"
                                "<td width=\"12\"></td><td>")
                           + space.repeated(4) + text("if a &lt; b then</td></tr>")));
    QVERIFY(table.contains(text("<tr class=\"removed\"><td class=\"number\" width=\"28\"></td>"
                                "<td width=\"12\">−</td><td>")
                           + space.repeated(2) + text("x = 1</td>")));
    QVERIFY(table.contains(text("<tr class=\"added\"><td class=\"number\" width=\"28\">2</td>"
                                "<td width=\"12\">+</td><td>")
                           + space.repeated(2) + text("x = 2</td>")));
    // Between two places that changed, and not before the first.
    QCOMPARE(table.count(text("⋮")), 1);
    QVERIFY(table.indexOf(text("⋮")) > table.indexOf(text("x = 2")));
    QVERIFY(table.indexOf(text("⋮")) < table.indexOf(text("end")));
    QVERIFY(table.startsWith(text("<table ")) && table.endsWith(text("</table>")));
    QVERIFY(!changeTable({}).contains(text("<tr")));
}

void TestReportParts::longChangesEnd()
{
    DiffHunk most;
    most.lines.assign(1500, {DiffLine::Kind::Added, text("x"), 0, 1});
    QCOMPARE(changeTable({most}).count(text("<tr")), 1500);
    const DiffHunk one{.lines = {{DiffLine::Kind::Added, text("y"), 0, 2}}};
    const QString table = changeTable({most, one, one});
    QCOMPARE(table.count(text("<tr")), 1501);
    QVERIFY(table.contains(text("which no page holds")));
    QVERIFY(!table.contains(text("<td>y</td>")));
}

void TestReportParts::notesBecomeHtml_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QString>("html"); // without ends of lines
    const auto row = [](const char *markdown, const char *html) {
        QTest::newRow(markdown) << text(markdown) << text(html);
    };
    row("One\ntwo\n\nthree", "<p>One two</p><p>three</p>");
    row("## A *title*\ntext", "<h4>A <i>title</i></h4><p>text</p>");
    row("####### no title", "<p>####### no title</p>");
    row("#none", "<p>#none</p>");
    row("- a\n* b\n+ c\nd", "<ul><li>a</li><li>b</li><li>c</li></ul><p>d</p>");
    row("1. a\n2) b\n- c", "<ol><li>a</li><li>b</li></ol><ul><li>c</li></ul>");
    row("text\n- a", "<p>text</p><ul><li>a</li></ul>");
    row("a **b c** d", "<p>a <b>b c</b> d</p>");
    row("a _b_ *c d*", "<p>a <i>b</i> <i>c d</i></p>");
    row("snake_case_name 2*3*4", "<p>snake_case_name 2*3*4</p>");
    row("* a *b* *", "<ul><li>a <i>b</i> *</li></ul>");
    row("see `a*b*c` and `open", "<p>see <code>a*b*c</code> and `open</p>");
    row("```lua\nx < 1\n\n- y\n```\nz", "<pre>x &lt; 1- y</pre><p>z</p>");
    row("```\nopen", "<pre>open</pre>");
    row("<b>&amp;</b> [a](http://b) ![c](d)",
        "<p>&lt;b&gt;&amp;amp;&lt;/b&gt; [a](http://b) ![c](d)</p>");
    row("", "");
}

void TestReportParts::notesBecomeHtml()
{
    QFETCH(QString, markdown);
    QFETCH(QString, html);
    QCOMPARE(markdownHtml(markdown).remove(QLatin1Char('\n')), html);
}

void TestReportParts::formulasAreSet()
{
    const FormulaHtml formula = [](const QString &tex, bool display) {
        return tex == QLatin1String("no") ? QString()
                                          : (display ? text("[%1]") : text("{%1}")).arg(tex);
    };
    QCOMPARE(markdownHtml(text("By $v$ and $no$ <b>."), formula).trimmed(),
             text("<p>By {v} and no &lt;b&gt;.</p>"));
    QCOMPARE(markdownHtml(text("First\n\n$$E = m$$\n\nlast"), formula).remove(QLatin1Char('\n')),
             text("<p>First</p><p align=\"center\">[E = m]</p><p>last</p>"));
}

void TestReportParts::formulasAreReadBack()
{
    const std::vector<ReportFormula> all{{text("v"), false}, {text("\\frac{1}{2}"), true}};
    QVERIFY(formulasFrom(textOf(all)) == all);
    QVERIFY(formulasFrom("nonsense").empty());
    const SetFormulas set{{all[0], {"<svg a", 1.0, 2.0, 0.5}}, {all[1], {"<svg b", 3.0, 4.0, 0.0}}};
    QVERIFY(setFormulasFrom(textOf(set)) == set);
}

/// What a stranger's process tells is a picture with a size, or nothing.
void TestReportParts::whatIsNoFormulaIsLeftOut()
{
    const ReportFormula name{text("v"), false};
    const SetFormula right{"<svg >", 1.0, 1.0, 0.0};
    QCOMPARE(setFormulasFrom(textOf(SetFormulas{{name, right}})).size(), std::size_t{1});
    for (const SetFormula &wrong :
         {SetFormula{"<script>", 1.0, 1.0, 0.0}, SetFormula{" <svg >", 1.0, 1.0, 0.0},
          SetFormula{"<svg >", 0.0, 1.0, 0.0}, SetFormula{"<svg >", 1.0, 0.0, 0.0},
          SetFormula{"<svg >", -1.0, 1.0, 0.0}})
        QVERIFY(setFormulasFrom(textOf(SetFormulas{{name, wrong}})).empty());
}

QTEST_GUILESS_MAIN(TestReportParts)
#include "test_report_parts.moc"

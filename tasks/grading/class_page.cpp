// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_page.h"

#include "tasks/grading/class_page_parts.h"
#include "tasks/grading/page.h"

#include <QCoreApplication>
#include <QLocale>

#include <numeric>

namespace cradle {

namespace {

struct ClassPageText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr std::size_t mostNumbers = 200; ///< that are told one by one
constexpr qsizetype mostTold = 10;       ///< with one number

const QString style = QStringLiteral(R"css(
:root { --heat: #e8590c; --bar-good: #69b57a; --bar-open: #f0a35e; --bar-quiet: #dee2e6;
  --bar-trouble: #d6616b; --bar-ink: #212529; }
@media (prefers-color-scheme: dark) { :root { --heat: #d9480f; --bar-good: #2f7d43;
  --bar-open: #a85a17; --bar-quiet: #3b4248; --bar-trouble: #a13a45; --bar-ink: #f1f3f5; } }
@media print { :root { --heat: #e8590c; --bar-good: #69b57a; --bar-open: #f0a35e;
  --bar-quiet: #dee2e6; --bar-trouble: #d6616b; --bar-ink: #212529; }
  @page { size: A4 landscape; margin: 12mm; } .met > li > details:not([open]) { display: none; } .wide { overflow: visible; } .heat { break-inside: avoid; }
  .who { font-size: 7.5pt; } .who td, .who th { padding: .1rem .2rem; } }
body { max-width: 76rem; }
.facts { display: flex; flex-wrap: wrap; gap: .75rem 2.5rem; margin: 1rem 0; padding: 0;
  list-style: none; }
.facts span { display: block; color: var(--muted); font-size: .875rem; }
.facts b { font-size: 1.5rem; font-weight: 600; line-height: 1.2; }
.wide { overflow-x: auto; }
.stand text { font: 13px Inter, "DejaVu Sans", sans-serif; fill: var(--ink); }
.stand .in { fill: var(--bar-ink); font-size: 12px; text-anchor: middle; }
.stand .p, .key .p { fill: var(--bar-good); } .stand .f, .key .f { fill: var(--bar-open); }
.stand .m, .key .m { fill: var(--bar-quiet); } .stand .n, .key .n { fill: var(--bar-trouble); }
.key { color: var(--muted); font-size: .875rem; } .key svg { vertical-align: -.1em; margin-inline-start: 1rem; }
.key svg:first-child { margin-inline-start: 0; }
.who { font-size: .875rem; } .who td { text-align: center; padding: .1rem .35rem; }
.who th { padding: .15rem .35rem; } .who thead th { text-align: center; position: sticky; top: 0;
  background: var(--page); } .who tbody th { font-weight: 400; max-width: 18rem; }
.who thead th:first-child { text-align: start; }
.who .p { background: var(--good-back); color: var(--good); }
.who .f { background: var(--open-back); color: var(--open); }
.who .m { color: var(--muted); } .who .n { background: var(--trouble-back); color: var(--trouble);
  font-weight: 700; }
.heat td { text-align: center; min-width: 2.6rem; background: color-mix(in srgb, var(--heat) var(--part), var(--page)); }
.heat td:empty { background: none; } .heat thead th { text-align: center; }
.heat thead th:first-child { text-align: start; } .heat tbody th { font-weight: 400; white-space: nowrap; }
.met { padding-inline-start: 0; list-style: none; } .met > li { margin: .35rem 0; }
.met .count { display: inline-block; min-width: 3.2rem; font-weight: 600; text-align: end;
  margin-inline-end: .75rem; font-variant-numeric: tabular-nums; }
.met details { border: 0; margin: 0 0 .25rem; margin-inline-start: 3.95rem; padding: 0; }
.met summary { font-weight: 400; padding: 0; color: var(--link); font-size: .875rem; }
.pair { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 0 1rem; }
.pair pre { white-space: pre-wrap; }
@media screen and (max-width: 50rem) { .stand { overflow-x: auto; } .stand > svg { min-width: 40rem; } }
@media (max-width: 50rem) { .pair { grid-template-columns: minmax(0, 1fr); } }
)css");

void writeFacts(QString &html, const ClassSummary &summary, const ClassFacts &facts,
                std::size_t steps)
{
    double sum = 0.0;
    double most = 0.0;
    int counted = 0;
    int finished = 0;
    for (const ClassSummary::Row &row : summary.rows()) {
        most = row.points.most;
        finished += row.passed == static_cast<int>(steps);
        if (row.points.earned) {
            sum += *row.points.earned;
            ++counted;
        }
    }
    const auto fact = [&](const QString &name, const QString &value) {
        html += QStringLiteral("<li><span>%1</span><b>%2</b></li>\n").arg(escaped(name), value);
    };
    html += QStringLiteral("<ul class=\"facts\">\n");
    fact(ClassPageText::tr("handed in"), QString::number(summary.rows().size()));
    if (!facts.missing.empty())
        fact(ClassPageText::tr("handed in nothing"), QString::number(facts.missing.size()));
    fact(ClassPageText::tr("pass every step"), QString::number(finished));
    if (counted > 0)
        fact(ClassPageText::tr("points on average"),
             escaped(ClassPageText::tr("%1 of %2")
                         .arg(QLocale().toString(sum / counted, 'f', 1),
                              QLocale().toString(most, 'g', 8))));
    if (!summary.notGraded().empty())
        fact(ClassPageText::tr("steps not graded"),
             QString::number(std::transform_reduce(
                 summary.steps().begin(), summary.steps().end(), 0, std::plus<>(),
                 [](const ClassSummary::Step &step) { return step.notGraded; })));
    html += QStringLiteral("</ul>\n");
}

void writeNotGraded(QString &html, const ClassSummary &summary)
{
    if (summary.notGraded().empty())
        return;
    html += heading(ClassPageText::tr("Not graded"));
    html +=
        paragraph(ClassPageText::tr("Here no verdict could be reached. These steps count neither "
                                    "as passed nor as failed, and the gradebooks leave the points "
                                    "of their students empty."));
    html += QStringLiteral("<ul>\n");
    for (const ClassSummary::NotGraded &each : summary.notGraded())
        html += QStringLiteral("<li>%1, %2: %3</li>\n")
                    .arg(escapedName(each.name), escaped(each.taskId), escaped(each.reason));
    html += QStringLiteral("</ul>\n");
}

/// Whose number is whose, where values are drawn by it; it accuses nobody.
void writeNumbers(QString &html, const ClassSummary &summary)
{
    QString list;
    std::size_t count = 0;
    const auto item = [&](const QString &text) {
        if (++count <= mostNumbers)
            list += QStringLiteral("<li>%1</li>\n").arg(text);
    };
    for (const ClassSummary::OtherNumber &each : summary.otherNumbers())
        item(escaped(
                 ClassPageText::tr("%1: the roster has %2, what was handed in has %3; judged with "
                                   "the values of %2."))
                 .arg(escapedName(each.name), escapedName(each.drawnBy),
                      escapedName(each.handedIn)));
    for (const auto &[number, names] : summary.handedNumbers()) {
        if (names.size() < 2)
            continue;
        QStringList all;
        for (const QString &name : names.mid(0, mostTold))
            all.append(escapedName(name));
        if (names.size() > mostTold)
            all.append(QStringLiteral("…"));
        item(escaped(ClassPageText::tr("%1 stands in what several handed in: %2."))
                 .arg(escapedName(number), all.join(QStringLiteral(", "))));
    }
    if (list.isEmpty())
        return;
    html += heading(ClassPageText::tr("Numbers that are not clear"));
    html +=
        paragraph(ClassPageText::tr("This lab draws values by a student's number: that of the "
                                    "roster, where it has one, else that of what was handed in. "
                                    "A mistyped number is likelier than anything else."));
    html += QStringLiteral("<ul>\n%1</ul>\n").arg(list);
    if (count > mostNumbers)
        html += paragraph(ClassPageText::tr("And %1 more.").arg(count - mostNumbers));
}

void writeMissing(QString &html, const ClassFacts &facts)
{
    if (facts.missing.empty())
        return;
    html += heading(ClassPageText::tr("Handed in nothing"));
    QStringList names;
    for (const MissingStudent &student : facts.missing)
        names.append(escapedName(student.name.isEmpty() ? student.id : student.name));
    html += QStringLiteral("<p>%1</p>\n").arg(names.join(QStringLiteral(" · ")));
}

void writeHow(QString &html, const Lab &lab, const ClassFacts &facts)
{
    html += heading(ClassPageText::tr("How it was judged"));
    html += QStringLiteral("<ul>\n");
    const auto item = [&](const QString &text) {
        html += QStringLiteral("<li>%1</li>\n").arg(escaped(text));
    };
    item(ClassPageText::tr("By %1, with version %2 of the lab %3 (sha256 %4).")
             .arg(facts.program.isEmpty() ? QStringLiteral("Cradle") : facts.program,
                  lab.version.isEmpty() ? QStringLiteral("?") : lab.version, lab.id, lab.hash));
    if (!facts.isolation.isEmpty())
        item(ClassPageText::tr("Programs were kept apart by: %1.").arg(facts.isolation));
    item(ClassPageText::tr(
        "A step is worth what the lab says, else the points of its checks; a check "
        "that passes brings its "
        "points also where others fail. Points are rounded to the hundredth, halves "
        "up, once, after all else."));
    const QLocale locale;
    if (facts.late.percentPerDay > 0.0)
        item(ClassPageText::tr(
                 "Each day late that has begun takes %1 % of the points, at most %2 %.")
                 .arg(locale.toString(facts.late.percentPerDay, 'g', 4),
                      locale.toString(facts.late.mostPercent, 'g', 4)));
    else
        item(ClassPageText::tr("Handing in late takes no points."));
    for (const QString &remark : facts.remarks)
        item(remark);
    html += QStringLiteral("</ul>\n");
}

} // namespace

QByteArray classPage(const ClassSummary &summary, const Lab &lab, const ClassFacts &facts)
{
    const QString title = facts.className.isEmpty() ? lab.title : facts.className;
    QString html =
        pageStart(QStringLiteral("%1 – %2").arg(title, lab.title), facts.language, style);
    html += QStringLiteral("<header>\n<h1>%1</h1>\n").arg(escaped(title));
    if (title != lab.title)
        html += paragraph(lab.title);
    html += QStringLiteral("</header>\n<main>\n");
    writeFacts(html, summary, facts, lab.tasks.size());
    writeNotGraded(html, summary);
    writeStand(html, summary);
    writeMisunderstandings(html, summary);
    writeChecks(html, summary);
    writeEffort(html, summary);
    writeAlike(html, summary);
    writeWho(html, summary);
    writeNumbers(html, summary);
    writeMissing(html, facts);
    writeHow(html, lab, facts);
    html += QStringLiteral("</main>\n");
    html += pageEnd(escaped(ClassPageText::tr("For the teacher alone: this page has names. What "
                                              "students read of themselves is in the folder "
                                              "students.")));
    return html.toUtf8();
}

} // namespace cradle

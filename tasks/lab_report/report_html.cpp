// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/report_html.h"

#include "tasks/lab_report/change_table.h"
#include "tasks/lab_report/markdown_html.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>
#include <QLocale>

namespace cradle {

namespace {

struct HtmlText {
    Q_DECLARE_TR_FUNCTIONS(LabReport)
};

// Tables and plain colours only: Qt's text documents print the same page.
const QString style = QStringLiteral(
    "body { font-family: Inter, 'DejaVu Sans', sans-serif; font-size: 10pt; color: #212529; "
    "background-color: #ffffff; }\n"
    "h1 { font-size: 20pt; } h2 { font-size: 14pt; } h3 { font-size: 10.5pt; }\n"
    "h2 { margin-bottom: 6px; } h3 { margin-top: 10px; margin-bottom: 3px; }\n"
    "p { margin-top: 5px; margin-bottom: 5px; } ul { margin-top: 3px; margin-bottom: 3px; }\n"
    "pre, code { font-family: 'JetBrains Mono', 'DejaVu Sans Mono', monospace; "
    "font-size: 8.5pt; }\n"
    "table { border-collapse: collapse; } td { vertical-align: top; }\n"
    ".muted { color: #5c636a; }\n"
    ".good { color: #2b8a3e; } .open { color: #a85100; }\n"
    "table.code td { font-family: 'JetBrains Mono', 'DejaVu Sans Mono', monospace; "
    "font-size: 8pt; white-space: pre-wrap; }\n"
    "td.number { color: #5c636a; text-align: right; padding-right: 6px; }\n"
    "tr.added td { background-color: #e6f4ea; } tr.removed td { background-color: #fbe9e7; }\n");
const QString screenStyle = QStringLiteral(
    "@media screen { body { max-width: 760px; margin: 24px auto; padding: 0 16px; } }\n"
    "svg { max-width: 100%; height: auto; }\n"
    "pre, code, table.code, svg { direction: ltr; unicode-bidi: isolate; }\n"
    "pre, code, table.code td { font-variant-ligatures: none; }\n"
    "@media print { h2, h3, svg { break-after: avoid; } }\n");

/// Writes the page piece by piece.
class Writer
{
public:
    Writer(const LabReport &report, Drawings drawings, const QString &language)
        : m_report(report)
        , m_drawings(drawings)
        , m_language(language)
    {
    }

    LabReportPage write()
    {
        const QString css = m_drawings == Drawings::Inside ? style + screenStyle : style;
        m_page.html += QStringLiteral("<!DOCTYPE html>\n<html lang=\"%1\"%4>\n<head>\n"
                                      "<meta charset=\"utf-8\">\n<title>%2</title>\n"
                                      "<style>\n%3</style>\n</head>\n<body>\n")
                           .arg(m_language, titleOf(m_report).toHtmlEscaped(), css,
                                directionAttribute(m_language));
        writeHead();
        for (const StepReport &step : m_report.steps)
            writeStep(step);
        writeEnd();
        m_page.html += QStringLiteral("</body>\n</html>\n");
        return std::move(m_page);
    }

private:
    void add(const QString &html) { m_page.html += html + QLatin1Char('\n'); }
    void addText(const char *element, const QString &text)
    {
        if (!text.isEmpty())
            add(QStringLiteral("<%1>%2</%1>").arg(QLatin1String(element), text.toHtmlEscaped()));
    }

    void addMarkdown(const QString &markdown)
    {
        add(markdownHtml(markdown, [this](const QString &tex, bool display) {
            const auto found = m_report.formulas.find({tex, display});
            return found == m_report.formulas.end() ? QString() : formulaHtml(tex, found->second);
        }));
    }

    QString formulaHtml(const QString &tex, const SetFormula &formula)
    {
        if (m_drawings == Drawings::Inside)
            return QStringLiteral(
                       "<svg role=\"img\" aria-label=\"%1\" style=\"vertical-align: %2ex\" %3")
                .arg(tex.toHtmlEscaped(), QString::number(-formula.depth),
                     QString::fromUtf8(formula.svg.mid(5))); // after "<svg "
        m_page.drawings.push_back(formula.svg);
        return QStringLiteral("<img src=\"formula:%1:%2:%3:%4\" alt=\"%5\">")
            .arg(m_page.drawings.size() - 1)
            .arg(formula.width)
            .arg(formula.height)
            .arg(formula.depth)
            .arg(tex.toHtmlEscaped());
    }

    void draw(const QByteArray &svg, int width, int height, int percent = 100)
    {
        if (svg.isEmpty())
            return;
        if (m_drawings == Drawings::Inside) {
            add(QString::fromUtf8(svg));
            return;
        }
        add(QStringLiteral("<img src=\"drawing:%1\" width=\"%2\" height=\"%3\">")
                .arg(m_page.drawings.size())
                .arg(width * percent / 100)
                .arg(height * percent / 100));
        m_page.drawings.push_back(svg);
    }

    void writeHead()
    {
        addText("h1", m_report.labTitle);
        QStringList who;
        for (const QString &part : {m_report.student, m_report.studentId})
            if (!part.isEmpty())
                who.append(part);
        // In the language of the page; where the system speaks it too, as the system writes dates.
        const QLocale spoken = spokenLocale(m_language);
        const QLocale dates = QLocale().language() == spoken.language() ? QLocale() : spoken;
        who.append(dates.toString(m_report.when.toLocalTime().date(), QLocale::LongFormat));
        addText("p", who.join(QStringLiteral(" · ")));
        addText(
            "p",
            HtmlText::tr("%1 of %2 steps pass. Every step was judged anew for this report, "
                         "by version %3 of the lab.")
                .arg(m_report.passedCount())
                .arg(m_report.steps.size())
                .arg(m_report.labVersion.isEmpty() ? QStringLiteral("?") : m_report.labVersion));
        if (!m_report.noteToTeacher.trimmed().isEmpty()) {
            addText("h3", HtmlText::tr("To the teacher"));
            for (const QString &line : m_report.noteToTeacher.split(QLatin1Char('\n')))
                addText("p", line);
        }
        QString rows;
        for (const StepReport &step : m_report.steps)
            rows += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2&nbsp;&nbsp;</td>"
                                   "<td class=\"%3\">%4</td></tr>\n")
                        .arg(step.id.toHtmlEscaped(), step.title.toHtmlEscaped(), classOf(step),
                             verdictText(step).toHtmlEscaped());
        add(QStringLiteral("<p></p><table>\n%1</table>").arg(rows));
    }

    static QString classOf(const StepReport &step)
    {
        return step.verdict == StepVerdict::Passed    ? QStringLiteral("good")
               : step.verdict == StepVerdict::NotDone ? QStringLiteral("muted")
                                                      : QStringLiteral("open");
    }

    static QString verdictText(const StepReport &step)
    {
        switch (step.verdict) {
        case StepVerdict::Passed:
            return HtmlText::tr("✓ passes");
        case StepVerdict::NotPassed:
            return HtmlText::tr("does not pass yet");
        case StepVerdict::Stopped:
            return HtmlText::tr("stops with an error");
        case StepVerdict::NotDone:
            break;
        }
        return HtmlText::tr("not done");
    }

    void writeStep(const StepReport &step)
    {
        const QString breaks =
            m_drawings == Drawings::Numbered && step.verdict != StepVerdict::NotDone
                ? QStringLiteral(" style=\"page-break-before: always\"")
                : QString();
        add(QStringLiteral("<h2%1>%2 · %3</h2>")
                .arg(breaks, step.id.toHtmlEscaped(), step.title.toHtmlEscaped()));
        addText("p", step.asked);
        const QString checks =
            step.attempts > 0
                ? QStringLiteral(" · ") + HtmlText::tr("Checks: %1").arg(step.attempts)
                : QString();
        add(QStringLiteral("<p class=\"%1\"><b>%2</b>%3</p>")
                .arg(classOf(step), verdictText(step).toHtmlEscaped(), checks.toHtmlEscaped()));
        addText("p", step.explanation);
        writeWay(step);
        writePrediction(step);
        writeRun(step);
        writeChange(step);
        if (!step.note.trimmed().isEmpty()) {
            addText("h3", HtmlText::tr("Notes"));
            addMarkdown(step.note);
        }
    }

    void writeWay(const StepReport &step)
    {
        if (step.met.empty())
            return;
        addText("h3", HtmlText::tr("Found on the way"));
        QString items;
        for (const StepReport::Met &met : step.met)
            items += QStringLiteral("<li>%1 (%2×)</li>\n")
                         .arg(met.headline.toHtmlEscaped(), QString::number(met.times));
        add(QStringLiteral("<ul>\n%1</ul>").arg(items));
    }

    void writePrediction(const StepReport &step)
    {
        if (step.question.isEmpty() || step.verdict == StepVerdict::NotDone)
            return;
        addText("h3", HtmlText::tr("Expected and found"));
        addMarkdown(step.question);
        const QString right = HtmlText::tr("What happens: %1").arg(step.right).toHtmlEscaped();
        const QString expected = HtmlText::tr("Expected: %1").arg(step.expected).toHtmlEscaped()
                                 + (step.wasRight ? QStringLiteral(" ✓") : QString());
        add(QStringLiteral("<p>%1</p>")
                .arg(step.expected.isEmpty() ? right : expected + QStringLiteral("<br>") + right));
    }

    void writeRun(const StepReport &step)
    {
        if (step.scene.isEmpty())
            return;
        addText("h3", HtmlText::tr("The run"));
        add(QStringLiteral("<table><tr><td>"));
        draw(step.scene, 300, 300, 75);
        add(QStringLiteral("</td><td>"));
        draw(step.momentum, 420, 150, 75);
        add(QStringLiteral("<br>"));
        draw(step.energy, 420, 150, 75);
        add(QStringLiteral("</td></tr></table>"));
        add(QStringLiteral("<p class=\"muted\">%1</p>").arg(step.moment.toHtmlEscaped()));
    }

    void writeChange(const StepReport &step)
    {
        if (!step.byProgram || step.verdict == StepVerdict::NotDone)
            return;
        addText("h3", HtmlText::tr("What changed in the program"));
        if (step.change.empty()) {
            addText("p", HtmlText::tr("Nothing: it is the program of the step before."));
            return;
        }
        add(changeTable(step.change));
    }

    void writeEnd()
    {
        if (m_report.energies.isEmpty())
            return;
        const QString breaks = m_drawings == Drawings::Numbered
                                   ? QStringLiteral(" style=\"page-break-before: always\"")
                                   : QString();
        add(QStringLiteral("<h2%1>%2</h2>")
                .arg(breaks, HtmlText::tr("Looking back").toHtmlEscaped()));
        addText("p", HtmlText::tr("The energy of the runs above in one chart, each as a part of "
                                  "what it started with. A law that keeps energy draws a straight "
                                  "line at 1; what lies above was made by the program, what lies "
                                  "below was lost."));
        add(QStringLiteral("<p>"));
        draw(m_report.energies, 640, 320);
        add(QStringLiteral("</p>"));
    }

    const LabReport &m_report;
    Drawings m_drawings;
    QString m_language;
    LabReportPage m_page{};
};

} // namespace

QString titleOf(const LabReport &report)
{
    return report.student.isEmpty()
               ? report.labTitle
               : QStringLiteral("%1 – %2").arg(report.labTitle, report.student);
}

LabReportPage labReportPage(const LabReport &report, Drawings drawings, const QString &language)
{
    return Writer(report, drawings, language).write();
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/page.h"

#include "tasks/text/plain_text.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>

namespace cradle {

namespace {

struct PageText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

// The colours are those of the window, with at least 4.5 : 1 against what they stand on.
const QString commonStyle = QStringLiteral(R"css(
:root { color-scheme: light dark; --page: #ffffff; --ink: #212529; --muted: #5c636a; --rule: #dee2e6;
  --card: #f8f9fa; --good: #2b7a3d; --good-back: #e6f4ea; --open: #9a4a00; --open-back: #fff1e0;
  --trouble: #b02a37; --trouble-back: #fbe9e7; --link: #1864ab; --mark: #fff3bf; --scene: #f0f8ff; }
@media (prefers-color-scheme: dark) { :root { --page: #16191d; --ink: #e9ecef; --muted: #a8b0b8;
  --rule: #3b4248; --card: #1f2429; --good: #8ce99a; --good-back: #17301d; --open: #ffc078;
  --open-back: #38260f; --trouble: #ffa8a8; --trouble-back: #3d1a1d; --link: #74c0fc;
  --mark: #4a3f10; --scene: #1b2530; } }
@media print { :root { color-scheme: light; --page: #ffffff; --ink: #212529; --muted: #5c636a;
  --rule: #ced4da; --card: #ffffff; --good: #2b7a3d; --good-back: #e6f4ea; --open: #9a4a00;
  --open-back: #fff1e0; --trouble: #b02a37; --trouble-back: #fbe9e7; --link: #212529;
  --mark: #fff3bf; --scene: #f0f8ff; } }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { font: 16px/1.5 Inter, "DejaVu Sans", system-ui, sans-serif; color: var(--ink);
  background: var(--page); max-width: 56rem; margin: 0 auto; padding: 1.5rem 1rem 3rem;
  overflow-wrap: break-word; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 .25rem; }
h2 { font-size: 1.25rem; line-height: 1.3; margin: 2.25rem 0 .5rem; }
h3 { font-size: 1rem; margin: 1.25rem 0 .4rem; }
p, ul, ol { margin: .5rem 0; }
a { color: var(--link); }
.muted, footer { color: var(--muted); }
footer { margin-top: 3rem; padding-top: .75rem; border-top: 1px solid var(--rule);
  font-size: .875rem; }
pre, code { font-family: "JetBrains Mono", "DejaVu Sans Mono", ui-monospace, monospace; }
pre, code { font-variant-ligatures: none; } code { font-size: .9em; }
pre { font-size: .8125rem; line-height: 1.5; background: var(--card); padding: .5rem .75rem;
  border: 1px solid var(--rule); border-radius: 6px; overflow-x: auto; margin: .5rem 0; }
pre.program { padding: .5rem 0; white-space: pre-wrap; }
pre.program span { display: block; padding: 0 .75rem 0 6.5ch; text-indent: -5ch; min-height: 1.5em; }
pre.program span::before { content: attr(data-line); display: inline-block; width: 3.5ch;
  margin-right: 1.5ch; text-align: right; text-indent: 0; color: var(--muted); font-weight: 400; }
pre.program .marked { background: var(--mark); font-weight: 600; }
table { border-collapse: collapse; font-size: .9375rem; } caption { text-align: start; }
th, td { text-align: start; vertical-align: top; padding: .3rem .6rem;
  border-bottom: 1px solid var(--rule); }
td.number, th.number { text-align: end; font-variant-numeric: tabular-nums; white-space: nowrap; }
.badge { display: inline-block; font-size: .8125rem; font-weight: 600; padding: .05rem .55rem;
  border-radius: 1rem; white-space: nowrap; }
.good { color: var(--good); background: var(--good-back); }
.open { color: var(--open); background: var(--open-back); }
.trouble { color: var(--trouble); background: var(--trouble-back); }
.quiet { color: var(--muted); background: var(--card); box-shadow: inset 0 0 0 1px var(--rule); }
details { border: 1px solid var(--rule); border-radius: 8px; margin: .6rem 0; padding: 0 1rem; }
details[open] { padding-bottom: .75rem; }
summary { cursor: pointer; padding: .55rem 0; font-weight: 600; }
summary:focus-visible, a:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
svg { max-width: 100%; height: auto; }
pre, code, svg { direction: ltr; unicode-bidi: isolate; } pre.message { direction: inherit; }
figure { margin: .75rem 0; } figcaption { color: var(--muted); font-size: .875rem; }
figure.scene svg { display: block; border: 1px solid var(--rule); border-radius: 6px; }
figure.scene svg rect[fill="#f0f8ff"] { fill: var(--scene); }
figure.scene svg [stroke="#212529"] { stroke: var(--ink); }
figure.scene svg text[fill="#212529"], figure.scene svg polygon[fill="#212529"] { fill: var(--ink); }
@media print { body { font-size: 10pt; max-width: none; padding: 0; }
  @page { margin: 16mm 14mm; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  a { text-decoration: none; } pre { white-space: pre-wrap; }
  h2, h3, summary { break-after: avoid; } figure, tr, pre.program { break-inside: avoid; }
  details { border: 0; padding: 0; } summary { list-style: none; }
  details.printed::details-content { content-visibility: visible; display: block; } }
)css");

QString classOf(Tone tone)
{
    switch (tone) {
    case Tone::Good:
        return QStringLiteral("good");
    case Tone::Open:
        return QStringLiteral("open");
    case Tone::Trouble:
        return QStringLiteral("trouble");
    case Tone::Quiet:
        break;
    }
    return QStringLiteral("quiet");
}

} // namespace

QString escaped(const QString &text)
{
    return printable(text).toHtmlEscaped();
}

QString escapedName(const QString &name)
{
    return QStringLiteral("<bdi>%1</bdi>").arg(escaped(name.simplified()));
}

QString pageStart(const QString &title, const QString &language, const QString &style)
{
    // Whatever got in would still load and run nothing.
    return QStringLiteral(
               "<!DOCTYPE html>\n<html lang=\"%1\"%4>\n<head>\n<meta charset=\"utf-8\">\n"
               "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src "
               "'none'; style-src 'unsafe-inline'\">\n"
               "<meta name=\"viewport\" content=\"width=device-width\">\n"
               "<title>%2</title>\n<style>%3</style>\n</head>\n<body>\n")
        .arg(escaped(language), escaped(title), commonStyle + style, directionAttribute(language));
}

QString pageEnd(const QString &footer)
{
    return QStringLiteral("<footer>%1</footer>\n</body>\n</html>\n").arg(footer);
}

QString codeAround(const QString &program, int line, int context)
{
    const QStringList lines = program.split(QLatin1Char('\n'));
    if (line < 1 || line > lines.size())
        return {};
    const int first = std::max(1, line - context);
    const int last = std::min(static_cast<int>(lines.size()), line + context);
    QString rows;
    for (int number = first; number <= last; ++number) {
        // A long line says no more than its beginning, and would make the page huge.
        QString text = lines[number - 1];
        text.remove(QLatin1Char('\r'));
        if (text.size() > 400)
            text = text.left(400) + QStringLiteral("…");
        rows += QStringLiteral("<span data-line=\"%1\"%2>%3</span>")
                    .arg(number)
                    .arg(number == line ? QStringLiteral(" class=\"marked\"") : QString(),
                         escaped(text));
    }
    return QStringLiteral("<pre class=\"program\" role=\"group\" aria-label=\"%1\">%2</pre>\n")
        .arg(escaped(PageText::tr("The program around line %1").arg(line)), rows);
}

QString belowHeadline(const QString &message)
{
    const auto end = message.indexOf(QLatin1Char('\n'));
    return end < 0 ? QString() : message.mid(end + 1).trimmed();
}

QString heading(const QString &text)
{
    return QStringLiteral("<h2>%1</h2>\n").arg(escaped(text));
}

QString paragraph(const QString &text, const char *kind)
{
    return QStringLiteral("<p%1>%2</p>\n")
        .arg(*kind ? QStringLiteral(" class=\"%1\"").arg(QLatin1String(kind)) : QString(),
             escaped(text));
}

QString countText(double value)
{
    return QLocale().toString(value, 'g', 8);
}

QString badge(const QString &text, Tone tone)
{
    return QStringLiteral("<span class=\"badge %1\">%2</span>").arg(classOf(tone), escaped(text));
}

} // namespace cradle

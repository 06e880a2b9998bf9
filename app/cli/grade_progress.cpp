// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/grade_progress.h"

#include "model/files/file_io.h"
#include "tasks/grading/points.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>

#include <algorithm>
#include <cstdio>

#include <sys/ioctl.h>
#include <unistd.h>

namespace cradle::cli {

namespace {

struct ProgressText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

constexpr qint64 betweenBars = 200;     ///< ms
constexpr qint64 betweenLines = 15'000; ///< ms
constexpr qsizetype mostBarLetters = 24;
constexpr qsizetype fewestBarLetters = 4;
constexpr int usualColumns = 80;

/// What fits on a line of the terminal: one that goes on below could not be wiped away.
qsizetype lettersOfLine()
{
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return (known ? size.ws_col : usualColumns) - 1;
}

/// The text, after a bar as long as there is room for.
QString lineOf(const QString &text, int done, int total)
{
    const qsizetype most = lettersOfLine();
    const qsizetype letters = std::min(mostBarLetters, most - text.size() - 3);
    if (letters < fewestBarLetters)
        return text.left(most);
    const qsizetype filled = total > 0 ? letters * done / total : 0;
    return u'[' + QString(filled, u'#') + QString(letters - filled, u'.') + QStringLiteral("] ")
           + text;
}

QString timeText(double seconds)
{
    const auto whole = static_cast<qint64>(seconds + 0.5);
    return QStringLiteral("%1:%2:%3")
        .arg(whole / 3600)
        .arg(whole / 60 % 60, 2, 10, QLatin1Char('0'))
        .arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QJsonObject jsonOf(const ClassProgress &progress)
{
    return {{QStringLiteral("students"), progress.students},
            {QStringLiteral("done"), progress.done},
            {QStringLiteral("kept"), progress.kept},
            {QStringLiteral("passed"), progress.passed},
            {QStringLiteral("failed"), progress.failed},
            {QStringLiteral("not_graded"), progress.notGraded}};
}

} // namespace

GradeProgress::GradeProgress(bool events)
    : m_form(events                       ? Form::Events
             : isatty(STDERR_FILENO) == 1 ? Form::Bar
                                          : Form::Lines)
{
    m_timer.start();
}

void GradeProgress::event(const QJsonObject &json)
{
    // Who reads them may have gone; the results do not depend on it.
    auto fault = writeStandardOutput(QJsonDocument(json).toJson(QJsonDocument::Compact) + '\n');
    if (fault && !m_fault)
        m_fault = std::move(fault);
}

void GradeProgress::clearBar()
{
    if (m_barStands)
        QTextStream(stderr) << QStringLiteral("\r\x1b[K") << Qt::flush;
    m_barStands = false;
}

void GradeProgress::start(int students, const QString &isolation)
{
    m_timer.start();
    if (m_form == Form::Events)
        return event({{QStringLiteral("event"), QStringLiteral("start")},
                      {QStringLiteral("students"), students},
                      {QStringLiteral("isolation"), isolation}});
    QTextStream(stderr) << ProgressText::tr("students: %1").arg(students) << '\n'
                        << ProgressText::tr("isolation: %1").arg(isolation) << Qt::endl;
}

QString GradeProgress::textOf(const ClassProgress &progress) const
{
    const double seconds = static_cast<double>(m_timer.elapsed()) / 1000.0;
    const int judged = progress.done - progress.kept;
    const double rate = seconds > 0.0 ? judged / seconds : 0.0;
    QString text = ProgressText::tr("%1 of %2 students").arg(progress.done).arg(progress.students);
    if (judged > 0)
        text += ProgressText::tr(", %1 a minute, %2 left")
                    .arg(rate * 60.0, 0, 'f', 0)
                    .arg(timeText((progress.students - progress.done) / rate));
    text += ProgressText::tr(", %1 steps not passed").arg(progress.failed);
    if (progress.notGraded > 0)
        text += ProgressText::tr(", %1 not graded").arg(progress.notGraded);
    return text;
}

void GradeProgress::show(const ClassProgress &progress)
{
    const qint64 now = m_timer.elapsed();
    if (m_form == Form::Events
        || now - m_shown < (m_form == Form::Bar ? betweenBars : betweenLines))
        return;
    const bool first = m_shown < 0;
    m_shown = now;
    if (m_form == Form::Lines) {
        if (!first)
            QTextStream(stderr) << textOf(progress) << Qt::endl;
        return;
    }
    showBar(textOf(progress), progress.done, progress.students);
}

void GradeProgress::tell(const ClassProgress &progress, const StudentResult &student)
{
    if (m_form != Form::Events)
        return show(progress);
    QJsonObject steps;
    for (const StepResult &step : student.steps)
        steps.insert(step.taskId, statusName(step.status));
    QJsonObject json = jsonOf(progress);
    json.insert(QStringLiteral("event"), QStringLiteral("student"));
    json.insert(QStringLiteral("id"), student.id);
    json.insert(QStringLiteral("steps"), steps);
    event(json);
}

void GradeProgress::showBar(const QString &text, int done, int total)
{
    QTextStream(stderr) << QStringLiteral("\r\x1b[K") << lineOf(text, done, total) << Qt::flush;
    m_barStands = true;
}

void GradeProgress::writing(int done, int total)
{
    if (m_form == Form::Events || (done < total && m_timer.elapsed() - m_shown < betweenBars))
        return;
    m_shown = m_timer.elapsed();
    if (m_form == Form::Bar)
        showBar(ProgressText::tr("writing, %1 of %2").arg(done).arg(total), done, total);
}

void GradeProgress::remark(const QString &text)
{
    if (m_form == Form::Events)
        return event(
            {{QStringLiteral("event"), QStringLiteral("remark")}, {QStringLiteral("text"), text}});
    clearBar();
    QTextStream(stderr) << text << Qt::endl;
}

void GradeProgress::end(const ClassProgress &progress, const char *outcome)
{
    if (m_form == Form::Events) {
        QJsonObject json = jsonOf(progress);
        json.insert(QStringLiteral("event"), QString::fromUtf8(outcome));
        return event(json);
    }
    clearBar();
    QTextStream(stderr)
        << ProgressText::tr("%1 of %2 students, %3 of them as they were before; steps: %4 passed, "
                            "%5 not passed, %6 not graded; %7")
               .arg(progress.done)
               .arg(progress.students)
               .arg(progress.kept)
               .arg(progress.passed)
               .arg(progress.failed)
               .arg(progress.notGraded)
               .arg(timeText(static_cast<double>(m_timer.elapsed()) / 1000.0))
        << Qt::endl;
}

} // namespace cradle::cli

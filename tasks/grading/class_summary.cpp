// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_summary.h"

#include "tasks/grading/page.h"
#include "tasks/lab_report/lab_report.h"
#include "tasks/report/report_json.h"
#include "tasks/script/lua_tokens.h"
#include "tasks/values/lab_values.h"

#include <QRegularExpression>

#include <algorithm>
#include <set>

namespace cradle {

namespace {

constexpr std::size_t mostAlike = 30;       ///< pairs that are told
constexpr std::size_t mostNotGraded = 200;  ///< that are told one by one
constexpr std::size_t mostSorts = 300;      ///< of misunderstandings of a step
constexpr std::size_t mostSharedLines = 30; ///< of a program that are shown
constexpr int exampleContext = 2;           ///< lines around the marked one

/// The lines of a program with their numbers, and a sign where some are left out.
QString numbered(const StudentResult &student, const SimilarPrograms::Lines &lines)
{
    QStringList all;
    for (const StepResult &step : student.steps) {
        if (step.taskId == lines.taskId)
            all = step.program.split(QLatin1Char('\n'));
    }
    QString text;
    int last = 0;
    std::size_t count = 0;
    for (const int line : lines.lines) {
        if (line < 1 || line > all.size())
            continue;
        if (++count > mostSharedLines) {
            text += QStringLiteral("   ⋮\n");
            break;
        }
        if (last > 0 && line != last + 1)
            text += QStringLiteral("   ⋮\n");
        text += QStringLiteral("%1  %2\n").arg(line, 4).arg(all[line - 1].left(160));
        last = line;
    }
    return text;
}

/// What a finding is counted as: a known mistake, or a law in its own words.
QString keyOf(const Finding &finding)
{
    return finding.mistake.isEmpty()
               ? aspectName(finding.aspect) + QLatin1Char(' ') + headlineOf(finding.message)
               : QLatin1Char('=') + finding.mistake;
}

} // namespace

QString withoutNames(const QString &text, const StudentResult &student)
{
    static const QRegularExpression breaks(QStringLiteral("[^\\w]+"),
                                           QRegularExpression::UseUnicodePropertiesOption);
    QString result = text;
    const QString all = student.name + QLatin1Char(' ') + student.id + QLatin1Char(' ')
                        + student.number + QLatin1Char(' ') + student.email;
    for (const QString &word : all.split(breaks, Qt::SkipEmptyParts)) {
        // Shorter ones are within every program, and tell nobody.
        if (word.size() >= 3)
            result.replace(
                QRegularExpression(QStringLiteral("\\b%1\\b").arg(QRegularExpression::escape(word)),
                                   QRegularExpression::CaseInsensitiveOption
                                       | QRegularExpression::UseUnicodePropertiesOption),
                QStringLiteral("…"));
    }
    return result;
}

QString withoutComments(const QString &program)
{
    QByteArray bytes = program.toUtf8();
    for (const LuaToken &token : luaTokens(bytes)) {
        if (token.kind != LuaToken::Kind::Comment)
            continue;
        for (qsizetype i = token.start; i < token.end(); ++i) {
            if (bytes[i] != '\n')
                bytes[i] = ' ';
        }
    }
    return QString::fromUtf8(bytes);
}

ClassSummary::ClassSummary(const Lab &lab, const ClassFacts &facts)
    : m_lab(lab)
    , m_facts(facts)
    , m_similar(lab)
{
    for (const Task &task : lab.tasks) {
        Step step{.id = task.id, .title = task.title};
        for (const CheckSpec &check : task.checks)
            step.checks.push_back({.id = check.id, .title = check.title});
        for (const Question &question : task.questions)
            step.checks.push_back({.id = question.id, .title = question.title});
        m_steps.push_back(std::move(step));
    }
}

void ClassSummary::add(const StudentResult &student)
{
    Row row{.id = student.id,
            .name = student.name.isEmpty() ? student.id : student.name,
            .points = pointsOf(student, m_lab, m_facts.late)};
    for (std::size_t i = 0; i < m_lab.tasks.size(); ++i) {
        const StepResult &step = resultOf(student, m_lab.tasks[i]);
        row.steps.push_back(step.status);
        row.passed += step.status == StepResult::Status::Passed;
        addStep(m_steps[i], student, step);
    }
    addNumber(row.name, student);
    m_rows.push_back(std::move(row));
    m_similar.add(student);
}

void ClassSummary::addNumber(const QString &name, const StudentResult &student)
{
    for (const StepResult &step : student.steps) {
        if (step.ownNumber.isEmpty())
            continue;
        m_handedNumbers[plainNumber(step.ownNumber)].append(name);
        if (step.hasForeignNumber())
            m_otherNumbers.push_back({name, step.drawnBy, step.ownNumber});
        return; // the same for all steps
    }
}

void ClassSummary::addStep(Step &sum, const StudentResult &student, const StepResult &step)
{
    sum.passed += step.status == StepResult::Status::Passed;
    sum.failed += step.status == StepResult::Status::Failed;
    sum.missing += step.status == StepResult::Status::Missing;
    if (step.status == StepResult::Status::NotGraded && ++sum.notGraded > 0
        && m_notGraded.size() < mostNotGraded)
        m_notGraded.push_back(
            {student.name.isEmpty() ? student.id : student.name, sum.id, step.reason});
    if (step.attempts > 0)
        sum.attempts.push_back(step.attempts);
    if (step.attempts > 0 || step.minutes > 0.0)
        sum.minutes.push_back(step.minutes);
    if (step.status == StepResult::Status::NotGraded || !step.report)
        return;
    sum.stopped += step.report->error.has_value();
    for (Check &check : sum.checks) {
        const auto &all = step.report->checks;
        const auto found = std::find_if(
            all.begin(), all.end(), [&](const CheckOutcome &each) { return each.id == check.id; });
        if (found != all.end())
            ++(found->passed ? check.passed : check.failed);
    }
    std::set<Aspect> aspects;
    std::set<QString> told;
    for (const Finding &finding : step.report->findings) {
        aspects.insert(finding.aspect);
        const QString key = keyOf(finding);
        if (!told.insert(key).second)
            continue;
        const bool isNew = !sum.misunderstandings.contains(key);
        if (isNew && sum.misunderstandings.size() >= mostSorts)
            continue;
        Misunderstanding &met = sum.misunderstandings[key];
        ++met.count;
        if (!isNew)
            continue;
        met.aspect = finding.aspect;
        met.headline = headlineOf(finding.message);
        met.message = withoutNames(belowHeadline(finding.message), student);
        const QStringList lines =
            withoutNames(withoutComments(step.program), student).split(QLatin1Char('\n'));
        if (finding.line < 1 || finding.line > lines.size())
            continue;
        const int first = std::max(1, finding.line - exampleContext);
        met.code = lines.mid(first - 1, 2 * exampleContext + 1).join(QLatin1Char('\n'));
        met.codeLine = finding.line - first + 1;
    }
    for (const Aspect aspect : aspects)
        ++sum.aspects[aspect];
}

std::optional<Error> ClassSummary::finish(const std::function<Result<StudentResult>(int)> &read)
{
    for (const AlikePair &pair : m_similar.pairs(mostAlike)) {
        const auto first = read(pair.first);
        if (!first)
            return first.error();
        const auto second = read(pair.second);
        if (!second)
            return second.error();
        const auto lines = m_similar.sharedLines(*first, *second);
        m_alike.push_back({.first = m_rows[static_cast<std::size_t>(pair.first)].name,
                           .second = m_rows[static_cast<std::size_t>(pair.second)].name,
                           .shared = pair.shared,
                           .part = pair.part,
                           .firstTask = lines.first.taskId,
                           .secondTask = lines.second.taskId,
                           .firstCode = numbered(*first, lines.first),
                           .secondCode = numbered(*second, lines.second)});
    }
    return std::nullopt;
}

} // namespace cradle

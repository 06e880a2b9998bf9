// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/approved_text.h"
#include "tests/text_print.h"

#include "tasks/judging/deviation.h"

#include <QRegularExpression>

#include <map>
#include <optional>

namespace cradle::approved {

/// What is said of many laws, part by part: a hash of all that is said in each, and at last how
/// often each headline is said, whoever and wherever it is said of. The first part that is not as
/// it is in a file of tests/approved ends it.
class ToldDeviations
{
public:
    explicit ToldDeviations(const QString &file)
        : m_file(file)
        , m_approved(read(file).split(QLatin1Char('\n')))
    {
    }

    void add(const std::vector<LawDeviation> &found)
    {
        *m_print << found.size();
        m_count += found.size();
        for (const LawDeviation &each : found) {
            ++m_headlines[withoutNames(each.message.section(QLatin1Char('\n'), 0, 0))];
            *m_print << each.message << int(each.aspect) << int(each.suspect) << each.shown
                     << each.family << int(each.topic) << each.isEverywhere << each.isConditional
                     << each.isOfSome << each.isMethod << each.hidesHits << each.hidesWalls
                     << each.moment.step << each.moment.circles << each.moment.isPosition
                     << each.moment.start.has_value() << each.moment.stage.preset.circles.size();
        }
    }
    void add(bool isSo) { *m_print << isSo; }
    void add(const QString &hash) { *m_print << hash; }
    /// \return what is not as approved; empty: nothing
    [[nodiscard]] QString endPart(const QString &name)
    {
        const QString line =
            QStringLiteral("%1: %2 %3").arg(name).arg(m_count).arg(m_print->text());
        m_print.emplace();
        m_count = 0;
        m_lines.append(line);
        if (isApproving() || m_approved.value(m_lines.size() - 1) == line)
            return {};
        return difference(
            m_lines.join(QLatin1Char('\n')),
            m_approved.first(std::min(m_lines.size(), m_approved.size())).join(QLatin1Char('\n')));
    }
    /// The same of all of it.
    [[nodiscard]] QString end()
    {
        for (const auto &[headline, count] : m_headlines)
            m_lines.append(QStringLiteral("%1 %2").arg(count, 6).arg(headline));
        return compare(m_file, m_lines.join(QLatin1Char('\n')) + QLatin1Char('\n'));
    }

private:
    static QString withoutNames(QString headline)
    {
        static const QRegularExpression number(QStringLiteral("-?\\d[\\d.]*"));
        static const QRegularExpression who(QStringLiteral("both circles|circle #"));
        static const QRegularExpression wall(
            QStringLiteral("\\b(((left|right) wall|floor|ceiling)(, | and )?)+|\\bwalls\\b"));
        return headline.replace(number, QStringLiteral("#"))
            .replace(who, QStringLiteral("…"))
            .replace(wall, QStringLiteral("… "))
            .simplified();
    }

    QString m_file;
    QStringList m_approved;
    QStringList m_lines{};
    std::optional<TextPrint> m_print{std::in_place};
    std::size_t m_count = 0;
    std::map<QString, int> m_headlines{};
};

} // namespace cradle::approved

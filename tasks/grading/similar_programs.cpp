// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/similar_programs.h"

#include "tasks/script/program_tokens.h"

#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <map>
#include <unordered_map>

namespace cradle {

namespace {

constexpr std::size_t runTokens = 18;                ///< k
constexpr std::size_t windowRuns = 8;                ///< w
constexpr int leastShared = 8;                       ///< fingerprints; fewer are chance
constexpr int manyShared = 20;                       ///< whatever part of the programs they are
constexpr double leastPart = 0.5;                    ///< of what the shorter program has of its own
constexpr quint64 startOfHash = 0xcbf29ce484222325u; // FNV-1a, 64 bits
constexpr quint64 primeOfHash = 0x100000001b3u;

/// Names that mean something to the machine; all others are the student's choice.
bool isGiven(const QString &name)
{
    static const QSet<QString> given = [] {
        const QString words = QStringLiteral(
            "on_load on_update circle1 circle2 circle3 circle4 circles position velocity radius "
            "density index vec dot x y length length_squared normalized perpendicular gravity "
            "restitution square half_width left right bottom top time step math string table "
            "ipairs pairs select type tostring tonumber print assert error pcall plot draw arrow "
            "line point text abs sqrt pi max min floor ceil sin cos tan atan huge insert remove "
            "concat sort unpack format sub len");
        const QStringList list = words.split(QLatin1Char(' '));
        return QSet<QString>(list.begin(), list.end());
    }();
    return given.contains(name);
}

/// What a token counts as.
QString normal(const ProgramToken &token)
{
    switch (token.kind) {
    case ProgramToken::Kind::Name:
        return isGiven(token.text) ? token.text : QStringLiteral("$");
    case ProgramToken::Kind::Text:
        return QStringLiteral("\"");
    case ProgramToken::Kind::Number: {
        bool ok = false;
        const double value = token.text.toDouble(&ok);
        return ok ? QString::number(value, 'g', 17) : token.text;
    }
    case ProgramToken::Kind::Keyword:
    case ProgramToken::Kind::Sign:
        break;
    }
    return token.text;
}

quint64 hashOf(const QString &text)
{
    quint64 hash = startOfHash;
    for (const char byte : text.toUtf8())
        hash = (hash ^ static_cast<unsigned char>(byte)) * primeOfHash;
    return hash;
}

/// The code in a text of the lab.
QStringList codeIn(const QString &markdown)
{
    static const QRegularExpression fenced(QStringLiteral("```[a-z]*\n(.*?)```"),
                                           QRegularExpression::DotMatchesEverythingOption);
    QStringList code;
    for (auto matches = fenced.globalMatch(markdown); matches.hasNext();)
        code.append(matches.next().captured(1));
    return code;
}

QStringList programsOf(const Task &task)
{
    QStringList programs{task.starter, task.solution};
    for (const KnownScript &mistake : task.mistakes)
        programs.append(mistake.source);
    for (const RemarkSpec &remark : task.remarks)
        programs.append(remark.script.source);
    programs += codeIn(task.instructions);
    for (const QString &hint : task.hints + task.codeHints)
        programs += codeIn(hint);
    return programs;
}

void addLines(std::vector<int> &lines, const Fingerprint &fingerprint)
{
    for (int line = fingerprint.line; line <= fingerprint.lastLine; ++line)
        lines.push_back(line);
}

void sortOnce(std::vector<int> &lines)
{
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
}

} // namespace

std::vector<Fingerprint> tokenRunsOf(const QString &program)
{
    std::vector<quint64> hashes;
    std::vector<int> lines;
    for (const ProgramToken &token : programTokens(program)) {
        hashes.push_back(hashOf(normal(token)));
        lines.push_back(token.line);
    }
    std::vector<Fingerprint> runs;
    for (std::size_t i = 0; i + runTokens <= hashes.size(); ++i) {
        quint64 hash = startOfHash;
        for (std::size_t j = i; j < i + runTokens; ++j) {
            hash = (hash ^ hashes[j]) * primeOfHash;
            hash ^= hash >> 29; // the high bits count in the comparison, too
        }
        runs.push_back({hash, lines[i], lines[i + runTokens - 1]});
    }
    return runs;
}

std::vector<Fingerprint> fingerprintsOf(const QString &program)
{
    const std::vector<Fingerprint> runs = tokenRunsOf(program);
    std::vector<Fingerprint> chosen;
    std::size_t last = runs.size();
    const std::size_t windows = runs.size() > windowRuns ? runs.size() - windowRuns + 1
                                                         : std::min<std::size_t>(1, runs.size());
    for (std::size_t start = 0; start < windows; ++start) {
        std::size_t least = start;
        for (std::size_t i = start; i < std::min(start + windowRuns, runs.size()); ++i) {
            if (runs[i].hash <= runs[least].hash) // of equal ones the rightmost
                least = i;
        }
        if (least != last)
            chosen.push_back(runs[least]);
        last = least;
    }
    return chosen;
}

SimilarPrograms::SimilarPrograms(const Lab &lab)
{
    for (const Task &task : lab.tasks) {
        for (const QString &program : programsOf(task)) {
            for (const Fingerprint &run : tokenRunsOf(program))
                m_ofLab.insert(run.hash);
        }
    }
}

void SimilarPrograms::add(const StudentResult &student)
{
    // A step's program goes on from that of the step before, so most of them are the same.
    std::vector<quint64> hashes;
    for (const StepResult &step : student.steps) {
        for (const Fingerprint &fingerprint : fingerprintsOf(step.program)) {
            if (!m_ofLab.contains(fingerprint.hash))
                hashes.push_back(fingerprint.hash);
        }
    }
    std::sort(hashes.begin(), hashes.end());
    hashes.erase(std::unique(hashes.begin(), hashes.end()), hashes.end());
    for (const quint64 hash : hashes)
        m_entries.push_back({hash, m_students});
    ++m_students;
}

int SimilarPrograms::commonFrom() const
{
    return std::clamp(m_students / 10, 4, 20);
}

std::vector<AlikePair> SimilarPrograms::pairs(std::size_t most)
{
    std::sort(m_entries.begin(), m_entries.end(), [](const Entry &a, const Entry &b) {
        return a.hash != b.hash ? a.hash < b.hash : a.student < b.student;
    });
    std::vector<int> own(static_cast<std::size_t>(m_students), 0);
    std::unordered_map<quint64, int> shared; // by both students
    for (std::size_t begin = 0, end = 0; begin < m_entries.size(); begin = end) {
        while (end < m_entries.size() && m_entries[end].hash == m_entries[begin].hash)
            ++end;
        if (end - begin > static_cast<std::size_t>(commonFrom()))
            continue;
        for (std::size_t i = begin; i < end; ++i) {
            ++own[static_cast<std::size_t>(m_entries[i].student)];
            for (std::size_t j = i + 1; j < end; ++j)
                ++shared[(static_cast<quint64>(m_entries[i].student) << 32)
                         | static_cast<quint64>(m_entries[j].student)];
        }
    }
    std::vector<AlikePair> pairs;
    for (const auto &[key, count] : shared) {
        const int first = static_cast<int>(key >> 32);
        const int second = static_cast<int>(key & 0xffffffffu);
        const int fewer =
            std::min(own[static_cast<std::size_t>(first)], own[static_cast<std::size_t>(second)]);
        const double part = static_cast<double>(count) / fewer;
        if (count >= manyShared || (count >= leastShared && part >= leastPart))
            pairs.push_back({first, second, count, part});
    }
    std::sort(pairs.begin(), pairs.end(), [](const AlikePair &a, const AlikePair &b) {
        if (a.shared != b.shared)
            return a.shared > b.shared;
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    pairs.resize(std::min(pairs.size(), most));
    return pairs;
}

bool SimilarPrograms::isOwn(quint64 hash) const
{
    if (m_ofLab.contains(hash))
        return false;
    const auto [begin, end] =
        std::equal_range(m_entries.begin(), m_entries.end(), Entry{hash, 0},
                         [](const Entry &a, const Entry &b) { return a.hash < b.hash; });
    return end - begin <= commonFrom();
}

SimilarPrograms::SharedLines SimilarPrograms::sharedLines(const StudentResult &first,
                                                          const StudentResult &second) const
{
    struct OwnPart {
        QString taskId;
        std::multimap<quint64, Fingerprint> own{};
    };
    const auto programsOfStudent = [this](const StudentResult &student) {
        std::vector<OwnPart> programs;
        for (const StepResult &step : student.steps) {
            programs.push_back({step.taskId});
            for (const Fingerprint &fingerprint : fingerprintsOf(step.program)) {
                if (isOwn(fingerprint.hash))
                    programs.back().own.emplace(fingerprint.hash, fingerprint);
            }
        }
        return programs;
    };
    const std::vector<OwnPart> others = programsOfStudent(second);
    SharedLines best;
    std::size_t most = 0;
    for (const OwnPart &mine : programsOfStudent(first)) {
        for (const OwnPart &theirs : others) {
            SharedLines shared{{mine.taskId}, {theirs.taskId}};
            std::size_t count = 0;
            for (const auto &[hash, fingerprint] : mine.own) {
                const auto [begin, end] = theirs.own.equal_range(hash);
                if (begin == end)
                    continue;
                count += 2;
                addLines(shared.first.lines, fingerprint);
                for (auto it = begin; it != end; ++it)
                    addLines(shared.second.lines, it->second);
            }
            count += count > 0 && mine.taskId == theirs.taskId;
            if (count > most) {
                sortOnce(shared.first.lines);
                sortOnce(shared.second.lines);
                best = std::move(shared);
                most = count;
            }
        }
    }
    return best;
}

} // namespace cradle

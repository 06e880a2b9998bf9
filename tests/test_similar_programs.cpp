// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "other_forms.h"
#include "tasks/grading/similar_programs.h"
#include "tasks/reading/lab_reader.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace cradle;

/// Programs that are alike: copies are found whatever they call things, honest work is not.
class TestSimilarPrograms : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void namesCommentsAndSpaceMakeNoDifference();
    void everyLongSharedRunIsSeen();
    void equalHashesTakeTheRightmost();
    void disguisedCopyIsFound();
    void reorderedFunctionsAreFound();
    void honestProgramsAreNotAlike();
    void whatTheLabGivesDoesNotCount_data();
    void whatTheLabGivesDoesNotCount();
    void whatTheClassSharesDoesNotCount();
    void sharedLinesAreThoseOfTheCopy();
    void whatTheClassSharesIsNotShown();
    void thousandsAreCompared();
    void pairsAreInTheOrderOfTheClass();

private:
    std::vector<AlikePair> pairsOf(const std::vector<QString> &programs) const;
    Lab m_lab;
};

namespace {

const QString own = QStringLiteral(R"lua(
-- my own way
local function energy_of(body)
  local e = 0.5 * body.density * body.radius * body.radius * body.velocity:length_squared()
  for attempt = 1, 3 do
    if e > 100 * attempt then print("large", e, attempt) else e = e + attempt * 0.25 end
  end
  return e
end

local function report(list)
  local sum, most = 0, nil
  for i = 1, #list do
    local e = energy_of(list[i])
    sum = sum + e
    if most == nil or e > most then most = e end
  end
  plot("energy", sum)
  return sum, most
end

function on_update(timestep)
  for i = 1, #circles do
    circles[i].velocity = circles[i].velocity + gravity * timestep
    circles[i].position = circles[i].position + circles[i].velocity * timestep
  end
  report(circles)
end
)lua");

StudentResult studentWith(const QString &program)
{
    StudentResult student;
    student.steps.push_back({.taskId = QStringLiteral("L42T5"), .program = program});
    return student;
}

QString renamed(QString program)
{
    const std::pair<const char *, const char *> names[] = {
        {"energy_of", "kin"}, {"attempt", "k"}, {"body", "thing"}, {"report", "tell_all"},
        {"list", "bodies"},   {"sum", "total"}, {"most", "peak"},  {"timestep", "dt"}};
    for (const auto &[before, after] : names)
        program.replace(QLatin1String(before), QLatin1String(after));
    return program.replace(QStringLiteral("-- my own way"), QStringLiteral("--[[ all mine ]]"))
        .replace(QStringLiteral("\n  "), QStringLiteral("\n\t\t "))
        .replace(QStringLiteral("\"large\""), QStringLiteral("'oh'"));
}

std::vector<quint64> hashesOf(const std::vector<Fingerprint> &fingerprints)
{
    std::vector<quint64> hashes;
    for (const Fingerprint &fingerprint : fingerprints)
        hashes.push_back(fingerprint.hash);
    return hashes;
}

} // namespace

void TestSimilarPrograms::initTestCase()
{
    const auto lab = readLab(QStringLiteral(":/labs/lab-4.2"));
    QVERIFY(lab.ok());
    m_lab = *lab;
}

std::vector<AlikePair> TestSimilarPrograms::pairsOf(const std::vector<QString> &programs) const
{
    SimilarPrograms similar(m_lab);
    for (const QString &program : programs)
        similar.add(studentWith(program));
    return similar.pairs(100);
}

void TestSimilarPrograms::namesCommentsAndSpaceMakeNoDifference()
{
    QVERIFY(renamed(own) != own);
    QCOMPARE(hashesOf(tokenRunsOf(renamed(own))), hashesOf(tokenRunsOf(own)));
    QVERIFY(!fingerprintsOf(own).empty());
    // What the program does does make one.
    QString other = own;
    other.replace(QStringLiteral("gravity * timestep"), QStringLiteral("gravity / timestep"));
    QVERIFY(hashesOf(tokenRunsOf(other)) != hashesOf(tokenRunsOf(own)));
}

void TestSimilarPrograms::everyLongSharedRunIsSeen()
{
    // The promise of winnowing, w + k − 1 = 25: of each 8 runs of 18 tokens in a row one is chosen.
    const auto runs = hashesOf(tokenRunsOf(own));
    const auto chosenList = hashesOf(fingerprintsOf(own));
    const std::set<quint64> chosen(chosenList.begin(), chosenList.end());
    QVERIFY(chosen.size() < runs.size() / 2);
    for (std::size_t start = 0; start + 8 <= runs.size(); ++start) {
        QVERIFY(std::any_of(runs.begin() + static_cast<std::ptrdiff_t>(start),
                            runs.begin() + static_cast<std::ptrdiff_t>(start + 8),
                            [&](quint64 hash) { return chosen.count(hash) == 1; }));
    }
}

void TestSimilarPrograms::equalHashesTakeTheRightmost()
{
    // 60 equal statements of five tokens: five different runs, and no window keeps two of them.
    const QString program = QStringLiteral("a = b + 1\n").repeated(60);
    const auto chosen = fingerprintsOf(program);
    const auto all = hashesOf(chosen);
    QCOMPARE(std::set<quint64>(all.begin(), all.end()).size(), std::size_t(1));
    QVERIFY(chosen.front().line < chosen.back().line);
    QVERIFY(fingerprintsOf({}).empty());
    QVERIFY(fingerprintsOf(QStringLiteral("x = 1")).empty());
}

void TestSimilarPrograms::disguisedCopyIsFound()
{
    const auto pairs = pairsOf({own, m_lab.tasks[4].solution, renamed(own)});
    QCOMPARE(pairs.size(), std::size_t(1));
    QCOMPARE(pairs[0].first, 0);
    QCOMPARE(pairs[0].second, 2);
    QCOMPARE(pairs[0].part, 1.0);
}

void TestSimilarPrograms::reorderedFunctionsAreFound()
{
    const QStringList parts = own.split(QStringLiteral("\n\n"));
    QCOMPARE(parts.size(), 3);
    const QString reordered =
        renamed(parts[2] + QStringLiteral("\n\n") + parts[1] + QStringLiteral("\n\n") + parts[0]);
    const auto pairs = pairsOf({own, reordered});
    QCOMPARE(pairs.size(), std::size_t(1));
    QVERIFY(pairs[0].part > 0.7);
}

void TestSimilarPrograms::honestProgramsAreNotAlike()
{
    using namespace programs;
    // The same step in ways that have nothing in common but the task.
    OtherForm table = otherForm(QStringLiteral("L42T5"));
    table.walls = parts::clamp;
    const QString first = table.source();
    const QString second = QStringLiteral(R"lua(
function on_load()
  gravity = vec(0, -9.81)
  for _, ball in ipairs(circles) do ball.position = vec(-2, 2) ball.velocity = vec(2, 0) end
end
function on_update(dt)
  local before = {circle1.position, circle2.position}
  local v1 = circle1.velocity
  circle1.velocity = v1 + dt * gravity
  circle1.position = before[1] + dt * v1
  circle2.velocity = circle2.velocity + dt * gravity
  circle2.position = before[2] + dt * circle2.velocity
  for i, ball in ipairs(circles) do
    local p, v, r = ball.position, ball.velocity, ball.radius
    if p.x + r > square.right or p.x - r < square.left then v = vec(-v.x, v.y) ball.position = before[i] end
    if p.y + r > square.top or p.y - r < square.bottom then v = vec(v.x, -v.y) ball.position = before[i] end
    ball.velocity = v
  end
end
)lua");
    QVERIFY(pairsOf({first, second, own}).empty());
}

void TestSimilarPrograms::whatTheLabGivesDoesNotCount_data()
{
    QTest::addColumn<QString>("program");
    const Task &task = m_lab.tasks[4];
    QTest::newRow("starter") << task.starter;
    QTest::newRow("solution") << task.solution;
    QTest::newRow("known mistake") << task.mistakes.front().source;
    QTest::newRow("solution of the whole lab") << m_lab.tasks.back().solution;
    QTest::newRow("disguised solution") << renamed(task.solution);
}

void TestSimilarPrograms::whatTheLabGivesDoesNotCount()
{
    QFETCH(QString, program);
    QVERIFY(pairsOf({program, program}).empty());
}

void TestSimilarPrograms::whatTheClassSharesDoesNotCount()
{
    // Four are alike: told. Five of a small class share it: taken for common.
    QCOMPARE(pairsOf({own, own, own, own}).size(), std::size_t(6));
    QVERIFY(pairsOf({own, own, own, own, own}).empty());
}

void TestSimilarPrograms::sharedLinesAreThoseOfTheCopy()
{
    const QString host = m_lab.tasks[4].solution;
    const StudentResult first = studentWith(host + own);
    const StudentResult second = studentWith(own);
    SimilarPrograms similar(m_lab);
    similar.add(first);
    similar.add(second);
    QCOMPARE(similar.pairs(0).size(), std::size_t(0));
    QCOMPARE(similar.pairs(10).size(), std::size_t(1));
    const auto shared = similar.sharedLines(first, second);
    QCOMPARE(shared.first.taskId, QStringLiteral("L42T5"));
    QCOMPARE(shared.second.taskId, QStringLiteral("L42T5"));
    QVERIFY(shared.first.lines.front() > static_cast<int>(host.count(QLatin1Char('\n'))));
    QVERIFY(shared.second.lines.size() > 15);
    QVERIFY(shared.second.lines.back() <= static_cast<int>(own.count(QLatin1Char('\n'))));
    // What both have of the lab is nobody's.
    const StudentResult given = studentWith(host);
    QVERIFY(similar.sharedLines(given, given).first.lines.empty());
}

/// Six share some twenty lines; of these two share more, which alone is shown.
void TestSimilarPrograms::whatTheClassSharesIsNotShown()
{
    QString common;
    for (int line = 0; line < 20; ++line)
        common += QStringLiteral("a%1 = b + 7 * (c - 9%1)\n").arg(line);
    SimilarPrograms similar(m_lab);
    const StudentResult first = studentWith(common + own);
    const StudentResult second = studentWith(common + renamed(own));
    for (int i = 0; i < 4; ++i)
        similar.add(studentWith(common));
    similar.add(first);
    similar.add(second);
    const auto pairs = similar.pairs(10);
    QCOMPARE(pairs.size(), std::size_t(1));
    QCOMPARE(pairs[0].first, 4);
    QCOMPARE(pairs[0].second, 5);
    const auto shared = similar.sharedLines(first, second);
    // A run that begins in the last common line is nobody else's.
    QVERIFY(shared.first.lines.front() >= 18);
    QVERIFY(shared.first.lines.size() > 15);
}

void TestSimilarPrograms::thousandsAreCompared()
{
    // Different by their numbers, so that every run of tokens is another.
    SimilarPrograms similar(m_lab);
    for (int i = 0; i < 3000; ++i) {
        QString program;
        for (int line = 0; line < 60; ++line)
            program += QStringLiteral("a%2 = b + %1 * (c - %2)\n").arg(i * 100 + line).arg(line);
        similar.add(studentWith(i == 2999 ? own : i == 17 ? renamed(own) : program));
    }
    const auto pairs = similar.pairs(10);
    QCOMPARE(pairs.size(), std::size_t(1));
    QCOMPARE(pairs[0].first, 17);
    QCOMPARE(pairs[0].second, 2999);
}

/// Those who share as much stand by the first of two, and then by the second.
void TestSimilarPrograms::pairsAreInTheOrderOfTheClass()
{
    QStringList order;
    for (const AlikePair &pair : pairsOf({own, renamed(own), own, own}))
        order.append(QStringLiteral("%1-%2").arg(pair.first).arg(pair.second));
    QCOMPARE(order.join(u' '), QStringLiteral("0-1 0-2 0-3 1-2 1-3 2-3"));
}

QTEST_APPLESS_MAIN(TestSimilarPrograms)
#include "test_similar_programs.moc"

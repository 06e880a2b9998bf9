// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_programs.h"
#include "tests/slips.h"

#include "tasks/authoring/mutations.h"
#include "tasks/judging/condition_words.h"
#include "tasks/judging/flight_words.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/wall_words.h"
#include "tasks/report/report_json.h"

#include <QCryptographicHash>

#include <map>

using namespace cradle;

/// What is told of many programs, whatever checks they fail: those of tests/approved, the solutions
/// with a token changed (mutantsOf()), solutions that are so only at times, and solutions with a
/// slip after every step. What has been told in other numbers in the same step is written down by
/// its hash, of slips only the headlines and the hash.
class TestApprovedTold : public QObject
{
    Q_OBJECT
private slots:
    void deviationsAreAsApproved_data() { approved::addSteps(); }
    void deviationsAreAsApproved();
};

namespace {

/// When a program is wrong that is right else.
constexpr const char *conditions[] = {"steps > 80",
                                      "steps % 3 == 0",
                                      "circles[1].velocity.x > 0",
                                      "circles[1].velocity:length() > 1.5",
                                      "circles[1].position.y < 0",
                                      "circles[#circles].velocity:length() < 0.01",
                                      "circles[1].radius > 0.25",
                                      "circles[#circles].density > 3",
                                      "gravity.y == 0",
                                      "restitution < 0.7",
                                      "h > 0.02"};

QString wrongIf(const QString &right, const QString &wrong, const char *condition)
{
    return QStringLiteral("do\n%1\nend\nlocal right = on_update\ndo\n%2\nend\n"
                          "local wrong, steps = on_update, 0\n"
                          "function on_update(h)\n"
                          "  steps = steps + 1\n"
                          "  if %3 then wrong(h) else right(h) end\n"
                          "end\n")
        .arg(right, wrong, QString::fromLatin1(condition));
}

std::vector<approved::Program> programs(const Task &task)
{
    std::vector<approved::Program> all = approved::programsOf(task.id);
    const std::vector<Mutant> mutants = mutantsOf(task.solution);
    for (std::size_t i = 0; i < mutants.size(); i += 3)
        all.push_back({mutants[i].name, mutants[i].source});
    // As many mutants as conditions, from all parts of the program.
    const std::size_t count = std::size(conditions);
    for (std::size_t i = 0; i < count && !mutants.empty(); ++i) {
        const Mutant &wrong = mutants[(2 * i + 1) * mutants.size() / (2 * count)];
        all.push_back({wrong.name + QStringLiteral(" if ") + QString::fromLatin1(conditions[i]),
                       wrongIf(task.solution, wrong.source, conditions[i])});
    }
    return all;
}

QString told(const LawDeviation &deviation)
{
    QString circles;
    for (const int circle : deviation.moment.circles)
        circles += QStringLiteral(" %1").arg(circle + 1);
    QString message = deviation.message;
    message.replace(QStringLiteral("\n\n"), QStringLiteral("\n  "));
    return QStringLiteral(
               "%1, suspect %2, topic %3, %4 shown, step %5, circles%6, %7%8%9 %10\n  %11\n")
        .arg(aspectName(deviation.aspect))
        .arg(int(deviation.suspect))
        .arg(int(deviation.topic))
        .arg(deviation.shown)
        .arg(deviation.moment.step)
        .arg(circles)
        .arg(int(deviation.moment.isPosition))
        .arg(int(deviation.isEverywhere))
        .arg(int(deviation.isConditional))
        .arg(deviation.family, message);
}

QString told(const MeasuredLaws &own, const MeasuredLaws &right, const Ground &ground)
{
    std::vector<std::pair<Aspect, std::vector<LawDeviation>>> all;
    if (!ground.timesteps.empty() && !ground.gravities.empty()) {
        all.emplace_back(Aspect::Motion, flightDeviations(own.flight(), right.flight(), ground));
        if (!ground.walls.circles.empty())
            all.emplace_back(Aspect::Walls, wallDeviations(own.walls(), right.walls(), ground));
        if (ground.pair.asked) {
            all.emplace_back(Aspect::Contact, contactDeviations(own.pair(), right.pair(), ground));
            all.emplace_back(Aspect::Response,
                             responseDeviations(own.pair(), right.pair(), ground));
        }
    }
    const Moment shown{.stage = {ground.own, false}};
    QString text;
    for (const auto &[aspect, found] : all) {
        for (const LawDeviation &deviation :
             conditioned(aspect, found, own, right, ground, shown).deviations)
            text += told(deviation);
    }
    return text;
}

QString hashOf(const QString &text)
{
    return QString::fromLatin1(
        QCryptographicHash::hash(text.toUtf8(), QCryptographicHash::Sha256).toHex().left(12));
}

QStringList headlinesOf(const QString &text)
{
    static const QRegularExpression headline(QStringLiteral("^\\S.*\\n(  .*\\n)"),
                                             QRegularExpression::MultilineOption);
    QStringList all;
    for (auto found = headline.globalMatch(text); found.hasNext();)
        all.append(found.next().captured(1));
    return all;
}

} // namespace

void TestApprovedTold::deviationsAreAsApproved()
{
    QFETCH(Task, task);
    approved::failOnWarnings();
    static const QRegularExpression numbers(QStringLiteral("[0-9][0-9.e/−-]*"));
    const Ground ground(task, task.preset);
    const MeasuredLaws right(&task.solution, ground);
    QString all;
    std::map<QString, QString> first; ///< who told the same in other numbers
    for (const approved::Program &program : programs(task)) {
        const MeasuredLaws own(&program.source, ground);
        const QString text = told(own, right, ground);
        const auto [as, isNew] =
            first.try_emplace(QString(text).replace(numbers, QStringLiteral("0")), program.name);
        all += QStringLiteral("== ") + program.name + QLatin1Char('\n');
        all += isNew ? text : QStringLiteral("as %1, %2\n").arg(as->second, hashOf(text));
    }
    for (const char *slip : approved::slips) {
        const QString program = approved::withSlip(task.solution, slip);
        const QString text = told(MeasuredLaws(&program, ground), right, ground);
        all += QStringLiteral("== %1, %2\n").arg(QLatin1String(slip), hashOf(text))
               + headlinesOf(text).join(QString());
    }
    const QString difference = approved::compare(QStringLiteral("told/%1.txt").arg(task.id), all);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedTold)
#include "test_approved_told.moc"

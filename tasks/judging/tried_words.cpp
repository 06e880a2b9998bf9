// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/tried_words.h"

#include "tasks/judging/brief_beside.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct TriedText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

using Tried = Condition::Kind;

/// \p text with the last right value and the first wrong one, told so that they differ.
QString withLimits(const QString &text, const Condition &condition)
{
    return text.arg(briefBeside(condition.inside, condition.outside),
                    briefBeside(condition.outside, condition.inside));
}

QString countedIn(const Condition &condition)
{
    switch (condition.counted) {
    case Condition::Counted::InRun:
        break;
    case Condition::Counted::OfCircle:
        return TriedText::tr("of each circle in a run");
    case Condition::Counted::AtWall:
        return TriedText::tr("of each circle at each wall in a run");
    }
    return TriedText::tr("in a run");
}

QString limitText(Tried kind)
{
    switch (kind) {
    case Tried::Pause:
        return TriedText::tr("all that came %1 s or more after the one before, none that came "
                             "within %2 s");
    case Tried::Until:
        return TriedText::tr("all up to %1 s of a run, none from %2 s on");
    case Tried::From:
        return TriedText::tr("all from %1 s of a run on, none up to %2 s");
    case Tried::Above:
        return TriedText::tr("all at y = %1 m and above, none at y = %2 m and below");
    case Tried::Below:
        return TriedText::tr("all at y = %1 m and below, none at y = %2 m and above");
    case Tried::LeftOf:
        return TriedText::tr("all at x = %1 m and left of it, none at x = %2 m and right of it");
    case Tried::RightOf:
        return TriedText::tr("all at x = %1 m and right of it, none at x = %2 m and left of it");
    case Tried::Slower:
        return TriedText::tr("all with up to %1 m/s, none with %2 m/s or more");
    case Tried::Faster:
        return TriedText::tr("all with %1 m/s or more, none with up to %2 m/s");
    case Tried::SlowerInto:
        return TriedText::tr("all with up to %1 m/s into the wall, none with %2 m/s or more");
    case Tried::FasterInto:
        return TriedText::tr("all with %1 m/s or more into the wall, none with up to %2 m/s");
    case Tried::SlowerAlong:
        return TriedText::tr("all with up to %1 m/s along the wall, none with %2 m/s or more");
    case Tried::FasterAlong:
        return TriedText::tr("all with %1 m/s or more along the wall, none with up to %2 m/s");
    default:
        return {};
    }
}

/// What comes right up to a time; one that nobody sees pass is none.
QString untilPhrase(const Condition &condition)
{
    constexpr double unseen = 0.005; // s, less than a step that anybody takes
    if (condition.outside < unseen)
        return TriedText::tr("all at the very start of a run, none later");
    if (condition.inside < unseen)
        return TriedText::tr("all at the very start of a run, none from %1 s on")
            .arg(briefBeside(condition.outside, condition.inside));
    return withLimits(limitText(condition.kind), condition);
}

} // namespace

QString triedPhrase(const Condition &condition)
{
    switch (condition.kind) {
    case Tried::Sometimes:
    case Tried::Setting:
        return {};
    case Tried::First:
        return TriedText::tr("the first %1, none of the later ones").arg(countedIn(condition));
    case Tried::NotFirst:
        return TriedText::tr("all but the first %1").arg(countedIn(condition));
    case Tried::FirstFew:
        return withLimits(TriedText::tr("all up to number %1, none from number %2 on, counted %3"),
                          condition)
            .arg(countedIn(condition));
    case Tried::AfterFew:
        return withLimits(TriedText::tr("all from number %1 on, none up to number %2, counted %3"),
                          condition)
            .arg(countedIn(condition));
    case Tried::OddOnes:
        return TriedText::tr("the first, the third and so on %1, none between them")
            .arg(countedIn(condition));
    case Tried::EvenOnes:
        return TriedText::tr("the second, the fourth and so on %1, none between them")
            .arg(countedIn(condition));
    case Tried::BeforeMet:
        return TriedText::tr("all before the two circles had hit each other, none after it");
    case Tried::BeforeHit:
        return TriedText::tr("all before the circles had hit a wall, none after it");
    case Tried::AfterHit:
        return TriedText::tr("all after the circles had hit a wall, none before it");
    case Tried::Rightward:
        return TriedText::tr("all that moved to the right, no others");
    case Tried::Leftward:
        return TriedText::tr("all that moved to the left, no others");
    case Tried::Upward:
        return TriedText::tr("all that moved upward, no others");
    case Tried::Downward:
        return TriedText::tr("all that moved downward, no others");
    case Tried::OtherRightward:
        return TriedText::tr("all while another circle moved to the right, no others");
    case Tried::OtherLeftward:
        return TriedText::tr("all while another circle moved to the left, no others");
    case Tried::OtherUpward:
        return TriedText::tr("all while another circle moved upward, no others");
    case Tried::OtherDownward:
        return TriedText::tr("all while another circle moved downward, no others");
    case Tried::Until:
        return untilPhrase(condition);
    default:
        return withLimits(limitText(condition.kind), condition);
    }
}

namespace {

/// What divides \p tries, as far as it helps; empty where it does not, or nothing is known.
QStringList dividingPhrases(const std::vector<Condition> &all)
{
    constexpr std::size_t most = 2; // more are no help
    QStringList phrases;
    for (const Condition &condition : all)
        phrases.append(triedPhrase(condition));
    phrases.removeAll(QString());
    return all.size() > most ? QStringList() : phrases;
}

/// \param told  with \p phrases in place of %2, where there are any
QString withPhrases(const QString &told, const QStringList &phrases, std::size_t conditions)
{
    const QString all = told.arg(phrases.join(QStringLiteral("; ")));
    return conditions == 1 ? all
                           : all + QLatin1Char(' ')
                                 + TriedText::tr("Which of these counts, the tries do not show.");
}

} // namespace

QString triesTold(const std::vector<Occasion> &tries)
{
    const int right = rightOnes(tries);
    const std::vector<Condition> all = conditionsOf(tries);
    const QStringList phrases = dividingPhrases(all);
    if (phrases.isEmpty())
        return TriedText::tr("Of %1 tries, early and late, here and there, %n came out right.",
                             nullptr, right)
            .arg(tries.size());
    return withPhrases(
        TriedText::tr("Of %1 tries, early and late, here and there, %n came out right: %2.",
                      nullptr, right)
            .arg(tries.size()),
        phrases, all.size());
}

QString answersTold(const std::vector<Occasion> &tries)
{
    const int answered = rightOnes(tries);
    const std::vector<Condition> all = conditionsOf(tries);
    const QStringList phrases = dividingPhrases(all);
    if (phrases.isEmpty())
        return TriedText::tr("Of %1 tries, early and late, here and there, %n were answered.",
                             nullptr, answered)
            .arg(tries.size());
    return withPhrases(
        TriedText::tr("Of %1 tries, early and late, here and there, %n were answered: %2.", nullptr,
                      answered)
            .arg(tries.size()),
        phrases, all.size());
}

} // namespace cradle

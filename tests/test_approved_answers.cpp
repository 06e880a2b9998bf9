// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/draws.h"
#include "tests/lab_test.h"
#include "tests/law_print.h"
#include "tests/told_deviations.h"

#include "tasks/judging/pair_words.h"
#include "tasks/judging/wall_words.h"

#include <QRegularExpression>

using namespace cradle;
using namespace cradle::approved;

/// What is said of programs that answer walls and other circles by other laws,
/// with numbers in them that are wrong by a little or much. Hashes of what is
/// said of some ten each, and how often each headline is, are in
/// tests/approved/answers.txt.
class TestApprovedAnswers : public QObject
{
    Q_OBJECT
private slots:
    void whatIsSaidOfAnswersIsAsApproved();
};

namespace {

/// In all of them A is drawn, and F is 1 + A. Of walls: how near a circle of
/// radius r counts, what else is asked, what comes back and what stays, and
/// where it is put.
constexpr const char *reaches[] = {"r", "r * F", "r + A", "0", "0.2", "r / 2", "2 * r", "r * r"};
constexpr const char *asks[] = {
    "true",           "out > 0",   "out > A", "out < 0",          "steps % 2 == 0",
    "v:length() < 2", "steps > 8", "i == 1",  "c.velocity.y < A", "restitution > 0.4"};
constexpr const char *backs[] = {"e", "e * F",        "1",     "e ^ 2", "1 - e",      "F", "-1",
                                 "0", "math.sqrt(e)", "r * 5", "e + A", "(1 + e) / 2"};
constexpr const char *stays[] = {"1", "F", "e", "0", "-1", "1 + A * e"};
constexpr const char *puts[] = {"c.position",
                                "x",
                                "x + A * v",
                                "c.position + h * c.velocity",
                                "x + F * h * c.velocity",
                                "vec(math.max(-w + r, math.min(w - r, c.position.x)), "
                                "math.max(-w + r, math.min(w - r, c.position.y)))",
                                "vec(math.max(-w, math.min(w, c.position.x)), c.position.y)",
                                "c.position * F",
                                "vec(0, 0)"};
/// Of two circles p and q: when they are near, which line, mass and push they
/// take, and where to.
constexpr const char *nears[] = {"p.radius + q.radius",
                                 "(p.radius + q.radius) * F",
                                 "p.radius + q.radius + A",
                                 "2 * p.radius",
                                 "0.4",
                                 "p.radius * F",
                                 "2 * math.max(p.radius, q.radius)"};
constexpr const char *comes[] = {
    "u > 0", "u > A", "true", "u < 0", "u > 0.3", "steps % 3 > 0", "p.position.x > q.position.x"};
constexpr const char *lines[] = {"d:normalized()",
                                 "(d + vec(A, 0)):normalized()",
                                 "d",
                                 "vec(d.y, d.x):normalized()",
                                 "d:normalized() * F",
                                 "(p.velocity - q.velocity):normalized()",
                                 "vec(1, 0)",
                                 "(oldq - oldp):normalized()"};
constexpr const char *masses[] = {"c.density * c.radius ^ 3",
                                  "c.density * c.radius ^ 3 + A",
                                  "c.density * c.radius ^ (3 * F)",
                                  "c.density * c.radius ^ 2",
                                  "1",
                                  "c.radius ^ 3",
                                  "c.density ^ F * c.radius ^ 3"};
constexpr const char *pushes[] = {"(1 + e) * u",     "(1 + e) * u * F",
                                  "2 * u",           "(1 + e * F) * u",
                                  "(1 + e ^ 2) * u", "u",
                                  "(1 + e) * u + A", "(1 + e) * math.abs(u)",
                                  "(2 - e) * u",     "(1 + e) * p.velocity:dot(n)"};
constexpr const char *places[] = {"p.position, q.position", "oldp, oldq", "oldp, q.position",
                                  "p.position - A * n, q.position + A * n",
                                  "p.position + h * p.velocity, q.position + h * q.velocity"};

constexpr const char *text = R"lua(
local steps = 0
local function mass(c) return MASS end
function on_update(h)
  steps = steps + 1
  local e, w, olds = restitution, square.half_width, {}
  for i, c in ipairs(circles) do
    local x, v, r = c.position, c.velocity, c.radius
    olds[i] = x
    c.velocity = v + gravity * h
    c.position = x + h * VELOCITY
    for _, n in ipairs({vec(1, 0), vec(0, 1), vec(-1, 0), vec(0, -1)}) do
      local out = c.velocity:dot(n)
      local isOdd = ODD
      local reach, asked, back, stay = r, out > 0, e, 1
      if isOdd then reach, asked, back, stay = REACH, ASK, BACK, STAY end
      if c.position:dot(n) + reach > w and asked then
        c.velocity = stay * (c.velocity - out * n) - back * out * n
        c.position = PUT
      end
    end
  end
  local p, q = circles[1], circles[2]
  if not q then return end
  local oldp, oldq, d = olds[1], olds[2], q.position - p.position
  local n = LINE
  local u = (p.velocity - q.velocity):dot(n)
  if d:length() < NEAR and COME then
    local j = PUSH
    local m1, m2 = mass(p), mass(q)
    p.velocity, q.velocity = p.velocity - j * m2 / (m1 + m2) * n, q.velocity + j * m1 / (m1 + m2) * n
    p.position, q.position = PLACE
  end
end
)lua";
constexpr const char *odds[] = {"true", "i == 1", "n.x > 0", "n.y < 0", "n.x ~= 0", "steps > 5"};

QString program(Draws &draws)
{
    QString all = QString::fromLatin1(text);
    const auto fill = [&](const char *word, const auto &of) {
        // Most are right, so that a fault is often alone.
        all.replace(QLatin1String(word),
                    QString::fromLatin1(of[draws.oneOf(3) ? draws.below(std::size(of)) : 0]));
    };
    fill("MASS", masses);
    fill("REACH", reaches);
    fill("ASK", asks);
    fill("BACK", backs);
    fill("STAY", stays);
    fill("PUT", puts);
    fill("LINE", lines);
    fill("NEAR", nears);
    fill("COME", comes);
    fill("PUSH", pushes);
    fill("PLACE", places);
    fill("ODD", odds);
    all.replace(QLatin1String("VELOCITY"), QLatin1String(draws.oneOf(2) ? "v" : "c.velocity"));
    const double by = draws.amount();
    static const QRegularExpression one(QStringLiteral("\\bA\\b"));
    static const QRegularExpression other(QStringLiteral("\\bF\\b"));
    return all.replace(one, QStringLiteral("(%1)").arg(by))
        .replace(other, QStringLiteral("(1 + (%1))").arg(by));
}

QString printOf(const MeasuredWalls &walls)
{
    Print print;
    for (const auto *hits : {&walls.hits, &walls.corners, &walls.slow, &walls.alike, &walls.denser,
                             &walls.slower, &walls.slanted, &walls.far, &walls.middle}) {
        for (const WallHit &hit : *hits)
            print.add(hit);
    }
    for (const Drop &drop : walls.drops)
        print.add(drop);
    return print.text();
}

QString printOf(const MeasuredPair &pair)
{
    Print print;
    for (const auto *hits :
         {&pair.contacts, &pair.otherRadii, &pair.modes, &pair.equals, &pair.radii, &pair.sizes,
          &pair.densities, &pair.rebounds, &pair.inSteps, &pair.partings, &pair.varied}) {
        for (const PairHit &hit : *hits)
            print.add(hit);
    }
    return print.text();
}

} // namespace

void TestApprovedAnswers::whatIsSaidOfAnswersIsAsApproved()
{
    const Lab lab = *readLab(QLatin1String(shippedLab));
    ToldDeviations told(QStringLiteral("answers.txt"));
    unsigned seed = 0;
    for (const char *step : {"L42T17", "L42T14", "L42T7"}) {
        const Task &task = lab.tasks[std::size_t(lab.indexOf(QLatin1String(step)))];
        const Ground ground(task, task.preset);
        const MeasuredLaws right(&task.solution, ground);
        for (int part = 1; part <= 10; ++part) {
            Draws draws(++seed);
            for (int i = 0; i < 8; ++i) {
                const QString source = program(draws);
                const MeasuredLaws own(&source, ground);
                told.add(printOf(own.walls()));
                told.add(wallDeviations(own.walls(), right.walls(), ground));
                told.add(own.walls().isLike(right.walls()));
                if (!ground.pair.asked)
                    continue;
                told.add(printOf(own.pair()));
                told.add(contactDeviations(own.pair(), right.pair(), ground));
                told.add(responseDeviations(own.pair(), right.pair(), ground));
                told.add(own.pair().contactIsLike(right.pair()));
            }
            const QString odd = told.endPart(task.id + QStringLiteral(" %1").arg(part));
            QVERIFY2(odd.isEmpty(), qPrintable(odd));
        }
    }
    const QString difference = told.end();
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedAnswers)
#include "test_approved_answers.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/text_print.h"

#include "tasks/judging/repair_order.h"

#include <QTest>

using namespace cradle;

/// What is read and tried in lines of all forms: hashes of the changes of such lines, whole and in
/// pieces, and of all that is read in the small programs of tests/approved/forms.lua, in
/// tests/approved/forms.txt.
class TestApprovedForms : public QObject
{
    Q_OBJECT
private slots:
    void everyFormIsAsApproved();
};

namespace {

/// Between lines that name two circles, their masses, a line of centres and a value that nobody
/// uses; it is line 9.
constexpr const char *around = R"lua(local kept = {}
function on_update(h)
  local a, b = circles[1], circles[2]
  local u, w = a.position, b.position
  local m1, m2 = a.density * a.radius ^ 3, b.density * b.radius ^ 3
  local va, vb = a.velocity, b.velocity
  local d, n = w - u, (w - u):normalized()
  local unused = m1 * m2 / (m1 + m2)
  LINE
  a.velocity = va - m2 * d:dot(n) * n
  b.velocity = vb + m1 * d:dot(n) * n
end
)lua";
constexpr int theLine = 9;

constexpr const char *operands[] = {"u",
                                    "2",
                                    "a.radius",
                                    "f(u, m1)",
                                    "0.125",
                                    "(va + vb)",
                                    "circles[1].velocity.x",
                                    "d:length()",
                                    "-w.y",
                                    "restitution",
                                    "vec(u.x, 0)",
                                    "math.abs(d.y)",
                                    "b",
                                    "square.left",
                                    "9.81",
                                    "n:dot(va)"};

constexpr const char *signs[] = {"+", "-", "*", "/", "^", "<", ">", "<=", ">=", "==", "..", "//"};

/// With an operand for each of A, B and C, and a sign for each of @ and $.
constexpr const char *places[] = {"x = A @ B", "f(A @ B, C)", "return A @ B $ C",
                                  "if A @ B and C then f() end", "a.velocity = C + A @ B"};

constexpr const char *shapes[] = {"x = math.max(A, B)",
                                  "x = math.min(A, square.right - B)",
                                  "x = math.atan(A / B)",
                                  "x = math.atan(A, B)",
                                  "x = math.sqrt(A)",
                                  "x = vec(A, 0)",
                                  "x = vec(0, A)",
                                  "a.position = vec(A, B)",
                                  "x, y = A, B",
                                  "x, y = A / C, B",
                                  "x, y = A, B * C",
                                  "a.velocity, b.velocity = A, B",
                                  "a.velocity = A",
                                  "a.velocity.x = A",
                                  "local x = A",
                                  "local x, y = A * C, B",
                                  "for i = 1, A do f(i, A) end",
                                  "for i = 1, #circles - 1 do f(circles[i], i, B) end",
                                  "x = (A + B) / 2",
                                  "x = (A + B) * C",
                                  "x = (A - B) * (A - B)",
                                  "x = A * -B + C",
                                  "x = math.abs(A) + d.x",
                                  "if i < 3 or A > count then f() end",
                                  "p = vec(square.left, A)",
                                  "x = circles[i].radius + A",
                                  "x = f(A, (B)) + f(A, (B)) - (C)",
                                  "m1 = A * C + m2",
                                  "local va, vb = A, B",
                                  "local x2 = A - C + B",
                                  "b.velocity = f(A, b)",
                                  "if f(a) then x = A end",
                                  "x = A / (B + C)",
                                  "x = A / B + C",
                                  "x = A * B * C / 2",
                                  "x = A - B * C * 180 / math.pi",
                                  "x = -A * B",
                                  "x = 2 * restitution * A",
                                  "x = 2 - restitution * A",
                                  "x = A ^ 2 * B ^ 3",
                                  "if A < B + C then x = C end",
                                  "if A < B or B > C then f() elseif A then f(B) else f(C) end",
                                  "if not A then return B end",
                                  "if A:length() < B.radius + C.radius then f() end",
                                  "while A < B do x = C end",
                                  "repeat f(A) until B < C",
                                  "x = A and B or C",
                                  "x = {A, B, y = C}",
                                  "kept[1] = A",
                                  "kept[i + 1] = A",
                                  "f(A)(B)",
                                  "A = B",
                                  "x = A -- B * C",
                                  "x = 'A * B' .. C",
                                  "x = 1 / 60 * A",
                                  "x = A * 0.0166",
                                  "x = vec(0, -9.81) * A",
                                  "x = vec(-A.x, 0)",
                                  "x = vec(0, A.y)"};

QString filled(const char *form, std::size_t i)
{
    constexpr std::size_t count = std::size(operands);
    const auto operand = [&](std::size_t k) { return QLatin1String(operands[k % count]); };
    QString line = QLatin1String(form);
    // Not into words such as "B" within "Both".
    return line.replace(QLatin1String("A"), QLatin1String("\1"))
        .replace(QLatin1String("B"), QLatin1String("\2"))
        .replace(QLatin1String("C"), QLatin1String("\3"))
        .replace(QLatin1String("\1"), operand(i))
        .replace(QLatin1String("\2"), operand(5 * i + 3))
        .replace(QLatin1String("\3"), operand(7 * i + 10));
}

void addLine(approved::TextPrint &print, std::size_t &count, const QString &line)
{
    const QString source = QString::fromLatin1(around).replace(QLatin1String("LINE"), line);
    std::vector<Repair> repairs =
        repairsOf(source, QStringLiteral("x = restitution"), {theLine}, 100'000);
    count += repairs.size();
    putInOrder(repairs, source, {theLine}, false);
    print << repairs;
}

template <typename Lines>
QString changesOf(const QString &name, Lines lines)
{
    approved::TextPrint print;
    std::size_t count = 0;
    lines([&](const QString &line) { addLine(print, count, line); });
    return QStringLiteral("%1: %2 changes %3\n").arg(name).arg(count).arg(print.text());
}

/// What begins and ends anywhere: as it is while somebody types.
constexpr const char *pieces[] = {
    "local x, y = -a.position.x * h ^ 2, b.velocity.y / (m1 + m2) - 9.81",
    "if not u and a.radius + b.radius > d:length() or w <= 3.9 then return end",
    "for i = 1, #circles do f(circles[i], i, k - 1) end",
    "x = math.abs(d.x) + math.max(u, w * z) - math.atan(u / w)",
    "p = vec(a.radius, square.top)",
    "v = vec(-v.x, 0)",
    "v = vec(0, v.y)",
    "return 2 * restitution * circles[1].velocity:dot(n:normalized())",
    "x = (d):normalized() * u:length() / f(u)(w)",
    "r = r1 ^ 2 + r2 ^ 2",
    "inv = 4 / 3 * math.pi * a.radius ^ 3 * a.density",
    "a.velocity, b.velocity = (u + w) / 2, {u, -w, y = 1 / 60}",
    "while u < w and w < z do u = u - 1 break end",
    "self.ball:move(- u, w == z, 'text' .. x)",
    "x = u[1] - u[2] + m1 * m2 ; y = x",
    "local s = h",
    "circles[1].velocity, kept[i].v = (u - w) * (u - w), w",
    "function ball.move(c, h) return c.position, h end",
    "while a.b do repeat f() until u == w end function on_update(h) dt = h end",
};

/// All that is tried in a line that begins or ends at any of its words.
QString piecesTold(const QString &line)
{
    approved::TextPrint print;
    std::size_t count = 0;
    const ProgramLines whole(line);
    const auto add = [&](const QString &piece) {
        const std::vector<Repair> repairs =
            repairsOf(piece, QStringLiteral("x = restitution"), {1}, 100'000);
        count += repairs.size();
        const ProgramLines program(piece);
        print << repairs << approved::statements(program) << approved::lines(program);
    };
    for (const ProgramToken &token : whole.tokens()) {
        add(line.mid(token.start));
        add(line.left(token.end()));
    }
    return QStringLiteral("pieces of %1: %2 changes %3\n").arg(line).arg(count).arg(print.text());
}

QString programTold(const QString &source)
{
    const ProgramLines program(source);
    std::vector<int> all;
    for (int line = 1; line <= program.count(); ++line)
        all.push_back(line);
    std::vector<Repair> repairs =
        repairsOf(source, QStringLiteral("x = restitution"), all, 100'000);
    approved::TextPrint print;
    print << repairs << repairsOf(source, QStringLiteral("x = restitution"), all, 40)
          << repairsOf(source, {}, all, 200);
    putInOrder(repairs, source, {1, 3}, true);
    print << repairs;
    return QStringLiteral("statements %1, lines %2, quantities %3, values %4, %5 changes %6\n")
        .arg(approved::statements(program), approved::lines(program), approved::quantities(program),
             approved::values(program))
        .arg(repairs.size())
        .arg(print.text());
}

} // namespace

void TestApprovedForms::everyFormIsAsApproved()
{
    QString all;
    for (const char *place : places) {
        for (std::size_t k = 0; k < std::size(signs); ++k) {
            QString form =
                QString::fromLatin1(place).replace(QLatin1Char('@'), QLatin1String(signs[k]));
            form.replace(QLatin1Char('$'), QLatin1String(signs[(k + 3) % 5]));
            all += changesOf(form, [&](auto add) {
                for (std::size_t i = 0; i < std::size(operands); ++i)
                    add(filled(form.toLatin1().constData(), i));
            });
        }
    }
    for (const char *shape : shapes) {
        all += changesOf(QString::fromLatin1(shape), [&](auto add) {
            for (std::size_t i = 0; i < std::size(operands); i += 2)
                add(filled(shape, i));
        });
    }
    for (const char *line : pieces)
        all += piecesTold(QString::fromLatin1(line));
    for (const QString &each : approved::read(QStringLiteral("forms.lua"))
                                   .split(QStringLiteral("--== "), Qt::SkipEmptyParts)) {
        const qsizetype end = each.indexOf(QLatin1Char('\n'));
        all += each.left(end) + QStringLiteral(": ") + programTold(each.mid(end + 1));
    }
    const QString difference = approved::compare(QStringLiteral("forms.txt"), all);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedForms)
#include "test_approved_forms.moc"

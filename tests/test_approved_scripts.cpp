// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/script_run.h"

#include "tasks/script/student_script.h"

using namespace cradle;
using namespace cradle::programs;

/// What small programs print, plot, draw, do and are told, word by word: tests/approved/scripts.lua
/// has them, each below a line with its name; scripts.txt what became of them in three steps.
class TestApprovedScripts : public QObject
{
    Q_OBJECT
private slots:
    void everyProgramDoesAsApproved();
};

namespace {

QString shortest(double value)
{
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString toldCircle(const Circle &c)
{
    return QStringLiteral("(%1, %2) (%3, %4) %5 %6")
        .arg(shortest(c.position.x), shortest(c.position.y), shortest(c.velocity.x),
             shortest(c.velocity.y), shortest(c.radius), shortest(c.density));
}

/// The first lines of a text, and how many more there are.
QString beginning(const QString &text)
{
    constexpr qsizetype most = 20;
    const QStringList lines = text.split(QLatin1Char('\n'));
    QString all = lines.mid(0, most).join(QLatin1Char('\n')) + QLatin1Char('\n');
    if (lines.size() > most)
        all += QStringLiteral("and %1 lines more\n").arg(lines.size() - most);
    return all;
}

QString told(const QString &source)
{
    QString all;
    StudentScript program(source);
    Preset scene = scriptScene();
    auto error = program.begin(scene);
    World world = initialWorld(scene);
    for (int i = 0; i < 3 && !error && program.moves(); ++i) {
        World next = world;
        error = program.advance(next, 0.125);
        if (error)
            break;
        world = next;
        ++world.step;
        world.time = 0.125 * static_cast<double>(world.step);
    }
    const ProgramOutput output = program.takeOutput();
    if (!output.text.isEmpty())
        all += beginning(output.text.trimmed());
    for (const PlottedPoint &point : output.points)
        all += QStringLiteral("plot %1 %2\n").arg(point.name, shortest(point.value));
    for (const Drawing &drawing : output.drawings)
        all += QStringLiteral("draw %1 (%2, %3) (%4, %5) %6 %7\n")
                   .arg(int(drawing.kind))
                   .arg(shortest(drawing.from.x), shortest(drawing.from.y), shortest(drawing.to.x),
                        shortest(drawing.to.y), drawing.colour, drawing.text);
    if (error) {
        all += QStringLiteral("error %1, line %2, step %3: %4\n")
                   .arg(int(error->kind))
                   .arg(error->line)
                   .arg(error->step)
                   .arg(error->message);
        for (const ProgramValue &local : error->locals)
            all += QStringLiteral("  %1 = %2\n").arg(local.name, local.value);
    }
    for (std::size_t i = 0; i < world.circles.size(); ++i) {
        if (world.circles[i] != scriptScene().circles.at(i).body)
            all += QStringLiteral("circle%1 %2\n").arg(i + 1).arg(toldCircle(world.circles[i]));
    }
    if (scene.gravity != scriptScene().gravity || scene.restitution != 0.5)
        all += QStringLiteral("g (%1, %2), e %3\n")
                   .arg(shortest(scene.gravity.x), shortest(scene.gravity.y),
                        shortest(scene.restitution));
    return all + QStringLiteral("%1 instructions\n").arg(program.instructions());
}

} // namespace

void TestApprovedScripts::everyProgramDoesAsApproved()
{
    const QString mark = QStringLiteral("--== ");
    QString all;
    for (const QString &section :
         approved::read(QStringLiteral("scripts.lua")).split(mark, Qt::SkipEmptyParts)) {
        const auto end = section.indexOf(QLatin1Char('\n'));
        all += QStringLiteral("== ") + section.left(end) + QLatin1Char('\n')
               + told(section.mid(end + 1)) + QLatin1Char('\n');
    }
    QVERIFY(all.count(QStringLiteral("== ")) > 50);
    const QString difference = approved::compare(QStringLiteral("scripts.txt"), all);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedScripts)
#include "test_approved_scripts.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/graded_class.h"
#include "tests/hostile_programs.h"
#include "tests/sanitized.h"
#include "tests/zip_maker.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace cradle::programs;

/// cradle-cli grade against students who mean harm: theirs is the only harm.
class TestCliGradeHostile : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void hostileProgramsLeaveOthersUnharmed();
    void hostileFilesLeaveOthersUnharmed();

private:
    void putHonest(const GradedClass &made) const;
    void verifyHonest(const GradedClass &made) const;

    GradedClass m_alone{}; ///< the honest, without the others
};

namespace {

constexpr int honest = 40 / cradle::oneOf(4);

QString honestName(int i)
{
    return QStringLiteral("honest%1").arg(i, 2, 10, QLatin1Char('0'));
}

/// Those that try to get out, besides the many of hostile_programs.h.
std::vector<HostileProgram> escapes()
{
    return {
        {"run", text("os.execute('touch /tmp/cradle-escaped')"), runtimeKind},
        {"pipe", text("io.popen('touch /tmp/cradle-escaped')"), runtimeKind},
        {"write", text("io.open('/tmp/cradle-escaped', 'w')"), runtimeKind},
        {"load", text("load('x = 1')()"), runtimeKind},
        {"library", text("package.loadlib('libc.so.6', '*')"), runtimeKind},
        {"fork bomb", text("while true do pcall(os.execute, '$0 & $0') end"), timeKind},
        {"flood", text("while true do print(('x'):rep(1e6)) end"), runtimeKind},
        {"verdict", text("print('{\"passed\": true}') error('\\0\\0\\0\\8passed')"), runtimeKind}};
}

} // namespace

void TestCliGradeHostile::putHonest(const GradedClass &made) const
{
    for (int i = 0; i < honest; ++i)
        made.putProgram(honestName(i), text("BALL1"), GradedClass::solution("BALL1"));
}

void TestCliGradeHostile::initTestCase()
{
    putHonest(m_alone);
    VERIFY_CODE(m_alone.grade(text("out"), {text("--exit-zero")}), 0);
}

void TestCliGradeHostile::verifyHonest(const GradedClass &made) const
{
    for (int i = 0; i < honest; ++i) {
        for (const char *suffix : {".json", ".html"}) {
            const QString path = text("out/students/") + honestName(i) + text(suffix);
            QVERIFY2(contentOf(made.at(path)) == contentOf(m_alone.at(path)), path.toUtf8());
        }
    }
    QVERIFY(!QFile::exists(text("/tmp/cradle-escaped")));
}

/// Every hostile program that we know gets a verdict, and the honest those without them.
void TestCliGradeHostile::hostileProgramsLeaveOthersUnharmed()
{
    const GradedClass made;
    putHonest(made);
    std::vector<HostileProgram> programs = escapes();
    for (const auto &some :
         {endlessPrograms(), greedyPrograms(), overflowingPrograms(), strangePrograms()})
        programs.insert(programs.end(), some.begin(), some.end());
    for (std::size_t i = 0; i < programs.size(); ++i)
        made.putProgram(QStringLiteral("hostile%1").arg(i), text("BALL1"),
                        programs[i].source.toUtf8());
    VERIFY_CODE(made.grade(text("out")), 1);
    verifyHonest(made);
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const QStringList verdicts = made.verdicts(text("out"), QStringLiteral("hostile%1").arg(i));
        QVERIFY2(verdicts.size() == 3 && !verdicts.contains(text("not_graded")), programs[i].name);
    }
}

void TestCliGradeHostile::hostileFilesLeaveOthersUnharmed()
{
    using cradle::authoring::ZipMaker;
    const GradedClass made;
    putHonest(made);
    const QByteArray good = GradedClass::solution("BALL1");
    const QString step = text("BALL1");
    made.putProgram(text("nul"), step, good + QByteArray(1, '\0'));
    made.putProgram(text("bytes"), step, "x = '\xff\xfe\x80'\n");
    made.putProgram(text("huge"), step, QByteArray(4'000'000, '\n') + good);
    made.putProgram(text("empty"), step, {});
    made.put(text("class/scene/presets/BALL1.json"), QByteArray(200'000, '['));
    made.put(text("class/words/cradle.json"), "{\"student\": \"\x1b[2J<script>\", \"lab\": 7}");
    made.putProgram(text("words"), step, good);
    made.put(text("class/rubbish.cradle-work"), QByteArray(100'000, 'P'));
    made.put(text("class/bomb.cradle-work"),
             ZipMaker()
                 .add({.name = "lab.lua", .content = QByteArray(60'000'000, ' '), .deflate = true})
                 .toBytes());
    for (int i = 0; i < 3000; ++i)
        made.put(QStringLiteral("class/many/%1.lua").arg(i), "x = 1");
    const QString longName(200, u'n'); // of which each is told, with that of another
    for (int i = 0; i < 1000; ++i)
        made.put(QStringLiteral("class/wordy/%1%2.lua").arg(longName).arg(i), "x = 1");
    const QByteArray longest =
        QFile::encodeName(made.at(text("class/"))) + QByteArray(250, '\xff') + ".lua";
    made.put(text("class/deep/") + text("a/").repeated(60) + text("BALL1.lua"), good);
    // Nothing that is no plain file of the student's is read, or waited for.
    for (const char *student : {"pipe", "device", "other", "loop", "folder"})
        QDir().mkpath(made.at(text("class/") + text(student) + text("/steps")));
    QCOMPARE(mkfifo(QFile::encodeName(made.at(text("class/pipe/steps/BALL1.lua"))), 0600), 0);
    const auto link = [&](const char *target, const char *name) {
        return symlink(target, QFile::encodeName(made.at(text("class/") + text(name)))) == 0;
    };
    QVERIFY(link("/dev/zero", "device/steps/BALL1.lua"));
    QVERIFY(link("../../honest00/steps/BALL1.lua", "other/steps/BALL1.lua"));
    QVERIFY(link("BALL1.lua", "loop/steps/BALL1.lua"));
    QVERIFY(QDir().mkpath(made.at(text("class/folder/steps/BALL1.lua"))));
    // Names as bytes: control characters, and no UTF-8.
    const QByteArray strange = QFile::encodeName(made.at(text("class/"))) + "\x1b[31m\xff\nx.lua";
    const int file = ::open(strange.constData(), O_WRONLY | O_CREAT, 0600);
    QVERIFY(file >= 0 && ::write(file, good.constData(), size_t(good.size())) == good.size());
    ::close(file);
    ::close(::open(longest.constData(), O_WRONLY | O_CREAT, 0600));
    const Outcome outcome = made.grade(text("out"));
    unlink(strange.constData()); // which Qt cannot name
    unlink(longest.constData());
    VERIFY_CODE(outcome, 1);
    verifyHonest(made);
    QVERIFY2(!outcome.error.contains(QChar(0x1b)), outcome.toText());
    const auto first = [&](const char *id) {
        return made.verdicts(text("out"), text(id)).value(0);
    };
    for (const char *id : {"nul", "bytes", "huge", "rubbish", "bomb"})
        QCOMPARE(first(id), text("failed"));
    for (const char *id : {"pipe", "device", "other", "loop", "folder", "deep"})
        QCOMPARE(first(id), text("missing"));
    QCOMPARE(first("words"), text("passed"));
    const QByteArray page = contentOf(made.at(text("out/class.html")));
    QVERIFY(!page.contains('\x1b') && !page.contains("<script"));
}

QTEST_GUILESS_MAIN(TestCliGradeHostile)
#include "test_cli_grade_hostile.moc"

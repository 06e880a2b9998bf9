// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/hand_in_test.h"
#include "tests/text.h"

#include "tasks/lab_report/chart_svg.h"
#include "tasks/lab_report/ending_page.h"
#include "tasks/lab_report/report_html.h"

#include <QRegularExpression>

using namespace cradle;

/// What becomes of a student's work, whole: the files, answers and commits after each of many
/// doings, what is handed in, and the pages that tell it: tests/approved/work.
class TestApprovedWork : public HandInTest
{
    Q_OBJECT
private slots:
    void initTestCase() { readTheLab(); }
    void doingsAreAsApproved();
    void reportsAreAsApproved();
    void handedInWorkIsAsApproved();
    void chartsAreAsApproved();

private:
    void compare(const char *file, QString now) const;
    [[nodiscard]] QString newInFiles(WorkFiles &before) const;
    [[nodiscard]] QString commits() const;
};

namespace {

const QString first = QStringLiteral("BALL1");
const QString second = QStringLiteral("BALL2");

QString told(const std::optional<Error> &error)
{
    return error ? error->toString() : QStringLiteral("done");
}

template <typename Value>
QString told(const Result<Value> &result)
{
    if (!result)
        return result.error().toString();
    if constexpr (std::is_same_v<Value, QString>)
        return *result;
    else
        return QString::fromUtf8(*result);
}

QString told(const Version &version)
{
    const VersionNote &note = version.note;
    return QStringLiteral("%1, reason %2, passed %3, seed %4, lab %5, %6")
        .arg(version.taskId)
        .arg(int(note.reason))
        .arg(note.passed ? int(*note.passed) : -1)
        .arg(note.seed)
        .arg(note.labHash.left(4), note.findings.join(u' '));
}

} // namespace

void TestApprovedWork::compare(const char *file, QString now) const
{
    static const QRegularExpression ids(QStringLiteral("\\b[0-9a-f]{40,64}\\b"));
    static const QRegularExpression times(
        QStringLiteral("20[0-9]{2}-[0-9]{2}-[0-9]{2}T[0-9:.]+(?:Z|[+-][0-9:]+)?"));
    now.replace(path(""), text("PLACE/"))
        .replace(ids, text("ID"))
        .replace(times, text("TIME"))
        .replace(u' ' + m_lab.hash.left(4), text(" LAB"))
        .replace(QChar(0), text("\\0"));
    const QString difference = approved::compare(text("work/") + text(file), now);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

/// What is other than before in all files but those of git and the lock, which has a process in it.
QString TestApprovedWork::newInFiles(WorkFiles &before) const
{
    WorkFiles now;
    for (const char *folder : {"w", "w/steps", "w/presets", "w/notes"}) {
        for (const QString &name :
             QDir(path(folder)).entryList(QDir::Files | QDir::Hidden, QDir::Name)) {
            if (!name.endsWith(text("lock")))
                now[text(folder) + u'/' + name] = content(path(folder) + u'/' + name);
        }
    }
    QString all;
    for (auto it = now.cbegin(); it != now.cend(); ++it) {
        if (!before.contains(it.key()) || before.value(it.key()) != *it)
            all += it.key() + text(": ") + QString::fromUtf8(it->left(300)).trimmed() + u'\n';
    }
    for (auto it = before.cbegin(); it != before.cend(); ++it) {
        if (!now.contains(it.key()))
            all += it.key() + text(" is gone\n");
    }
    before = now;
    return all;
}

QString TestApprovedWork::commits() const
{
    QString all;
    for (const QString &name :
         git(text("for-each-ref --format=%(refname)")).split(u'\n', Qt::SkipEmptyParts)) {
        all += name + u'\n';
        for (const QString &id : git(text("rev-list ") + name).split(u'\n')) {
            all += git(text("log -1 --format=%an|%cn|%B ") + id).trimmed() + u'\n';
            all +=
                text("  ") + git(text("ls-tree -r --name-only ") + id).replace(u'\n', u' ') + u'\n';
        }
    }
    return all;
}

void TestApprovedWork::doingsAreAsApproved()
{
    takeNewFolder();
    QString all;
    Workspace work(path("w"));
    WorkFiles before;
    const auto add = [&](const char *doing, const QString &said) {
        all += QStringLiteral("== %1: %2\n").arg(text(doing), said);
        for (int i = 0; i < int(m_lab.tasks.size()); ++i) {
            const QString &id = m_lab.tasks[std::size_t(i)].id;
            all += QStringLiteral("%1 %2 %3|")
                       .arg(id)
                       .arg(int(work.has(id)))
                       .arg(told(work.textOf(m_lab, i)).section(u'\n', 0, 0));
            all += work.startOf(m_lab, i).section(u'\n', 0, 0) + u'|' + work.noteOf(id)
                   + (work.passedScene(id) ? text("|scene\n") : text("\n"));
        }
        all += newInFiles(before);
    };
    add("begin", told(work.begin(m_lab, first)));
    add("save", told(work.save(first, text("-- mine\n"))));
    add("save another", told(work.save(second, text("-- second\n"))));
    add("note", told(work.saveNote(first, text("One *note*."))));
    add("the same note", told(work.saveNote(first, text("One *note*."))));
    add("keep note", told(work.keepNote(first)));
    add("keep note again", told(work.keepNote(first)));
    const auto keep = [&](const char *program, const VersionNote &note) {
        add("keep",
            text(program).trimmed() + text(", ") + told(work.keep(first, text(program), note)));
    };
    keep("-- typed\n", {.reason = VersionReason::Typed});
    keep("-- typed\n", {.reason = VersionReason::Before});
    keep("-- wrong\n", {.reason = VersionReason::Checked,
                        .passed = false,
                        .seed = 3,
                        .labHash = m_lab.hash,
                        .findings = {text("one"), text("two")}});
    keep("-- right\n", {.reason = VersionReason::Checked, .passed = true, .seed = 4});
    keep("-- right\n", {.reason = VersionReason::Checked, .passed = true, .seed = 5});
    CheckReport report{.labId = m_lab.id,
                       .labHash = m_lab.hash,
                       .taskId = first,
                       .seed = 5,
                       .passed = true,
                       .byProgram = true,
                       .commit = text("Let the ball fall")};
    add("pass", told(work.commitPass(report, text("-- passed\n"), std::nullopt)));
    report.taskId = second;
    report.commit = text("It bounces");
    add("pass a scene", told(work.commitPass(report, std::nullopt, m_lab.tasks[1].preset)));
    add("student", told(work.setStudent(text("Ada Lovelace"), text("0042"))));
    add("predictions", told(work.saveSaid(text("predictions.json"), "{\"BALL1\": {}}\n")));
    add("the same", told(work.saveSaid(text("predictions.json"), "{\"BALL1\": {}}\n")));
    // Another program at work.
    QVERIFY(!writeFile(path("w/steps/BALL1.lua"), "-- of another\n"));
    QVERIFY(!writeFile(path("w/lab.lua"), QByteArray("\xff\xfe-\0-\0", 6)));
    QVERIFY(!writeFile(path("w/notes/BALL1.md"), "Their note."));
    for (const OutsideEdit &edit : work.outsideEdits(first)) {
        all += edit.path + u'|' + edit.text.value_or(text("no program")) + u'\n';
        add("keep what is of others", told(work.keepOutside(first, edit)));
    }
    add("nothing more", QString::number(work.outsideEdits(first).size()));
    add("note over theirs", told(work.saveNote(first, text("Mine."))));
    QVERIFY(!writeFile(path("w/steps/BALL2.lua"), QByteArray("\xff\xfe-\0-\0a\0", 8)));
    add("foreign", QString::number(work.canConvert(second)));
    add("convert", told(work.replaceForeign(m_lab, 1, true)));
    QVERIFY(!writeFile(path("w/steps/BALL2.lua"), QByteArray("a\0b", 3)));
    add("foreign again", QString::number(work.canConvert(second)));
    add("begin anew", told(work.replaceForeign(m_lab, 1, false)));
    for (const Task &task : m_lab.tasks) {
        for (const Version &version : work.history()->versions(task.id))
            all += told(version) + u'|' + told(work.history()->textOf(version)).trimmed() + u'\n';
    }
    for (const int most : {0, 1, 2, 100})
        all += QStringLiteral("%1: %2 versions, %3 passes\n")
                   .arg(most)
                   .arg(work.history()->versions(first, most).size())
                   .arg(work.history()->passes(most).size());
    Workspace other(path("w"));
    // One after the other: which of two operands is worked out first is the compiler's choice.
    all += text("another window: ") + told(other.begin(m_lab, second)) + u'\n';
    all += QString::number(other.mayWrite()) + u'\n';
    all += told(other.save(second, text("-- x"))) + u'\n';
    all += commits();
    static const QRegularExpression pids(text("process [0-9]+"));
    compare("doings.txt", all.replace(pids, text("process")));
}

void TestApprovedWork::reportsAreAsApproved()
{
    workOnTheLab();
    const HandIn handIn = gathered();
    for (const Drawings drawings : {Drawings::Inside, Drawings::Numbered}) {
        const LabReportPage page = labReportPage(handIn.report, drawings, text("en"));
        compare(drawings == Drawings::Inside ? "report.html" : "report-numbered.html", page.html);
        QCOMPARE(page.drawings.empty(), drawings == Drawings::Inside);
        if (QTest::currentTestFailed())
            return;
    }
    const LabReportPage ended = endingPage(handIn.report, true);
    QString all = ended.html + endingPage(handIn.report, false).html + u'\n';
    for (const QByteArray &drawing : ended.drawings)
        all += QString::fromUtf8(drawing) + u'\n';
    compare("ending.html", all);
}

void TestApprovedWork::handedInWorkIsAsApproved()
{
    workOnTheLab();
    const auto handed = unpackWork(packed(), {});
    QVERIFY(handed.ok());
    QString all;
    for (auto it = handed->cbegin(); it != handed->cend(); ++it) {
        all += QStringLiteral("== ") + it.key() + u'\n';
        if (!it.key().endsWith(text(".bundle")))
            all += QString::fromUtf8(*it) + u'\n';
    }
    QVERIFY(!writeFile(path("ada.cradle-work"), packed()));
    const auto opened = openHandIn(path("ada.cradle-work"), path("opened"));
    QVERIFY(opened.ok());
    const auto work = readWork(*opened, m_lab);
    QVERIFY(work.ok());
    for (const auto &[id, step] : work->steps) {
        all += QStringLiteral("%1 %2|%3|%4\n")
                   .arg(id, step.program.value_or(text("none")).section(u'\n', 0, 0),
                        step.programFault, step.note);
        for (const KeptProgram &kept : step.versions)
            all += told(kept.version) + u'|' + kept.text.section(u'\n', 0, 0) + u'\n';
    }
    all += noteToTeacher(*opened) + u'\n';
    // Anybody may have written it: each half of a file, and each with another byte.
    for (const char *name : {"history.json", "manifest.json", "cradle.json"}) {
        for (const int part : {0, 1, 2, 3}) {
            WorkFiles broken = *handed;
            QByteArray &file = broken[text(name)];
            file = part == 3 ? file.replace("1", "true") : file.left(part * file.size() / 3);
            const auto manifest = manifestOf(broken);
            const StudentWork left = workFrom(broken, m_lab);
            all += QStringLiteral("%1 %2: %3, %4 versions, of %5\n")
                       .arg(text(name))
                       .arg(part)
                       .arg(manifest ? manifest->labId : manifest.error().toString())
                       .arg(left.step(first).versions.size())
                       .arg(left.info.student);
        }
    }
    compare("handed-in.txt", all);
}

void TestApprovedWork::chartsAreAsApproved()
{
    QString all;
    const auto add = [&](double width, double height, const std::vector<ChartLine> &lines) {
        all += QString::fromUtf8(chartSvg(width, height, text("Energy, J"), lines)) + u'\n';
    };
    const auto line = [](const char *name, std::vector<Vec2> points) {
        return ChartLine{.name = text(name), .points = std::move(points), .pen = {}};
    };
    add(400, 200, {});
    add(400, 200, {line("none", {})});
    add(400, 200, {line("one", {{1.0, 2.0}})});
    add(400, 200, {line("flat", {{0.0, 3.0}, {5.0, 3.0}})});
    add(400, 200, {line("zero", {{0.0, 0.0}, {5.0, 0.0}})});
    for (const double scale : {1e-9, 1e-3, 0.07, 1.0, 13.0, 999.0, 1e4, 3e7}) {
        std::vector<Vec2> up;
        std::vector<Vec2> wave;
        for (int i = 0; i <= 20; ++i) {
            up.push_back({0.1 * scale * i, scale * i * i});
            wave.push_back({0.1 * scale * i, scale * (i % 4 - 1.5)});
        }
        add(600, 240, {line("up", up), line("wave & <more>", wave)});
    }
    compare("charts.txt", all);
}

QTEST_GUILESS_MAIN(TestApprovedWork)
#include "test_approved_work.moc"

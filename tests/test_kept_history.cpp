// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/handed_repository.h"
#include "tasks/workspace/kept_history.h"
#include "tests/patience.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <unistd.h>

using namespace cradle;

/// Histories of strangers, read from bytes; made by git itself where a test says so.
class TestKeptHistory : public QObject
{
    Q_OBJECT
private slots:
    void commitsAndVersionsAreRead_data();
    void commitsAndVersionsAreRead();
    void deltasAreResolved();
    void everyFlippedByteIsHarmless();
    void onlyHistoryIsOpened();
    void whatIsNoRepositoryHasNoHistory();

private:
    QString git(const QStringList &arguments) const;
    void makeRepository();
    [[nodiscard]] RepositoryFiles files() const;

    std::unique_ptr<QTemporaryDir> m_folder{};
    mutable int m_minute = 0;
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

const QStringList steps{QStringLiteral("BALL1"), QStringLiteral("BALL2")};

void put(const QString &path, const QByteArray &content)
{
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
}

} // namespace

/// Every call is a minute later than the one before.
QString TestKeptHistory::git(const QStringList &arguments) const
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    const QString when = QStringLiteral("%1 +0200").arg(1'777'600'000 + 60 * ++m_minute);
    for (const char *name : {"GIT_AUTHOR_DATE", "GIT_COMMITTER_DATE"})
        environment.insert(text(name), when);
    for (const char *name : {"GIT_CONFIG_GLOBAL", "GIT_CONFIG_SYSTEM"})
        environment.insert(text(name), text("/dev/null"));
    environment.insert(text("LC_ALL"), text("C"));
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(m_folder->path());
    process.start(text("git"), QStringList{text("-c"), text("user.name=Ada"), text("-c"),
                                           text("user.email=ada@example.org")}
                                   + arguments);
    process.closeWriteChannel();
    return process.waitForFinished(patience) && process.exitCode() == 0
               ? QString::fromUtf8(process.readAllStandardOutput()).trimmed()
               : QString();
}

/// Three commits, of which two change BALL1, one BALL2; and two versions of BALL1 that were
/// checked.
void TestKeptHistory::makeRepository()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_minute = 0;
    git({text("init"), text("-q"), text("-b"), text("main")});
    const auto commit = [&](const char *step, const QByteArray &program) {
        put(m_folder->filePath(text("steps/") + text(step) + text(".lua")), program);
        git({text("add"), text(".")});
        git({text("commit"), text("-q"), text("-m"), text("work")});
    };
    commit("BALL1", "-- one\n");
    commit("BALL1", "-- two\n");
    commit("BALL2", "-- three\n");
    const QString tree = git({text("write-tree")});
    QString parent;
    for (const bool passed : {false, true}) {
        const VersionNote note{.reason = VersionReason::Checked, .passed = passed};
        QStringList line{text("commit-tree"), tree, text("-m"), versionMessage(steps[0], note)};
        if (!parent.isEmpty())
            line += {text("-p"), parent};
        parent = git(line);
    }
    QVERIFY(!parent.isEmpty());
    git({text("update-ref"), text("refs/cradle/versions/BALL1"), parent});
}

RepositoryFiles TestKeptHistory::files() const
{
    const QByteArray folder = QFile::encodeName(m_folder->path());
    const auto read = readRepository(folder, folder + "/.git");
    return read ? *read : RepositoryFiles();
}

void TestKeptHistory::commitsAndVersionsAreRead_data()
{
    QTest::addColumn<QStringList>("packing");
    QTest::newRow("loose") << QStringList{};
    QTest::newRow("packed") << QStringList{text("gc"), text("-q"), text("--aggressive")};
    QTest::newRow("packed, references to bases") << QStringList{
        text("-c"), text("repack.useDeltaBaseOffset=false"), text("repack"), text("-adfq")};
}

void TestKeptHistory::commitsAndVersionsAreRead()
{
    QFETCH(QStringList, packing);
    makeRepository();
    if (!packing.isEmpty()) {
        git(packing);
        const QDir objects(m_folder->filePath(text(".git/objects")));
        QVERIFY(!objects.entryList({text("pack")}).isEmpty());
    }
    const auto history = keptHistory(files(), steps);
    const auto &first = history.at(steps[0]);
    QCOMPARE(first.size(), std::size_t(4));
    int checked = 0;
    for (const Version &version : first)
        checked += version.note.passed.has_value();
    QCOMPARE(checked, 2);
    QCOMPARE(first[0].when.secsTo(first[1].when), -120); // each call of git takes a minute
    QCOMPARE(first[2].note.passed, std::optional(true)); // the newest version first
    QCOMPARE(first[2].when.secsTo(first[3].when), -60);
    QCOMPARE(history.at(steps[1]).size(), std::size_t(1));
    QCOMPARE(history.at(steps[1])[0].id, git({text("rev-parse"), text("HEAD")}));
}

/// Commits with long messages and trees of many files, so that git makes deltas of them.
void TestKeptHistory::deltasAreResolved()
{
    makeRepository();
    for (int i = 0; i < 200; ++i)
        put(m_folder->filePath(QStringLiteral("steps/other%1.lua").arg(i)),
            QByteArray::number(i * 7919));
    for (int i = 0; i < 6; ++i) {
        put(m_folder->filePath(text("steps/BALL2.lua")), QByteArray::number(i));
        git({text("add"), text(".")});
        git({text("commit"), text("-q"), text("-m"),
             text("The same words again and again. ").repeated(50) + QString::number(i)});
    }
    const auto loose = keptHistory(files(), steps);
    git({text("repack"), text("-adfq"), text("--depth=50"), text("--window=50")});
    const QString packs = git({text("verify-pack"), text("-v"),
                               m_folder->filePath(text(".git/objects/pack/"))
                                   + QDir(m_folder->filePath(text(".git/objects/pack")))
                                         .entryList({text("*.idx")})
                                         .value(0)});
    QVERIFY2(packs.contains(text("chain length = ")), packs.toUtf8());
    QCOMPARE(loose.at(steps[1]).size(), std::size_t(7));
    QCOMPARE(keptHistory(files(), steps), loose);
}

void TestKeptHistory::everyFlippedByteIsHarmless()
{
    makeRepository();
    git({text("gc"), text("-q")});
    const RepositoryFiles right = files();
    for (auto it = right.begin(); it != right.end(); ++it) {
        for (qsizetype at = 0; at < it->size(); at += 1 + it->size() / 400) {
            RepositoryFiles broken = right;
            broken[it.key()][at] = static_cast<char>((*it)[at] ^ 0x55);
            (void)keptHistory(broken, steps); // sanitizers look on
            broken[it.key()] = it->left(at);
            (void)keptHistory(broken, steps);
        }
    }
}

/// Neither settings nor hooks nor alternates are of interest, nor what a link leads to.
void TestKeptHistory::onlyHistoryIsOpened()
{
    makeRepository();
    put(m_folder->filePath(text(".git/objects/info/alternates")), "/somewhere/else\n");
    put(m_folder->filePath(text(".git/hooks/post-checkout")), "#!/bin/sh\ntouch /tmp/hooked\n");
    QCOMPARE(symlink("/etc/passwd", QFile::encodeName(m_folder->filePath(text(".git/refs/evil")))),
             0);
    const QStringList names = files().keys();
    QVERIFY(names.contains(text("HEAD")) && names.contains(text("refs/heads/main")));
    for (const QString &name : names)
        QVERIFY2(name == text("HEAD") || name == text("packed-refs")
                     || name.startsWith(text("refs/heads/"))
                     || name.startsWith(text("refs/cradle/"))
                     || (name.startsWith(text("objects/")) && !name.contains(text("info"))),
                 name.toUtf8());
    // A link in the place of a folder could lead to the whole disk.
    QVERIFY(QDir(m_folder->filePath(text(".git/objects"))).removeRecursively());
    QCOMPARE(symlink("/", QFile::encodeName(m_folder->filePath(text(".git/objects")))), 0);
    QVERIFY(keptHistory(files(), steps).empty());
    QVERIFY(!files().keys().join(u' ').contains(text("objects/")));
}

void TestKeptHistory::whatIsNoRepositoryHasNoHistory()
{
    QVERIFY(keptHistory({}, steps).empty());
    QVERIFY(keptHistory({{text("HEAD"), "ref: HEAD"}}, steps).empty());
    m_folder = std::make_unique<QTemporaryDir>();
    put(m_folder->filePath(text(".git")), "gitdir: /somewhere/else\n");
    QVERIFY(files().isEmpty());
    // More than a teacher would wait for.
    QFile::remove(m_folder->filePath(text(".git")));
    put(m_folder->filePath(text(".git/HEAD")), "ref: refs/heads/main\n");
    put(m_folder->filePath(text(".git/objects/pack/large.pack")), QByteArray(33 << 20, 'P'));
    const QByteArray folder = QFile::encodeName(m_folder->path());
    QVERIFY(!readRepository(folder, folder + "/.git"));
}

QTEST_GUILESS_MAIN(TestKeptHistory)
#include "test_kept_history.moc"

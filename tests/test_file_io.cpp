// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/file_io.h"

#include "full_disk.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <thread>

#include <sys/stat.h>
#include <unistd.h>

using namespace cradle;

/// Files are written whole or not at all, and what keeps one from it is said.
class TestFileIo final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void replacesWhatWasThere();
    void leavesNothingBeside();
    void keepsPermissionsAndLinks();
    void aNewFileIsAsOthersAre();
    void fullDiskLeavesTheOldFile_data();
    void fullDiskLeavesTheOldFile();
    void partsWithoutCommitAreNothing();
    void saysWhatIsWrong_data();
    void saysWhatIsWrong();
    void writesToPipes();
    void fullDeviceIsSaid();
    void aFileInMemoryIsReplacedWhole();
    void makesFolders();
    void removesWhatAKilledProcessLeft();

private:
    [[nodiscard]] QString path(const char *name = "f.txt") const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    static QByteArray content(const QString &path);

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestFileIo::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

QByteArray TestFileIo::content(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
}

void TestFileIo::replacesWhatWasThere()
{
    QVERIFY(!writeFile(path(), "a long first content\n"));
    QVERIFY(!writeFile(path(), "second\n"));
    QCOMPARE(content(path()), QByteArray("second\n"));
    QVERIFY(!writeFile(path(), {}));
    QCOMPARE(content(path()), QByteArray());
}

void TestFileIo::leavesNothingBeside()
{
    QVERIFY(!writeFile(path(), "one"));
    QVERIFY(!writeFile(path(), "two"));
    const auto everything = QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot;
    QCOMPARE(QDir(m_folder->path()).entryList(everything), QStringList{QStringLiteral("f.txt")});
}

void TestFileIo::keepsPermissionsAndLinks()
{
    QVERIFY(!writeFile(path(), "one"));
    QCOMPARE(::chmod(QFile::encodeName(path()).constData(), 0640), 0);
    QVERIFY(QFile::link(QStringLiteral("f.txt"), path("link")));
    QVERIFY(!writeFile(path("link"), "two"));
    QVERIFY(QFileInfo(path("link")).isSymLink());
    QCOMPARE(content(path()), QByteArray("two"));
    struct stat there {
    };
    QCOMPARE(::stat(QFile::encodeName(path()).constData(), &there), 0);
    QCOMPARE(there.st_mode & 07777, mode_t(0640));
}

void TestFileIo::aNewFileIsAsOthersAre()
{
    const mode_t before = ::umask(027);
    const auto error = writeFile(path(), "one");
    ::umask(before);
    QVERIFY(!error);
    struct stat there {
    };
    QCOMPARE(::stat(QFile::encodeName(path()).constData(), &there), 0);
    QCOMPARE(there.st_mode & 07777, mode_t(0640));
}

void TestFileIo::fullDiskLeavesTheOldFile_data()
{
    QTest::addColumn<int>("size");
    QTest::newRow("one part of a buffer") << 700;
    QTest::newRow("a program") << 6000;
    QTest::newRow("a long run") << 5'000'000;
}

void TestFileIo::fullDiskLeavesTheOldFile()
{
    QFETCH(int, size);
    QVERIFY(!writeFile(path(), "mine"));
    std::optional<Error> error;
    {
        const FullDisk full(512);
        error = writeFile(path(), QByteArray(size, 'x'));
    }
    QVERIFY(error);
    QCOMPARE(error->file, path());
    QVERIFY2(error->message.contains(QLatin1String("so large")), qPrintable(error->message));
    QCOMPARE(content(path()), QByteArray("mine"));
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
}

void TestFileIo::partsWithoutCommitAreNothing()
{
    QVERIFY(!writeFile(path(), "mine"));
    {
        WholeFile file(path());
        file.append("first ");
        file.append("second");
    }
    QCOMPARE(content(path()), QByteArray("mine"));
    WholeFile file(path());
    file.append("first ");
    file.append("second");
    QVERIFY(!file.commit());
    QCOMPARE(content(path()), QByteArray("first second"));
}

void TestFileIo::saysWhatIsWrong_data()
{
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("words");
    QTest::newRow("no folder") << "none/f.txt"
                               << "no such folder";
    QTest::newRow("a file above") << "file/f.txt"
                                  << "a file is where a folder should be";
    QTest::newRow("a folder") << "folder"
                              << "this is a folder";
    QTest::newRow("a long name") << QString(300, QLatin1Char('n')) << "too long";
}

void TestFileIo::saysWhatIsWrong()
{
    QFETCH(QString, place);
    QFETCH(QString, words);
    QVERIFY(!writeFile(path("file"), "mine"));
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("folder")));
    const auto error = writeFile(m_folder->filePath(place), "x");
    QVERIFY(error);
    QVERIFY2(error->message.contains(words), qPrintable(error->message));
}

void TestFileIo::writesToPipes()
{
    QCOMPARE(::mkfifo(QFile::encodeName(path("pipe")).constData(), 0600), 0);
    QByteArray heard;
    std::thread reader([&] { heard = content(path("pipe")); });
    const auto error = writeFile(path("pipe"), "through");
    reader.join();
    QVERIFY(!error);
    QCOMPARE(heard, QByteArray("through"));
    QVERIFY(!QFileInfo(path("pipe")).isFile());
    QVERIFY(!writeFile(QStringLiteral("/dev/null"), "gone"));
}

void TestFileIo::fullDeviceIsSaid()
{
    const auto error = writeFile(QStringLiteral("/dev/full"), "x");
    QVERIFY(error);
    QCOMPARE(error->message, QStringLiteral("the disk is full"));
}

/// A folder under /dev may hold files as others are: only what stands for a device is written to.
void TestFileIo::aFileInMemoryIsReplacedWhole()
{
    const QTemporaryDir folder(QStringLiteral("/dev/shm/cradle-XXXXXX"));
    if (!folder.isValid())
        QSKIP("there is no folder in memory");
    const QString file = folder.filePath(QStringLiteral("f.txt"));
    QVERIFY(!writeFile(file, "the first, which is longer"));
    QVERIFY(!writeFile(file, "the second"));
    QCOMPARE(content(file), QByteArray("the second"));
}

void TestFileIo::makesFolders()
{
    QVERIFY(!makeFolder(path("a/b/c")));
    QVERIFY(!makeFolder(path("a/b/c")));
    QVERIFY(QFileInfo(path("a/b/c")).isDir());
    QVERIFY(!writeFile(path("file"), "mine"));
    const auto error = makeFolder(path("file/b"));
    QVERIFY(error);
    QCOMPARE(error->message, QStringLiteral("a file is where a folder should be"));
    const auto readOnly = makeFolder(QStringLiteral("/proc/none"));
    QVERIFY(readOnly);
    QCOMPARE(readOnly->message, QStringLiteral("you may not write here"));
}

void TestFileIo::removesWhatAKilledProcessLeft()
{
    QVERIFY(!writeFile(path(), "mine"));
    QVERIFY(!writeFile(path((QByteArray(unfinishedPrefix) + "x1").constData()), "half"));
    removeUnfinished(m_folder->path());
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden),
             QStringList{QStringLiteral("f.txt")});
}

QTEST_APPLESS_MAIN(TestFileIo)
#include "test_file_io.moc"

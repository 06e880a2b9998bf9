// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_list.h"
#include "tasks/reading/lab_reader.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

using namespace cradle;

class TestLabList : public QObject
{
    Q_OBJECT
private slots:
    void shippedLabsAreListedInTheLanguage();
    void shippedLabsOpen();
    void stepsLeadToTheirLab();
    void foldersWithALabAreListedByTitle();
    void translatedTitleIsTaken();
    void missingFolderHasNoLabs();
    void whatCannotBeReadIsNoLab();
    void aMenuHoldsAHundredLabs();

private:
    void writeFile(const QString &name, const QByteArray &text);

    QTemporaryDir m_folder;
};

namespace {

QStringList titlesOf(const std::vector<ListedLab> &labs)
{
    QStringList titles;
    for (const ListedLab &lab : labs)
        titles.append(lab.title);
    return titles;
}

QByteArray labCalled(const char *title)
{
    return QByteArray(R"({"format": 1, "id": "a", "title": ")") + title
           + R"(", "version": "1.0", "language": "en", "steps": ["one"]})";
}

} // namespace

void TestLabList::writeFile(const QString &name, const QByteArray &text)
{
    const QString path = m_folder.filePath(name);
    QVERIFY(QDir().mkpath(QFileInfo(path).path()));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

void TestLabList::shippedLabsAreListedInTheLanguage()
{
    QCOMPARE(titlesOf(shippedLabs(QStringLiteral("en"))),
             (QStringList{QStringLiteral("Lab 4.2 · Physically Based Simulation"),
                          QStringLiteral("Bouncing ball")}));
    QCOMPARE(titlesOf(shippedLabs(QStringLiteral("de"))),
             (QStringList{QStringLiteral("Lab 4.2 · Physikalisch basierte Simulation"),
                          QStringLiteral("Springender Ball")}));
}

void TestLabList::shippedLabsOpen()
{
    for (const ListedLab &listed : shippedLabs(QStringLiteral("en"))) {
        const Result<Lab> lab = readLab(listed.folder);
        QVERIFY2(lab, qPrintable(listed.folder));
        QCOMPARE(lab->title, listed.title);
    }
}

void TestLabList::stepsLeadToTheirLab()
{
    for (const ListedLab &listed : shippedLabs(QStringLiteral("en"))) {
        const Result<Lab> lab = readLab(listed.folder);
        for (const Task &task : lab->tasks)
            QCOMPARE(shippedLabWith(task.id), listed.folder);
    }
    QCOMPARE(shippedLabWith(QString()), QLatin1String(shippedLab));
    QCOMPARE(shippedLabWith(QStringLiteral("nowhere")), QLatin1String(shippedLab));
}

void TestLabList::foldersWithALabAreListedByTitle()
{
    writeFile(QStringLiteral("labs/x/lab.json"), labCalled("Zebra"));
    writeFile(QStringLiteral("labs/y/lab.json"), labCalled("Ant"));
    writeFile(QStringLiteral("labs/broken/lab.json"), "{");
    writeFile(QStringLiteral("labs/other/lab.json"), R"({"title": "No lab"})");
    writeFile(QStringLiteral("labs/empty/readme.txt"), "no lab");
    writeFile(QStringLiteral("labs/lab.json"), labCalled("Not in a folder"));
    const std::vector<ListedLab> labs =
        labsIn(m_folder.filePath(QStringLiteral("labs")), QStringLiteral("en"));
    QCOMPARE(titlesOf(labs), (QStringList{QStringLiteral("Ant"), QStringLiteral("Zebra")}));
    QCOMPARE(labs.front().folder, m_folder.filePath(QStringLiteral("labs/y")));
}

void TestLabList::translatedTitleIsTaken()
{
    writeFile(QStringLiteral("more/x/lab.json"), labCalled("Ant"));
    writeFile(QStringLiteral("more/x/lab.de.json"), R"({"title": "Ameise"})");
    writeFile(QStringLiteral("more/y/lab.json"), labCalled("Bee"));
    writeFile(QStringLiteral("more/y/lab.de.json"), R"({"titel": "Biene"})");
    const QString parent = m_folder.filePath(QStringLiteral("more"));
    QCOMPARE(titlesOf(labsIn(parent, QStringLiteral("de"))),
             (QStringList{QStringLiteral("Ameise"), QStringLiteral("Bee")}));
    QCOMPARE(titlesOf(labsIn(parent, QStringLiteral("en"))),
             (QStringList{QStringLiteral("Ant"), QStringLiteral("Bee")}));
}

void TestLabList::missingFolderHasNoLabs()
{
    QVERIFY(labsIn(m_folder.filePath(QStringLiteral("nowhere")), QStringLiteral("en")).empty());
}

/// A lab.json of more than 256 KiB, a pipe that nobody writes to; labs of one title keep their
/// order.
void TestLabList::whatCannotBeReadIsNoLab()
{
    const QByteArray title = labCalled("Ant");
    constexpr qsizetype most = 256 * 1024;
    writeFile(QStringLiteral("odd/a/lab.json"), title + QByteArray(most - title.size(), ' '));
    writeFile(QStringLiteral("odd/b/lab.json"), title + QByteArray(most + 1 - title.size(), ' '));
    writeFile(QStringLiteral("odd/c/lab.json"), title);
    QVERIFY(QDir().mkpath(m_folder.filePath(QStringLiteral("odd/d"))));
    QCOMPARE(::mkfifo(QFile::encodeName(m_folder.filePath(QStringLiteral("odd/d/lab.json"))), 0600),
             0);
    const QString parent = m_folder.filePath(QStringLiteral("odd"));
    const auto labs = labsIn(parent, QStringLiteral("en"));
    QCOMPARE(labs.size(), std::size_t(2));
    QCOMPARE(labs[0].folder, parent + QStringLiteral("/a"));
    QCOMPARE(labs[1].folder, parent + QStringLiteral("/c"));
}

/// More could not be found in a menu.
void TestLabList::aMenuHoldsAHundredLabs()
{
    for (int i = 0; i < 102; ++i)
        writeFile(QStringLiteral("many/%1/lab.json").arg(i), labCalled("Ant"));
    QCOMPARE(labsIn(m_folder.filePath(QStringLiteral("many")), QStringLiteral("en")).size(),
             std::size_t(100));
}

QTEST_GUILESS_MAIN(TestLabList)
#include "test_lab_list.moc"

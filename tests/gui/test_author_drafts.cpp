// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_author.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_draft.h"
#include "tasks/authoring/lab_edits.h"
#include "tests/patience.h"
#include "tests/test_paths.h"
#include "tests/typist.h"

#include <QProcess>

using namespace cradle;

namespace {

constexpr int killings = 8;
const QString textFile = QStringLiteral("BALL1/instructions.md");

/// Writes on without a pause until it is killed.
int writeForEver(const QString &folder)
{
    AuthorDocument document;
    document.keepDraftsIn(folder + QStringLiteral("/drafts"));
    if (document.open(folder + QStringLiteral("/ball")))
        return 1;
    return typeForEver([&](int key) {
        document.edit(QStringLiteral("Type"),
                      withFile(document.files(), textFile, QByteArray::number(key)),
                      QStringLiteral("text"));
    });
}

} // namespace

/// What an author has not saved is there again after the window was killed.
class TestAuthorDrafts final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void killedWindowLosesLittle();
    void changesComeBackAndCanBeDiscarded();
    void whatOthersChangedMeanwhileIsAskedAbout();
    void savedOrDiscardedLeavesNothing();
    void newLabComesBack();
    void draftOfALivingWindowIsItsOwn();

private:
    [[nodiscard]] QDir drafts() const { return {m_folder->filePath(QStringLiteral("drafts"))}; }
    /// As if another process, which is no more, had kept it.
    void leave(const QString &lab, const LabFiles &files, const LabFiles &onDisk) const;

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_ball;
};

void TestAuthorDrafts::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_ball = m_folder->filePath(QStringLiteral("ball"));
    const auto files = readLabFiles(sourcePath("tasks/labs/bouncing-ball"));
    QVERIFY(files && !saveLabFiles(*files, {}, m_ball));
}

void TestAuthorDrafts::leave(const QString &lab, const LabFiles &files,
                             const LabFiles &onDisk) const
{
    QVERIFY(!saveDraft(drafts().path(), lab, files, onDisk));
    const QString own = QString::number(QCoreApplication::applicationPid());
    for (const QString &name : drafts().entryList(QDir::Files))
        QVERIFY(drafts().rename(name, QString(name).replace(own, QStringLiteral("99999999"))));
}

void TestAuthorDrafts::killedWindowLosesLittle()
{
    std::vector<std::unique_ptr<QTemporaryDir>> folders;
    QStringList paths;
    for (int run = 0; run < killings; ++run) {
        init();
        paths.append(m_folder->path());
        folders.push_back(std::move(m_folder));
    }
    const auto typists = typistsIn(paths);
    for (std::size_t run = 0; run < folders.size(); ++run) {
        m_folder = std::move(folders[run]);
        m_ball = m_folder->filePath(QStringLiteral("ball"));
        // Another number of keys each time, so that it dies at another moment of saving.
        const int keys = keysUntilKilled(*typists[run], 100 + 7 * static_cast<int>(run));
        windows::OpenAuthor author(*m_folder);
        QVERIFY(!author.window.files().open(m_ball));
        const int kept = author.files().contents.value(textFile).toInt();
        QVERIFY2(kept > 0 && keys - kept <= mostLost,
                 qPrintable(QStringLiteral("%1 of %2").arg(kept).arg(keys)));
        author.document().discardDraft();
    }
}

void TestAuthorDrafts::changesComeBackAndCanBeDiscarded()
{
    const LabFiles onDisk = *readLabFiles(m_ball);
    LabFiles changed = onDisk;
    changed.contents[textFile] = "# Mine";
    changed.contents[QStringLiteral("BALL1/new.txt")] = QByteArray("\0\xff", 2);
    changed.contents.remove(QStringLiteral("BALL2/floor.svg"));
    leave(m_ball, changed, onDisk);
    windows::OpenAuthor author(*m_folder);
    QVERIFY(!author.window.files().open(m_ball));
    QVERIFY(author.files() == changed);
    QVERIFY(author.document().isModified());
    QVERIFY(author.window.notice().text().contains(QStringLiteral("without saving")));
    author.click(QStringLiteral("Discard them"));
    QVERIFY(author.files() == onDisk);
    QTRY_VERIFY(drafts().entryList(QDir::Files).isEmpty());
}

void TestAuthorDrafts::whatOthersChangedMeanwhileIsAskedAbout()
{
    const LabFiles onDisk = *readLabFiles(m_ball);
    LabFiles changed = onDisk;
    changed.contents[textFile] = "# Mine";
    leave(m_ball, changed, onDisk);
    LabFiles theirs = onDisk;
    theirs.contents[textFile] = "# Theirs";
    QVERIFY(!saveLabFiles(theirs, onDisk, m_ball));
    windows::OpenAuthor author(*m_folder);
    QVERIFY(!author.window.files().open(m_ball));
    QCOMPARE(author.files().contents.value(textFile), QByteArray("# Mine"));
    const auto refused = author.document().save();
    QVERIFY(refused && refused->message.contains(textFile));
    QCOMPARE(readLabFiles(m_ball)->contents.value(textFile), QByteArray("# Theirs"));
    QVERIFY(!author.document().takeTheirs());
    QCOMPARE(author.files().contents.value(textFile), QByteArray("# Theirs"));
}

void TestAuthorDrafts::savedOrDiscardedLeavesNothing()
{
    windows::OpenAuthor author(*m_folder);
    QVERIFY(!author.window.files().open(m_ball));
    author.document().edit(QStringLiteral("x"), withFile(author.files(), textFile, "# Mine"));
    QTRY_COMPARE(drafts().entryList(QDir::Files).size(), 1);
    QVERIFY(author.window.files().save());
    QVERIFY(drafts().entryList(QDir::Files).isEmpty());
    author.document().edit(QStringLiteral("x"), withFile(author.files(), textFile, "# More"));
    QTRY_COMPARE(drafts().entryList(QDir::Files).size(), 1);
    windows::OpenAuthor::answerQuestion(QStringLiteral("Discard"));
    QVERIFY(author.window.close());
    QVERIFY(drafts().entryList(QDir::Files).isEmpty());
}

void TestAuthorDrafts::newLabComesBack()
{
    LabFiles files = newLab(QStringLiteral("mine"), QStringLiteral("Mine"), QStringLiteral("en"));
    leave({}, files, {});
    windows::OpenAuthor author(*m_folder);
    QVERIFY(!author.window.files().open(m_ball));
    author.click(QStringLiteral("Open it"));
    QVERIFY(author.files() == files);
    QVERIFY(author.document().folder().isEmpty());
    QVERIFY(author.document().isModified());
    QCOMPARE(drafts().entryList(QDir::Files).size(), 1); // this window's own
    author.document().discardDraft();
}

void TestAuthorDrafts::draftOfALivingWindowIsItsOwn()
{
    const LabFiles onDisk = *readLabFiles(m_ball);
    LabFiles changed = onDisk;
    changed.contents[textFile] = "# Mine";
    QVERIFY(!saveDraft(drafts().path(), m_ball, changed, onDisk));
    windows::OpenAuthor author(*m_folder);
    QVERIFY(!author.window.files().open(m_ball));
    QVERIFY(author.files() == onDisk);
    QCOMPARE(drafts().entryList(QDir::Files).size(), 1);
}

int main(int argc, char **argv)
{
    QApplication app(argc, argv);
    if (const QStringList arguments = QApplication::arguments();
        arguments.value(1) == QLatin1String("--type"))
        return writeForEver(arguments.value(2));
    TestAuthorDrafts test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_author_drafts.moc"

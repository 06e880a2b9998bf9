// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_draft.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

/// What an author has not saved is found again when the window that changed it is no more.
class TestLabDraft : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_drafts = std::make_unique<QTemporaryDir>(); }
    void draftOfADeadProcessIsFound();
    void draftOfALivingProcessIsItsOwn();
    void onlyWhatDiffersIsKept();
    void changesGoOntoWhatIsThereNow();
    void eachLabHasItsOwn();
    void newestIsTaken();
    void whatIsNoDraftIsPassedBy_data();
    void whatIsNoDraftIsPassedBy();

private:
    [[nodiscard]] QString drafts() const { return m_drafts->path(); }
    /// Saves what differs, and has the process that did so gone. \return the draft's file
    QString leave(const LabFiles &files, const LabFiles &onDisk, const QString &folder,
                  int process = 99'999'999) const
    {
        if (saveDraft(drafts(), folder, files, onDisk))
            return {};
        const QStringList names = QDir(drafts()).entryList(
            {QStringLiteral("*-%1.json").arg(QCoreApplication::applicationPid())});
        if (names.size() != 1)
            return {};
        const QString path = drafts() + QLatin1Char('/') + names[0].section(QLatin1Char('-'), 0, 0)
                             + QStringLiteral("-%1.json").arg(process);
        return QFile::rename(drafts() + QLatin1Char('/') + names[0], path) ? path : QString();
    }

    std::unique_ptr<QTemporaryDir> m_drafts;
};

namespace {

const QString lab = QStringLiteral("/labs/one");

LabFiles files(const QMap<QString, QByteArray> &contents)
{
    LabFiles made;
    for (auto it = contents.begin(); it != contents.end(); ++it)
        made.contents.insert(it.key(), it.value());
    return made;
}

const LabFiles saved = files({{QStringLiteral("lab.json"), "{}"},
                              {QStringLiteral("S1/a.md"), "a"},
                              {QStringLiteral("S1/b.md"), "b"}});
const LabFiles changed = files({{QStringLiteral("lab.json"), "{}"},
                                {QStringLiteral("S1/a.md"), QByteArray("\0\xff new", 6)},
                                {QStringLiteral("S1/c.md"), "c"}});

} // namespace

void TestLabDraft::draftOfADeadProcessIsFound()
{
    QVERIFY(!findDraft(drafts(), lab, saved));
    const QString path = leave(changed, saved, lab);
    QVERIFY(!path.isEmpty());
    const auto draft = findDraft(drafts(), lab, saved);
    QVERIFY(draft);
    QCOMPARE(draft->folder, lab);
    QCOMPARE(draft->path, path);
    QVERIFY(draft->files == changed);
    QVERIFY(draft->base == saved);
    QVERIFY(draft->when.isValid() && draft->when <= QDateTime::currentDateTimeUtc());
    QCOMPARE(draft->when.timeSpec(), Qt::UTC);
}

void TestLabDraft::draftOfALivingProcessIsItsOwn()
{
    QVERIFY(!saveDraft(drafts(), lab, changed, saved));
    QVERIFY(!findDraft(drafts(), lab, saved)); // this process lives
    QCOMPARE(QDir(drafts()).entryList(QDir::Files).size(), 1);
    removeDraft(drafts(), QStringLiteral("/labs/other"));
    QCOMPARE(QDir(drafts()).entryList(QDir::Files).size(), 1);
    removeDraft(drafts(), lab);
    QCOMPARE(QDir(drafts()).entryList(QDir::Files).size(), 0);
}

void TestLabDraft::onlyWhatDiffersIsKept()
{
    QFile file(leave(changed, saved, lab));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
    const QStringList paths{QStringLiteral("S1/a.md"), QStringLiteral("S1/b.md"),
                            QStringLiteral("S1/c.md")};
    const QJsonObject mine = json.value(QStringLiteral("files")).toObject();
    const QJsonObject before = json.value(QStringLiteral("base")).toObject();
    QCOMPARE(mine.keys(), paths);
    QCOMPARE(before.keys(), paths);
    QVERIFY(mine.value(paths[1]).isNull() && before.value(paths[2]).isNull());
    QCOMPARE(before.value(paths[1]).toString(), QStringLiteral("Yg==")); // b in base64
}

/// Another program may have changed the lab since.
void TestLabDraft::changesGoOntoWhatIsThereNow()
{
    QVERIFY(!leave(changed, saved, lab).isEmpty());
    LabFiles now = saved;
    now.contents[QStringLiteral("lab.json")] = "{\"more\": 1}";
    now.contents[QStringLiteral("S1/b.md")] = "other";
    const auto draft = findDraft(drafts(), lab, now);
    QVERIFY(draft);
    LabFiles expected = changed;
    expected.contents[QStringLiteral("lab.json")] = "{\"more\": 1}";
    QVERIFY(draft->files == expected);
    LabFiles base = saved;
    base.contents[QStringLiteral("lab.json")] = "{\"more\": 1}";
    QVERIFY(draft->base == base);
}

void TestLabDraft::eachLabHasItsOwn()
{
    QVERIFY(!leave(changed, saved, lab).isEmpty());
    QVERIFY(!findDraft(drafts(), QStringLiteral("/labs/other"), saved));
    QVERIFY(!findDraft(drafts(), {}, saved));
    QVERIFY(findDraft(drafts(), QStringLiteral("/labs/two/../one"), saved)); // the same folder
    QVERIFY(!leave(changed, {}, {}).isEmpty());
    const auto unsaved = findDraft(drafts(), {}, {});
    QVERIFY(unsaved && unsaved->folder.isEmpty() && unsaved->files == changed);
}

void TestLabDraft::newestIsTaken()
{
    for (const int process : {99'999'997, 99'999'998, 99'999'999}) {
        LabFiles edited = saved;
        edited.contents[QStringLiteral("S1/a.md")] = QByteArray::number(process);
        QFile file(leave(edited, saved, lab, process));
        // The one in the middle was written last.
        QVERIFY(file.open(QIODevice::ReadWrite));
        const int age = process == 99'999'998 ? 10 : 1000;
        QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-age),
                                 QFileDevice::FileModificationTime));
    }
    const auto draft = findDraft(drafts(), lab, saved);
    QVERIFY(draft);
    QCOMPARE(draft->files.contents.value(QStringLiteral("S1/a.md")), QByteArray("99999998"));
}

void TestLabDraft::whatIsNoDraftIsPassedBy_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<bool>("found");
    QTest::newRow("as it is") << QByteArray() << QByteArray() << true;
    QTest::newRow("another format")
        << QByteArray("\"format\":1") << QByteArray("\"format\":2") << false;
    QTest::newRow("no JSON") << QByteArray("{") << QByteArray("") << false;
    QTest::newRow("outside of the lab") << QByteArray("S1/c.md") << QByteArray("../c.md") << true;
}

void TestLabDraft::whatIsNoDraftIsPassedBy()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(bool, found);
    QFile file(leave(changed, saved, lab));
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray bytes = file.readAll();
    if (!from.isEmpty())
        bytes.replace(from, to);
    file.resize(0);
    file.seek(0);
    file.write(bytes);
    file.close();
    const auto draft = findDraft(drafts(), lab, saved);
    QCOMPARE(draft.has_value(), found);
    if (found) {
        QVERIFY(!draft->files.contents.contains(QStringLiteral("../c.md")));
        QCOMPARE(draft->files.contents.contains(QStringLiteral("S1/c.md")), from.isEmpty());
    }
}

QTEST_GUILESS_MAIN(TestLabDraft)
#include "test_lab_draft.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/test_paths.h"

#include "app/author_window.h"

#include <QDirIterator>

using namespace cradle;
using namespace cradle::windows;

/// Lab 4.2 through the author's window and back: not a byte changes.
class TestAuthorResave : public QObject
{
    Q_OBJECT
private slots:
    void labIsSavedAsItWas();
};

namespace {

QMap<QString, QByteArray> bytesIn(const QString &folder)
{
    QMap<QString, QByteArray> bytes;
    QDirIterator it(folder, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        QFile file(it.next());
        if (file.open(QIODevice::ReadOnly))
            bytes.insert(QDir(folder).relativeFilePath(file.fileName()), file.readAll());
    }
    return bytes;
}

} // namespace

void TestAuthorResave::labIsSavedAsItWas()
{
    const QTemporaryDir folder;
    const QString from = sourcePath("tasks/labs/lab-4.2");
    const QString copy = folder.filePath(QStringLiteral("copy"));
    QVERIFY(!saveLabFiles(*readLabFiles(from), {}, copy));
    const QMap<QString, QByteArray> before = bytesIn(from);
    QVERIFY(before.size() > 200);
    QCOMPARE(bytesIn(copy), before);

    OpenAuthor author(folder);
    QVERIFY(!author.window.files().open(copy));
    QCOMPARE(author.document().steps().size(), 17);
    // Looking at everything changes nothing.
    for (const QString &language : {QStringLiteral("de"), QStringLiteral("en")}) {
        author.document().setLanguage(language);
        for (const QString &step : author.document().steps()) {
            author.document().setStep(step);
            for (int tab = AuthorWindow::Scene; tab <= AuthorWindow::Proof; ++tab) {
                author.window.panes().showTab(tab);
                QCoreApplication::processEvents();
            }
        }
    }
    QVERIFY(!author.document().isModified());
    QCOMPARE(author.document().undoStack().count(), 0);

    // An edit that is taken back, and a title that is written as it was.
    author.window.steps().moveDown();
    author.document().undoStack().undo();
    QVERIFY(!author.document().isModified());
    const QString elsewhere = folder.filePath(QStringLiteral("elsewhere"));
    QVERIFY(!author.document().saveAs(elsewhere));
    QCOMPARE(bytesIn(elsewhere), before);
}

QTEST_MAIN(TestAuthorResave)
#include "test_author_resave.moc"

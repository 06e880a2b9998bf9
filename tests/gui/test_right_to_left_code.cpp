// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/drawn_texts.h"
#include "tests/patience.h"
#include "views/code/code_editor.h"
#include "views/code/run_marks.h"

#include <Qsci/qsciscintilla.h>

#include <QApplication>
#include <QClipboard>
#include <QTest>

using namespace cradle;

/// Words in a program that go from the right: QScintilla drew none of a comment of nothing else.
class TestRightToLeftCode final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void wordsHaveTheirWidth_data();
    void wordsHaveTheirWidth();
    void typedWordsHaveTheirWidth();
    void pastedWordsHaveTheirWidth();
    void undoTakesWordsBack();
    void wordsPastedBehindOthersGoBackAtOnce();
    void copiedWordsHaveNoMarks();
    void undoTakesTheFirstLetterBackAtOnce();
    void dashesStandWhereTheyDoBeforeLatin();

private:
    [[nodiscard]] QsciScintilla &area() { return *m_editor->findChild<QsciScintilla *>(); }
    /// Where the last letter of the first line ends, px.
    [[nodiscard]] long endOfLine()
    {
        QCoreApplication::processEvents(); // marks follow a key
        const long at = area().SendScintilla(QsciScintilla::SCI_GETLINEENDPOSITION, 0UL);
        return area().SendScintilla(QsciScintilla::SCI_POINTXFROMPOSITION, 0UL, at);
    }
    [[nodiscard]] long beginOfLine()
    {
        return area().SendScintilla(QsciScintilla::SCI_POINTXFROMPOSITION, 0UL, 0L);
    }

    std::unique_ptr<CodeEditor> m_editor;
};

void TestRightToLeftCode::init()
{
    QGuiApplication::setLayoutDirection(Qt::RightToLeft);
    m_editor = std::make_unique<CodeEditor>();
    m_editor->resize(700, 120);
    m_editor->show();
    m_editor->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_editor.get(), patience));
    area().setFocus();
}

void TestRightToLeftCode::cleanup()
{
    m_editor.reset();
    QGuiApplication::setLayoutDirection(Qt::LeftToRight);
}

void TestRightToLeftCode::wordsHaveTheirWidth_data()
{
    QTest::addColumn<QString>("line");
    QTest::newRow("Latin") << QStringLiteral("-- runs once");
    QTest::newRow("comment") << QStringLiteral("-- تُنفَّذ مرة واحدة");
    QTest::newRow("sentence") << QStringLiteral("-- أعطِ circle1 سرعتها هنا.");
    QTest::newRow("string") << QStringLiteral("print(\"مرة واحدة\", 1) -- مرة");
    QTest::newRow("Hebrew") << QStringLiteral("  -- שלום עולם");
}

void TestRightToLeftCode::wordsHaveTheirWidth()
{
    QFETCH(QString, line);
    m_editor->setText(line + QLatin1String("\nend\n"));
    QCOMPARE(m_editor->text(), line + QLatin1String("\nend\n"));
    QVERIFY(!m_editor->canUndo());
    QVERIFY2(endOfLine() - beginOfLine() > 40, qPrintable(QString::number(endOfLine())));
    // Every part of the line stands beside the others.
    QString drawn;
    for (const DrawnText &text : drawnTexts(*m_editor))
        drawn += text.text;
    for (QString word : line.split(QLatin1Char(' '), Qt::SkipEmptyParts))
        QVERIFY2(withoutRunMarks(drawn).contains(word.remove(QLatin1Char('.'))), qPrintable(word));
}

void TestRightToLeftCode::typedWordsHaveTheirWidth()
{
    QTest::keyClicks(&area(), QStringLiteral("-- "));
    for (const QChar letter : QStringLiteral("مرة واحدة"))
        QTest::sendKeyEvent(QTest::Click, &area(), Qt::Key_unknown, letter, Qt::NoModifier);
    QVERIFY(endOfLine() - beginOfLine() > 60);
    QCOMPARE(m_editor->text(), QStringLiteral("-- مرة واحدة"));
    QTest::keyClicks(&area(), QStringLiteral(" x"));
    QCOMPARE(m_editor->text(), QStringLiteral("-- مرة واحدة x"));
}

void TestRightToLeftCode::pastedWordsHaveTheirWidth()
{
    QGuiApplication::clipboard()->setText(QStringLiteral("-- مرة واحدة\n-- مرة"));
    area().paste();
    QVERIFY(endOfLine() - beginOfLine() > 60);
    QCOMPARE(m_editor->text(), QStringLiteral("-- مرة واحدة\n-- مرة"));
}

void TestRightToLeftCode::undoTakesWordsBack()
{
    m_editor->setText(QStringLiteral("x = 1"));
    QGuiApplication::clipboard()->setText(QStringLiteral("-- مرة\n"));
    area().paste();
    QCoreApplication::processEvents();
    QCOMPARE(m_editor->text(), QStringLiteral("-- مرة\nx = 1"));
    m_editor->undo();
    QCoreApplication::processEvents();
    QCOMPARE(m_editor->text(), QStringLiteral("x = 1"));
    QVERIFY(!m_editor->canUndo());
}

void TestRightToLeftCode::wordsPastedBehindOthersGoBackAtOnce()
{
    const QString words = QStringLiteral("-- مرة");
    m_editor->setText(words);
    area().SendScintilla(QsciScintilla::SCI_DOCUMENTEND);
    QGuiApplication::clipboard()->setText(QStringLiteral("واحدة"));
    QTest::keyClick(&area(), Qt::Key_V, Qt::ControlModifier);
    QCoreApplication::processEvents();
    QCOMPARE(m_editor->text(), words + QStringLiteral("واحدة"));
    m_editor->undo();
    QCoreApplication::processEvents();
    QCOMPARE(m_editor->text(), words);
    QVERIFY(!m_editor->canUndo());
}

/// The marks are the editor's own: no other program gets them.
void TestRightToLeftCode::copiedWordsHaveNoMarks()
{
    const QString line = QStringLiteral("print(\"مرة واحدة\") -- مرة");
    m_editor->setText(line);
    QVERIFY(area().text() != line);
    m_editor->selectAll();
    area().copy();
    QCOMPARE(QGuiApplication::clipboard()->text(), line);
}

void TestRightToLeftCode::undoTakesTheFirstLetterBackAtOnce()
{
    m_editor->setText(QStringLiteral("-- "));
    area().SendScintilla(QsciScintilla::SCI_DOCUMENTEND);
    const QString words = QStringLiteral("مرة");
    for (const QChar letter : words)
        QTest::sendKeyEvent(QTest::Click, &area(), Qt::Key_unknown, letter, Qt::NoModifier);
    QCoreApplication::processEvents();
    QCOMPARE(m_editor->text(), QStringLiteral("-- ") + words);
    m_editor->undo(); // what followed the first letter
    QCoreApplication::processEvents();
    QCOMPARE(m_editor->text(), QStringLiteral("-- ") + words.left(1));
    m_editor->undo();
    QCoreApplication::processEvents();
    QCOMPARE(m_editor->text(), QStringLiteral("-- "));
    QVERIFY(!m_editor->canUndo());
}

/// A font that joins two dashes to one sign drew it a letter further left before Arabic.
void TestRightToLeftCode::dashesStandWhereTheyDoBeforeLatin()
{
    // Columns of pixels with ink where the two dashes stand, past the cursor.
    const auto inked = [this](const QString &line) {
        m_editor->setText(line + QLatin1Char('\n'));
        area().SendScintilla(QsciScintilla::SCI_DOCUMENTEND);
        QCoreApplication::processEvents();
        const QImage image = area().viewport()->grab().toImage();
        const auto place = [this](long position) {
            return static_cast<int>(
                area().SendScintilla(QsciScintilla::SCI_POINTXFROMPOSITION, 0UL, position));
        };
        const int height =
            static_cast<int>(area().SendScintilla(QsciScintilla::SCI_TEXTHEIGHT, 0UL));
        const QColor ground = image.pixelColor(place(0) - 1, height / 2);
        QList<int> dashes;
        for (int dash = 0; dash < 2; ++dash) {
            int columns = 0;
            for (int x = place(dash); x < place(dash + 1); ++x) {
                for (int y = 0; y < height; ++y) {
                    if (qAbs(image.pixelColor(x, y).lightness() - ground.lightness()) > 40) {
                        ++columns;
                        break;
                    }
                }
            }
            dashes.append(columns);
        }
        return dashes;
    };
    for (const int columns : inked(QStringLiteral("-- runs once")))
        QVERIFY(columns >= 4);
    for (const int columns : inked(QStringLiteral("-- تُنفَّذ مرة واحدة")))
        QVERIFY(columns >= 4);
}

QTEST_MAIN(TestRightToLeftCode)

#include "test_right_to_left_code.moc"

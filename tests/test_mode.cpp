// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab/mode.h"

#include "tasks/reading/known_scripts.h"
#include "tasks/reading/lab_reader.h"

#include <QTest>

using namespace cradle;

/// Texts for those who explore and for those who write code.
class TestMode final : public QObject
{
    Q_OBJECT
private slots:
    void everyModeHasItsWord();
    void partsAreForTheirMode();
    void hintsAreForTheirMode();
    void shippedStepsHaveBoth();
    void commentBlockIsTheMessage();
};

void TestMode::everyModeHasItsWord()
{
    QCOMPARE(modeFrom(QStringLiteral("explore")), Mode::Explore);
    QCOMPARE(modeFrom(QStringLiteral("code")), Mode::Code);
    QVERIFY(!modeFrom(QStringLiteral("all")));
    QCOMPARE(partWords(), (QStringList{QStringLiteral("explore"), QStringLiteral("code"),
                                       QStringLiteral("all")}));
}

void TestMode::partsAreForTheirMode()
{
    const QString text = QStringLiteral("# A\n\n<!-- explore -->\n\nset it\n\n<!-- all -->\n\n"
                                        "<!-- code -->\n\nwrite it\n\n<!-- all -->\nend");
    const QString explore = textFor(Mode::Explore, text);
    QVERIFY(explore.contains(QLatin1String("set it")));
    QVERIFY(!explore.contains(QLatin1String("write it")));
    QVERIFY(explore.endsWith(QLatin1String("end")));
    const QString code = textFor(Mode::Code, text);
    QVERIFY(!code.contains(QLatin1String("set it")));
    QVERIFY(code.contains(QLatin1String("write it")));
    QVERIFY(!code.contains(QLatin1String("<!--")));
    QVERIFY(!explore.contains(QLatin1String("<!--")));
    // Before the first mark and after that of both, all is for both.
    QVERIFY(code.startsWith(QLatin1String("# A\n")) && code.endsWith(QLatin1String("end")));
    Task task;
    task.instructions = text;
    QCOMPARE(taskFor(Mode::Code, task).instructions, code);
}

void TestMode::hintsAreForTheirMode()
{
    Task task;
    task.hints = {QStringLiteral("inspector")};
    QCOMPARE(taskFor(Mode::Code, task).hints, task.hints); // a lab without hints of their own
    task.codeHints = {QStringLiteral("on_load")};
    QCOMPARE(taskFor(Mode::Code, task).hints, task.codeHints);
    QCOMPARE(taskFor(Mode::Explore, task).hints, task.hints);
}

void TestMode::shippedStepsHaveBoth()
{
    for (const char *language : {"en", "de"}) {
        const Result<Lab> lab = readLab(QLatin1String(shippedLab), QLatin1String(language));
        QVERIFY(lab);
        for (const Task &task : lab->tasks) {
            QVERIFY2(textFor(Mode::Code, task.instructions)
                         != textFor(Mode::Explore, task.instructions),
                     qPrintable(task.id));
            QVERIFY2(task.codeHints.size() >= 3, qPrintable(task.id));
            QVERIFY2(!task.solution.isEmpty() && !task.starter.isEmpty(), qPrintable(task.id));
            QVERIFY2(task.mistakes.size() >= 3, qPrintable(task.id));
        }
    }
}

void TestMode::commentBlockIsTheMessage()
{
    QCOMPARE(firstCommentBlock(QStringLiteral("-- Head\n--\n-- Body\n--  more\n\n-- not this\n")),
             QStringLiteral("Head\n\nBody\n more"));
    QCOMPARE(firstCommentBlock(QStringLiteral("x = 1\n-- late\n")), QString());
}

QTEST_APPLESS_MAIN(TestMode)
#include "test_mode.moc"

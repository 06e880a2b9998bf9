// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/cli/graded_class.h"

#include "model/files/file_io.h"

#include <QCryptographicHash>
#include <QRegularExpression>

using namespace cradle::programs;

/// All that cradle-cli grade says and writes of a small class, in all that can become of a step:
/// tests/approved/grade.txt; of most files a hash.
class TestApprovedGrade : public QObject
{
    Q_OBJECT
private slots:
    void classIsAsApproved();
};

void TestApprovedGrade::classIsAsApproved()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    made.put(text("class/bob/lab.lua"), GradedClass::solution("BALL3"));
    made.putProgram(text("cy"), text("BALL1"), QByteArray("x = 1\n\0", 7));
    made.putProgram(text("cy"), text("BALL2"), "function on_update() x.y = 1 end\n");
    made.putProgram(text("cy"), text("BALL3"), "while true do end\n");
    made.put(text("class/dot.cradle-work"), "no archive");
    made.putProgram(text("eve"), text("BALL2"), GradedClass::solution("BALL2"));
    made.putProgram(text("eve"), text("BALL3"),
                    GradedClass::solution("BALL3").replace("restitution *", "restitution ^ 2 *"));
    made.putProgram(
        text("fay"), text("BALL1"),
        "local t = string.rep('x', 100000)\nfunction on_update(h)\n  t = t .. t\nend\n");
    const Outcome outcome = made.grade(text("out"), {text("--jobs"), text("2")});
    static const QRegularExpression isolation(text("isolation: (.*)\n"));
    static const QRegularExpression hash(text("\\b[0-9a-f]{64}\\b"));
    static const QRegularExpression time(text("[0-9]+:[0-9]{2}:[0-9]{2}"));
    const QByteArray here = isolation.match(outcome.error).captured(1).toUtf8();
    QVERIFY(!here.isEmpty());
    QString all = QStringLiteral("%1\n%2\n%3\n")
                      .arg(outcome.code)
                      .arg(outcome.out, QString(outcome.error).replace(time, text("TIME")))
                      .replace(QString::fromUtf8(here), text("HERE"));
    const auto files = made.files(text("out"));
    for (auto it = files.cbegin(); it != files.cend(); ++it) {
        if (it.key() == text("lab.cradle"))
            continue; // the lab itself, of which any edit has another hash, too
        const QByteArray file = QString::fromUtf8(QByteArray(*it).replace(here, "HERE"))
                                    .replace(hash, text("HASH"))
                                    .toUtf8();
        all += it.key() + u' ';
        all += it.key().endsWith(text(".csv"))
                   ? u'\n' + QString::fromUtf8(file)
                   : QString::fromLatin1(
                       QCryptographicHash::hash(file, QCryptographicHash::Sha256).toHex().left(32));
        all += u'\n';
    }
    const QString difference = cradle::approved::compare(text("grade.txt"), all);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedGrade)
#include "test_approved_grade.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "class_of_three.h"
#include "tasks/grading/csv_text.h"
#include "tasks/grading/gradebooks.h"
#include "tasks/grading/roster.h"
#include "tool_run.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;
using namespace cradle::classes;

/// The tables that other programs read of a class; each is read back by a program of its kind.
class TestGradebooks : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void pointsAreRoundedOnce_data();
    void pointsAreRoundedOnce();
    void latenessTakesItsPart_data();
    void latenessTakesItsPart();
    void noVerdictIsNoSum();
    void fieldsAreQuotedAndHarmless_data();
    void fieldsAreQuotedAndHarmless();
    void tablesReadBack_data();
    void tablesReadBack();
    void awkwardNamesReadBack_data();
    void awkwardNamesReadBack();
    void marksAreWhereTheyDoNoHarm_data();
    void marksAreWhereTheyDoNoHarm();
    void plainTableIsARoster();
    void canvasHasItsTwoHeadLines();
    void numbersGoWhereTheyWereGivenOut();

private:
    [[nodiscard]] QJsonArray tableOf(
        const char *name,
        const QString &encoding = QStringLiteral("utf-8-sig")) const; ///< as Python's csv reads it
    QTemporaryDir m_folder;
    Lab m_lab = smallLab();
    ClassFacts m_facts = facts();
};

void TestGradebooks::init()
{
    const std::vector<StudentResult> students{ada(m_lab), bob(m_lab), mallory(m_lab)};
    QVERIFY(keep(m_folder.path(), students, m_lab));
    Gradebooks books(m_lab, m_facts);
    for (const StudentResult &student : students)
        books.add(student);
    QVERIFY(!books.write(m_folder.path()));
}

QJsonArray TestGradebooks::tableOf(const char *name, const QString &encoding) const
{
    const ToolRun ended =
        runTool(QStringLiteral("python3"),
                {QStringLiteral("-c"),
                 QStringLiteral("import csv, json, sys\n"
                                "rows = list(csv.reader(open(sys.argv[1], newline='', "
                                "encoding=sys.argv[2]), strict=True))\n"
                                "print(json.dumps(rows))"),
                 m_folder.filePath(QString::fromLatin1(name)), encoding});
    return ended.code == 0 ? QJsonDocument::fromJson(ended.out).array() : QJsonArray();
}

void TestGradebooks::pointsAreRoundedOnce_data()
{
    QTest::addColumn<double>("points");
    QTest::addColumn<QString>("text");
    QTest::newRow("whole") << 3.0 << QStringLiteral("3");
    QTest::newRow("a third") << 1.0 / 3.0 << QStringLiteral("0.33");
    QTest::newRow("two thirds") << 2.0 / 3.0 << QStringLiteral("0.67");
    QTest::newRow("half of a hundredth, up") << 0.125 << QStringLiteral("0.13");
    QTest::newRow("a half that is less in binary") << 1.005 << QStringLiteral("1.01");
    QTest::newRow("none") << 0.0 << QStringLiteral("0");
    QTest::newRow("many") << 1e6 << QStringLiteral("1000000");
}

void TestGradebooks::pointsAreRoundedOnce()
{
    QFETCH(double, points);
    QTEST(pointsText(points), "text");
}

void TestGradebooks::latenessTakesItsPart_data()
{
    QTest::addColumn<double>("days");
    QTest::addColumn<double>("perDay");
    QTest::addColumn<double>("most");
    QTest::addColumn<double>("kept");
    QTest::newRow("in time") << 0.0 << 10.0 << 100.0 << 1.0;
    QTest::newRow("early") << -3.0 << 10.0 << 100.0 << 1.0;
    QTest::newRow("a begun day counts whole") << 0.01 << 10.0 << 100.0 << 0.9;
    QTest::newRow("two days") << 1.5 << 10.0 << 100.0 << 0.8;
    QTest::newRow("no more than all") << 20.0 << 10.0 << 100.0 << 0.0;
    QTest::newRow("no more than the most") << 20.0 << 10.0 << 30.0 << 0.7;
    QTest::newRow("no rule") << 20.0 << 0.0 << 100.0 << 1.0;
}

void TestGradebooks::latenessTakesItsPart()
{
    QFETCH(double, days);
    QFETCH(double, perDay);
    QFETCH(double, most);
    QTEST(keptWhenLate(days, {perDay, most}), "kept");
}

void TestGradebooks::noVerdictIsNoSum()
{
    // 3 + 2.5 points, two days late at 10 %.
    QCOMPARE(*pointsOf(ada(m_lab), m_lab, m_facts.late).earned, 4.4);
    QCOMPARE(*pointsOf(mallory(m_lab), m_lab, m_facts.late).earned, 1.0);
    QVERIFY(!pointsOf(bob(m_lab), m_lab, m_facts.late).earned);
    QCOMPARE(pointsOf(bob(m_lab), m_lab).most, 5.5);
}

void TestGradebooks::fieldsAreQuotedAndHarmless_data()
{
    QTest::addColumn<QString>("field");
    QTest::addColumn<QByteArray>("written");
    QTest::newRow("plain") << QStringLiteral("Ada") << QByteArray("Ada");
    QTest::newRow("comma") << QStringLiteral("a,b") << QByteArray("\"a,b\"");
    QTest::newRow("quote") << QStringLiteral("a\"b") << QByteArray("\"a\"\"b\"");
    QTest::newRow("line ends") << QStringLiteral("a\r\nb") << QByteArray("a b");
    QTest::newRow("formula") << QStringLiteral("=1+1") << QByteArray("'=1+1");
    QTest::newRow("formula behind a tab")
        << QStringLiteral("\t@SUM(A1)") << QByteArray("'@SUM(A1)");
    QTest::newRow("plus") << QStringLiteral("+cmd|x") << QByteArray("'+cmd|x");
    QTest::newRow("full width") << QStringLiteral("\uFF1D1") << QStringLiteral("'\uFF1D1").toUtf8();
    QTest::newRow("plus and a number") << QStringLiteral("+1") << QByteArray("'+1");
    QTest::newRow("no number") << QStringLiteral("-inf") << QByteArray("'-inf");
    QTest::newRow("behind the ; of another country")
        << QStringLiteral("Ada;\" =cmd|x") << QByteArray("\"Ada;\"\" '=cmd|x\"");
    QTest::newRow("number below zero") << QStringLiteral("-1.5") << QByteArray("-1.5");
    QTest::newRow("control character") << QStringLiteral("a\x1b[31mb") << QByteArray("a[31mb");
    QTest::newRow("spaces of Canvas")
        << QStringLiteral("    Points Possible") << QByteArray("    Points Possible");
}

void TestGradebooks::fieldsAreQuotedAndHarmless()
{
    QFETCH(QString, field);
    QFETCH(QByteArray, written);
    QCOMPARE(csvRow({field}), written + "\r\n");
}

void TestGradebooks::tablesReadBack_data()
{
    QTest::addColumn<int>("heads");
    QTest::newRow("gradebook.csv") << 1;
    QTest::newRow("gradebooks/moodle.csv") << 1;
    QTest::newRow("gradebooks/canvas.csv") << 2;
    QTest::newRow("gradebooks/blackboard.csv") << 1;
}

void TestGradebooks::tablesReadBack()
{
    QFETCH(int, heads);
    const QJsonArray rows = tableOf(QTest::currentDataTag());
    QCOMPARE(rows.size(), heads + 4); // three and the one who handed in nothing
    for (const QJsonValue &row : rows) {
        QCOMPARE(row.toArray().size(), rows[0].toArray().size());
        for (const QJsonValue &field : row.toArray()) {
            const QString text = field.toString().trimmed();
            bool isNumber = false;
            (void)text.toDouble(&isNumber);
            QVERIFY2(isNumber || text.isEmpty() || !QStringLiteral("=+-@").contains(text[0]),
                     qPrintable(text));
        }
    }
    // The sum is the last column, or before the word of Moodle; in the plain one it has a name.
    const qsizetype column = [&] {
        const QJsonArray head = rows[0].toArray();
        for (qsizetype i = 0; i < head.size(); ++i) {
            if (head[i].toString() == QLatin1String("points"))
                return i;
        }
        return head.size() - (head[0].toString() == QLatin1String("Identifier") ? 2 : 1);
    }();
    const auto sum = [&](int row) { return rows[heads + row].toArray()[column].toString(); };
    QCOMPARE(sum(0), QStringLiteral("4.4"));
    QCOMPARE(sum(1), QString());
    QCOMPARE(sum(2), QStringLiteral("1"));
    QCOMPARE(sum(3), QStringLiteral("0"));
}

void TestGradebooks::awkwardNamesReadBack_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("read");
    const auto row = [](const char *label, const char *name, const char *read) {
        QTest::newRow(label) << QString::fromUtf8(name) << QString::fromUtf8(read);
    };
    row("plus", "+1", "'+1");
    row("at", "@x", "'@x");
    row("formula", "=cmd|' /C calc'!A0", "'=cmd|' /C calc'!A0");
    row("behind a ;", "Eve;=1+1", "Eve;'=1+1");
    row("Arabic", "سارة عبد الله", "سارة عبد الله");
    row("quotes", "Ann \"the \"\" one\"", "Ann \"the \"\" one\"");
    row("lines", "Ann\r\n=1+1", "Ann =1+1");
}

/// In every table there is a row of the name, as many cells as in the others, and its sum.
void TestGradebooks::awkwardNamesReadBack()
{
    QFETCH(QString, name);
    QFETCH(QString, read);
    StudentResult student = ada(m_lab);
    student.name = name;
    Gradebooks books(m_lab, m_facts);
    books.add(student);
    QVERIFY(!books.write(m_folder.path()));
    const std::pair<const char *, int> columns[] = {
        {"gradebook.csv", 1}, {"gradebooks/moodle.csv", 1}, {"gradebooks/canvas.csv", 0}};
    for (const auto &[file, column] : columns) {
        const QJsonArray rows = tableOf(file);
        const QJsonArray found = rows[rows.size() - 2].toArray(); // the last handed in nothing
        QCOMPARE(found.size(), rows[0].toArray().size());
        QCOMPARE(found[column].toString(), read);
        QVERIFY(found.contains(QStringLiteral("4.4")));
    }
    // Blackboard has it in two; the cells of both begin as harmlessly.
    const QJsonArray rows = tableOf("gradebooks/blackboard.csv");
    const QJsonArray found = rows[rows.size() - 2].toArray();
    QCOMPARE(found.size(), rows[0].toArray().size());
    for (const QJsonValue &cell : found)
        QVERIFY(cell.toString().isEmpty() || !QStringLiteral("=+-@").contains(cell.toString()[0]));
    QVERIFY(found.contains(QStringLiteral("4.4")));
}

void TestGradebooks::marksAreWhereTheyDoNoHarm_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("head");
    const QString mark(QChar(0xFEFF));
    QTest::newRow("people") << QStringLiteral("gradebook.csv") << mark + QStringLiteral("id");
    QTest::newRow("Moodle takes it off")
        << QStringLiteral("gradebooks/moodle.csv") << mark + QStringLiteral("Identifier");
    QTest::newRow("Canvas looks for Student in it")
        << QStringLiteral("gradebooks/canvas.csv") << mark + QStringLiteral("Student");
    QTest::newRow("Blackboard") << QStringLiteral("gradebooks/blackboard.csv")
                                << QStringLiteral("Last Name");
}

/// As a reader sees the first cell that knows nothing of marks.
void TestGradebooks::marksAreWhereTheyDoNoHarm()
{
    QFETCH(QString, file);
    QFETCH(QString, head);
    const QJsonArray rows = tableOf(file.toLatin1(), QStringLiteral("utf-8"));
    QCOMPARE(rows[0].toArray()[0].toString(), head);
    QFile written(m_folder.filePath(file));
    QVERIFY(written.open(QIODevice::ReadOnly));
    QCOMPARE(written.readAll().count(byteOrderMark), head.startsWith(QChar(0xFEFF)) ? 1 : 0);
}

void TestGradebooks::plainTableIsARoster()
{
    const auto roster = readRoster(m_folder.filePath(QStringLiteral("gradebook.csv")));
    QVERIFY2(roster, roster ? "" : qPrintable(roster.error().toString()));
    QCOMPARE(roster->size(), std::size_t(4));
    QCOMPARE(roster->front().id, QStringLiteral("ada"));
}

void TestGradebooks::canvasHasItsTwoHeadLines()
{
    const QJsonArray rows = tableOf("gradebooks/canvas.csv");
    QCOMPARE(rows[0].toArray(),
             (QJsonArray::fromStringList(
                 {QStringLiteral("Student"), QStringLiteral("ID"), QStringLiteral("SIS User ID"),
                  QStringLiteral("SIS Login ID"), QStringLiteral("Section"), m_lab.title})));
    QCOMPARE(rows[1].toArray(),
             (QJsonArray::fromStringList(
                 {QStringLiteral("    Points Possible"), {}, {}, {}, {}, QStringLiteral("5.5")})));
}

void TestGradebooks::numbersGoWhereTheyWereGivenOut()
{
    const QJsonArray canvas = tableOf("gradebooks/canvas.csv");
    QCOMPARE(canvas[2].toArray()[1].toString(), QString()); // Ada's is of the university
    QCOMPARE(canvas[2].toArray()[2].toString(), QStringLiteral("0042"));
    QCOMPARE(canvas[4].toArray()[1].toString(), QStringLiteral("-77"));
    QCOMPARE(canvas[4].toArray()[2].toString(), QString());
    const QJsonArray moodle = tableOf("gradebooks/moodle.csv");
    QCOMPARE(moodle[2].toArray()[0].toString(), QStringLiteral("Participant 99"));
    QCOMPARE(moodle[2].toArray()[2].toString(), QString());
    QCOMPARE(moodle[1].toArray()[2].toString(), QStringLiteral("0042"));
}

QTEST_APPLESS_MAIN(TestGradebooks)
#include "test_gradebooks.moc"

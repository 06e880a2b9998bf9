// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/json_schema.h"

#include "tests/scenes.h"

#include <QFile>
#include <QTemporaryDir>

using namespace cradle;

class TestJsonSchema : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void readsAFileWhole();
    void readsNoMoreThanAllowed_data();
    void readsNoMoreThanAllowed();
    void refusesAFolder();
    void refusesAMissingFile();
    void refusesAnEndlessFile();
    void takesWhatFits();
    void refusesWhatDoesNotFit_data();
    void refusesWhatDoesNotFit();
    void countsLinesOfBrokenSyntax_data();
    void countsLinesOfBrokenSyntax();
    void namesTheSource();
    void errorsReadLikeThoseOfACompiler_data();
    void errorsReadLikeThoseOfACompiler();

private:
    QTemporaryDir m_folder;
    QString m_schema;

    QString write(const QString &name, const QByteArray &text) const;
};

QString TestJsonSchema::write(const QString &name, const QByteArray &text) const
{
    const QString path = m_folder.filePath(name);
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? path : QString();
}

void TestJsonSchema::initTestCase()
{
    m_schema = write(QStringLiteral("schema.json"), R"({
        "description": "an object with size and parts", "type": "object",
        "additionalProperties": false, "required": ["size"],
        "properties": {
            "size": {"description": "a number from 1 to 9", "type": "number",
                     "minimum": 1, "maximum": 9},
            "parts": {"description": "a list of parts, or an object with copies", "anyOf": [
                {"type": "array", "items": {"$ref": "#/definitions/part"}},
                {"type": "object", "additionalProperties": false,
                 "properties": {"copies": {"description": "a whole number", "type": "integer"}}}]}
        },
        "definitions": {"part": {
            "description": "an object with kind", "type": "object",
            "additionalProperties": false, "required": ["kind"],
            "properties": {"kind": {"description": "one of nut, bolt", "enum": ["nut", "bolt"]}}}}
    })");
    QVERIFY(!m_schema.isEmpty());
}

void TestJsonSchema::readsAFileWhole()
{
    const QByteArray text("line 1\nline 2\n\0 and on", 22);
    const Result<QByteArray> read = readFile(write(QStringLiteral("text"), text), 1000);
    QVERIFY(read.ok());
    QCOMPARE(*read, text);
}

void TestJsonSchema::readsNoMoreThanAllowed_data()
{
    QTest::addColumn<int>("size");
    QTest::addColumn<bool>("read");
    QTest::newRow("empty") << 0 << true;
    QTest::newRow("below") << 99 << true;
    QTest::newRow("just as many") << 100 << true;
    QTest::newRow("one more") << 101 << false;
    QTest::newRow("far more") << 100'000 << false;
}

void TestJsonSchema::readsNoMoreThanAllowed()
{
    QFETCH(int, size);
    QFETCH(bool, read);
    const QString path = write(QStringLiteral("sized"), QByteArray(size, 'x'));
    const Result<QByteArray> text = readFile(path, 100);
    QCOMPARE(text.ok(), read);
    if (read) {
        QCOMPARE(text->size(), size);
    } else {
        QCOMPARE(text.error().file, path);
        QVERIFY2(text.error().message.contains(QStringLiteral("100")),
                 qPrintable(text.error().message));
    }
}

void TestJsonSchema::refusesAFolder()
{
    const Result<QByteArray> text = readFile(m_folder.path(), 100);
    QVERIFY(!text.ok());
    QCOMPARE(text.error().file, m_folder.path());
}

void TestJsonSchema::refusesAMissingFile()
{
    const QString path = m_folder.filePath(QStringLiteral("missing"));
    const Result<QByteArray> text = readFile(path, 100);
    QVERIFY(!text.ok());
    QCOMPARE(text.error().file, path);
    QVERIFY(!text.error().message.isEmpty());
}

void TestJsonSchema::refusesAnEndlessFile()
{
    if (!QFile::exists(QStringLiteral("/dev/zero")))
        QSKIP("no /dev/zero here");
    QVERIFY(!readFile(QStringLiteral("/dev/zero"), 1000).ok());
}

void TestJsonSchema::takesWhatFits()
{
    for (const char *text : {R"({"size": 1})", R"({"size": 9, "parts": []})",
                             R"({"size": 2.5, "parts": [{"kind": "nut"}, {"kind": "bolt"}]})",
                             R"({"parts": {"copies": 3}, "size": 1e0})"}) {
        const Result<QJsonObject> json = parseJson(text, m_schema, {});
        QVERIFY2(json.ok(), json ? "" : qPrintable(json.error().toString()));
        QVERIFY(json->contains(QStringLiteral("size")));
    }
}

void TestJsonSchema::refusesWhatDoesNotFit_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, const char *text, const char *pointer, const char *says) {
        QTest::newRow(name) << QByteArray(text) << QString::fromLatin1(pointer)
                            << QString::fromLatin1(says);
    };
    row("a list", "[1, 2]", "", "a list of 2 value(s) is not right here");
    row("missing", "{}", "", "\"size\" is missing");
    row("too small", R"({"size": 0.5})", "/size", "0.5 is not right here; right would be a number");
    row("too large", R"({"size": 9.5})", "/size", "a number from 1 to 9");
    row("a text", R"({"size": "2"})", "/size", "\"2\" is not right here");
    row("a truth", R"({"size": true})", "/size", "true is not right here");
    row("null", R"({"size": null})", "/size", "null is not right here");
    row("an object", R"({"size": {}})", "/size", "an object is not right here");
    row("unknown", R"({"size": 2, "seize": 3})", "/seize", "parts, size");
    row("neither branch", R"({"size": 2, "parts": 7})", "/parts", "a list of parts, or");
    row("in a list", R"({"size": 2, "parts": [{"kind": "nut"}, {"kind": "cog"}]})", "/parts/1/kind",
        "\"cog\" is not right here; right would be one of nut, bolt");
    row("two alike in a list",
        R"({"size": 2, "parts": [{"kind": "nut"}, {"kind": "cog"}, {"kind": "peg"}]})",
        "/parts/1/kind", "\"cog\" is not right here");
    row("missing in a list", R"({"size": 2, "parts": [{}]})", "/parts/0", "\"kind\" is missing");
    row("unknown in a list", R"({"size": 2, "parts": [{"kind": "nut", "weight": 1}]})",
        "/parts/0/weight", "unknown key \"weight\"");
    row("in the other branch", R"({"size": 2, "parts": {"copies": 2.5}})", "/parts/copies",
        "a whole number");
}

void TestJsonSchema::refusesWhatDoesNotFit()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, pointer);
    QFETCH(QString, says);
    const Result<QJsonObject> json = parseJson(text, m_schema, {});
    QVERIFY(!json.ok());
    QCOMPARE(json.error().pointer, pointer);
    QCOMPARE(json.error().line, 0);
    QVERIFY2(json.error().message.contains(says), qPrintable(json.error().message));
}

void TestJsonSchema::countsLinesOfBrokenSyntax_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::newRow("nothing") << QByteArray() << 1;
    QTest::newRow("on the first") << QByteArray("{size: 1}") << 1;
    QTest::newRow("on the third") << QByteArray("{\n\"size\": 1,\n\"parts\": x}\n") << 3;
    QTest::newRow("lines of DOS") << QByteArray("{\r\n\"size\": 1,\r\n\"parts\": x}\r\n") << 3;
    QTest::newRow("never closed") << QByteArray("{\n\"size\": 1") << 2;
}

void TestJsonSchema::countsLinesOfBrokenSyntax()
{
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    const Result<QJsonObject> json = parseJson(text, m_schema, {});
    QVERIFY(!json.ok());
    QCOMPARE(json.error().line, line);
    QVERIFY(json.error().pointer.isEmpty());
}

void TestJsonSchema::namesTheSource()
{
    const QString source = QStringLiteral("labs/a.json");
    QCOMPARE(parseJson("{", m_schema, source).error().file, source);
    QCOMPARE(parseJson("{}", m_schema, source).error().file, source);
    QCOMPARE(parseJson(R"({"size": 0})", m_schema, source).error().file, source);
    QCOMPARE(parseJson(R"({"size": 1, "x": 0})", m_schema, source).error().file, source);
}

void TestJsonSchema::errorsReadLikeThoseOfACompiler_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("text");
    const QString file = QStringLiteral("a.json");
    const QString place = QStringLiteral("/gravity/1");
    QTest::newRow("line") << file << QString() << 12 << QStringLiteral("a.json:12: wrong");
    QTest::newRow("pointer") << file << place << 0 << QStringLiteral("a.json: /gravity/1: wrong");
    QTest::newRow("file alone") << file << QString() << 0 << QStringLiteral("a.json: wrong");
    QTest::newRow("no file") << QString() << place << 0 << QStringLiteral("/gravity/1: wrong");
    QTest::newRow("message alone") << QString() << QString() << 0 << QStringLiteral("wrong");
}

void TestJsonSchema::errorsReadLikeThoseOfACompiler()
{
    QFETCH(QString, file);
    QFETCH(QString, pointer);
    QFETCH(int, line);
    QFETCH(QString, text);
    const Error error{QStringLiteral("wrong"), file, pointer, line};
    QCOMPARE(error.toString(), text);
}

QTEST_GUILESS_MAIN(TestJsonSchema)
#include "test_json_schema.moc"

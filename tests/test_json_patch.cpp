// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/json_patch.h"

#include "model/world/random.h"
#include "tasks/authoring/json_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

using namespace cradle;

/// JSON is changed where it differs, and nowhere else.
class TestJsonPatch : public QObject
{
    Q_OBJECT
private slots:
    void changesOnePlace_data();
    void changesOnePlace();
    void numbersTakeTheFewestDigits_data();
    void numbersTakeTheFewestDigits();
    void newFilesAreLaidOutAsTheLabs();
    void anyEditOfAnyTextGivesWhatIsWanted();
    void whatIsTheSameKeepsItsText();
    void textIsTakenApart_data();
    void textIsTakenApart();
};

namespace {

QJsonObject parsed(const QByteArray &text)
{
    return QJsonDocument::fromJson(text).object();
}

int below(Random &random, int count)
{
    return static_cast<int>(random.uniform() * count);
}

QJsonValue anyValue(Random &random, int depth)
{
    switch (below(random, depth > 0 ? 7 : 5)) {
    case 0:
        return random.uniform() < 0.5;
    case 1:
        return below(random, 100) - 50;
    case 2:
        return (random.uniform() - 0.5) * 1e-3;
    case 3:
        return QStringLiteral("\"{}[],:\\ \n größer %1").arg(below(random, 10));
    case 4:
        return QJsonValue();
    case 5: {
        QJsonArray list;
        for (int i = below(random, 4); i > 0; --i)
            list.append(anyValue(random, depth - 1));
        return list;
    }
    default: {
        QJsonObject object;
        for (int i = below(random, 4); i > 0; --i)
            object.insert(QStringLiteral("key \"%1").arg(below(random, 5)),
                          anyValue(random, depth - 1));
        return object;
    }
    }
}

QByteArray anySpace(Random &random)
{
    static const QByteArray spaces[] = {"", " ", "\n", "\t ", "  \r\n"};
    return spaces[below(random, 5)];
}

/// A value in one of the many ways that it can be written in.
QByteArray written(const QJsonValue &value, Random &random)
{
    const auto scalar = [](const QJsonValue &v) {
        const QByteArray list = QJsonDocument(QJsonArray{v}).toJson(QJsonDocument::Compact);
        return list.mid(1, list.size() - 2);
    };
    if (value.isArray()) {
        QByteArray text = "[" + anySpace(random);
        const QJsonArray list = value.toArray();
        for (qsizetype i = 0; i < list.size(); ++i)
            text += (i > 0 ? "," + anySpace(random) : QByteArray()) + written(list.at(i), random)
                    + anySpace(random);
        return text + "]";
    }
    if (!value.isObject())
        return scalar(value);
    QByteArray text = "{" + anySpace(random);
    const QJsonObject object = value.toObject();
    bool first = true;
    for (auto it = object.begin(); it != object.end(); ++it) {
        text += (first ? QByteArray() : "," + anySpace(random)) + scalar(it.key())
                + anySpace(random) + ":" + anySpace(random) + written(it.value(), random)
                + anySpace(random);
        first = false;
    }
    return text + "}";
}

/// Something else at one place, or a little more or less.
QJsonValue edited(const QJsonValue &value, Random &random)
{
    if (value.isArray() && random.uniform() < 0.9) {
        QJsonArray list = value.toArray();
        if (list.isEmpty() || random.uniform() < 0.3)
            list.insert(below(random, static_cast<int>(list.size()) + 1), anyValue(random, 2));
        else if (random.uniform() < 0.3)
            list.removeAt(below(random, static_cast<int>(list.size())));
        else if (random.uniform() < 0.3)
            list.append(list.takeAt(0));
        else
            list[0] = edited(list.at(0), random);
        return list;
    }
    if (value.isObject() && random.uniform() < 0.9) {
        QJsonObject object = value.toObject();
        const QStringList keys = object.keys();
        if (keys.isEmpty() || random.uniform() < 0.3) {
            object.insert(QStringLiteral("new %1").arg(below(random, 3)), anyValue(random, 2));
            return object;
        }
        const QString key = keys.at(below(random, static_cast<int>(keys.size())));
        if (random.uniform() < 0.3)
            object.remove(key);
        else
            object.insert(key, edited(object.value(key), random));
        return object;
    }
    return anyValue(random, 2);
}

} // namespace

void TestJsonPatch::changesOnePlace_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("wanted");
    QTest::addColumn<QByteArray>("patched");
    const auto row = [](const char *name, const char *text, const char *wanted,
                        const char *patched) {
        QTest::newRow(name) << QByteArray(text) << QByteArray(wanted) << QByteArray(patched);
    };
    row("a number", "{\"a\": 1.0, \"b\": 2}\n", R"({"a": 1, "b": 3})", "{\"a\": 1.0, \"b\": 3}\n");
    row("a text", "{\n  \"title\": \"Old\"\n}\n", R"({"title": "New \"one\""})",
        "{\n  \"title\": \"New \\\"one\\\"\"\n}\n");
    row("a new member goes where it belongs", "{\n  \"id\": \"S1\",\n  \"hints\": []\n}\n",
        R"({"id": "S1", "hints": [], "title": "T"})",
        "{\n  \"id\": \"S1\",\n  \"title\": \"T\",\n  \"hints\": []\n}\n");
    row("a member that is gone", "{\n  \"id\": \"S1\",\n  \"extra\": true\n}\n", R"({"id": "S1"})",
        "{\n  \"id\": \"S1\"\n}\n");
    row("the first member that is gone", "{ \"a\": 1, \"b\":2 }", R"({"b": 2})", "{ \"b\":2 }");
    row("all members", "{\n  \"a\": 1\n}\n", "{}", "{}\n");
    row("the first member", "{}\n", R"({"a": 1})", "{\n  \"a\": 1\n}\n");
    row("a list on one line", "{\"a\": [1,2]}", R"({"a": [1, 2, 3]})", "{\"a\": [1,2,3]}");
    row("a deep list that begins is on one line", "{\"a\": {\"b\": []}}",
        R"({"a": {"b": ["x", "y"]}})", "{\"a\": {\"b\": [\"x\", \"y\"]}}");
    row("lists within that line are on it, too", "{\"a\": {\"b\": []}}",
        R"({"a": {"b": [[["x"], {"c": [[1], ["y"]]}]]}})",
        "{\"a\": {\"b\": [[[\"x\"], {\"c\": [[1], [\"y\"]]}]]}}");
    row("a list on lines", "{\n  \"a\": [\n    \"x\",\n    \"y\"\n  ]\n}\n",
        R"({"a": ["x", "new", "y"]})",
        "{\n  \"a\": [\n    \"x\",\n    \"new\",\n    \"y\"\n  ]\n}\n");
    row("an inner member", "{\"a\": {\"x\": 1, \"y\":  2.50}}", R"({"a": {"x": 7, "y": 2.5}})",
        "{\"a\": {\"x\": 7, \"y\":  2.50}}");
    row("letters that need no escape", "{\"a\": \"x\"}", "{\"a\": \"größer ≥\"}",
        "{\"a\": \"größer ≥\"}");
}

void TestJsonPatch::changesOnePlace()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, wanted);
    QFETCH(QByteArray, patched);
    QCOMPARE(patchJson(text, parsed(text), parsed(wanted)), patched);
}

void TestJsonPatch::numbersTakeTheFewestDigits_data()
{
    QTest::addColumn<double>("number");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("whole") << 4.0 << QByteArray("4");
    QTest::newRow("a tenth") << 0.1 << QByteArray("0.1");
    QTest::newRow("a sixtieth") << 1.0 / 60.0 << QByteArray("0.016666666666666666");
    QTest::newRow("small") << 1e-5 << QByteArray("1e-05");
    QTest::newRow("negative") << -9.81 << QByteArray("-9.81");
}

void TestJsonPatch::numbersTakeTheFewestDigits()
{
    QFETCH(double, number);
    QFETCH(QByteArray, text);
    QCOMPARE(patchJson("{}", {}, {{QStringLiteral("a"), QJsonArray{number}}}),
             "{\n  \"a\": [" + text + "]\n}");
}

void TestJsonPatch::newFilesAreLaidOutAsTheLabs()
{
    const QByteArray text =
        "{\n"
        "  \"format\": 1,\n"
        "  \"id\": \"S1\",\n"
        "  \"title\": \"T\",\n"
        "  \"square\": {\n"
        "    \"half_width\": 4\n"
        "  },\n"
        "  \"gravity\": [0, -9.81],\n"
        "  \"hints\": [\n"
        "    \"One\",\n"
        "    \"Two\"\n"
        "  ],\n"
        "  \"checks\": [\n"
        "    {\"id\": \"a\", \"kind\": \"start\", \"title\": \"A\", "
        "\"circles\": [1, 2], \"scene\": {\"kind\": \"own\", \"duration\": 1}}\n"
        "  ]\n"
        "}\n";
    QCOMPARE(patchJson("{}\n", {}, parsed(text)), text);
}

void TestJsonPatch::anyEditOfAnyTextGivesWhatIsWanted()
{
    Random random(42);
    for (int i = 0; i < 20'000; ++i) {
        QJsonObject before;
        for (int k = below(random, 5); k > 0; --k)
            before.insert(QStringLiteral("key %1").arg(k), anyValue(random, 3));
        QJsonValue after = before;
        for (int edits = 1 + below(random, 3); edits > 0; --edits)
            after = edited(after, random);
        const QByteArray text = written(before, random);
        QVERIFY(parsed(text) == before);
        const QByteArray patched = patchJson(text, before, after.toObject());
        QVERIFY2(parsed(patched) == after.toObject(),
                 text + "\nbecame\n" + patched + "\nfor\n"
                     + QJsonDocument(after.toObject()).toJson());
    }
}

void TestJsonPatch::whatIsTheSameKeepsItsText()
{
    Random random(7);
    for (int i = 0; i < 2'000; ++i) {
        const QJsonObject kept{{QStringLiteral("kept"), anyValue(random, 3)}};
        QJsonObject before = kept;
        before.insert(QStringLiteral("other"), anyValue(random, 2));
        QJsonObject after = kept;
        after.insert(QStringLiteral("other"), anyValue(random, 2));
        const QByteArray value = written(kept.value(QStringLiteral("kept")), random);
        const QByteArray text = "{\"kept\" :" + value + ",\"other\":"
                                + written(before.value(QStringLiteral("other")), random) + "}";
        const QByteArray patched = patchJson(text, before, after);
        QVERIFY2(patched.startsWith("{\"kept\" :" + value + ",\"other\":"), patched.constData());
        QCOMPARE(patchJson(text, before, before), text);
    }
}

void TestJsonPatch::textIsTakenApart_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("parts"); // open, separator, keys and values, close
    const auto row = [](const char *text, const char *parts) {
        QTest::newRow(text) << QByteArray(text) << QByteArray(parts);
    };
    row("\n {\"a\": 1}", "{|, |a=1|}");
    row("[ 1,\n 2 ]", "[ |,\n |=1|=2| ]");
    row("{\n  \"a\": [1, {}]\n}", "{\n  |,\n  |a=[1, {}]|\n}");
    row("{\n \"a\": 1, \"b\": \"}\"}", "{\n |, |a=1|b=\"}\"|}");
    row("{\"a\": 1, \"b\": 2,\n\"a\": {\"a\": [\"\\\"\"]}}", "{|, |b=2|a={\"a\": [\"\\\"\"]}|}");
    row("{\"b\": 1, \"a\":2,\"c\": 3, \"a\" : 4 }", "{|, |b=1|c=3|a=4| }");
    row("[1, 1]", "[|, |=1|=1|]");
    row("[]", "[|, |]");
}

void TestJsonPatch::textIsTakenApart()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, parts);
    const JsonPieces pieces = takeApart(text);
    QByteArray found = pieces.open + '|' + pieces.separator;
    for (const JsonPieces::Piece &piece : pieces.pieces)
        found += '|' + piece.key.toUtf8() + '=' + piece.value;
    QCOMPARE(found + '|' + pieces.close, parts);
    QCOMPARE(pieces.indexOf(QStringLiteral("none")), -1);
}

QTEST_GUILESS_MAIN(TestJsonPatch)
#include "test_json_patch.moc"

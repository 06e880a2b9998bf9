// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab/prediction.h"

#include "tasks/reading/lab_reader.h"
#include "tests/test_paths.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

namespace {

const char good[] = R"({"prediction": {"question": "Up?", "answers": ["yes", "no", "both"],
                        "right": 2, "outcome": "It falls."}})";

QJsonObject object(const QByteArray &text)
{
    return QJsonDocument::fromJson(text).object();
}

} // namespace

/// The question of a step, its answers and its translation, as they are read.
class TestPrediction : public QObject
{
    Q_OBJECT
private slots:
    void readsTheQuestionOfAStep();
    void isNotThereWithoutAQuestion();
    void takesATranslationThatIsWhole_data();
    void takesATranslationThatIsWhole();
    void rightAnswerMustBeOneOfThem_data();
    void rightAnswerMustBeOneOfThem();
    void readerNamesTheWrongPlace();
};

void TestPrediction::readsTheQuestionOfAStep()
{
    const auto prediction = readPrediction(object(good), {});
    QVERIFY(prediction);
    QCOMPARE(prediction->question, QStringLiteral("Up?"));
    QCOMPARE(prediction->answers,
             (QStringList{QStringLiteral("yes"), QStringLiteral("no"), QStringLiteral("both")}));
    QCOMPARE(prediction->right, 1); // counted from 1 in the file
    QCOMPARE(prediction->outcome, QStringLiteral("It falls."));
    QVERIFY(predictionFault(object(good)).isEmpty());
}

void TestPrediction::isNotThereWithoutAQuestion()
{
    QVERIFY(!readPrediction({}, {}));
    // A translation alone asks nothing.
    QVERIFY(!readPrediction({}, object(good)));
    QVERIFY(predictionFault({}).isEmpty());
}

void TestPrediction::takesATranslationThatIsWhole_data()
{
    QTest::addColumn<QByteArray>("words");
    QTest::addColumn<QString>("question");
    QTest::newRow("whole") << QByteArray(
        R"({"prediction": {"question": "Hoch?", "answers": ["ja", "nein", "beides"],
                          "outcome": "Er fällt."}})")
                           << QStringLiteral("Hoch?");
    QTest::newRow("none") << QByteArray("{}") << QStringLiteral("Up?");
    QTest::newRow("an answer is missing")
        << QByteArray(R"({"prediction": {"question": "Hoch?", "answers": ["ja", "nein"],
                          "outcome": "Er fällt."}})")
        << QStringLiteral("Up?");
    QTest::newRow("the outcome is missing") << QByteArray(
        R"({"prediction": {"question": "Hoch?", "answers": ["ja", "nein", "beides"]}})")
                                            << QStringLiteral("Up?");
    QTest::newRow("the question is missing") << QByteArray(
        R"({"prediction": {"answers": ["ja", "nein", "beides"], "outcome": "Er fällt."}})")
                                             << QStringLiteral("Up?");
}

void TestPrediction::takesATranslationThatIsWhole()
{
    QFETCH(QByteArray, words);
    QFETCH(QString, question);
    const auto prediction = readPrediction(object(good), object(words));
    QVERIFY(prediction);
    QCOMPARE(prediction->question, question);
    // All of it, or nothing.
    const bool translated = question == QLatin1String("Hoch?");
    QCOMPARE(prediction->answers.value(2),
             translated ? QStringLiteral("beides") : QStringLiteral("both"));
    QCOMPARE(prediction->outcome,
             translated ? QStringLiteral("Er fällt.") : QStringLiteral("It falls."));
    QCOMPARE(prediction->answers.size(), 3);
    QCOMPARE(prediction->right, 1);
}

void TestPrediction::rightAnswerMustBeOneOfThem_data()
{
    QTest::addColumn<int>("right");
    QTest::addColumn<bool>("valid");
    QTest::newRow("none") << 0 << false;
    QTest::newRow("first") << 1 << true;
    QTest::newRow("last") << 3 << true;
    QTest::newRow("past the last") << 4 << false;
}

void TestPrediction::rightAnswerMustBeOneOfThem()
{
    QFETCH(int, right);
    QFETCH(bool, valid);
    QJsonObject json = object(good);
    QJsonObject part = json.value(QStringLiteral("prediction")).toObject();
    part.insert(QStringLiteral("right"), right);
    json.insert(QStringLiteral("prediction"), part);
    QCOMPARE(predictionFault(json).isEmpty(), valid);
    QCOMPARE(readPrediction(json, {}).has_value(), valid);
}

/// The step stays, without its question.
void TestPrediction::readerNamesTheWrongPlace()
{
    const QTemporaryDir folder;
    const QString from = fixturePath("labs/good/");
    QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("S1")));
    for (const char *name : {"S1/preset.json", "S1/instructions.md"})
        QVERIFY(QFile::copy(from + QLatin1String(name), folder.filePath(QLatin1String(name))));
    QFile lab(folder.filePath(QStringLiteral("lab.json")));
    QVERIFY(lab.open(QIODevice::WriteOnly));
    lab.write(R"({"format": 1, "id": "x", "title": "X", "version": "1", "language": "en",
                  "steps": ["S1"]})");
    lab.close();
    QFile original(from + QStringLiteral("S1/task.json"));
    QVERIFY(original.open(QIODevice::ReadOnly));
    QJsonObject task = object(original.readAll());
    QJsonObject part = object(good).value(QStringLiteral("prediction")).toObject();
    const auto findingsWith = [&](const char *key, const QJsonValue &value) {
        part.insert(QLatin1String(key), value);
        task.insert(QStringLiteral("prediction"), part);
        QFile file(folder.filePath(QStringLiteral("S1/task.json")));
        if (file.open(QIODevice::WriteOnly))
            file.write(QJsonDocument(task).toJson());
        file.close();
        return readLab(folder.path())->findings;
    };
    QVERIFY(findingsWith("right", 3).empty());
    QCOMPARE(readLab(folder.path())->tasks[0].prediction->right, 2);
    const std::vector<Error> none = findingsWith("right", 4);
    QCOMPARE(none.size(), std::size_t{1});
    QCOMPARE(none[0].pointer, QStringLiteral("/prediction/right"));
    QVERIFY(none[0].message.contains(QStringLiteral("from 1 to 3")));
    QCOMPARE(readLab(folder.path())->tasks.size(), std::size_t{1});
    QVERIFY(!readLab(folder.path())->tasks[0].prediction);
    // The question is asked, in the language of the lab.
    QFile german(folder.filePath(QStringLiteral("S1/task.de.json")));
    QVERIFY(german.open(QIODevice::WriteOnly));
    german.write(R"({"prediction": {"question": "Hoch?", "answers": ["ja", "nein"],
                     "outcome": "Es fällt."}})");
    german.close();
    for (const char *language : {"en", "de"}) {
        QVERIFY(findingsWith("right", 3).size() == 1);
        const Lab read = *readLab(folder.path(), QLatin1String(language));
        QCOMPARE(read.findings.size(), std::size_t{1});
        QVERIFY(read.findings[0].file.endsWith(QStringLiteral("S1/task.de.json")));
        QCOMPARE(read.findings[0].pointer, QStringLiteral("/prediction/answers"));
        QVERIFY(read.findings[0].message.startsWith(QStringLiteral("3 answers")));
        QCOMPARE(read.tasks[0].prediction->question, QStringLiteral("Up?"));
    }
    QVERIFY(german.remove());
    // What the schema refuses leaves the step out, as any other wrong place does.
    const std::vector<Error> single =
        findingsWith("answers", QJsonArray{QStringLiteral("only one")});
    QCOMPARE(single.size(), std::size_t{1});
    QCOMPARE(single[0].pointer, QStringLiteral("/prediction/answers"));
    QVERIFY(single[0].message.contains(QStringLiteral("a list of two to four answers")));
}

QTEST_GUILESS_MAIN(TestPrediction)
#include "test_prediction.moc"

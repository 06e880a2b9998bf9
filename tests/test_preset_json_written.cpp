// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/preset_json.h"

#include "tests/scene_files.h"
#include "tests/scenes.h"

#include <QTemporaryDir>

using namespace cradle;
using namespace cradle::scenes;

/// How a scene is written and saved.
class TestPresetJsonWritten : public QObject
{
    Q_OBJECT
private slots:
    void numbersAreWrittenWithTheFewestDigits();
    void writesTheFormatOfTheContract();
    void awkwardNamesRoundTrip_data();
    void awkwardNamesRoundTrip();
    void awkwardNumbersRoundTrip_data();
    void awkwardNumbersRoundTrip();
    void savesWholeFiles();
    void savingWhereNothingCanBeWrittenFails();
};

void TestPresetJsonWritten::numbersAreWrittenWithTheFewestDigits()
{
    Preset preset;
    preset.gravity = {0.1, -9.81};
    preset.timestep = 1.0 / 60.0;
    const QByteArray text = writePreset(preset);
    QVERIFY(text.contains(R"("gravity": [0.1, -9.81])"));
    QVERIFY(text.contains(R"("timestep": 0.016666666666666666)"));
    QVERIFY(text.contains(R"("square": {"half_width": 4})"));
}

void TestPresetJsonWritten::writesTheFormatOfTheContract()
{
    // Already as it would be written, but for the capital digits of a colour, which are kept.
    const QByteArray text = contentOf(fixture(QStringLiteral("good/full")));
    const Result<Preset> preset = parsePreset(text);
    QVERIFY(preset.ok());
    QCOMPARE(writePreset(*preset), text);
}

void TestPresetJsonWritten::awkwardNamesRoundTrip_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("empty") << QString(QLatin1String(""));
    QTest::newRow("quotes") << QStringLiteral("a \"b\" \\ c");
    QTest::newRow("place markers") << QStringLiteral("%1 %2 %9 %L1 %%");
    QTest::newRow("control characters") << QStringLiteral("a\tb\nc\r\x01\x7f");
    QTest::newRow("braces") << QStringLiteral("}],\"format\": 2");
    QTest::newRow("beyond Latin") << QStringLiteral("Kreis für 圆 \u2028 🙂");
}

void TestPresetJsonWritten::awkwardNamesRoundTrip()
{
    QFETCH(QString, name);
    Preset preset = scene({circle({0, 0}), circle({1, 0})}, {});
    preset.name = name;
    preset.circles[0].name = name;
    const Result<Preset> again = parsePreset(writePreset(preset));
    QVERIFY(again.ok());
    QCOMPARE(again->name, name);
    QCOMPARE(again->circles[0].name, name);
    QVERIFY(*again == preset);
}

void TestPresetJsonWritten::awkwardNumbersRoundTrip_data()
{
    QTest::addColumn<double>("number");
    QTest::newRow("one third") << 1.0 / 3.0;
    QTest::newRow("0.1 + 0.2") << 0.1 + 0.2;
    QTest::newRow("least") << 5e-324;
    QTest::newRow("smallest normal") << 2.2250738585072014e-308;
    QTest::newRow("next after 1") << std::nextafter(1.0, 2.0);
    QTest::newRow("largest in range") << 1e4;
    QTest::newRow("just below") << std::nextafter(1e4, 0.0);
    QTest::newRow("minus zero") << -0.0;
}

void TestPresetJsonWritten::awkwardNumbersRoundTrip()
{
    QFETCH(double, number);
    const Preset preset = scene({circle({number, -number}, {number, 0})}, {});
    const QByteArray written = writePreset(preset);
    const Result<Preset> again = parsePreset(written);
    QVERIFY(again.ok());
    QVERIFY(*again == preset);
    QCOMPARE(writePreset(*again), written);
}

void TestPresetJsonWritten::savesWholeFiles()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("saved.json"));
    const Preset preset = scene({circle({0, 0}, {1, 2})}, {});
    QVERIFY(!savePreset(preset, path).has_value());
    QCOMPARE(contentOf(path), writePreset(preset));
    const Result<Preset> again = readPreset(path);
    QVERIFY(again.ok());
    QVERIFY(*again == preset);
}

void TestPresetJsonWritten::savingWhereNothingCanBeWrittenFails()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("no/such/folder/saved.json"));
    const std::optional<Error> error = savePreset(Preset{}, path);
    QVERIFY(error.has_value());
    QCOMPARE(error->file, path);
    QVERIFY(!error->message.isEmpty());
}

QTEST_GUILESS_MAIN(TestPresetJsonWritten)
#include "test_preset_json_written.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/preset_json.h"

#include "tests/scene_files.h"
#include "tests/scenes.h"
#include "tests/test_paths.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

using namespace cradle;
using namespace cradle::scenes;

/// Scene files that are refused, with the place and what would be right.
class TestPresetJsonRefused : public QObject
{
    Q_OBJECT
private slots:
    void badFilesAreRefused_data();
    void badFilesAreRefused();
    void everyBadFileHasARow();
    void aTruncatedFileIsRefusedWhereverItEnds();
    void aDamagedByteNeverCrashes();
    void deepNestingIsRefused_data();
    void deepNestingIsRefused();
    void tooLargeAFileIsRefusedUnread();
    void aFolderIsRefused();
    void aMissingFileIsRefused();
    void textWithoutAFileHasNoFileInItsMessage();
};

void TestPresetJsonRefused::badFilesAreRefused_data()
{
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("right"); // what the message must say
    const auto broken = [](const char *file, int line) {
        QTest::newRow(file) << QString() << line << QStringLiteral("not JSON");
    };
    const auto wrong = [](const char *file, const char *pointer, const char *right) {
        QTest::newRow(file) << QString::fromLatin1(pointer) << 0 << QString::fromUtf8(right);
    };
    broken("empty", 1);
    broken("blank", 3);
    broken("binary", 1);
    broken("utf16", 1);
    broken("latin1", 1);
    broken("truncated", 10);
    broken("trailing_comma", 3);
    broken("comment", 1);
    broken("two_documents", 2);
    broken("single_quotes", 1);
    broken("nan", 2);
    broken("infinity", 3);
    broken("huge_exponent", 2);
    broken("bare_number", 1);
    broken("bare_null", 1);

    wrong("list", "", "an object with format");
    wrong("unknown_format", "/format", "needs a newer Cradle: format 2, this one reads 1");
    wrong("format_text", "/format", "right would be 1");
    wrong("no_format", "", "\"format\" is missing");
    wrong("no_circles", "", "\"circles\" is missing");
    wrong("unknown_key", "/friction", "restitution");
    wrong("unknown_key_in_square", "/square/height", "half_width");
    wrong("unknown_key_in_laws", "/laws/wall", "walls");
    wrong("unknown_key_in_circle", "/circles/1/raduis", "radius");
    wrong("unknown_key_beside_fill", "/circles/file", "fill");
    wrong("unknown_key_in_fill", "/circles/fill/speed", "rms_speed");
    // RFC 6901 writes / in a key as ~1 and ~ as ~0.
    wrong("unknown_key_with_slash", "/a~1b~0c", "restitution");
    wrong("name_number", "/name", "a text");
    wrong("square_number", "/square", "an object with half_width");
    wrong("square_empty", "/square", "\"half_width\" is missing");
    wrong("half_width_text", "/square/half_width", "a number from");
    wrong("half_width_zero", "/square/half_width", "1e-6 to 10000");
    wrong("gravity_number", "/gravity", "two numbers [x, y] in m/s²");
    wrong("gravity_one", "/gravity", "two numbers");
    wrong("gravity_three", "/gravity", "two numbers");
    wrong("gravity_text", "/gravity/1", "a number in m/s²");
    wrong("restitution_negative", "/restitution", "0 to 1");
    wrong("restitution_above_one", "/restitution", "0 to 1");
    wrong("restitution_null", "/restitution", "0 to 1");
    wrong("restitution_bool", "/restitution", "0 to 1");
    wrong("timestep_zero", "/timestep", "1e-6 to 0.1");
    wrong("timestep_negative", "/timestep", "1e-6 to 0.1");
    wrong("timestep_coarse", "/timestep", "1e-6 to 0.1");
    wrong("laws_list", "/laws", "walls, circles and timing");
    wrong("law_of_walls", "/laws/walls", "none, reflect");
    wrong("law_of_circles", "/laws/circles", "impulse");
    wrong("law_of_timing", "/laws/timing", "discrete, continuous, exact");
    wrong("circles_number", "/circles", "a list of circles, or an object with fill");
    wrong("circles_null", "/circles", "a list of circles, or an object with fill");
    wrong("circles_empty_object", "/circles", "fill");
    wrong("circle_number", "/circles/0", "an object with position");
    wrong("circle_without_position", "/circles/0", "\"position\" is missing");
    wrong("position_object", "/circles/0/position", "two numbers [x, y] in m");
    wrong("position_far", "/circles/0/position/1", "-10000 to 10000");
    wrong("velocity_fast", "/circles/0/velocity/0", "-1e7 to 1e7");
    wrong("velocity_nested", "/circles/0/velocity/0", "a number in m/s");
    wrong("radius_zero", "/circles/0/radius", "1e-6 to 10000");
    wrong("radius_negative", "/circles/1/radius", "1e-6 to 10000");
    wrong("radius_text", "/circles/0/radius", "1e-6 to 10000");
    wrong("density_zero", "/circles/0/density", "1e-9 to 1e9");
    wrong("density_negative", "/circles/0/density", "1e-9 to 1e9");
    wrong("circle_name_list", "/circles/0/name", "a text");
    wrong("colour_word", "/circles/0/colour", "#1e90ff");
    wrong("colour_number", "/circles/0/colour", "#1e90ff");
    wrong("integrator_word", "/circles/0/integrator", "euler, symplectic_euler, verlet, rk4");
    wrong("overlapping", "/circles/2/position", "at least r₁ + r₂ = 0.4 m");
    wrong("duplicate_circles", "/circles/1/position", "at least r₁ + r₂ = 0.4 m");
    wrong("outside", "/circles/1/position", "from -3.8 to 3.8 m");
    wrong("wider_than_the_square", "/circles/0/position", "wider than the square");
    wrong("fill_number", "/circles/fill", "an object with count and radius");
    wrong("fill_without_count", "/circles/fill", "\"count\" is missing");
    wrong("fill_without_radius", "/circles/fill", "\"radius\" is missing");
    wrong("fill_count_zero", "/circles/fill/count", "1 to 100000");
    wrong("fill_count_half", "/circles/fill/count", "a whole number");
    wrong("fill_count_text", "/circles/fill/count", "a whole number");
    wrong("fill_count_too_large", "/circles/fill/count", "1 to 100000");
    wrong("fill_radius_negative", "/circles/fill/radius", "1e-6 to 10000");
    wrong("fill_speed_negative", "/circles/fill/rms_speed", "0 to 1e6");
    wrong("fill_density_zero", "/circles/fill/density", "1e-9 to 1e9");
    wrong("fill_seed_negative", "/circles/fill/seed", "0 to 2147483647");
    wrong("fill_does_not_fit", "/circles/fill/count", "at most 400 are right");
    wrong("fill_wider_than_the_square", "/circles/fill/count", "at most 0 are right");
}

void TestPresetJsonRefused::badFilesAreRefused()
{
    QFETCH(QString, pointer);
    QFETCH(int, line);
    QFETCH(QString, right);
    const QString path =
        fixture(QStringLiteral("bad/") + QString::fromLatin1(QTest::currentDataTag()));
    QVERIFY(!path.isEmpty());
    const Result<Preset> preset = readPreset(path);
    QVERIFY(!preset.ok());
    const Error &error = preset.error();
    QCOMPARE(error.file, path);
    QCOMPARE(error.pointer, pointer);
    QCOMPARE(error.line, line);
    QVERIFY2(error.message.contains(right), qPrintable(error.message));
    QVERIFY(error.toString().startsWith(path + QLatin1Char(':')));
}

void TestPresetJsonRefused::everyBadFileHasARow()
{
    const QDir folder = QFileInfo(fixture(QStringLiteral("bad/empty"))).dir();
    const QByteArray source = contentOf(sourcePath("tests/test_preset_json_refused.cpp"));
    const QFileInfoList files = folder.entryInfoList(QDir::Files);
    for (const QFileInfo &file : files) {
        const QByteArray name = '"' + file.baseName().toUtf8() + '"';
        QVERIFY2(source.contains(name), name.constData());
    }
}

void TestPresetJsonRefused::aTruncatedFileIsRefusedWhereverItEnds()
{
    const QByteArray text = contentOf(fixture(QStringLiteral("good/full"))).trimmed();
    QVERIFY(text.endsWith('}'));
    for (qsizetype length = 0; length < text.size(); ++length) {
        const Result<Preset> preset = parsePreset(text.left(length));
        QVERIFY2(!preset.ok(), QByteArray::number(length).constData());
        QVERIFY(preset.error().line >= 1);
        QVERIFY(preset.error().line <= 1 + text.count('\n'));
    }
    QVERIFY(parsePreset(text).ok());
}

void TestPresetJsonRefused::aDamagedByteNeverCrashes()
{
    // Read or refused, as may be; a refusal always says something.
    const QByteArray text = contentOf(fixture(QStringLiteral("good/full")));
    for (qsizetype i = 0; i < text.size(); i += 3) {
        for (const char byte : {'\0', '"', '}', ']', '-', '9', '\xff'}) {
            QByteArray damaged = text;
            damaged[i] = byte;
            const Result<Preset> preset = parsePreset(damaged);
            if (!preset)
                QVERIFY(!preset.error().message.isEmpty());
        }
    }
}

void TestPresetJsonRefused::deepNestingIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    const int depth = 100'000;
    QByteArray objects;
    for (int i = 0; i < depth; ++i)
        objects += R"({"circles":)";
    QTest::newRow("lists, open") << QByteArray(depth, '[');
    QTest::newRow("lists, closed") << QByteArray(depth, '[') + QByteArray(depth, ']');
    QTest::newRow("objects, open") << objects;
    QTest::newRow("lists as circles")
        << R"({"format": 1, "circles": )" + QByteArray(depth, '[') + QByteArray(depth, ']') + '}';
    QTest::newRow("as deep as the parser goes")
        << R"({"format": 1, "circles": )" + QByteArray(1000, '[') + QByteArray(1000, ']') + '}';
}

void TestPresetJsonRefused::deepNestingIsRefused()
{
    QFETCH(QByteArray, text);
    const Result<Preset> preset = parsePreset(text);
    QVERIFY(!preset.ok());
    QVERIFY(!preset.error().message.isEmpty());
}

void TestPresetJsonRefused::tooLargeAFileIsRefusedUnread()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("large.json"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"format": 1, "circles": []})");
    QVERIFY(file.resize(32 * 1024 * 1024 + 1)); // sparse: takes no room on the disk
    file.close();
    const Result<Preset> preset = readPreset(path);
    QVERIFY(!preset.ok());
    QCOMPARE(preset.error().file, path);
    QVERIFY2(preset.error().message.contains(QStringLiteral("too large")),
             qPrintable(preset.error().message));
    QVERIFY2(preset.error().message.contains(QStringLiteral("32")),
             qPrintable(preset.error().message));
}

void TestPresetJsonRefused::aFolderIsRefused()
{
    QTemporaryDir folder;
    const Result<Preset> preset = readPreset(folder.path());
    QVERIFY(!preset.ok());
    QCOMPARE(preset.error().file, folder.path());
    QVERIFY(preset.error().message.contains(QStringLiteral("folder")));
}

void TestPresetJsonRefused::aMissingFileIsRefused()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("none.json"));
    const Result<Preset> preset = readPreset(path);
    QVERIFY(!preset.ok());
    QCOMPARE(preset.error().file, path);
    QVERIFY(preset.error().message.contains(QStringLiteral("cannot be read")));
}

void TestPresetJsonRefused::textWithoutAFileHasNoFileInItsMessage()
{
    const Result<Preset> preset = parsePreset(R"({"format": 1, "gravity": 3, "circles": []})");
    QVERIFY(!preset.ok());
    QVERIFY(preset.error().toString().startsWith(QStringLiteral("/gravity: ")));
}

QTEST_GUILESS_MAIN(TestPresetJsonRefused)
#include "test_preset_json_refused.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/preset_json.h"

#include "tests/scenes.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

using namespace cradle;
using namespace cradle::scenes;

Q_DECLARE_METATYPE(cradle::WallLaw)
Q_DECLARE_METATYPE(cradle::CircleLaw)
Q_DECLARE_METATYPE(cradle::Timing)
Q_DECLARE_METATYPE(cradle::Integrator)

namespace {

QString fixture(const QString &name)
{
    return QFINDTESTDATA(QStringLiteral("fixtures/presets/%1.json").arg(name));
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestPresetJson : public QObject
{
    Q_OBJECT
private slots:
    void readsEveryKey();
    void whatIsLeftOutHasItsDefault();
    void readsEveryLaw_data();
    void readsEveryLaw();
    void readsEveryIntegrator_data();
    void readsEveryIntegrator();
    void goodFilesAreRead_data();
    void goodFilesAreRead();
    void goodFilesRoundTrip_data();
    void goodFilesRoundTrip();
    void aFillIsMadeAndKept();
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
    void numbersAreWrittenWithTheFewestDigits();
    void writesTheFormatOfTheContract();
    void awkwardNamesRoundTrip_data();
    void awkwardNamesRoundTrip();
    void awkwardNumbersRoundTrip_data();
    void awkwardNumbersRoundTrip();
    void savesWholeFiles();
    void savingWhereNothingCanBeWrittenFails();
    void timingNamesReadBack();
};

void TestPresetJson::readsEveryKey()
{
    const Result<Preset> preset = readPreset(fixture(QStringLiteral("good/full")));
    QVERIFY2(preset.ok(), preset ? "" : qPrintable(preset.error().toString()));
    QCOMPARE(preset->name, QStringLiteral("Glancing hit"));
    QCOMPARE(preset->halfWidth, 4.0);
    QVERIFY(preset->gravity == (Vec2{0, -9.81}));
    QCOMPARE(preset->restitution, 0.75);
    QCOMPARE(preset->timestep, 1.0 / 60.0);
    QVERIFY(preset->laws == (Laws{WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact}));
    QVERIFY(!preset->fill.has_value());
    QCOMPARE(preset->circles.size(), std::size_t{2});
    const PresetCircle &second = preset->circles[1];
    QCOMPARE(preset->circles[0].name, QStringLiteral("circle 1"));
    QVERIFY(preset->circles[0].body.position == (Vec2{-2, 2.3}));
    QVERIFY(preset->circles[0].body.velocity == (Vec2{2, 0}));
    QVERIFY(preset->circles[0].integrator == Integrator::Euler);
    QVERIFY(second.body == (Circle{{2, 2}, {0, 0}, 0.252, 1.5}));
    QCOMPARE(second.colour, QStringLiteral("#FF0000"));
    QVERIFY(second.integrator == Integrator::RungeKutta4);
}

void TestPresetJson::whatIsLeftOutHasItsDefault()
{
    const Result<Preset> preset = readPreset(fixture(QStringLiteral("good/minimal")));
    QVERIFY(preset.ok());
    QCOMPARE(preset->halfWidth, 4.0);
    QVERIFY(preset->gravity == Vec2{});
    QCOMPARE(preset->restitution, 1.0);
    QCOMPARE(preset->timestep, 1.0 / 60.0);
    QVERIFY(preset->laws == (Laws{WallLaw::None, CircleLaw::None, Timing::Discrete}));
    QCOMPARE(preset->circles.size(), std::size_t{1});
    QVERIFY(preset->circles[0].body == (Circle{{1, -2}, {0, 0}, 0.2, 7.8}));
    QCOMPARE(preset->circles[0].name, QStringLiteral("circle 1"));
    QCOMPARE(preset->circles[0].colour, QStringLiteral("#1e90ff"));
    QVERIFY(preset->circles[0].integrator == Integrator::Euler);
}

void TestPresetJson::readsEveryLaw_data()
{
    QTest::addColumn<QByteArray>("laws");
    QTest::addColumn<WallLaw>("walls");
    QTest::addColumn<CircleLaw>("circles");
    QTest::addColumn<Timing>("timing");
    const auto row = [](const char *laws, WallLaw walls, CircleLaw circles, Timing timing) {
        QTest::newRow(laws) << QByteArray(laws) << walls << circles << timing;
    };
    row(R"("walls": "none")", WallLaw::None, CircleLaw::None, Timing::Discrete);
    row(R"("walls": "reflect")", WallLaw::Reflect, CircleLaw::None, Timing::Discrete);
    row(R"("circles": "none")", WallLaw::None, CircleLaw::None, Timing::Discrete);
    row(R"("circles": "stop")", WallLaw::None, CircleLaw::Stop, Timing::Discrete);
    row(R"("circles": "swap_velocities")", WallLaw::None, CircleLaw::SwapVelocities,
        Timing::Discrete);
    row(R"("circles": "swap_normal")", WallLaw::None, CircleLaw::SwapNormal, Timing::Discrete);
    row(R"("circles": "impulse")", WallLaw::None, CircleLaw::Impulse, Timing::Discrete);
    row(R"("timing": "discrete")", WallLaw::None, CircleLaw::None, Timing::Discrete);
    row(R"("timing": "continuous")", WallLaw::None, CircleLaw::None, Timing::Continuous);
    row(R"("timing": "exact")", WallLaw::None, CircleLaw::None, Timing::Exact);
}

void TestPresetJson::readsEveryLaw()
{
    QFETCH(QByteArray, laws);
    QFETCH(WallLaw, walls);
    QFETCH(CircleLaw, circles);
    QFETCH(Timing, timing);
    const QByteArray text = R"({"format": 1, "laws": {)" + laws + R"(}, "circles": []})";
    const Result<Preset> preset = parsePreset(text);
    QVERIFY(preset.ok());
    QVERIFY(preset->laws == (Laws{walls, circles, timing}));
    QVERIFY(writePreset(*preset).contains(laws));
}

void TestPresetJson::readsEveryIntegrator_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::newRow("euler") << Integrator::Euler;
    QTest::newRow("symplectic_euler") << Integrator::SymplecticEuler;
    QTest::newRow("verlet") << Integrator::Verlet;
    QTest::newRow("rk4") << Integrator::RungeKutta4;
}

void TestPresetJson::readsEveryIntegrator()
{
    QFETCH(Integrator, integrator);
    const QByteArray key = QByteArray(R"("integrator": ")") + QTest::currentDataTag() + '"';
    const Result<Preset> preset =
        parsePreset(R"({"format": 1, "circles": [{"position": [0, 0], )" + key + "}]}");
    QVERIFY(preset.ok());
    QVERIFY(preset->circles.at(0).integrator == integrator);
    QVERIFY(writePreset(*preset).contains(key));
}

void TestPresetJson::goodFilesAreRead_data()
{
    QTest::addColumn<QString>("path");
    const QFileInfoList files =
        QFileInfo(fixture(QStringLiteral("good/full"))).dir().entryInfoList(QDir::Files);
    for (const QFileInfo &file : files)
        QTest::newRow(qPrintable(file.baseName())) << file.filePath();
}

void TestPresetJson::goodFilesAreRead()
{
    QFETCH(QString, path);
    const Result<Preset> preset = readPreset(path);
    QVERIFY2(preset.ok(), preset ? "" : qPrintable(preset.error().toString()));
}

void TestPresetJson::goodFilesRoundTrip_data()
{
    goodFilesAreRead_data();
}

void TestPresetJson::goodFilesRoundTrip()
{
    QFETCH(QString, path);
    const Result<Preset> preset = readPreset(path);
    QVERIFY(preset.ok());
    const QByteArray written = writePreset(*preset);
    const Result<Preset> again = parsePreset(written);
    QVERIFY(again.ok());
    QVERIFY(*again == *preset);
    QCOMPARE(writePreset(*again), written);
}

void TestPresetJson::aFillIsMadeAndKept()
{
    const Result<Preset> preset = readPreset(fixture(QStringLiteral("good/fill")));
    QVERIFY(preset.ok());
    QVERIFY(preset->fill == (CircleFill{100, 0.05, 2.0, 1.0, 7}));
    QCOMPARE(preset->circles.size(), std::size_t{100});
    QVERIFY(writePreset(*preset).contains(
        R"("circles": {"fill": {"count": 100, "radius": 0.05, "rms_speed": 2, "density": 1, "seed": 7}})"));
}

void TestPresetJson::badFilesAreRefused_data()
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

void TestPresetJson::badFilesAreRefused()
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

void TestPresetJson::everyBadFileHasARow()
{
    const QDir folder = QFileInfo(fixture(QStringLiteral("bad/empty"))).dir();
    const QByteArray source = contentOf(QFINDTESTDATA("test_preset_json.cpp"));
    const QFileInfoList files = folder.entryInfoList(QDir::Files);
    for (const QFileInfo &file : files) {
        const QByteArray name = '"' + file.baseName().toUtf8() + '"';
        QVERIFY2(source.contains(name), name.constData());
    }
}

void TestPresetJson::aTruncatedFileIsRefusedWhereverItEnds()
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

void TestPresetJson::aDamagedByteNeverCrashes()
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

void TestPresetJson::deepNestingIsRefused_data()
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

void TestPresetJson::deepNestingIsRefused()
{
    QFETCH(QByteArray, text);
    const Result<Preset> preset = parsePreset(text);
    QVERIFY(!preset.ok());
    QVERIFY(!preset.error().message.isEmpty());
}

void TestPresetJson::tooLargeAFileIsRefusedUnread()
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

void TestPresetJson::aFolderIsRefused()
{
    QTemporaryDir folder;
    const Result<Preset> preset = readPreset(folder.path());
    QVERIFY(!preset.ok());
    QCOMPARE(preset.error().file, folder.path());
    QVERIFY(preset.error().message.contains(QStringLiteral("folder")));
}

void TestPresetJson::aMissingFileIsRefused()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("none.json"));
    const Result<Preset> preset = readPreset(path);
    QVERIFY(!preset.ok());
    QCOMPARE(preset.error().file, path);
    QVERIFY(preset.error().message.contains(QStringLiteral("cannot be read")));
}

void TestPresetJson::textWithoutAFileHasNoFileInItsMessage()
{
    const Result<Preset> preset = parsePreset(R"({"format": 1, "gravity": 3, "circles": []})");
    QVERIFY(!preset.ok());
    QVERIFY(preset.error().toString().startsWith(QStringLiteral("/gravity: ")));
}

void TestPresetJson::numbersAreWrittenWithTheFewestDigits()
{
    Preset preset;
    preset.gravity = {0.1, -9.81};
    preset.timestep = 1.0 / 60.0;
    const QByteArray text = writePreset(preset);
    QVERIFY(text.contains(R"("gravity": [0.1, -9.81])"));
    QVERIFY(text.contains(R"("timestep": 0.016666666666666666)"));
    QVERIFY(text.contains(R"("square": {"half_width": 4})"));
}

void TestPresetJson::writesTheFormatOfTheContract()
{
    // Already as it would be written, but for the capital digits of a colour, which are kept.
    const QByteArray text = contentOf(fixture(QStringLiteral("good/full")));
    const Result<Preset> preset = parsePreset(text);
    QVERIFY(preset.ok());
    QCOMPARE(writePreset(*preset), text);
}

void TestPresetJson::awkwardNamesRoundTrip_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("empty") << QString(QLatin1String(""));
    QTest::newRow("quotes") << QStringLiteral("a \"b\" \\ c");
    QTest::newRow("place markers") << QStringLiteral("%1 %2 %9 %L1 %%");
    QTest::newRow("control characters") << QStringLiteral("a\tb\nc\r\x01\x7f");
    QTest::newRow("braces") << QStringLiteral("}],\"format\": 2");
    QTest::newRow("beyond Latin") << QStringLiteral("Kreis für 圆 \u2028 🙂");
}

void TestPresetJson::awkwardNamesRoundTrip()
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

void TestPresetJson::awkwardNumbersRoundTrip_data()
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

void TestPresetJson::awkwardNumbersRoundTrip()
{
    QFETCH(double, number);
    const Preset preset = scene({circle({number, -number}, {number, 0})}, {});
    const QByteArray written = writePreset(preset);
    const Result<Preset> again = parsePreset(written);
    QVERIFY(again.ok());
    QVERIFY(*again == preset);
    QCOMPARE(writePreset(*again), written);
}

void TestPresetJson::savesWholeFiles()
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

void TestPresetJson::savingWhereNothingCanBeWrittenFails()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("no/such/folder/saved.json"));
    const std::optional<Error> error = savePreset(Preset{}, path);
    QVERIFY(error.has_value());
    QCOMPARE(error->file, path);
    QVERIFY(!error->message.isEmpty());
}

void TestPresetJson::timingNamesReadBack()
{
    QVERIFY(timingFromName(QStringLiteral("discrete")) == Timing::Discrete);
    QVERIFY(timingFromName(QStringLiteral("continuous")) == Timing::Continuous);
    QVERIFY(timingFromName(QStringLiteral("exact")) == Timing::Exact);
    QVERIFY(!timingFromName(QStringLiteral("Exact")).has_value());
    QVERIFY(!timingFromName(QString()).has_value());
}

QTEST_GUILESS_MAIN(TestPresetJson)
#include "test_preset_json.moc"

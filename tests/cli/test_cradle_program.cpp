// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/program_run.h"
#include "tests/sanitized.h"
#include "tests/test_paths.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/reading/lab_archive.h"

#include <QDirIterator>
#include <QSize>
#include <QtEndian>

using namespace cradle::programs;

/// The desktop program where there is no display, and the pictures that it draws there.
class TestCradleProgram : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_home = std::make_unique<QTemporaryDir>(); }
    void withoutADisplaySaysSo_data();
    void withoutADisplaySaysSo();
    void explainsItselfWithoutADisplay_data();
    void explainsItselfWithoutADisplay();
    void drawsAPictureWithoutADisplay_data();
    void drawsAPictureWithoutADisplay();
    void drawsAWindowWithoutOpenGl();
    void pictureShowsTheMoment();
    void pictureShowsAFile();
    void pictureShowsAnArchive();
    void pictureLeavesNoProgress();
    void wrongUsageIsSaid_data();
    void wrongUsageIsSaid();

private:
    [[nodiscard]] QString path(const char *name) const
    {
        return m_home->filePath(QLatin1String(name));
    }
    /// \p options  may name the picture as PICTURE
    [[nodiscard]] Outcome cradle(const QString &options,
                                 const QProcessEnvironment &environment) const;
    [[nodiscard]] QByteArray picture(const QString &options) const;

    std::unique_ptr<QTemporaryDir> m_home;
};

namespace {

QProcessEnvironment noDisplay()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(text(name));
    return environment;
}

/// Width and height as the head of a PNG file says; none for another file.
QSize sizeOf(const QByteArray &png)
{
    if (png.size() < 24 || !png.startsWith("\x89PNG"))
        return {};
    return {qFromBigEndian<qint32>(png.constData() + 16),
            qFromBigEndian<qint32>(png.constData() + 20)};
}

} // namespace

Outcome TestCradleProgram::cradle(const QString &options,
                                  const QProcessEnvironment &environment) const
{
    QStringList arguments = options.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    arguments.replaceInStrings(text("PICTURE"), path("picture.png"));
    return run(cradle::desktopProgram(), arguments, m_home->path(), environment);
}

/// The bytes of a picture; empty if there is none.
QByteArray TestCradleProgram::picture(const QString &options) const
{
    QFile::remove(path("picture.png"));
    const Outcome outcome = cradle(text("--screenshot PICTURE ") + options, noDisplay());
    if (!outcome.ended || outcome.code != 0)
        qWarning("%s", outcome.toText().constData());
    return contentOf(path("picture.png"));
}

void TestCradleProgram::withoutADisplaySaysSo_data()
{
    QTest::addColumn<QString>("display");
    QTest::addColumn<QString>("word");
    QTest::newRow("none") << QString() << text("there is no display");
    QTest::newRow("one that is not there") << text(":9999") << text("\":9999\"");
    QTest::newRow("no name of one") << text("nonsense") << text("\"nonsense\"");
}

void TestCradleProgram::withoutADisplaySaysSo()
{
    QFETCH(QString, display);
    QFETCH(QString, word);
    QProcessEnvironment environment = noDisplay();
    if (!display.isEmpty())
        environment.insert(text("DISPLAY"), display);
    const Outcome outcome = cradle({}, environment);
    VERIFY_CODE(outcome, 2);
    QVERIFY(outcome.out.isEmpty());
    QVERIFY2(outcome.error.startsWith(text("cradle: ")), outcome.toText().constData());
    QVERIFY2(outcome.error.contains(word), outcome.toText().constData());
    QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
    QVERIFY(outcome.error.endsWith(QLatin1Char('\n')));
}

void TestCradleProgram::explainsItselfWithoutADisplay_data()
{
    QTest::addColumn<QString>("option");
    QTest::addColumn<QString>("word");
    QTest::newRow("help") << text("--help") << text("--screenshot");
    QTest::newRow("version") << text("--version") << text("adle ");
}

void TestCradleProgram::explainsItselfWithoutADisplay()
{
    QFETCH(QString, option);
    QFETCH(QString, word);
    const Outcome outcome = cradle(option, noDisplay());
    VERIFY_CODE(outcome, 0);
    QVERIFY2(outcome.out.contains(word), outcome.toText().constData());
}

void TestCradleProgram::drawsAPictureWithoutADisplay_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<QSize>("size");
    QTest::newRow("a step") << text("--at 1.9 --step L42T11 --size 1280x800") << QSize(1280, 800);
    QTest::newRow("German, dark") << text("--at 1.9 --step L42T11 --size 1400x900 --language de "
                                          "--theme dark")
                                  << QSize(1400, 900);
    QTest::newRow("large") << text("--at 0 --size 1920x1080") << QSize(1920, 1080);
}

void TestCradleProgram::drawsAPictureWithoutADisplay()
{
    QFETCH(QString, options);
    QFETCH(QSize, size);
    QCOMPARE(sizeOf(picture(options)), size);
}

/// On a display with GLX whose drivers this machine lacks, which Qt ends a program for.
void TestCradleProgram::drawsAWindowWithoutOpenGl()
{
    QVERIFY(QDir(m_home->path()).mkdir(text("drivers")));
    for (const char *name : {"drivers/libGLX_mesa.so.0", "drivers/libGLX_indirect.so.0"})
        QVERIFY(!written(*m_home, name, "no library").isEmpty());
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(text("QT_QPA_PLATFORM"), text("xcb"));
    environment.remove(text("QT_XCB_GL_INTEGRATION"));
    const QStringList arguments{text("env"),
                                text("LD_LIBRARY_PATH=") + path("drivers"),
                                cradle::desktopProgram(),
                                text("--screenshot"),
                                path("picture.png"),
                                text("--size"),
                                text("1280x800")};
    const Outcome outcome =
        run(cradle::sourcePath("tests/tools/with-display"), arguments, m_home->path(), environment);
    VERIFY_CODE(outcome, 0);
    QCOMPARE(sizeOf(contentOf(path("picture.png"))), QSize(1280, 800));
}

void TestCradleProgram::pictureShowsTheMoment()
{
    const QString options = text("--step L42T11 --size 1280x800 --theme light --language ");
    const QByteArray early = picture(options + text("en --at 0"));
    QCOMPARE(sizeOf(early), QSize(1280, 800));
    const QByteArray late = picture(options + text("en --at 1.9"));
    const QByteArray german = picture(options + text("de --at 1.9"));
    QVERIFY(early != late);
    QVERIFY(german != late);
}

void TestCradleProgram::pictureShowsAFile()
{
    const QString preset = cradle::sourcePath("tasks/labs/lab-4.2/L42T14/preset.json");
    QCOMPARE(sizeOf(picture(text("--at 1 --size 1280x800 ") + preset)), QSize(1280, 800));
    const QString lab = cradle::fixturePath("labs/good");
    QCOMPARE(sizeOf(picture(text("--step S2 --size 1280x800 ") + lab)), QSize(1280, 800));
}

/// As the folder that it was made of, and the archive is not left unpacked.
void TestCradleProgram::pictureShowsAnArchive()
{
    const cradle::LabFiles lab = cradle::newLab(text("my-lab"), text("My lab"), text("en"));
    QVERIFY(!cradle::saveLabFiles(lab, {}, path("my-lab")));
    QVERIFY(!cradle::exportLab(lab, path("my-lab.cradle")));
    const QString options = text("--at 0.5 --size 1280x800 --theme light ");
    const QByteArray ofFolder = picture(options + path("my-lab"));
    const QByteArray ofArchive = picture(options + path("my-lab.cradle"));
    QCOMPARE(sizeOf(ofArchive), QSize(1280, 800));
    QCOMPARE(ofArchive, ofFolder);
    QVERIFY(ofArchive != picture(options));
    // In the window in which labs are written, too; its title bar alone knows the folder.
    const QString author = text("--tab text --size 1280x800 --theme light --author ");
    const QByteArray written = picture(author + path("my-lab.cradle"));
    QCOMPARE(written, picture(author + path("my-lab")));
    QVERIFY(written != ofArchive);
    QDirIterator files(m_home->path(), {text("lab.json")}, QDir::Files,
                       QDirIterator::Subdirectories);
    QCOMPARE(files.next(), path("my-lab/lab.json"));
    QVERIFY(!files.hasNext());
}

void TestCradleProgram::pictureLeavesNoProgress()
{
    QVERIFY(!picture(text("--at 1 --step L42T5 --size 1280x800")).isEmpty());
    QDirIterator files(m_home->path(), {text("progress.json*")}, QDir::Files,
                       QDirIterator::Subdirectories);
    QVERIFY(!files.hasNext());
}

void TestCradleProgram::wrongUsageIsSaid_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<QString>("word");
    int count = 0;
    const auto row = [&](const char *name, const QString &options, const char *word) {
        if (++count % cradle::oneOf(3) == 0)
            QTest::newRow(name) << options << text(word);
    };
    const QString bad = cradle::fixturePath("presets/bad/");
    const QString draw = text("--screenshot PICTURE ");
    row("unknown step", draw + text("--step L42T99"), "L42T17");
    row("step outside the lab", draw + text("--step ../L42T1"), "L42T17");
    row("missing file", draw + text("nowhere.json"), "nowhere.json: ");
    row("broken preset", draw + bad + text("radius_negative.json"),
        "radius_negative.json: /circles/1/radius: ");
    row("broken lab", draw + cradle::fixturePath("labs/wrong_format"), "lab.json: /format: ");
    row("archive that is none", draw + bad + text("../../labs/good/lab.cradle"), "lab.cradle: ");
    row("author of an archive that is none",
        draw + text("--author ") + bad + text("../../labs/good/lab.cradle"), "lab.cradle: ");
    row("author of nothing", draw + text("--author nowhere"), "nowhere: ");
    row("unknown tab", draw + text("--tab pictures --author ") + bad, "--tab pictures");
    row("two files", draw + text("a.json b.json"), "b.json");
    row("time is a word", draw + text("--at soon"), "--at soon");
    row("time before the start", draw + text("--at -1"), "--at -1");
    row("no time", draw + text("--at nan"), "--at nan");
    row("far too long", draw + text("--at 1e9"), "--at 1e9");
    row("size is a word", draw + text("--size large"), "--size large");
    row("size too small", draw + text("--size 10x10"), "--size 10x10");
    row("size too large", draw + text("--size 100000x800"), "--size 100000x800");
    row("three sizes", draw + text("--size 1280x800x600"), "--size 1280x800x600");
    row("unknown language", draw + text("--language xx"), "--language xx");
    row("unknown theme", draw + text("--theme pink"), "--theme pink");
    row("picture nowhere", text("--screenshot /no/such/folder/p.png"), "/no/such/folder/p.png");
    row("picture without a name", text("--screenshot"), "screenshot");
    row("unknown option", draw + text("--colour"), "colour");
    row("step without a name", text("--size 1280x800 --screenshot PICTURE --step"), "step");
}

void TestCradleProgram::wrongUsageIsSaid()
{
    QFETCH(QString, options);
    QFETCH(QString, word);
    const Outcome outcome = cradle(options, noDisplay());
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.contains(word), outcome.toText().constData());
    QVERIFY(!QFile::exists(path("picture.png")));
}

QTEST_GUILESS_MAIN(TestCradleProgram)
#include "test_cradle_program.moc"

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "tests/gui/window_test.h"
#include "tests/test_paths.h"

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QTimer>

using namespace cradle;
using namespace cradle::windows;

/// Files that the window opens, and that are broken.
class TestMainWindowFiles final : public WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void sceneFileIsOpened();
    void brokenSceneFileGivesANotice_data();
    void brokenSceneFileGivesANotice();
    void brokenSettingsDoNoHarm();

private:
    void openFile(const QString &path);
};

void TestMainWindowFiles::initTestCase()
{
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    applyTheme(ThemeChoice::Light);
}

void TestMainWindowFiles::init()
{
    setLanguage(QStringLiteral("en"));
    takeNewFolder();
}

void TestMainWindowFiles::cleanup()
{
    m_open.reset();
    applyTheme(ThemeChoice::Light);
}

/// Opens a file by the dialog of the menu.
void TestMainWindowFiles::openFile(const QString &path)
{
    bool accepted = false;
    QTimer watch;
    connect(&watch, &QTimer::timeout, this, [&] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        if (!dialog || accepted)
            return;
        accepted = true;
        dialog->findChild<QLineEdit *>()->setText(path);
        QMetaObject::invokeMethod(dialog, "accept");
    });
    watch.start(10);
    m_open->window.opening().openPresetFile();
    QVERIFY(accepted);
}

void TestMainWindowFiles::sceneFileIsOpened()
{
    openFile(sourcePath("tasks/labs/lab-4.2/L42T14/preset.json"));
    QVERIFY(m_open->preset() == *readPreset(QStringLiteral(":/labs/lab-4.2/L42T14/preset.json")));
    // The lab is still there.
    QVERIFY(m_open->bench.openTask(QStringLiteral("L42T2")));
    QVERIFY(m_open->window.transportBar().checkAction()->isEnabled());
}

void TestMainWindowFiles::brokenSceneFileGivesANotice_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"radius_negative.json", "binary.json", "overlapping.json"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestMainWindowFiles::brokenSceneFileGivesANotice()
{
    QFETCH(QString, name);
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("2"));
    const Preset before = m_open->preset();
    openFile(fixturePath("presets/bad/") + name);
    QVERIFY(m_open->window.notice().isVisible());
    QVERIFY2(m_open->window.notice().text().contains(name),
             qPrintable(m_open->window.notice().text()));
    QVERIFY(m_open->preset() == before);
    QCOMPARE(m_open->bench.current(), 0);
    m_open->click(QStringLiteral("Got it"));
    QVERIFY(m_open->window.notice().isHidden());
}

void TestMainWindowFiles::brokenSettingsDoNoHarm()
{
    m_open.reset();
    {
        QSettings settings(m_folder->filePath(QStringLiteral("settings.ini")),
                           QSettings::IniFormat);
        settings.setValue(QStringLiteral("geometry"), QByteArray("nonsense"));
        settings.setValue(QStringLiteral("layout/explore"), QByteArray(1000, '\xff'));
        settings.setValue(QStringLiteral("renderer"), QStringLiteral("crayon"));
    }
    reopen();
    QVERIFY(pane("task")->isVisible());
    m_open->press(Qt::Key_Right);
    QCOMPARE(m_open->simulation().current(), qint64{1});
}

QTEST_MAIN(TestMainWindowFiles)
#include "test_main_window_files.moc"

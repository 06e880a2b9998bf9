// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "open_window.h"
#include "tests/git_home.h"
#include "tests/patience.h"
#include "tests/test_paths.h"
#include "tests/typist.h"

#include "views/code/code_editor.h"
#include "views/code/code_pane.h"

#include <QProcess>

#include <cstdio>

using namespace cradle;

namespace {

constexpr int killings = 8; ///< or as many as the environment's CRADLE_KILLINGS says

/// The whole window, in which keys are pressed without a pause until it is killed.
int typeIntoWindow(const QString &folder)
{
    const QTemporaryDir place(folder + QStringLiteral("/w"));
    windows::OpenWindow open(place);
    std::printf("%s\n", qPrintable(place.path()));
    open.bench.setMode(Mode::Code);
    CodeEditor &editor = open.window.codePane().editor();
    editor.exchangeText(QStringLiteral("-- "));
    QWidget *area = editor.focusProxy();
    QTest::keyClick(area, Qt::Key_End, Qt::ControlModifier);
    return typeForEver([&](int) { QTest::keyClick(area, Qt::Key_1); });
}

} // namespace

/// Kill -9 of the window in which somebody types.
class TestKilledWindow final : public QObject
{
    Q_OBJECT
private slots:
    void losesLittleAndLeavesNothing_data();
    void losesLittleAndLeavesNothing();

private:
    GitHome m_home;
};

/// More keys than may be lost, and another number each time, so that it dies at another moment of
/// saving.
void TestKilledWindow::losesLittleAndLeavesNothing_data()
{
    QTest::addColumn<int>("most"); // keys before it is killed
    bool given = false;
    const int wanted = qEnvironmentVariableIntValue("CRADLE_KILLINGS", &given);
    for (int run = 0; run < (given ? wanted : killings); ++run)
        QTest::addRow("%d", run) << mostLost + 5 + 2 * (run % 25);
}

void TestKilledWindow::losesLittleAndLeavesNothing()
{
    QFETCH(int, most);
    const QTemporaryDir folder;
    const QTemporaryDir passing;
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("TMPDIR"), passing.path());
    environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), folder.path());
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    process.setProcessEnvironment(environment);
    process.start(ownProgram(), {QStringLiteral("--type"), folder.path()});
    QVERIFY(process.waitForReadyRead(patience));
    const QString place = QString::fromLocal8Bit(process.readLine()).trimmed();
    const int keys = keysUntilKilled(process, most);
    QVERIFY(keys > 0);
    QFile file(place + QStringLiteral("/programs/lab-4.2/steps/L42T1.lua"));
    const auto kept = file.open(QIODevice::ReadOnly) ? file.readAll().count('1') : 0;
    QVERIFY2(keys - kept <= mostLost, qPrintable(QStringLiteral("%1 of %2").arg(kept).arg(keys)));
    const QStringList left =
        QDir(passing.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    QVERIFY2(left.isEmpty(), qPrintable(left.join(QLatin1Char(' '))));
}

int main(int argc, char **argv)
{
    QApplication app(argc, argv);
    if (const QStringList arguments = QApplication::arguments();
        arguments.value(1) == QLatin1String("--type"))
        return typeIntoWindow(arguments.value(2));
    TestKilledWindow test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_killed_window.moc"

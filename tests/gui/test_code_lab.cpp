// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_window.h"

#include "app/code_desk.h"
#include "tests/patience.h"
#include "tests/sanitized.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"

#include <QSignalSpy>

using namespace cradle;
using cradle::windows::OpenWindow;

/// The lab as a student of the mode with code goes through it: types a program, presses Check.
class TestCodeLab final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void solutionsPassWhenTyped_data();
    void solutionsPassWhenTyped();
    void mistakesAreRecognised_data();
    void mistakesAreRecognised();

private:
    void open(const QString &step);
    void type(const QString &program);
    void check();

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestCodeLab::init()
{
    m_open.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    m_open->bench.setMode(Mode::Code);
}

void TestCodeLab::open(const QString &step)
{
    QVERIFY(m_open->bench.openTask(step));
    QVERIFY(m_open->bench.mode() == Mode::Code);
}

/// Key by key, without the spaces at the beginning of a line: those are the editor's business.
void TestCodeLab::type(const QString &program)
{
    CodeEditor &editor = m_open->window.codePane().editor();
    editor.setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Delete);
    for (const QString &line : program.split(QLatin1Char('\n'))) {
        for (const QChar letter : line.trimmed())
            QTest::keyClick(QApplication::focusWidget(), letter.toLatin1());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    QTRY_COMPARE(m_open->bench.code().text(), editor.text());
}

void TestCodeLab::check()
{
    QSignalSpy ended(&m_open->bench.check(), &WorkCheck::reported);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return, Qt::ControlModifier);
    QVERIFY2(!ended.isEmpty() || ended.wait(patience), qPrintable(m_open->bench.code().text()));
    QTRY_VERIFY(!m_open->bench.check().awaitsRun());
}

void TestCodeLab::solutionsPassWhenTyped_data()
{
    QTest::addColumn<QString>("step");
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    for (std::size_t i = 0; i < lab->tasks.size(); i += std::size_t{oneOf(3)})
        QTest::newRow(qPrintable(lab->tasks[i].id)) << lab->tasks[i].id;
}

void TestCodeLab::solutionsPassWhenTyped()
{
    QFETCH(QString, step);
    open(step);
    // Comments are many letters and no program.
    QStringList lines = m_open->bench.task()->solution.split(QLatin1Char('\n'));
    lines.removeIf(
        [](const QString &line) { return line.trimmed().startsWith(QLatin1String("--")); });
    type(lines.join(QLatin1Char('\n')));
    check();
    QVERIFY(m_open->bench.check().report());
    const CheckReport &report = *m_open->bench.check().report();
    QVERIFY2(!report.error, report.error ? qPrintable(report.error->message) : "");
    QVERIFY(report.passed);
    QVERIFY(!report.diagnosis());
    QVERIFY(m_open->isTicked(m_open->bench.current()));
    QVERIFY(m_open->bench.progress().mayShowSolution());
}

void TestCodeLab::mistakesAreRecognised_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<int>("mistake");
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    for (std::size_t i = 0; i < lab->tasks.size(); i += std::size_t{oneOf(3)}) {
        const Task &task = lab->tasks[i];
        // Another one in every step.
        const auto count = static_cast<int>(task.mistakes.size());
        const int mistake = static_cast<int>(task.id.size() * 7 + task.title.size()) % count;
        QTest::addRow("%s %s", qPrintable(task.id),
                      qPrintable(task.mistakes[static_cast<std::size_t>(mistake)].name))
            << task.id << mistake;
    }
}

void TestCodeLab::mistakesAreRecognised()
{
    QFETCH(QString, step);
    QFETCH(int, mistake);
    open(step);
    const KnownScript known = m_open->bench.task()->mistakes[static_cast<std::size_t>(mistake)];
    m_open->bench.code().replace(known.source);
    check();
    QVERIFY(m_open->bench.check().report());
    const CheckReport &report = *m_open->bench.check().report();
    QVERIFY(!report.passed);
    QVERIFY2(report.diagnosis(), "no diagnosis");
    QCOMPARE(report.diagnosis()->mistake, known.name);
    const QString headline = known.message.section(QLatin1Char('\n'), 0, 0);
    const auto labels = m_open->window.taskPane().findChildren<QLabel *>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [&](const QLabel *label) {
        return label->isVisible() && label->text() == headline;
    }));
}

QTEST_MAIN(TestCodeLab)
#include "test_code_lab.moc"

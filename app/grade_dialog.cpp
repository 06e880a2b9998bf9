// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grade_dialog.h"

#include "app/language.h"
#include "views/mnemonics.h"

#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>

namespace cradle {

namespace {

QString chosenFolder(QWidget *parent, const QString &title, const QString &before)
{
    return QFileDialog::getExistingDirectory(parent, title, before,
                                             QFileDialog::DontUseNativeDialog);
}

/// Words of the command as a sentence of the window. What begins with a file or a student stays.
QString sentence(const QString &words)
{
    return words.section(u' ', 0, 0).contains(u':') ? words
                                                    : words.left(1).toUpper() + words.mid(1);
}

} // namespace

GradeDialog::GradeDialog(const Lab &lab, QWidget *parent)
    : QDialog(parent)
    , m_lab(lab.folder)
{
    // Made in the order in which Tab goes through them.
    setWindowTitle(tr("Grade a class: %1").arg(lab.title));
    auto *form = new QFormLayout;
    m_submissions = addPath(
        form, tr("&Handed in:"),
        tr("A folder with a folder, or a .cradle-work file, for each student; or a download of "
           "Moodle, Canvas, Blackboard or GitHub Classroom. Nothing in it is changed."),
        [this](const QString &before) {
            return chosenFolder(this, tr("Choose what was handed in"), before);
        });
    m_results =
        addPath(form, tr("&Results:"),
                tr("A folder for the results: an empty one, or one with the results of the "
                   "same class, which then go on where they were."),
                [this](const QString &before) {
                    return chosenFolder(this, tr("Choose a folder for the results"), before);
                });
    m_roster = addPath(form, tr("R&oster:"),
                       tr("A table (CSV) of who is in the class: id, folder, name, number, email, "
                          "late days. It may be left out."),
                       [this](const QString &before) {
                           return QFileDialog::getOpenFileName(this, tr("Choose a roster"), before,
                                                               tr("Tables (*.csv)"), nullptr,
                                                               QFileDialog::DontUseNativeDialog);
                       });
    m_late = new QDoubleSpinBox(this);
    m_late->setButtonSymbols(QAbstractSpinBox::NoButtons); // up and down do it
    m_late->setRange(0.0, 100.0);
    m_late->setDecimals(1);
    m_late->setMaximumWidth(m_late->fontMetrics().averageCharWidth() * 18);
    m_late->setSuffix(tr(" % a day"));
    m_late->setAccessibleDescription(tr("What each day late that has begun takes of the points"));
    m_late->setToolTip(m_late->accessibleDescription());
    form->addRow(tr("&Late:"), m_late);
    m_progress = new QProgressBar(this);
    m_message = new QLabel(this);
    m_message->setWordWrap(true);
    m_message->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_message->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_message->setTextFormat(Qt::PlainText);
    m_message->setAccessibleName(tr("How the grading goes"));
    m_message->setText(tr("Choose what was handed in, and a folder for the results. Grading can be "
                          "stopped at any time, and goes on where it was."));
    // Of a class there may be hundreds: they scroll, and the window stays as large as it is.
    m_remarks = new QPlainTextEdit(this);
    m_remarks->setReadOnly(true);
    m_remarks->setTabChangesFocus(true);
    m_remarks->setAccessibleName(tr("Remarks on what was handed in"));
    QSizePolicy policy = m_remarks->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_remarks->setSizePolicy(policy);
    m_remarks->hide();
    m_progress->setAccessibleName(tr("Students done"));
    m_progress->setTextVisible(false); // the message has the numbers, and the bar is thin
    m_progress->hide();
    auto *buttons = new QDialogButtonBox(this);
    m_start = buttons->addButton(tr("&Grade"), QDialogButtonBox::ActionRole);
    m_stop = buttons->addButton(tr("&Stop"), QDialogButtonBox::ActionRole);
    m_open = buttons->addButton(tr("O&pen the results"), QDialogButtonBox::ActionRole);
    buttons->addButton(QDialogButtonBox::Close);
    m_start->setDefault(true);
    m_stop->setEnabled(false);
    auto *column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(m_progress);
    column->addWidget(m_message);
    column->addWidget(m_remarks, 1);
    column->addWidget(buttons);
    resize(680, 360);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_start, &QPushButton::clicked, this, &GradeDialog::grade);
    connect(m_stop, &QPushButton::clicked, &m_run, &GradeRun::stop);
    connect(m_open, &QPushButton::clicked, this, &GradeDialog::openResults);
    connect(&m_run, &GradeRun::progressed, this, &GradeDialog::showState);
    connect(&m_run, &GradeRun::remarked, this, &GradeDialog::addRemark);
    connect(&m_run, &GradeRun::ended, this, &GradeDialog::end);
    const auto refresh = [this] {
        m_open->setEnabled(!m_results->text().isEmpty() && QFileInfo::exists(resultsPage()));
        m_start->setEnabled(!m_run.isRunning() && !m_submissions->text().isEmpty()
                            && !m_results->text().isEmpty());
        m_start->setDefault(true); // else the results of before would be opened by Enter
    };
    connect(m_submissions, &QLineEdit::textChanged, this, refresh);
    connect(m_results, &QLineEdit::textChanged, this, refresh);
    refresh();
}

QLineEdit *GradeDialog::addPath(QFormLayout *form, const QString &label, const QString &about,
                                const std::function<QString(const QString &)> &choose)
{
    auto *edit = new QLineEdit(this);
    edit->setToolTip(about);
    edit->setAccessibleDescription(about);
    auto *button = new QPushButton(tr("Choose…"), this);
    button->setAutoDefault(false);
    const QString name = withoutMnemonic(label).remove(QLatin1Char(':'));
    edit->setAccessibleName(name);
    button->setAccessibleName(tr("Choose: %1").arg(name));
    auto *row = new QHBoxLayout;
    row->addWidget(edit, 1);
    row->addWidget(button);
    form->addRow(label, row);
    // A row's label knows the field of a layout not by itself.
    if (auto *text = qobject_cast<QLabel *>(form->labelForField(row)))
        text->setBuddy(edit);
    connect(button, &QPushButton::clicked, this, [edit, choose] {
        const QString chosen = choose(edit->text());
        if (!chosen.isEmpty())
            edit->setText(QDir::toNativeSeparators(chosen));
    });
    return edit;
}

void GradeDialog::setFolders(const QString &submissions, const QString &results)
{
    m_submissions->setText(submissions);
    m_results->setText(results);
}

QString GradeDialog::resultsPage() const
{
    return QDir(m_results->text()).absoluteFilePath(QStringLiteral("class.html"));
}

void GradeDialog::grade()
{
    m_remarks->clear();
    m_remarks->hide();
    m_message->setText(tr("What was handed in is read…"));
    m_progress->setRange(0, 0);
    m_progress->show();
    m_start->setEnabled(false);
    m_open->setEnabled(false);
    m_stop->setEnabled(true);
    m_run.start({.submissions = m_submissions->text(),
                 .lab = m_lab,
                 .results = m_results->text(),
                 .roster = m_roster->text(),
                 .latePercent = m_late->value(),
                 .language = currentLanguage()});
}

void GradeDialog::showState()
{
    const GradeState &state = m_run.state();
    if (state.students > 0) {
        m_progress->setRange(0, state.students);
        m_progress->setValue(state.done);
    }
    QString text = tr("%1 of %2 students: %3 steps pass, %4 do not, %5 could not be graded.")
                       .arg(state.done)
                       .arg(state.students)
                       .arg(state.passed)
                       .arg(state.failed)
                       .arg(state.notGraded);
    if (state.kept > 0)
        text +=
            QLatin1Char(' ') + tr("%n of the students as they were before.", nullptr, state.kept);
    m_message->setText(text);
}

void GradeDialog::addRemark(const QString &text)
{
    m_remarks->appendPlainText(sentence(text));
    m_remarks->show();
}

void GradeDialog::end(bool complete, const QString &fault)
{
    m_stop->setEnabled(false);
    m_start->setEnabled(true);
    m_open->setEnabled(QFileInfo::exists(resultsPage()));
    m_progress->setVisible(complete);
    if (complete) {
        m_open->setDefault(true);
        m_open->setFocus();
        return;
    }
    if (fault.isEmpty()) {
        const QString stopped =
            tr("Stopped. What is judged stays; grading again goes on from here.");
        showState();
        m_message->setText(
            m_run.state().students > 0 ? stopped + QLatin1Char('\n') + m_message->text() : stopped);
        return;
    }
    m_message->setText(sentence(fault.section(u'\n', 0, 0)));
    if (const QString more = fault.section(u'\n', 1); !more.isEmpty())
        addRemark(more);
}

void GradeDialog::openResults()
{
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(resultsPage())))
        m_message->setText(tr("No program opened the page. It is %1").arg(resultsPage()));
}

} // namespace cradle

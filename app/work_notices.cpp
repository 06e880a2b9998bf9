// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/work_notices.h"

#include "app/notice_bar.h"
#include "app/workbench.h"
#include "tasks/hand_in/hand_in.h"

#include <QInputDialog>
#include <QLocale>
#include <QMessageBox>
#include <QSettings>

#include <utility>

namespace cradle {

namespace {

/// Whether commits are signed "Student": neither git nor the work knows a name.
bool signsAsNobody(const Workspace &workspace)
{
    const History *history = workspace.history();
    return history && history->gitName().isEmpty() && workspace.info().student.isEmpty();
}

} // namespace

WorkNotices::WorkNotices(Workbench &workbench, NoticeBar &notice, QSettings &settings,
                         QWidget &window)
    : m_workbench(workbench)
    , m_notice(notice)
    , m_settings(settings)
    , m_window(window)
{
    CodeSession *code = &workbench.code();
    connect(&workbench, &Workbench::failed, this,
            [this](const Error &error) { m_notice.warn(error.toString()); });
    connect(&workbench, &Workbench::taskChanged, this, &WorkNotices::showTaskNotice);
    // In another mode there is something else to say; what was closed stays so.
    connect(&workbench, &Workbench::modeChanged, this, [this] {
        if (m_taskNotice == m_notice.notice())
            showTaskNotice();
    });
    connect(&workbench, &Workbench::heldElsewhere, this, &WorkNotices::showHolder);
    connect(&workbench.check(), &WorkCheck::stepCommitted, this, &WorkNotices::askNameOnce);
    // Not while the lab is being opened.
    connect(&workbench, &Workbench::numberWanted, this, &WorkNotices::askNumber,
            Qt::QueuedConnection);
    connect(code, &CodeSession::failed, this, &WorkNotices::reportUnsaved);
    connect(code, &CodeSession::savedAgain, this,
            [this] { m_notice.retract(std::exchange(m_unsavedWarning, {})); });
    connect(code, &CodeSession::setAside, this, &WorkNotices::showSetAside);
    connect(code, &CodeSession::changedOutside, this, [this](bool taken) {
        m_notice.showNotice(taken ? tr("Another program has changed your program. Its text is "
                                       "shown now; yours is among the versions of this step.")
                                  : tr("Another program has changed your program while you "
                                       "typed. Yours stays; the other is among the versions of "
                                       "this step."));
    });
}

void WorkNotices::showSetAside(const QString &name, const QString &kept)
{
    m_notice.showNotice(tr("Another program has made %1 a file that is no program. It is kept as "
                           "%2; what can be read of it is among the versions of this step.")
                            .arg(name, kept));
}

/// The values of the lab are drawn by it.
void WorkNotices::askNumber()
{
    if (!m_workbench.wantsNumber() || !m_window.isVisible())
        return;
    // Not one that blocks: a picture may be taken, or the lab left.
    auto *dialog = new QInputDialog(&m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Your number"));
    dialog->setLabelText(tr("This lab draws its values for each student by the number that you "
                            "hand in with.\nYour number:"));
    connect(dialog, &QDialog::finished, this, [this, dialog](int result) {
        const QString number = dialog->textValue().simplified();
        if (!m_workbench.wantsNumber())
            return;
        if (result != QDialog::Accepted || number.isEmpty())
            m_notice.showNotice(tr("The values of this lab are those of nobody until you give "
                                   "your number: open the lab again for that."));
        else if (const auto error = m_workbench.setStudentNumber(number))
            m_notice.showNotice(error->toString());
    });
    dialog->open();
}

void WorkNotices::reportUnsaved(const Error &error)
{
    m_notice.retract(m_unsavedWarning);
    m_unsavedWarning = error.toString();
    m_notice.warn(m_unsavedWarning);
}

/// What there is to know about the step that was opened.
void WorkNotices::showTaskNotice()
{
    m_notice.clearNotice();
    Workbench *bench = &m_workbench;
    const CodeSession &code = bench->code();
    if (bench->task() && code.workspace().isLookedAt()) {
        const WorkspaceInfo &info = code.workspace().info();
        const QString whose =
            tr("Work that %1 handed in. Run it, check it, read its versions and notes: nothing of "
               "it is changed, and nothing of what it says about itself is believed.")
                .arg(info.student.isEmpty() ? tr("somebody") : info.student);
        const QString note = noteToTeacher(code.workspace().folder());
        m_notice.showNotice(
            note.isEmpty() ? whose : whose + QLatin1Char(' ') + tr("They write: “%1”").arg(note));
    } else if (bench->task() && bench->mode() == Mode::Code && code.foreign()) {
        std::vector<NoticeBar::Offer> offers;
        if (code.workspace().canConvert(code.taskId()))
            offers.push_back(
                {tr("Make a program of it"), [bench] { bench->waysBack().convertProgram(); }});
        if (bench->waysBack().newestVersion())
            offers.push_back({tr("Back to the newest version"),
                              [bench] { bench->waysBack().takeNewestVersion(); }});
        offers.push_back(
            {tr("Begin this step anew"), [bench] { bench->waysBack().setProgramAside(); }});
        m_notice.showNotice(tr("The file of your program is no program, and is left as it is. %1 "
                               "Whatever you choose, the file is kept beside it.")
                                .arg(code.foreign()->toString()),
                            offers);
    } else if (const Task *missed =
                   bench->mode() == Mode::Code ? bench->waysBack().missedTask() : nullptr) {
        m_notice.showNotice(
            tr("This step goes on from the one before, which you have not done. You begin with "
               "your own program."),
            {{tr("Begin with the solution of “%1”").arg(missed->title),
              [bench] { bench->waysBack().startFromSolution(); }}});
    } else if (bench->isFirstStart() && bench->current() == 0) {
        m_notice.showNotice(
            bench->mode() == Mode::Code
                ? tr("Read the step on the left, write your program in the middle, press Run to "
                     "watch, and Check when you are done.")
                : tr("Read the step on the left, set the values beside the scene, press Run to "
                     "watch, and Check when you are done."),
            {{tr("Show me around"),
              [this] {
                  m_notice.clearNotice();
                  emit tourRequested();
              }},
             {tr("Got it"), [this] { m_notice.clearNotice(); }}});
    }
    m_taskNotice = m_notice.notice();
}

void WorkNotices::showHolder()
{
    const auto &holder = m_workbench.code().workspace().holder();
    if (!holder)
        return;
    Workbench *bench = &m_workbench;
    m_notice.warn(tr("Another window works on this lab (process %1 on %2, since %3). In this one "
                     "you can look, but nothing is saved.")
                      .arg(holder->process)
                      .arg(holder->host,
                           QLocale().toString(holder->since.toLocalTime(), QLocale::ShortFormat)),
                  {{tr("Take over"), [bench] { bench->takeOver(); }}});
}

/// Whose the commits are, if neither git nor the work knows it.
void WorkNotices::askNameOnce()
{
    const QString asked = QStringLiteral("nameAsked");
    if (m_settings.value(asked).toBool() || !signsAsNobody(m_workbench.code().workspace()))
        return;
    m_settings.setValue(asked, true);
    m_notice.showNotice(tr("What you pass is kept in your history, signed “Student”. It can be "
                           "signed with your name."),
                        {{tr("Give your name…"), [this] { giveName(); }}});
}

void WorkNotices::giveName()
{
    Workspace &workspace = m_workbench.code().workspace();
    const QString name = QInputDialog::getText(&m_window, tr("Your name"), tr("Your name:"),
                                               QLineEdit::Normal, workspace.info().student);
    if (name.simplified().isEmpty())
        return;
    if (const auto error = workspace.setStudent(name, workspace.info().studentId))
        m_notice.showNotice(error->toString());
    else
        m_notice.clearNotice();
}

bool WorkNotices::mayClose()
{
    m_workbench.code().save();
    if (m_workbench.code().isSaved())
        return true;
    return QMessageBox::warning(&m_window, tr("Your program is not saved"),
                                m_unsavedWarning + QStringLiteral("\n\n")
                                    + tr("What you typed since it was last saved is lost if you "
                                         "close the window."),
                                QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel)
           == QMessageBox::Discard;
}

} // namespace cradle

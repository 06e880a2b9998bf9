// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/author_document.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/reading/lab_reader.h"

#include <QDirIterator>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QUndoCommand>
#include <QtConcurrentRun>

#include <utility>

namespace cradle {

namespace {

constexpr int readDelay = 300;       ///< ms after an edit, while more may follow
constexpr int draftDelay = 250;      ///< ms after the first edit that is not kept
constexpr int lookDelay = 400;       ///< ms; editors write a file in several steps
constexpr qint64 typingPause = 2000; ///< ms without an edit that end an undo step

} // namespace

/// One undo step: the files before and after, and the step that was open.
class AuthorEdit final : public QUndoCommand
{
public:
    using State = AuthorDocument::State;

    AuthorEdit(AuthorDocument &document, const QString &text, State after, QString mergeKey)
        : QUndoCommand(text)
        , m_document(document)
        , m_before{document.m_files, document.m_step}
        , m_after(std::move(after))
        , m_mergeKey(std::move(mergeKey))
    {
        m_age.start();
    }

    void undo() override { m_document.apply(m_before); }
    void redo() override { m_document.apply(m_after); }
    [[nodiscard]] int id() const override { return m_mergeKey.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand *other) override
    {
        const auto *next = static_cast<const AuthorEdit *>(other);
        if (next->m_mergeKey != m_mergeKey || m_age.elapsed() > typingPause)
            return false;
        m_after = next->m_after;
        m_age.restart();
        setObsolete(m_after.files == m_before.files);
        return true;
    }

private:
    AuthorDocument &m_document;
    State m_before;
    State m_after;
    QString m_mergeKey;
    QElapsedTimer m_age; ///< since the last edit that was merged
};

AuthorDocument::AuthorDocument(QObject *parent)
    : QObject(parent)
{
    m_readTimer.setSingleShot(true);
    m_readTimer.setInterval(readDelay);
    m_lookTimer.setSingleShot(true);
    m_lookTimer.setInterval(lookDelay);
    m_draftTimer.setSingleShot(true);
    m_draftTimer.setInterval(draftDelay);
    connect(&m_draftTimer, &QTimer::timeout, this, &AuthorDocument::keepDraft);
    connect(&m_readTimer, &QTimer::timeout, this, &AuthorDocument::startReading);
    connect(&m_lookTimer, &QTimer::timeout, this, &AuthorDocument::lookOutside);
    connect(&m_reading, &QFutureWatcherBase::finished, this, [this] {
        const auto &[number, lab] = *m_reading.result();
        if (number == m_readings)
            takeLab(lab);
    });
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, &AuthorDocument::stateChanged);
}

AuthorDocument::~AuthorDocument()
{
    // The stack tells of its end when some of this is gone already.
    disconnect(&m_undoStack, nullptr, this, nullptr);
    m_reading.waitForFinished();
}

bool AuthorDocument::isModified() const
{
    return !m_readOnly && m_files != m_onDisk;
}

QString AuthorDocument::whyReadOnly() const
{
    return m_readOnly ? tr("This lab ships with Cradle and stays as it is; make a copy of it to "
                           "change that")
                      : QString();
}

QStringList AuthorDocument::steps() const
{
    return stepsOf(m_files);
}

QString AuthorDocument::title() const
{
    if (!m_lab.title.isEmpty())
        return m_lab.title;
    return m_folder.isEmpty() ? tr("New lab") : QFileInfo(m_folder).fileName();
}

const Task *AuthorDocument::task() const
{
    for (const Task &task : m_lab.tasks) {
        if (QFileInfo(task.folder).fileName() == m_step)
            return &task;
    }
    return nullptr;
}

std::optional<Error> AuthorDocument::open(const QString &folder)
{
    std::vector<Error> findings;
    const Result<LabFiles> files = readLabFiles(folder, &findings);
    if (!files)
        return files.error();
    m_unread = findings;
    m_onDisk = *files;
    take(*files, folder);
    takeDraft();
    return std::nullopt;
}

void AuthorDocument::begin(const LabFiles &files)
{
    m_unread.clear();
    m_onDisk = {};
    take(files, {});
}

void AuthorDocument::take(const LabFiles &files, const QString &folder)
{
    m_undoStack.clear();
    m_files = files;
    m_folder = folder;
    m_readOnly = folder.startsWith(QLatin1Char(':'));
    m_step = steps().value(0);
    if (const QStringList languages = languagesOf(files); !languages.contains(m_language))
        m_language = languages.front();
    watch();
    readNow();
    emit opened();
    emit stateChanged();
    emit stepChanged();
    emit changed();
}

bool AuthorDocument::edit(const QString &text, const Result<LabFiles> &after,
                          const QString &mergeKey)
{
    return editStep(text, after, m_step, mergeKey);
}

bool AuthorDocument::editStep(const QString &text, const Result<LabFiles> &after,
                              const QString &step, const QString &mergeKey)
{
    if (!after) {
        emit refused(after.error());
        return false;
    }
    if (*after == m_files)
        return true;
    if (m_readOnly) {
        emit refused({.message = whyReadOnly()});
        return false;
    }
    m_undoStack.push(new AuthorEdit(*this, text, {*after, step}, mergeKey));
    return true;
}

bool AuthorDocument::editTask(const QString &text, const std::function<void(TaskForm &)> &change,
                              const QString &mergeKey)
{
    Result<TaskForm> changed = form();
    if (!changed)
        return false;
    change(*changed);
    return edit(text, withTask(m_files, m_step, *changed, m_language), mergeKey);
}

void AuthorDocument::apply(const State &state)
{
    m_files = state.files;
    const bool moved = state.step != m_step;
    m_step = state.step;
    readSoon();
    emit changed();
    if (moved)
        emit stepChanged();
    emit stateChanged();
    if (!m_drafts.isEmpty() && !m_draftTimer.isActive())
        m_draftTimer.start();
}

void AuthorDocument::setStep(const QString &step)
{
    if (step == m_step)
        return;
    m_step = step;
    emit stepChanged();
}

void AuthorDocument::setLanguage(const QString &language)
{
    if (language == m_language)
        return;
    m_language = language;
    emit languageChanged();
    readSoon();
}

void AuthorDocument::readSoon()
{
    m_readTimer.start();
}

void AuthorDocument::startReading()
{
    const int number = ++m_readings;
    m_reading.setFuture(
        QtConcurrent::run([files = m_files, folder = m_folder, language = m_language, number] {
            return std::make_shared<const Reading>(number, readLab(files, folder, language));
        }));
}

void AuthorDocument::readNow()
{
    m_readTimer.stop();
    ++m_readings;
    takeLab(readLab(m_files, m_folder, m_language));
}

void AuthorDocument::takeLab(const Result<Lab> &lab)
{
    m_lab = lab ? *lab : Lab();
    if (!lab)
        m_lab.findings.push_back(lab.error());
    emit labRead();
}

} // namespace cradle

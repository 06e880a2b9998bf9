// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/task_form.h"
#include "tasks/lab/lab.h"
#include "tasks/lab_files/lab_files.h"

#include <QDateTime>
#include <QFutureWatcher>
#include <QObject>
#include <QTimer>
#include <QUndoStack>

#include <functional>
#include <memory>

class QFileSystemWatcher;

namespace cradle {

/// The lab that an author works on: all its files as one value, the step and the language that are
/// open, and one undo for every edit.
class AuthorDocument final : public QObject
{
    Q_OBJECT
public:
    explicit AuthorDocument(QObject *parent = nullptr);
    ~AuthorDocument() override;

    [[nodiscard]] const LabFiles &files() const { return m_files; }
    [[nodiscard]] const QString &folder() const { return m_folder; } ///< empty: not saved yet
    [[nodiscard]] bool isReadOnly() const { return m_readOnly; }
    /// What an author should know who wants to edit it then; else empty.
    [[nodiscard]] QString whyReadOnly() const;
    [[nodiscard]] bool isModified() const;
    [[nodiscard]] QStringList steps() const;                     ///< folders, in order
    [[nodiscard]] const QString &step() const { return m_step; } ///< the open one; may be empty
    [[nodiscard]] const QString &language() const { return m_language; } ///< of the texts, "en"
    /// The open step as a form, with texts in the open language.
    [[nodiscard]] Result<TaskForm> form() const { return taskForm(m_files, m_step, m_language); }
    /// The path in the lab of what is \p file in the open step's folder: "solution.lua".
    [[nodiscard]] QString inStep(const QString &file) const { return m_step + u'/' + file; }
    /// The files as they were read from, or written to, the folder last.
    [[nodiscard]] const LabFiles &onDisk() const { return m_onDisk; }
    /// The lab as it was read last, a little after the newest edit.
    [[nodiscard]] const Lab &lab() const { return m_lab; }
    /// Its title as it was read last, or what else it can be called.
    [[nodiscard]] QString title() const;
    /// The open step as it was read last; nullptr if it cannot be read.
    [[nodiscard]] const Task *task() const;
    [[nodiscard]] QUndoStack &undoStack() { return m_undoStack; }
    /// What kept files of the folder from being read.
    [[nodiscard]] const std::vector<Error> &unread() const { return m_unread; }

    /// Opens a lab's folder. \return what is wrong with it
    std::optional<Error> open(const QString &folder);
    /// Begins with \p files, which lie nowhere yet.
    void begin(const LabFiles &files);
    /// Makes an edit named \p text; edits with the same non-empty \p mergeKey in a row, as those
    /// of typing, become one undo step.
    /// \return false (and refused() is emitted) if \p after is an error or the lab is read-only
    bool edit(const QString &text, const Result<LabFiles> &after, const QString &mergeKey = {});
    /// The same, and opens \p step with it.
    bool editStep(const QString &text, const Result<LabFiles> &after, const QString &step,
                  const QString &mergeKey = {});
    /// The same; \param change  makes of the open step's form, in the open language, what it is to
    /// be.
    bool editTask(const QString &text, const std::function<void(TaskForm &)> &change,
                  const QString &mergeKey = {});
    /// Writes what changed. \param overwrite  also files that somebody else changed meanwhile
    /// \return what kept it from being saved
    std::optional<Error> save(bool overwrite = false);
    /// Writes all files into an empty or new folder and goes on there.
    std::optional<Error> saveAs(const QString &folder) { return saveCopy(folder, m_files); }
    /// The same with \p files, the lab under another id; what was edited cannot be undone there.
    std::optional<Error> saveCopy(const QString &folder, const LabFiles &files);
    /// Takes the folder's files as they are now, as one edit that can be undone.
    std::optional<Error> reload();
    /// Takes what another program changed in the folder, file by file, as one edit that can be
    /// undone; all else stays as it is here.
    std::optional<Error> takeTheirs();
    /// Reads the lab at once instead of a little later.
    void readNow();
    /// Where changes that are not saved are kept, within 0.5 s; without it nowhere.
    void keepDraftsIn(const QString &folder) { m_drafts = folder; }
    /// Whether there is a lab that was never saved when a window was killed.
    [[nodiscard]] bool hasUnsavedDraft() const;
    /// Begins with the lab that was never saved when a window was killed. \return whether there was
    /// one
    bool openUnsavedDraft();
    /// The changes are not wanted any more.
    void discardDraft();

public slots:
    void setStep(const QString &step);
    void setLanguage(const QString &language);

signals:
    void opened();                             ///< another lab
    void draftTaken(const QDateTime &when);    ///< changes that were not saved then are back
    void changed();                            ///< files, or whether they may be edited
    void stepChanged();                        ///< another step, or none
    void languageChanged();                    ///< of the texts
    void labRead();                            ///< lab() follows the files again
    void refused(const cradle::Error &error);  ///< an edit was not made
    void changedOutside(const QString &names); ///< files in the folder are not as they were read
    void stateChanged();                       ///< folder, modified or not

private:
    friend class AuthorEdit;
    struct State {
        LabFiles files;
        QString step;
    };

    void apply(const State &state);
    void take(const LabFiles &files, const QString &folder);
    std::optional<Error> readAgain(const QString &name, bool whole);
    void readSoon();
    void startReading();
    void takeLab(const Result<Lab> &lab);
    void watch();
    void lookOutside();
    void takeDraft();
    void keepDraft();

    LabFiles m_files;
    LabFiles m_onDisk; ///< as they were read or saved last
    QString m_folder;
    QString m_step;
    QString m_language = QStringLiteral("en");
    bool m_readOnly = false;
    QUndoStack m_undoStack;
    Lab m_lab;
    std::vector<Error> m_unread;
    QTimer m_readTimer;
    QTimer m_lookTimer;
    QString m_drafts;
    QTimer m_draftTimer;
    /// A lab with the number of the reading that it came from: older ones are no news.
    using Reading = std::pair<int, Result<Lab>>;
    QFutureWatcher<std::shared_ptr<const Reading>> m_reading;
    int m_readings = 0; ///< begun so far
    std::unique_ptr<QFileSystemWatcher> m_watcher;
};

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/task_form.h"
#include "tasks/lab_files/lab_files.h"

namespace cradle {

// Edits of a lab: from files to files. What an edit does not change keeps its bytes. An Error says
// why an edit cannot be made, with the file.

/// A lab of one step that passes verify: the start of a new one.
/// \param language  "de" for a German template; else the texts are English
[[nodiscard]] LabFiles newLab(const QString &id, const QString &title, const QString &language);

/// What lab.json says of the lab as a whole.
struct LabForm {
    QString id;
    QString title;
    QString version{};
    QString language{};

    friend bool operator==(const LabForm &, const LabForm &) = default;
};
[[nodiscard]] Result<LabForm> labForm(const LabFiles &files, const QString &language = {});
/// In another language than the lab's own an empty title takes the translation away.
[[nodiscard]] Result<LabFiles> withLab(const LabFiles &files, const LabForm &form,
                                       const QString &language = {});
/// Whether the lab has a title in that language, which may be its own.
[[nodiscard]] bool hasTitle(const LabFiles &files, const QString &language);
/// Says that the lab's own texts are in that language.
/// \return an error if there are translations into it already
[[nodiscard]] Result<LabFiles> withOwnLanguage(const LabFiles &files, const QString &language);

/// What keeps lab.json or the texts of \p step from being read, in \p language, with the path of
/// the file in the lab; nullopt if nothing does. A file that is not there is no broken one.
[[nodiscard]] std::optional<Error> brokenFile(const LabFiles &files, const QString &step,
                                              const QString &language = {});

/// The folders of the lab's steps, in order; empty if lab.json cannot be read.
[[nodiscard]] QStringList stepsOf(const LabFiles &files);

/// The languages that the lab or a step has texts in: its own first.
[[nodiscard]] QStringList languagesOf(const LabFiles &files);

/// A step like that of a new lab, in folder \p step, which is its id, too.
/// \param at  its place from 0; −1 for the end
[[nodiscard]] Result<LabFiles> withStepAdded(const LabFiles &files, const QString &step,
                                             const QString &title, int at = -1);
/// Removes the step with its files; foreignFiles() stay.
[[nodiscard]] Result<LabFiles> withStepRemoved(const LabFiles &files, const QString &step);
/// Files in the folder of a step that it does not use: neither a name that steps have nor one that
/// its texts tell. Somebody put them there, and the lab can do without.
[[nodiscard]] QStringList foreignFiles(const LabFiles &files, const QString &step);
/// \param to  its place from 0 among all steps afterwards
[[nodiscard]] Result<LabFiles> withStepMoved(const LabFiles &files, const QString &step, int to);
/// Renames the folder, and the id where it was the folder's name.
[[nodiscard]] Result<LabFiles> withStepRenamed(const LabFiles &files, const QString &step,
                                               const QString &name);
/// A copy in folder \p name, which is its id, right after \p step.
[[nodiscard]] Result<LabFiles> withStepDuplicated(const LabFiles &files, const QString &step,
                                                  const QString &name);
/// A name for a folder that the lab has not yet: \p wish, or with a number.
[[nodiscard]] QString freeStepName(const LabFiles &files, const QString &wish);

/// The scene that a step starts with (the file that its task.json names) or that passes it.
enum class StepPreset { Start, Solution };
[[nodiscard]] QString solutionPresetPath(const QString &step);
[[nodiscard]] Result<QString> presetPath(const LabFiles &files, const QString &step,
                                         StepPreset which);
[[nodiscard]] Result<Preset> presetOf(const LabFiles &files, const QString &step,
                                      StepPreset which = StepPreset::Start);
[[nodiscard]] Result<LabFiles> withPreset(const LabFiles &files, const QString &step,
                                          const Preset &preset,
                                          StepPreset which = StepPreset::Start);

/// The text of a file, with "\n" at the ends of lines; empty if there is none.
[[nodiscard]] QString textOf(const LabFiles &files, const QString &path);
/// Sets the text of a file in UTF-8; a text that is textOf() already changes no byte.
[[nodiscard]] LabFiles withText(const LabFiles &files, const QString &path, const QString &text);
/// Sets a file as it is: a picture.
[[nodiscard]] LabFiles withFile(const LabFiles &files, const QString &path,
                                const QByteArray &content);
[[nodiscard]] LabFiles withoutFile(const LabFiles &files, const QString &path);
/// "STEP/instructions.md", or in another language "STEP/instructions.de.md".
[[nodiscard]] QString instructionsPath(const LabFiles &files, const QString &step,
                                       const QString &language = {});

/// Programs with a word of the lab for who wrote the same.
enum class KnownKind { Mistake, Remark };
/// Their names, in order of the alphabet (mistakes) or of task.json (remarks).
[[nodiscard]] QStringList knownNames(const LabFiles &files, const QString &step, KnownKind kind);
/// "STEP/mistakes/NAME.lua", whether it is kept whole in that file or as its difference from the
/// solution in NAME.diff beside it.
[[nodiscard]] QString knownPath(const QString &step, KnownKind kind, const QString &name);
/// Whether the program \p path is kept as its difference from the step's solution.
[[nodiscard]] bool isDiff(const LabFiles &files, const QString &path);
/// The whole of any program, "STEP/solution.lua" or "STEP/mistakes/NAME.lua", however it is kept;
/// empty if there is none. \return an Error with file and line of a difference that does not apply
/// to the solution as it is now
[[nodiscard]] Result<QString> programText(const LabFiles &files, const QString &path);
/// Sets the whole of a program; one that is kept as a difference stays so.
[[nodiscard]] LabFiles withProgramText(const LabFiles &files, const QString &path,
                                       const QString &text);
/// Keeps as differences all mistakes and remarks that are shorter so.
[[nodiscard]] LabFiles withDifferences(const LabFiles &files);
/// A program is kept as its difference from the solution if that is much shorter.
[[nodiscard]] Result<LabFiles> withKnownAdded(const LabFiles &files, const QString &step,
                                              KnownKind kind, const QString &name,
                                              const QString &source);
[[nodiscard]] Result<LabFiles> withKnownRemoved(const LabFiles &files, const QString &step,
                                                KnownKind kind, const QString &name);
/// With its texts in other languages.
[[nodiscard]] Result<LabFiles> withKnownRenamed(const LabFiles &files, const QString &step,
                                                KnownKind kind, const QString &name,
                                                const QString &newName);
/// What a student reads of it in another language (in the lab's own it is the program's first
/// comment block); empty if there is no translation.
[[nodiscard]] QString knownText(const LabFiles &files, const QString &step, KnownKind kind,
                                const QString &name, const QString &language);
[[nodiscard]] Result<LabFiles> withKnownText(const LabFiles &files, const QString &step,
                                             KnownKind kind, const QString &name,
                                             const QString &language, const QString &text);

} // namespace cradle

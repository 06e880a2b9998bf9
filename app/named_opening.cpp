// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/named_opening.h"

#include "app/author_window.h"
#include "app/language.h"
#include "app/main_window.h"
#include "tasks/hand_in/hand_in.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_list.h"
#include "tasks/reading/lab_reader.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace cradle {

namespace {

/// What is wrong with the name of a step; asked before anything of the student's is touched.
std::optional<Error> missingStep(const QString &folder, const QString &step)
{
    if (step.isEmpty())
        return std::nullopt;
    const Result<Lab> lab = readLab(folder);
    if (!lab)
        return lab.error();
    if (lab->indexOf(step) >= 0)
        return std::nullopt;
    QStringList ids;
    for (const Task &task : lab->tasks)
        ids.append(task.id);
    return Error{.message = QCoreApplication::translate("Main", "there is no step %1; there are %2")
                                .arg(step, ids.join(QStringLiteral(", ")))};
}

/// The folder of an archive, which is unpacked into \p labs; any other path as it is.
Result<QString> unpacked(const QString &path, const QString &labs)
{
    return isLabArchive(path) ? importLab(path, labs) : Result<QString>(path);
}

/// A student's own workspace; or one that was handed in, to be looked at.
std::optional<Error> openWork(Workbench &bench, const QString &path, const QString &step,
                              const QString &labs)
{
    const bool handedIn = isWorkArchive(path);
    // Clean: a new profile has no folder of labs from which ".." could lead anywhere.
    const Result<QString> folder =
        handedIn ? openHandIn(path, QDir::cleanPath(labs + QStringLiteral("/../handed-in")))
                 : Result<QString>(path);
    if (!folder)
        return folder.error();
    if (auto error = bench.openWork(*folder, handedIn, currentLanguage()))
        return error;
    if (step.isEmpty() || bench.openTask(step))
        return std::nullopt;
    return Error{
        .message =
            QCoreApplication::translate("Main", "there is no step %1 in this lab").arg(step)};
}

} // namespace

std::optional<Error> openNamed(Workbench &bench, const QString &named, const QString &step,
                               const QString &labs)
{
    if (isWorkArchive(named) || isWorkspace(named))
        return openWork(bench, named, step, labs);
    const Result<QString> place = unpacked(named, labs);
    if (!place)
        return place.error();
    const QString &path = *place;
    const bool isLab = path.isEmpty() || QFileInfo(path).isDir();
    const QString folder = isLab && !path.isEmpty() ? path : shippedLabWith(step);
    if (auto error = missingStep(folder, step))
        return error;
    if (auto error = bench.openLab(folder, currentLanguage()))
        return error;
    if (!isLab && step.isEmpty())
        return bench.openPreset(path);
    if (step.isEmpty())
        return std::nullopt;
    bench.openTask(step);
    return isLab ? std::nullopt : bench.takePreset(path);
}

std::optional<Error> openExampleNamed(Workbench &bench, const QString &name)
{
    if (const auto example = exampleFromId(name))
        return bench.openExample(*example);
    QStringList ids;
    for (const Example each : allExamples)
        ids.append(idOf(each));
    return Error{.message =
                     QCoreApplication::translate("Main", "there is no example %1; there are %2")
                         .arg(name, ids.join(QStringLiteral(", ")))};
}

std::optional<Error> openAuthor(MainWindow &window, const QString &lab, const QString &step,
                                const QString &tab, const QString &labs)
{
    static const QStringList tabs{QStringLiteral("scene"), QStringLiteral("text"),
                                  QStringLiteral("checks"), QStringLiteral("programs"),
                                  QStringLiteral("proof")};
    if (!tabs.contains(tab))
        return Error{.message = QCoreApplication::translate(
                                    "Main", "--tab %1: scene, text, checks, programs or proof is "
                                            "right")
                                    .arg(tab)};
    const Result<QString> folder = unpacked(lab, labs);
    if (!folder)
        return folder.error();
    if (auto error = window.authors().open(*folder))
        return error;
    AuthorDocument &document = window.authors().newest()->document();
    if (!step.isEmpty() && !document.steps().contains(step))
        return Error{.message =
                         QCoreApplication::translate("Main", "there is no step %1; there are %2")
                             .arg(step, document.steps().join(QStringLiteral(", ")))};
    if (!step.isEmpty())
        document.setStep(step);
    window.authors().newest()->panes().showTab(static_cast<int>(tabs.indexOf(tab)));
    return std::nullopt;
}

} // namespace cradle

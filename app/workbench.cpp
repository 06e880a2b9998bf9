// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench.h"

#include "model/files/json_schema.h"
#include "model/files/preset_json.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_list.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/script/script_limits.h"

#include <QFileInfo>

#include <algorithm>

namespace cradle {

namespace {

/// The folder of the lab with that id, among those that ship and the user's; empty if none has it.
QString labNamed(const QString &id)
{
    std::vector<ListedLab> labs = shippedLabs(QStringLiteral("en"));
    for (ListedLab &own : labsIn(userLabsFolder(), QStringLiteral("en")))
        labs.push_back(std::move(own));
    for (const ListedLab &listed : labs) {
        if (const auto lab = readLab(listed.folder); lab && lab->id == id)
            return listed.folder;
    }
    return {};
}

} // namespace

Workbench::Workbench(const QString &progressFile, QObject *parent)
    : QObject(parent)
    , m_progressFile(progressFile)
    , m_programs(progressFile.isEmpty()
                     ? QString()
                     : QFileInfo(progressFile).path() + QStringLiteral("/programs"))
    , m_simulation(Preset{})
    , m_document(m_simulation)
    , m_code(m_simulation)
    , m_progress(m_place, m_code, progressFile)
    , m_moment(m_place, m_document, m_code)
    , m_check(m_place, m_document, m_code, m_progress, m_moment)
    , m_waysBack(m_place, m_document, m_code, m_progress)
{
    connect(&m_document, &PresetDocument::edited, &m_progress, [this] {
        m_progress.noteScene(m_document.isOriginal() ? std::nullopt
                                                     : std::optional(m_document.preset()));
    });
    connect(&m_simulation, &Simulation::frameReady, &m_progress, [this] {
        if (!m_simulation.atStart())
            m_progress.noteWatched();
    });
    connect(&m_code, &CodeSession::failed, this, &Workbench::failed);
    connect(&m_progress, &KeptProgress::failed, this, &Workbench::failed);
    connect(&m_check, &WorkCheck::failed, this, &Workbench::failed);
}

Workbench::~Workbench()
{
    m_progress.saveDue();
}

std::optional<Error> Workbench::openLab(const QString &folder, const QString &language)
{
    return openLabWith(folder, language, {}, false);
}

std::optional<Error> Workbench::openWork(const QString &folder, bool readOnly,
                                         const QString &language)
{
    const auto info = readWorkspaceInfo(folder);
    if (!info)
        return info.error();
    const QString lab = labNamed(info->labId);
    if (lab.isEmpty())
        return Error{.message = tr("this is work in the lab %1, which is not here; open that lab "
                                   "once, and then the work")
                                    .arg(info->labId),
                     .file = folder};
    return openLabWith(lab, language, folder, readOnly);
}

/// \param work  folder of the workspace; empty: that of the lab among the student's own
std::optional<Error> Workbench::openLabWith(const QString &folder, const QString &language,
                                            const QString &work, bool readOnly)
{
    Result<Lab> lab = readLab(folder, language);
    if (!lab)
        return lab.error();
    m_progress.saveDue();
    m_code.close();
    // The progress of work that lies elsewhere lies with it; who only looks has none.
    const std::optional<Error> brokenProgress =
        m_progress.open(work.isEmpty() ? m_progressFile
                        : readOnly     ? QString()
                                       : work + QStringLiteral("/.git/cradle-progress.json"));
    m_place = {.lab = std::move(*lab)};
    const bool isNew = m_progress.isEmpty();
    m_firstStart = isNew && work.isEmpty();
    openWorkspace(work.isEmpty() && !m_programs.isEmpty()
                      ? m_programs + QLatin1Char('/') + m_place.lab.id
                      : work,
                  readOnly);
    if (!work.isEmpty() && isNew)
        m_progress.takeFromWork();
    m_place.lab = forStudent(m_place.lab, m_code.workspace().info().studentId);
    emit labChanged();
    if (!m_place.lab.tasks.empty())
        openTaskAt(std::max(0, m_place.lab.indexOf(m_progress.lastStep())));
    if (brokenProgress)
        emit failed(*brokenProgress);
    if (m_code.workspace().holder())
        emit heldElsewhere();
    if (wantsNumber())
        emit numberWanted();
    return std::nullopt;
}

void Workbench::openWorkspace(const QString &folder, bool readOnly)
{
    m_code.setWorkspace(Workspace()); // gives the lock back: this may be the same lab again
    if (folder.isEmpty())
        return;
    Workspace workspace(folder);
    std::optional<Error> error;
    if (readOnly)
        workspace.beginReading();
    else
        error = workspace.begin(m_place.lab, m_progress.lastStep());
    m_code.setWorkspace(std::move(workspace));
    if (error)
        emit failed(*error);
}

void Workbench::takeOver()
{
    if (!task())
        return;
    if (const auto error = m_progress.readAgain())
        emit failed(*error);
    m_code.takeOver(m_place.lab, m_place.current);
    emit taskChanged();
}

bool Workbench::wantsNumber() const
{
    return m_place.lab.drawsValues && m_code.workspace().info().studentId.isEmpty()
           && m_code.workspace().mayWrite() && !m_code.workspace().isLookedAt();
}

std::optional<Error> Workbench::setStudentNumber(const QString &number)
{
    auto error = m_code.workspace().setStudent(m_code.workspace().info().student, number);
    const QString step = task() ? task()->id : QString();
    m_place.lab = forStudent(m_place.lab, m_code.workspace().info().studentId);
    m_place.current = -1; // its scene is another now
    emit labChanged();
    openTaskAt(std::max(0, m_place.lab.indexOf(step)));
    return error;
}

void Workbench::setLanguage(const QString &language)
{
    Result<Lab> lab = readLab(m_place.lab.folder, language);
    if (!lab || lab->tasks.size() != m_place.lab.tasks.size())
        return;
    m_place.lab = forStudent(*lab, m_code.workspace().info().studentId);
    emit labChanged();
    emit taskChanged();
    // The messages of a report are in the language of its time.
    if (m_check.report())
        m_check.start();
}

std::optional<Error> Workbench::openPreset(const QString &path)
{
    const Result<Preset> preset = readPreset(path);
    if (!preset)
        return preset.error();
    openScene(*preset, std::nullopt);
    return std::nullopt;
}

std::optional<Error> Workbench::openExample(Example example)
{
    const Result<Preset> preset = readPreset(fileOf(example));
    if (!preset)
        return preset.error();
    openScene(*preset, example);
    return std::nullopt;
}

void Workbench::openScene(const Preset &preset, std::optional<Example> example)
{
    m_check.leave();
    m_simulation.pause();
    m_place.current = -1;
    m_example = example;
    m_code.close();
    m_moment.forgetGhost();
    m_document.setLocked({});
    m_document.open(preset);
    emit taskChanged();
}

bool Workbench::openTask(const QString &id)
{
    const int index = m_place.lab.indexOf(id);
    if (index >= 0)
        openTaskAt(index);
    return index >= 0;
}

std::optional<Error> Workbench::takePreset(const QString &path)
{
    const Result<Preset> preset = readPreset(path);
    if (!preset)
        return preset.error();
    m_document.edit(tr("Open a scene"), *preset);
    return std::nullopt;
}

std::optional<Error> Workbench::takeScript(const QString &path)
{
    const Result<QByteArray> text = readFile(path, limits::sourceBytes);
    if (!text)
        return text.error();
    m_code.replace(QString::fromUtf8(*text));
    return std::nullopt;
}

void Workbench::setMode(Mode mode)
{
    m_wantedMode = mode;
    if (mode == this->mode())
        return;
    m_check.leave();
    m_document.leave();
    m_code.run().setActive(mode == Mode::Code);
    m_moment.forgetGhost();
    emit modeChanged();
}

void Workbench::openTaskAt(int index)
{
    if (index < 0 || index >= static_cast<int>(m_place.lab.tasks.size()))
        return;
    m_check.leave();
    m_simulation.pause();
    m_place.current = index;
    m_example.reset();
    m_progress.noteOpened();
    m_moment.forgetGhost();
    m_simulation.setProgramLaws(task()->laws);
    // The old program does not meet the new scene, nor the new one the old scene.
    m_code.open(m_place.lab, index, m_wantedMode == Mode::Code, [this](Program *program) {
        m_document.setLocked({}); // those of the step before
        m_document.open(task()->preset, m_progress.scene(), program);
        m_document.setLocked(task()->locked);
    });
    emit taskChanged();
}

void Workbench::openNextTask()
{
    openTaskAt(m_place.current + 1);
}

void Workbench::openPreviousTask()
{
    openTaskAt(m_place.current - 1);
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench.h"

#include "model/files/json_schema.h"
#include "model/files/preset_json.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_list.h"
#include "tasks/reading/lab_reader.h"

#include <QFileInfo>

#include <algorithm>
#include <chrono>

namespace cradle {

namespace {

using namespace std::chrono_literals;

/// After the last edit; a drag makes many.
constexpr auto saveDelay = 300ms;

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
    , m_store(progressFile)
    , m_simulation(Preset{})
    , m_document(m_simulation)
    , m_code(m_simulation)
    , m_progressFile(progressFile)
    , m_programs(progressFile.isEmpty()
                     ? QString()
                     : QFileInfo(progressFile).path() + QStringLiteral("/programs"))
{
    m_saveSoon.setSingleShot(true);
    m_saveSoon.setInterval(saveDelay);
    connect(&m_saveSoon, &QTimer::timeout, this, &Workbench::save);
    connect(&m_document, &PresetDocument::edited, this, &Workbench::keepEdited);
    connect(&m_document, &PresetDocument::visitingChanged, this, [this](bool visiting) {
        if (!visiting) {
            m_code.setPinned(false);
            setGhost(nullptr);
        }
    });
    connect(&m_simulation, &Simulation::frameReady, this, &Workbench::noteWatched);
    connect(&m_code, &CodeSession::edited, this, [this] {
        forgetRun();
        markStale();
    });
    connect(&m_code, &CodeSession::opened, this, &Workbench::forgetRun);
    connect(&m_code, &CodeSession::textReplaced, this, &Workbench::forgetRun);
    connect(&m_code, &CodeSession::failed, this, &Workbench::failed);
    connect(&m_checker, &Checker::progressed, this, &Workbench::checkProgressed);
    connect(&m_checker, &Checker::finished, this, &Workbench::finishCheck);
    connect(&m_checker, &Checker::cancelled, this, &Workbench::checkCancelled);
    connect(&m_reference, &ReferenceRun::finished, this, &Workbench::setGhost);
}

Workbench::~Workbench()
{
    if (m_saveSoon.isActive())
        save();
}

const Task *Workbench::task() const
{
    return m_current >= 0 ? &m_lab.tasks[static_cast<std::size_t>(m_current)] : nullptr;
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
    if (m_saveSoon.isActive())
        save();
    m_code.close();
    // The progress of work that lies elsewhere lies with it; who only looks has none.
    m_store = ProgressStore(work.isEmpty() ? m_progressFile
                            : readOnly     ? QString()
                                           : work + QStringLiteral("/.git/cradle-progress.json"));
    const std::optional<Error> brokenProgress = m_store.load();
    m_lab = std::move(*lab);
    m_current = -1;
    LabProgress &progressOfLab = m_store.lab(m_lab.id);
    m_firstStart = progressOfLab.tasks.empty() && work.isEmpty();
    const bool isNew = progressOfLab.tasks.empty();
    openWorkspace(work.isEmpty() && !m_programs.isEmpty() ? m_programs + QLatin1Char('/') + m_lab.id
                                                          : work,
                  readOnly);
    if (!work.isEmpty() && isNew)
        takeKeptProgress();
    m_lab = forStudent(m_lab, m_code.workspace().info().studentId);
    emit labChanged();
    if (!m_lab.tasks.empty())
        openTaskAt(std::max(0, m_lab.indexOf(progressOfLab.currentTask)));
    if (brokenProgress)
        emit failed(*brokenProgress);
    if (m_code.workspace().holder())
        emit heldElsewhere();
    if (wantsNumber())
        emit numberWanted();
    return std::nullopt;
}

bool Workbench::wantsNumber() const
{
    return m_lab.drawsValues && m_code.workspace().info().studentId.isEmpty() && mayWrite()
           && !m_code.workspace().isLookedAt();
}

std::optional<Error> Workbench::setStudentNumber(const QString &number)
{
    auto error = m_code.workspace().setStudent(m_code.workspace().info().student, number);
    const QString step = task() ? task()->id : QString();
    m_lab = forStudent(m_lab, m_code.workspace().info().studentId);
    m_current = -1; // its scene is another now
    emit labChanged();
    openTaskAt(std::max(0, m_lab.indexOf(step)));
    return error;
}

void Workbench::setLanguage(const QString &language)
{
    Result<Lab> lab = readLab(m_lab.folder, language);
    if (!lab || lab->tasks.size() != m_lab.tasks.size())
        return;
    m_lab = forStudent(*lab, m_code.workspace().info().studentId);
    emit labChanged();
    emit taskChanged();
    // The messages of a report are in the language of its time.
    if (m_report)
        check();
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
    cancelCheck();
    m_simulation.pause();
    m_current = -1;
    m_example = example;
    dropReport();
    m_code.close();
    setGhost(nullptr);
    m_document.setLocked({});
    m_document.open(preset);
    emit taskChanged();
}

bool Workbench::openTask(const QString &id)
{
    const int index = m_lab.indexOf(id);
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

void Workbench::setMode(Mode mode)
{
    m_wantedMode = mode;
    if (mode == this->mode())
        return;
    cancelCheck();
    m_document.leave();
    m_code.setActive(mode == Mode::Code);
    dropReport();
    setGhost(nullptr);
    emit modeChanged();
}

void Workbench::openTaskAt(int index)
{
    if (index < 0 || index >= static_cast<int>(m_lab.tasks.size()))
        return;
    cancelCheck();
    m_simulation.pause();
    m_current = index;
    m_example.reset();
    dropReport();
    m_store.lab(m_lab.id).currentTask = task()->id;
    setGhost(nullptr);
    m_simulation.setProgramLaws(task()->laws);
    // The old program does not meet the new scene, nor the new one the old scene.
    m_code.open(m_lab, index, m_wantedMode == Mode::Code, [this](Program *program) {
        m_document.setLocked({}); // those of the step before
        m_document.open(task()->preset, progress().edited, program);
        m_document.setLocked(task()->locked);
    });
    m_saveSoon.start();
    emit taskChanged();
}

void Workbench::openNextTask()
{
    openTaskAt(m_current + 1);
}

void Workbench::openPreviousTask()
{
    openTaskAt(m_current - 1);
}

void Workbench::keepEdited()
{
    forgetRun();
    markStale();
    if (!task())
        return;
    const bool original = m_document.isOriginal();
    progress().edited = original ? std::nullopt : std::optional(m_document.preset());
    m_saveSoon.start();
}

bool Workbench::isLast() const
{
    const auto last = std::find_if(m_lab.tasks.rbegin(), m_lab.tasks.rend(),
                                   [](const Task &each) { return !each.extra; });
    return last != m_lab.tasks.rend() && task() == &*last;
}

} // namespace cradle

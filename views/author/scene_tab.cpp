// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/scene_tab.h"

#include "tasks/script/student_script.h"
#include "views/author/form_rows.h"
#include "views/author/scene_text.h"
#include "views/boxes.h"
#include "views/choice_box.h"
#include "views/error_line.h"
#include "views/flow_layout.h"
#include "views/inspector/inspector.h"
#include "views/menu.h"
#include "views/on_change.h"
#include "views/scene/scene_view.h"
#include "views/theme.h"
#include "views/timeline.h"
#include "views/transport_bar.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>

namespace cradle {

SceneTab::SceneTab(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_simulation(Preset())
    , m_preset(m_simulation)
{
    makeLayout();
    keepTranslated(this, &SceneTab::retranslate);
    connect(&document, &AuthorDocument::changed, this, &SceneTab::reload);
    connect(&document, &AuthorDocument::stepChanged, this, &SceneTab::reload);
    connect(&m_preset, &PresetDocument::edited, this, &SceneTab::takePreset);
    connect(&m_preset, &PresetDocument::visitingChanged, this, [this](bool visiting) {
        m_leave->setVisible(visiting);
        enableControls();
        emit visitingChanged(visiting);
    });
    connect(&m_simulation, &Simulation::frameReady, this, &SceneTab::enableControls);
    connect(&m_simulation, &Simulation::programFailed, this, &SceneTab::showError);
    connect(&m_simulation, &Simulation::restarted, this, &SceneTab::showError);
    connect(m_error, &ErrorLine::clicked, this, [this] {
        if (const auto &error = m_simulation.programError())
            emit programRequested(m_programFile, error->line);
    });
    connect(m_scene, &SceneView::selectionChanged, m_inspector, &Inspector::select);
    connect(m_inspector, &Inspector::selectionChanged, m_scene, &SceneView::select);
    connect(m_fromMoment, &QPushButton::clicked, this, &SceneTab::setFromMoment);
    connect(m_leave, &QPushButton::clicked, this, [this] {
        m_preset.leave();
        chooseMover();
    });
    connect(m_mover, &QComboBox::activated, this, &SceneTab::chooseMover);
    connect(m_which, &QComboBox::currentIndexChanged, this, &SceneTab::reload);
    connect(m_asText, &QPushButton::toggled, this, [this](bool shown) {
        enableControls();
        if (shown)
            m_text->setFocus();
    });
    connect(m_make, &QPushButton::clicked, this, &SceneTab::makeSolution);
    connect(m_remove, &QPushButton::clicked, this, &SceneTab::removeSolution);
    reload();
}

SceneTab::~SceneTab()
{
    m_simulation.setProgram(nullptr); // it is borrowed from here
}

void SceneTab::makeLayout()
{
    m_transport = new TransportBar(m_simulation, this);
    m_transport->setCheckShown(false);
    m_templateButton = new QPushButton(this);
    m_lockButton = new QPushButton(this);
    m_fromMoment = new QPushButton(this);
    m_asText = new QPushButton(this);
    m_leave = new QPushButton(this);
    m_remove = new QPushButton(this);
    m_which = new ChoiceBox(this);
    m_mover = new ChoiceBox(this);
    m_templates = new Menu(m_templateButton);
    m_locks = new Menu(m_lockButton);
    m_templateButton->setMenu(m_templates);
    m_lockButton->setMenu(m_locks);
    auto *choices = new FlowLayout; // with large texts they are more than a row
    choices->setSpacing(8);
    choices->addWidget(m_which);
    for (QPushButton *button :
         {m_templateButton, m_fromMoment, m_lockButton, m_asText, m_remove, m_leave}) {
        setKind(button, button->menu() ? "menu" : "small");
        choices->addWidget(button);
    }
    m_asText->setCheckable(true);
    m_asText->setObjectName(QStringLiteral("asText"));
    setKind(m_leave, "primary");
    m_leave->hide();
    auto *top = makeRow({12, 8, 12, 0}, 8, {{choices, 1}, {m_mover, 0, Qt::AlignTop}});
    m_mover->setObjectName(QStringLiteral("mover"));
    m_which->setObjectName(QStringLiteral("whichScene"));

    m_scene = new SceneView(m_preset, this);
    m_inspector = new Inspector(m_preset, this);
    m_inspector->hideReset();
    m_error = new ErrorLine(this);
    m_error->hide();
    m_timeline = new Timeline(m_simulation, this);
    m_text = new SceneText(m_document, this);
    m_text->hide();
    m_splitter = makeSplitter(Qt::Horizontal, {m_scene, m_inspector, m_text}, {560, 440, 440});
    m_splitter->setStretchFactor(0, 1);

    m_missing = new QWidget(this);
    m_missingText = makeMutedText(m_missing);
    m_make = new QPushButton(m_missing);
    layOutColumn(m_missing, {12, 12, 12, 12}, 8,
                 {m_missingText, {m_make, 0, Qt::AlignLeft}, BoxPart::rest()});

    layOutColumn(this, {}, 0,
                 {top, {m_missing, 1}, m_transport, {m_splitter, 1}, m_error, m_timeline});
}

/// An edit made here comes back as it was; anything else begins the scene anew.
void SceneTab::reload()
{
    const QString shown = m_document.step() + QString::number(m_which->currentIndex());
    const Result<Preset> preset = presetOf(m_document.files(), m_document.step(), which());
    setEnabled(preset.ok() || isMissing());
    if (preset && (shown != m_shown || *preset != m_preset.own())) {
        ++m_openings;
        m_shown = shown;
        m_preset.open(*preset);
        chooseMover();
    } else {
        followMover();
    }
    m_preset.setReadOnly(m_document.whyReadOnly());
    m_text->showScene(which());
    showLocks();
    enableControls();
}

QStringList SceneTab::refusedScenes() const
{
    return m_text->refused();
}

StepPreset SceneTab::which() const
{
    return m_which->currentIndex() == 1 ? StepPreset::Solution : StepPreset::Start;
}

/// Whether the step could have the scene that is asked for, and has none.
bool SceneTab::isMissing() const
{
    const QString &step = m_document.step();
    return which() == StepPreset::Solution && !step.isEmpty()
           && !m_document.files().contents.contains(solutionPresetPath(step));
}

void SceneTab::openStart()
{
    m_which->setCurrentIndex(0);
}

void SceneTab::openSolution()
{
    m_which->setCurrentIndex(1);
}

void SceneTab::makeSolution()
{
    const LabFiles &files = m_document.files();
    if (const Result<Preset> start = presetOf(files, m_document.step()))
        m_document.edit(tr("Add the scene that passes"),
                        withPreset(files, m_document.step(), *start, StepPreset::Solution));
}

void SceneTab::removeSolution()
{
    m_document.edit(tr("Remove the scene that passes"),
                    withoutFile(m_document.files(), solutionPresetPath(m_document.step())));
}

void SceneTab::takePreset()
{
    const QString key =
        QStringLiteral("scene:%1:%2").arg(m_openings).arg(m_preset.undoStack().count());
    if (!m_document.edit(
            m_preset.undoStack().undoText(),
            withPreset(m_document.files(), m_document.step(), m_preset.preset(), which()), key))
        QMetaObject::invokeMethod(this, &SceneTab::reload, Qt::QueuedConnection);
}

void SceneTab::setFromMoment()
{
    m_preset.startFromMoment();
}

void SceneTab::enableControls()
{
    const bool visiting = m_preset.isVisiting();
    const bool missing = isMissing() && !visiting;
    const bool solution = which() == StepPreset::Solution;
    for (QWidget *part : {static_cast<QWidget *>(m_transport), static_cast<QWidget *>(m_splitter),
                          static_cast<QWidget *>(m_timeline)})
        part->setVisible(!missing);
    m_missing->setVisible(missing);
    m_make->setEnabled(!m_document.isReadOnly());
    m_which->setEnabled(!visiting);
    const bool own = !visiting && !missing && !m_document.isReadOnly();
    m_templateButton->setEnabled(own);
    m_lockButton->setEnabled(own);
    m_fromMoment->setEnabled(own && !m_simulation.atStart());
    const bool asText = m_asText->isChecked() && !visiting;
    m_asText->setVisible(!visiting && !missing);
    m_inspector->setVisible(!asText);
    m_text->setVisible(asText);
    m_lockButton->setVisible(!solution); // what is locked is of the step
    m_remove->setVisible(solution && !missing);
    m_remove->setEnabled(own);
    m_mover->setVisible(!visiting && !solution);
    if (missing)
        m_error->hide();
}

void SceneTab::retranslate()
{
    m_templateButton->setText(tr("Templates"));
    m_templateButton->setToolTip(tr("Scenes to begin with; the one that is here is replaced"));
    m_scene->setEmptyHint(tr("Add a circle: + Add circle"));
    m_fromMoment->setText(tr("Start from this moment"));
    m_fromMoment->setToolTip(
        tr("The circles start where, and as fast as, they are at the moment shown"));
    m_lockButton->setToolTip(tr("What the student may not change in this step"));
    m_asText->setText(tr("As text"));
    m_asText->setToolTip(tr("The file of this scene, in which numbers may be expressions"));
    m_leave->setText(tr("Back to the step's scene"));
    m_remove->setText(tr("Remove this scene"));
    m_missingText->setText(tr("Students may also pass without a program, by setting the scene and "
                              "its laws. This step has no scene yet that passes its checks so; "
                              "with one, the proof looks after it, too."));
    m_make->setText(tr("Make it from what the student finds"));
    const QStringList scenes{tr("What the student finds"), tr("What passes without a program")};
    m_which->setTexts(scenes);
    m_which->setAccessibleName(tr("Which scene of the step"));
    const QStringList movers{tr("Moved by the scene's laws"), tr("Moved by solution.lua")};
    m_mover->setTexts(movers);
    m_mover->setAccessibleName(tr("What moves the circles here"));
    fillTemplates();
    showLocks();
    m_preset.setReadOnly(m_document.whyReadOnly());
    showError();
}

} // namespace cradle

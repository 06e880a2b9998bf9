// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/scene_tab.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/locks.h"
#include "tasks/script/student_script.h"
#include "views/author/scene_templates.h"
#include "views/inspector/inspector.h"
#include "views/scene/scene_view.h"
#include "views/theme.h"
#include "views/timeline.h"
#include "views/transport_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
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
    retranslate();
    connect(&document, &AuthorDocument::changed, this, &SceneTab::reload);
    connect(&document, &AuthorDocument::stepChanged, this, &SceneTab::reload);
    connect(&m_preset, &PresetDocument::edited, this, &SceneTab::takePreset);
    connect(&m_preset, &PresetDocument::visitingChanged, this, [this](bool visiting) {
        m_leave->setVisible(visiting);
        enableControls();
        emit visitingChanged(visiting);
    });
    connect(&m_simulation, &Simulation::frameReady, this, &SceneTab::enableControls);
    connect(m_scene, &SceneView::selectionChanged, m_inspector, &Inspector::select);
    connect(m_inspector, &Inspector::selectionChanged, m_scene, &SceneView::select);
    connect(m_fromMoment, &QPushButton::clicked, this, &SceneTab::setFromMoment);
    connect(m_leave, &QPushButton::clicked, this, [this] {
        m_preset.leave();
        chooseMover();
    });
    connect(m_mover, &QComboBox::activated, this, &SceneTab::chooseMover);
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
    m_leave = new QPushButton(this);
    m_mover = new QComboBox(this);
    m_templates = new QMenu(m_templateButton);
    m_locks = new QMenu(m_lockButton);
    m_templateButton->setMenu(m_templates);
    m_lockButton->setMenu(m_locks);
    auto *top = new QHBoxLayout;
    top->setSpacing(8);
    top->setContentsMargins(12, 8, 12, 0);
    for (QPushButton *button : {m_templateButton, m_fromMoment, m_lockButton, m_leave}) {
        setKind(button, "small");
        top->addWidget(button);
    }
    setKind(m_leave, "primary");
    m_leave->hide();
    top->addStretch(1);
    top->addWidget(m_mover);
    m_mover->setObjectName(QStringLiteral("mover"));

    m_scene = new SceneView(m_preset, this);
    m_inspector = new Inspector(m_preset, this);
    m_timeline = new Timeline(m_simulation, this);
    m_splitter = new QSplitter(Qt::Horizontal, this);
    m_splitter->addWidget(m_scene);
    m_splitter->addWidget(m_inspector);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setSizes({560, 440});

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(top);
    column->addWidget(m_transport);
    column->addWidget(m_splitter, 1);
    column->addWidget(m_timeline);
}

/// An edit made here comes back as it was; anything else begins the scene anew.
void SceneTab::reload()
{
    const QString &step = m_document.step();
    const Result<Preset> preset = presetOf(m_document.files(), step);
    setEnabled(preset.ok());
    if (preset && (step != m_shownStep || *preset != m_preset.own())) {
        ++m_openings;
        m_shownStep = step;
        m_preset.open(*preset);
        chooseMover();
    }
    showLocks();
    enableControls();
}

void SceneTab::takePreset()
{
    const QString key =
        QStringLiteral("scene:%1:%2").arg(m_openings).arg(m_preset.undoStack().count());
    if (!m_document.edit(m_preset.undoStack().undoText(),
                         withPreset(m_document.files(), m_document.step(), m_preset.preset()), key))
        QMetaObject::invokeMethod(this, &SceneTab::reload, Qt::QueuedConnection);
}

void SceneTab::setFromMoment()
{
    m_preset.startFromMoment();
}

void SceneTab::visit(const Preset &scene, const QString &program, qint64 step)
{
    m_preset.visit(scene);
    auto script = program.isEmpty() ? nullptr : std::make_unique<StudentScript>(program);
    m_simulation.setProgram(script.get());
    m_program = std::move(script);
    m_simulation.goTo(step);
}

void SceneTab::chooseMover()
{
    const QString path = m_document.step() + QStringLiteral("/solution.lua");
    const QString program =
        m_mover->currentIndex() == 1 ? textOf(m_document.files(), path) : QString();
    auto script = program.isEmpty() ? nullptr : std::make_unique<StudentScript>(program);
    m_simulation.setProgram(script.get());
    m_program = std::move(script);
}

void SceneTab::fillTemplates()
{
    m_templates->clear();
    for (const SceneTemplate scene : allTemplates) {
        QAction *action = m_templates->addAction(titleOf(scene));
        connect(action, &QAction::triggered, this, [this, scene] {
            m_preset.edit(tr("Take the template %1").arg(titleOf(scene)), presetOf(scene));
        });
    }
}

void SceneTab::fillLocks()
{
    const Preset &preset = m_preset.own();
    const QStringList fields = lockableFields(preset);
    QStringList names;
    for (const QString &field : fields) {
        const QString name = lockedName(field, preset);
        names.append(name.left(1).toUpper() + name.mid(1));
    }
    if (names == m_lockNames)
        return;
    m_lockNames = names;
    m_locks->clear();
    for (qsizetype i = 0; i < fields.size(); ++i) {
        const QString &field = fields[i];
        QAction *action = m_locks->addAction(names[i]);
        action->setCheckable(true);
        action->setData(field);
        connect(action, &QAction::triggered, this,
                [this, field](bool on) { setLocked(field, on); });
    }
}

void SceneTab::showLocks()
{
    fillLocks();
    const Result<TaskForm> form = taskForm(m_document.files(), m_document.step());
    const QStringList locked = form ? form->locked : QStringList();
    for (QAction *action : m_locks->actions())
        action->setChecked(locked.contains(action->data().toString()));
    m_lockButton->setText(locked.isEmpty() ? tr("Lock…") : tr("Locked: %1").arg(locked.size()));
}

void SceneTab::setLocked(const QString &field, bool locked)
{
    Result<TaskForm> form = taskForm(m_document.files(), m_document.step());
    if (!form)
        return;
    form->locked.removeAll(field);
    if (locked)
        form->locked.append(field);
    if (!m_document.edit(locked ? tr("Lock a field") : tr("Unlock a field"),
                         withTask(m_document.files(), m_document.step(), *form)))
        showLocks();
}

void SceneTab::enableControls()
{
    const bool own = !m_preset.isVisiting() && !m_document.isReadOnly();
    m_templateButton->setEnabled(own);
    m_lockButton->setEnabled(own);
    m_fromMoment->setEnabled(own && !m_simulation.atStart());
    m_mover->setVisible(!m_preset.isVisiting());
}

void SceneTab::retranslate()
{
    m_templateButton->setText(tr("Templates"));
    m_templateButton->setToolTip(tr("Scenes to begin with; the one that is here is replaced"));
    m_fromMoment->setText(tr("Start from this moment"));
    m_fromMoment->setToolTip(
        tr("The circles start where, and as fast as, they are at the moment shown"));
    m_lockButton->setToolTip(tr("What the student may not change in this step"));
    m_leave->setText(tr("Back to the step's scene"));
    const QStringList movers{tr("Moved by the scene's laws"), tr("Moved by solution.lua")};
    for (int i = 0; i < movers.size(); ++i) {
        if (i >= m_mover->count())
            m_mover->addItem(movers[i]);
        m_mover->setItemText(i, movers[i]);
    }
    m_mover->setAccessibleName(tr("What moves the circles here"));
    fillTemplates();
    showLocks();
}

void SceneTab::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace cradle

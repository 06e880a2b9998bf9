// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/lab_edits.h"
#include "views/author/arrangement.h"
#include "views/author/author_document.h"
#include "views/author/scene_visit.h"
#include "views/preset_document.h"

#include <QWidget>

#include <memory>

QT_BEGIN_NAMESPACE
class QLabel;
class QPushButton;
class QSplitter;
QT_END_NAMESPACE

namespace cradle {

class ChoiceBox;
class ErrorLine;
class Inspector;
class Menu;
class SceneText;
class SceneView;
class StudentScript;
class Timeline;
class TransportBar;

/// The scene that a step starts with, or the one that passes without a program, edited where it is
/// seen: by its handles and by numbers. It can run, by its laws or by the reference program;
/// templates, the moment shown, and what the student may not change are in menus.
class SceneTab final : public QWidget
{
    Q_OBJECT
public:
    explicit SceneTab(AuthorDocument &document, QWidget *parent = nullptr);
    ~SceneTab() override;

    [[nodiscard]] SceneView &scene() { return *m_scene; }
    [[nodiscard]] Simulation &simulation() { return m_simulation; }
    [[nodiscard]] PresetDocument &preset() { return m_preset; }
    [[nodiscard]] Menu &templates() { return *m_templates; }
    [[nodiscard]] Menu &locks() { return *m_locks; }

    void openStart();    ///< shows what the student finds
    void openSolution(); ///< shows what passes without a program
    /// Makes \p run up to its step, to be looked at; not the step's own scene.
    void visit(const SceneVisit &run);
    /// The files of which something is typed as text that cannot be read.
    [[nodiscard]] QStringList refusedScenes() const;

public slots:
    /// The circles start where, and as fast as, they are at the moment shown.
    void setFromMoment();

signals:
    void visitingChanged(bool visiting);
    /// The program that stopped, at the line where it did.
    void programRequested(const QString &file, int line);

private:
    void makeLayout();
    void retranslate();
    void reload();
    void takePreset();
    void fillTemplates();
    void take(const Preset &scene); ///< a template
    void arrange(Arrangement::Pattern pattern);
    void fillLocks();
    void showLocks();
    void setLocked(const QString &field, bool locked);
    void chooseMover();
    void followMover();
    void runProgram(const QString &source, bool pinned);
    void showError();
    void enableControls();
    void makeSolution();
    void removeSolution();
    [[nodiscard]] QString moverSource() const;
    [[nodiscard]] QStringList lockedFields() const;
    [[nodiscard]] StepPreset which() const;
    [[nodiscard]] bool isMissing() const;

    AuthorDocument &m_document;
    Simulation m_simulation;
    PresetDocument m_preset;
    std::unique_ptr<StudentScript> m_program; ///< that moves the circles, if one does
    QString m_programFile;                    ///< its name in the step
    QStringList m_locked;                     ///< what it must leave as it is
    TransportBar *m_transport = nullptr;
    QPushButton *m_templateButton = nullptr;
    QPushButton *m_lockButton = nullptr;
    QPushButton *m_fromMoment = nullptr;
    QPushButton *m_asText = nullptr; ///< checked: the text stands in place of the inspector
    QPushButton *m_leave = nullptr;  ///< a visit
    QPushButton *m_remove = nullptr; ///< the scene that passes
    ChoiceBox *m_which = nullptr;    ///< of the step's two scenes
    ChoiceBox *m_mover = nullptr;
    QWidget *m_missing = nullptr; ///< shown while there is no such scene
    QLabel *m_missingText = nullptr;
    QPushButton *m_make = nullptr;
    Menu *m_templates = nullptr;
    Menu *m_locks = nullptr;
    QSplitter *m_splitter = nullptr;
    SceneView *m_scene = nullptr;
    Inspector *m_inspector = nullptr;
    SceneText *m_text = nullptr;
    ErrorLine *m_error = nullptr; ///< why the program stopped
    Timeline *m_timeline = nullptr;
    QString m_shown;         ///< step and scene
    QStringList m_lockNames; ///< in the menu
    int m_openings = 0;      ///< of presets: edits of two never merge
};

} // namespace cradle

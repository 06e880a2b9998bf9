// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

#include <QStringList>
#include <QUndoStack>

namespace cradle {

/// The preset that the student edits: every edit is an undo command, checked before it is made,
/// and starts the simulation again from the changed preset.
class PresetDocument final : public QObject
{
    Q_OBJECT
public:
    explicit PresetDocument(Simulation &simulation, QObject *parent = nullptr);

    [[nodiscard]] const Preset &preset() const { return m_simulation.basePreset(); }
    [[nodiscard]] Simulation &simulation() const { return m_simulation; }
    [[nodiscard]] QUndoStack &undoStack() { return m_undoStack; }
    [[nodiscard]] bool isOriginal() const { return preset() == m_original; }
    /// The student's own preset: preset(), but for a visit.
    [[nodiscard]] const Preset &own() const { return m_own ? *m_own : preset(); }
    [[nodiscard]] bool isVisiting() const { return m_own.has_value(); }

    /// Takes \p preset as the one that the step came with, and \p edited (if any) as what the
    /// student has made of it; forgets the undo history.
    void open(const Preset &original, const std::optional<Preset> &edited = std::nullopt);
    /// The same together with what moves the circles (Simulation::setRun()): one start for both.
    void open(const Preset &original, const std::optional<Preset> &edited, Program *program);

    /// Fixes fields of the preset (tasks/script/locks.h): edits of them are refused with the
    /// reason. Only the way back to the original is open.
    void setLocked(const QStringList &fields);
    /// Keeps all of the preset as it is, for the reason \p why; with none it may be edited again.
    void setReadOnly(const QString &why);
    /// Why nothing of what is shown can be changed: it is read-only, or a visit; else empty.
    [[nodiscard]] QString whyReadOnly() const;
    /// Why \p field cannot be changed; empty if it can.
    [[nodiscard]] QString whyLocked(const QString &field) const;

    /// Why \p changed cannot be: it changes what is locked, or has a fault.
    [[nodiscard]] std::optional<Error> faultOf(const Preset &changed) const;

    /// Makes an edit named \p text; edits with the same non-empty \p mergeKey in a row (a drag, a
    /// spin) become one undo step.
    /// \return false (and refused() is emitted) if \p changed cannot be
    bool edit(const QString &text, const Preset &changed, const QString &mergeKey = {});

    /// Makes the moment that the simulation shows the start of the scene, as one undoable edit.
    /// \return false (and refused() is emitted) if that cannot be: circles overlap, say
    bool startFromMoment();

    /// Shows \p preset, a scene that is not the student's to edit; leave() goes back.
    void visit(const Preset &preset);

public slots:
    void leave();           ///< ends a visit
    void resetToOriginal(); ///< as one undoable edit

signals:
    void refused(const cradle::Error &error); ///< an edit would make an impossible scene
    void visitingChanged(bool visiting);
    void lockedChanged(); ///< what may be edited
    void edited();        ///< the preset changed by edit, undo or redo (not by open)

private:
    friend class PresetEdit;
    void forgetEdits();
    void apply(const Preset &preset);

    Simulation &m_simulation;
    QUndoStack m_undoStack;
    Preset m_original;
    std::optional<Preset> m_own; ///< during a visit
    QStringList m_locked;
    QString m_whyReadOnly;
};

} // namespace cradle

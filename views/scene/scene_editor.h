// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/preset_document.h"

namespace cradle {

/// Which circle is selected, and the edits that the scene offers for it. Every edit goes through
/// the document and can be undone; an impossible one is told by noticed() and not made.
class SceneEditor final : public QObject
{
    Q_OBJECT
public:
    explicit SceneEditor(PresetDocument &document, QObject *parent = nullptr);

    [[nodiscard]] int selected() const { return m_selected; } ///< -1: none
    [[nodiscard]] int circleCount() const;
    [[nodiscard]] const Preset &preset() const { return m_document.preset(); }
    [[nodiscard]] PresetDocument &document() const { return m_document; }

    /// Makes the edit if it has no fault; see PresetDocument::edit.
    bool commit(const QString &text, const Preset &changed, const QString &mergeKey = {});

public slots:
    void select(int index);          ///< an index that is no circle selects none
    void addCircle(cradle::Vec2 at); ///< at or near \p at, m; selects it
    void duplicateSelected();
    void removeSelected();
    void stopSelected();                 ///< sets its velocity to zero
    void nudgeSelected(cradle::Vec2 by); ///< m; only at the start of the run

signals:
    void selectionChanged(int index);
    void noticed(const QString &text); ///< why something was not done

private:
    void keepSelectionValid();
    void noticeOverruled(const Preset &before);

    PresetDocument &m_document;
    int m_selected = -1;
};

} // namespace cradle

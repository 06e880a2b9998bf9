// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/preset_document.h"

#include <vector>

namespace cradle {

/// Which circles are selected, and the edits that the scene offers for them. Every edit goes
/// through the document and can be undone; an impossible one is told by noticed() and not made.
class SceneEditor final : public QObject
{
    Q_OBJECT
public:
    explicit SceneEditor(PresetDocument &document, QObject *parent = nullptr);

    /// The circle that was selected last, which the inspector shows; -1: none.
    [[nodiscard]] int selected() const { return m_selected; }
    /// All that are selected, ascending; empty if selected() is -1.
    [[nodiscard]] const std::vector<int> &selection() const { return m_selection; }
    [[nodiscard]] bool isSelected(int index) const;
    [[nodiscard]] int circleCount() const;
    [[nodiscard]] const Preset &preset() const { return m_document.preset(); }
    [[nodiscard]] PresetDocument &document() const { return m_document; }

    /// Makes the edit if it has no fault; see PresetDocument::edit.
    bool commit(const QString &text, const Preset &changed, const QString &mergeKey = {});

public slots:
    void select(int index); ///< it alone; an index that is no circle selects none
    void toggle(int index); ///< selects it as well, or no longer
    void addToSelection(const std::vector<int> &indices); ///< the last of them becomes selected()
    void selectAll();
    void addCircle(cradle::Vec2 at); ///< at or near \p at, m; selects it
    void duplicateSelected();        ///< and selects the copies
    void removeSelected();
    void stopSelected();                 ///< sets their velocities to zero
    void nudgeSelected(cradle::Vec2 by); ///< m; only at the start of the run
    void copySelected();                 ///< to the clipboard, as they are at the start of the run
    void cutSelected();
    void paste(); ///< circles from the clipboard, at the nearest free places; selects them

signals:
    void selectionChanged(int index);
    void noticed(const QString &text); ///< why something was not done

private:
    void setSelection(std::vector<int> selection, int selected);
    void selectFrom(int first); ///< all from \p first on
    void keepSelectionValid();
    void noticeOverruled(const Preset &before);
    /// "circle 1" or "3 circles": what an edit is about, for its name in the menu.
    [[nodiscard]] QString subject() const;

    PresetDocument &m_document;
    std::vector<int> m_selection;
    int m_selected = -1;
};

} // namespace cradle

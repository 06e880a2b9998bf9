// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/preset_document.h"

#include <QWidget>

class QBoxLayout;
class QLabel;

namespace cradle {

class CirclesGroup;
class LawsGroup;
class WorldGroup;

/// Shows the preset as numbers and lists, and asks for edits of it. What cannot be is refused
/// with the reason at the foot of the pane.
class Inspector final : public QWidget
{
    Q_OBJECT
public:
    /// \param document  must outlive the inspector
    explicit Inspector(PresetDocument &document, QWidget *parent = nullptr);

    [[nodiscard]] int selected() const; ///< index of a circle; −1 if none is selected
    /// Where the scene edited is the step's own, there is none to go back to.
    void hideReset();

public slots:
    void select(int circle); ///< −1 selects none

signals:
    void selectionChanged(int circle);

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void makeLayout();
    void retranslate();
    void showRefusal(const Error &error);
    void showNotANumber(const QString &text);
    void clearRefusal();
    void showReadOnly();
    void showStartNote();
    void arrange();

    PresetDocument &m_document;
    WorldGroup *m_world = nullptr;
    LawsGroup *m_laws = nullptr;
    CirclesGroup *m_circles = nullptr;
    QBoxLayout *m_groups = nullptr; ///< World and Laws, then Circles
    QBoxLayout *m_top = nullptr;    ///< World and Laws
    QLabel *m_refusal = nullptr;
    QLabel *m_readOnly = nullptr;
    QLabel *m_startNote = nullptr;
};

} // namespace cradle

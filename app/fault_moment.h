// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/code_session.h"
#include "app/lab_place.h"
#include "app/reference_run.h"
#include "views/preset_document.h"

namespace cradle {

/// Shows the moment in which a check went wrong, with the run of the reference beside it.
class FaultMoment final : public QObject
{
    Q_OBJECT
public:
    /// \param place  whose open step has the reference; outlives this, as do the others
    FaultMoment(const LabPlace &place, PresetDocument &document, CodeSession &code);

    /// Whether the moment shown is the one that show() went to.
    [[nodiscard]] bool isShown() const;
    /// The run of the reference in the scene shown, some time after show(); null if there is none.
    [[nodiscard]] const std::shared_ptr<const Recording> &ghost() const { return m_ghost; }

public slots:
    void show(const cradle::CheckOutcome &outcome); ///< in the scene of that check
    void forgetGhost();                             ///< what is shown from now on is something else

signals:
    void ghostChanged();

private:
    void setGhost(std::shared_ptr<const Recording> ghost);

    const LabPlace &m_place;
    PresetDocument &m_document;
    CodeSession &m_code;
    ReferenceRun m_reference; ///< makes the ghost
    std::shared_ptr<const Recording> m_ghost;
    qint64 m_step = 0; ///< that show() went to
};

} // namespace cradle

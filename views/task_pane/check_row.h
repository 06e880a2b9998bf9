// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"

#include <QWidget>

class QPushButton;
class QToolButton;

namespace cradle {

/// Whether there is a moment at which to see what \p outcome found: a start value that is wrong
/// is no moment.
[[nodiscard]] bool hasMoment(const CheckOutcome &outcome);

/// The link that leads to the moment of an outcome.
[[nodiscard]] QPushButton *makeMomentLink();

/// One check of a report: a tick or a ring, its title, and if it failed what was observed, shown
/// on a click, which also leads to the moment.
class CheckRow final : public QWidget
{
    Q_OBJECT
public:
    explicit CheckRow(const CheckOutcome &outcome, QWidget *parent = nullptr);

signals:
    void showMoment(const cradle::CheckOutcome &outcome);

protected:
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    void addObserved(const CheckOutcome &outcome);

    CheckOutcome m_outcome;
    QToolButton *m_expand = nullptr; ///< of a failed check
};

} // namespace cradle

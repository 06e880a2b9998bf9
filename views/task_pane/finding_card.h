// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"

#include <QFrame>

class QToolButton;
class QVBoxLayout;

namespace cradle {

class FormulaRenderer;

/// One finding of a report: its headline, and below it, if it is open, what was measured and where
/// to look.
class FindingCard final : public QFrame
{
    Q_OBJECT
public:
    /// \param renderer  outlives the card; nullptr: it has its own
    FindingCard(const Finding &finding, bool open, FormulaRenderer *renderer,
                QWidget *parent = nullptr);

    /// Where more can be put below what is said, to be hidden with it.
    [[nodiscard]] QVBoxLayout *body() const { return m_body; }

private:
    QVBoxLayout *m_body = nullptr;
    QToolButton *m_expand = nullptr;
};

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"

#include <QLabel>

namespace cradle {

/// Why a program stopped, in amber, with its place before it; a click or Enter asks for that.
class ErrorLine final : public QLabel
{
    Q_OBJECT
public:
    explicit ErrorLine(QWidget *parent = nullptr);

    void setError(const ProgramError &error);

    /// "line 12, step 40: …", with as much of the place as is known.
    [[nodiscard]] static QString describe(const ProgramError &error);

signals:
    void clicked();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
};

} // namespace cradle

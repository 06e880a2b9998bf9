// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

#include <vector>

namespace cradle {

/// The numbers of the circles that a check or a remark looks at, as "1, 2".
class CirclesLine final : public QLineEdit
{
    Q_OBJECT
public:
    explicit CirclesLine(QWidget *parent = nullptr);

    /// \param circles  from 0; empty: not said, which means the first
    void showCircles(const std::vector<int> &circles);
    void retranslate();

signals:
    void circlesEdited(const std::vector<int> &circles);
    void refused(const QString &reason); ///< what was typed are no circles

private:
    void take();

    std::vector<int> m_circles;
};

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

#include <vector>

namespace cradle {

class RefusedTexts;

/// The numbers of the circles that a check or a remark looks at, as "1, 2".
class CirclesLine final : public QLineEdit
{
    Q_OBJECT
public:
    /// \param texts  keeps what is typed and names no circles
    CirclesLine(RefusedTexts &texts, QWidget *parent);

    /// \param circles  from 0; empty: not said, which means the first
    void showCircles(const std::vector<int> &circles);
    void retranslate();

signals:
    void circlesEdited(const std::vector<int> &circles);

private:
    void take();

    RefusedTexts &m_texts;
    std::vector<int> m_circles;
};

} // namespace cradle

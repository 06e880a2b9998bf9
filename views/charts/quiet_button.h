// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

QT_BEGIN_NAMESPACE
class QMenu;
QT_END_NAMESPACE

namespace cradle {

/// A small button that stands on a heading's line: muted text, which is filled when checked. Its
/// text may have symbols with a subscript like "p_x".
class QuietButton final : public QAbstractButton
{
    Q_OBJECT
public:
    explicit QuietButton(QWidget *parent = nullptr);

    /// Opens \p menu, a child of this, when it is clicked.
    /// \param arrow  whether the button has one, to say so
    void setMenu(QMenu *menu, bool arrow = true);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QMenu *m_menu = nullptr;
    bool m_hasArrow = false;
};

} // namespace cradle

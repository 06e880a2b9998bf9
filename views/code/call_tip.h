// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/code/completion.h"

#include <QFrame>

QT_BEGIN_NAMESPACE
class QLabel;
QT_END_NAMESPACE

namespace cradle {

/// A function's signature, with the argument that is being written, and what it does.
class CallTip final : public QFrame
{
    Q_OBJECT
public:
    explicit CallTip(QWidget *window);

    /// Shows \p call over \p place of the window, or below where there is no room.
    void showCall(const CallPlace &call, const QRect &place);
    [[nodiscard]] QString text() const; ///< as plain text

private:
    QLabel *m_signature;
    QLabel *m_doc;
    CallPlace m_call;
};

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/theme.h"

#include <QLabel>

namespace cradle {

/// A text of a card in several lines, which is no markup. \param kind  see setKind()
inline QLabel *makeCardLabel(const char *kind)
{
    auto *label = new QLabel;
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    setKind(label, kind);
    return label;
}

} // namespace cradle

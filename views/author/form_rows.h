// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_kinds.h"

#include <QList>

QT_BEGIN_NAMESPACE
class QComboBox;
class QFormLayout;
class QLabel;
class QScrollArea;
class QSplitter;
class QWidget;
QT_END_NAMESPACE

namespace cradle {

// What the author's forms have in common.

/// Captions at the left, fields that take the rest of the width.
[[nodiscard]] QFormLayout *makeFormRows();

/// Lays \p parts out side by side in all of \p whole; none can be folded away.
/// \param widths  px, to begin with
QSplitter *layOutSideBySide(QWidget *whole, const QList<QWidget *> &parts,
                            const QList<int> &widths);

/// \p widget where it scrolls.
[[nodiscard]] QScrollArea *scrolled(QWidget *widget);

/// A muted text of one or more lines.
[[nodiscard]] QLabel *makeMutedText(QWidget *parent);

/// Says what keeps an input from being taken, and is hidden while nothing does.
[[nodiscard]] QLabel *makeRefusal(QWidget *parent);
void showRefusal(QLabel *label, const QString &reason);

/// Marks a field whose input cannot be taken.
void markRefused(QWidget *field, bool refused);

/// Fills a list with the titles of kinds; its data are their names.
void fillKindList(QComboBox *list, const std::vector<KindInfo> &kinds);

} // namespace cradle

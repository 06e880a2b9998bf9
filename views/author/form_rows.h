// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "tasks/checks/check_kinds.h"

#include <QList>

QT_BEGIN_NAMESPACE
class QComboBox;
class QFormLayout;
class QLabel;
class QPlainTextEdit;
class QScrollArea;
class QSplitter;
class QToolButton;
class QWidget;
QT_END_NAMESPACE

namespace cradle {

class RefusedTexts;

// What the author's forms have in common.

/// A section heading, still without text.
[[nodiscard]] QLabel *makeHeading(QWidget *parent);

/// A flat button with the icon of that name, for a row beside a list. Its words come with
/// nameButton().
[[nodiscard]] QToolButton *makeIconButton(const QString &iconName, QWidget *parent);

/// The button's tooltip and accessible name; \p keys are told in the tooltip.
void nameButton(QToolButton *button, const QString &name, const QString &keys = {});

/// Captions at the left, fields that take the rest of the width.
[[nodiscard]] QFormLayout *makeFormRows();

/// A caption for \p field, which is made already; nameField() writes it.
QLabel *makeCaption(QWidget *field);

/// Adds \p field to a form, with a caption. \return that
QLabel *addField(QFormLayout *rows, QWidget *field);

/// Writes the caption of \p field, its tooltip, and its name for screen readers.
/// \param spoken  that name; empty: the caption
void nameField(QWidget *field, const QString &caption, const QString &tip = {},
               const QString &spoken = {});

/// Shows or hides \p field and its caption.
void showField(QWidget *field, bool visible);

/// \p parts beside or below each other; none can be folded away.
/// \param sizes  px, to begin with; empty: as the parts want it
[[nodiscard]] QSplitter *makeSplitter(Qt::Orientation orientation, const QList<QWidget *> &parts,
                                      const QList<int> &sizes);

/// Lays \p parts out side by side in all of \p whole; none can be folded away.
/// \param widths  px, to begin with
QSplitter *layOutSideBySide(QWidget *whole, const QList<QWidget *> &parts,
                            const QList<int> &widths);

/// \p widget where it scrolls.
[[nodiscard]] QScrollArea *scrolled(QWidget *widget);

/// The text of a file of the lab, to be written in; undo is the lab's. \param name  of the object
[[nodiscard]] QPlainTextEdit *makeFileText(const QString &name, QWidget *parent);

/// A muted text of one or more lines.
[[nodiscard]] QLabel *makeMutedText(QWidget *parent);

/// Says what keeps an input from being taken, and is hidden while nothing does.
[[nodiscard]] QLabel *makeRefusal(QWidget *parent);
/// The same, of what is refused in a form.
[[nodiscard]] QLabel *makeRefusal(const RefusedTexts &texts, QWidget *parent);
void showRefusal(QLabel *label, const QString &reason);

/// Marks a field whose input cannot be taken.
void markRefused(QWidget *field, bool refused);

/// Why \p id cannot be that of a check or a question; empty if it can.
[[nodiscard]] QString faultOfId(const QString &id);

/// What passing a check, or a right answer, is worth, as its line has it: 1 where that is empty.
[[nodiscard]] QString pointsText(double points);
/// \return an error that says what would be right
[[nodiscard]] Result<double> pointsFrom(const QString &text);

/// Fills a list with the titles of kinds; its data are their names.
void fillKindList(QComboBox *list, const std::vector<KindInfo> &kinds);

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/arrangement.h"

#include <QDialog>

QT_BEGIN_NAMESPACE
class QCheckBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;
QT_END_NAMESPACE

namespace cradle {

/// Asks how many circles a rack, a grid or a ring has, how large they are and how far apart. It
/// says how many that makes, and cannot be accepted while they find no place.
class ArrangementDialog final : public QDialog
{
    Q_OBJECT
public:
    ArrangementDialog(Arrangement::Pattern pattern, QWidget *parent);

    [[nodiscard]] Arrangement arrangement() const;

private:
    QSpinBox *addCount(const QString &caption, const char *name, int value);
    QDoubleSpinBox *addLength(const QString &caption, const char *name, double value, double least);
    void add(QWidget *field, const QString &caption, const char *name);
    void showResult();

    Arrangement::Pattern m_pattern;
    QFormLayout *m_form;
    QSpinBox *m_rows = nullptr;
    QSpinBox *m_columns = nullptr; ///< of a grid alone
    QDoubleSpinBox *m_radius = nullptr;
    QDoubleSpinBox *m_gap = nullptr;
    QCheckBox *m_striker = nullptr;
    QLabel *m_result = nullptr;
    QDialogButtonBox *m_buttons = nullptr;
};

} // namespace cradle

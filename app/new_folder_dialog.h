// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>

namespace cradle {

/// A name for a file or an id made of \p title: letters, digits and dashes.
[[nodiscard]] QString nameFrom(const QString &title);

/// Asks for a folder that a lab may be written into: a new one, or one in which nothing is, which
/// a QFileDialog for saving would open instead of taking it.
class NewFolderDialog final : public QFileDialog
{
    Q_OBJECT
public:
    NewFolderDialog(QWidget *parent, const QString &title);

    /// The one that was chosen.
    [[nodiscard]] QString folder() const;

protected:
    void accept() override;

private:
    [[nodiscard]] QString typed() const;
};

} // namespace cradle

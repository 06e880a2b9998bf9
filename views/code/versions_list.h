// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/workspace/version.h"

#include <QTreeWidget>

#include <vector>

namespace cradle {

/// A version with its program.
struct ShownVersion {
    Version version;
    QString text;
};

/// The versions of a program, a row each: when, what was found, and the first line that differs
/// from the version before.
class VersionsList final : public QTreeWidget
{
    Q_OBJECT
public:
    explicit VersionsList(QWidget *parent = nullptr);

    /// \param versions  the newest first
    void fill(const std::vector<ShownVersion> &versions);
    void retranslate();

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void fitColumns();
};

} // namespace cradle

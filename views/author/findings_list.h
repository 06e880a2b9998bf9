// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/author_document.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
QT_END_NAMESPACE

namespace cradle {

class RowsList;

/// What is wrong in the lab's files: the heading says that nothing is, or how much.
class FindingsList final : public QWidget
{
    Q_OBJECT
public:
    explicit FindingsList(AuthorDocument &document, QWidget *parent = nullptr);

    /// Whether there is a finding in a file of that step.
    [[nodiscard]] bool concernsStep(const QString &step) const;

signals:
    void chosen(const cradle::Error &finding); ///< its file below the lab's folder
    void shown();                              ///< others than before, perhaps

private:
    void reload();
    void retranslate();

    AuthorDocument &m_document;
    QLabel *m_heading;
    RowsList *m_list;
    std::vector<Error> m_findings;
};

} // namespace cradle

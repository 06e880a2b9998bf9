// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/author_document.h"

#include <QDialog>

#include <vector>

QT_BEGIN_NAMESPACE
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
QT_END_NAMESPACE

namespace cradle {

/// What lab.json says of the lab as a whole: its title in each language, version, id, and the
/// language that its texts are written in. All of it becomes one edit.
class LabDialog final : public QDialog
{
    Q_OBJECT
public:
    explicit LabDialog(AuthorDocument &document, QWidget *parent = nullptr);

    void accept() override; ///< stays open, and says why, if the edit cannot be made

private:
    struct Title {
        QString language;
        QLineEdit *line = nullptr;
    };

    void makeTitles(QFormLayout *form);
    void makeFields(QFormLayout *form);
    [[nodiscard]] Result<LabFiles> edited() const;

    AuthorDocument &m_document;
    QString m_ownLanguage;
    std::vector<Title> m_titles;
    QLineEdit *m_version = nullptr;
    QLineEdit *m_id = nullptr;
    QComboBox *m_language = nullptr;
    QLabel *m_refusal = nullptr;
};

} // namespace cradle

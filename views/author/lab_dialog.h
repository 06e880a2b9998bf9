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
/// language that its texts are written in. All of it becomes one edit; of a copy that is to be
/// made, whose progress must not be that of the original, it is the copy's.
class LabDialog final : public QDialog
{
    Q_OBJECT
public:
    enum class Purpose { Edit, Copy };

    LabDialog(AuthorDocument &document, Purpose purpose, QWidget *parent = nullptr);

    /// The files of the copy, once it was accepted.
    [[nodiscard]] const LabFiles &copy() const { return m_copy; }

    void accept() override; ///< stays open, and says why, if the edit cannot be made

private:
    struct Title {
        QString language;
        QLineEdit *line = nullptr;
    };

    void makeTitles(QFormLayout *form);
    void makeFields(QFormLayout *form);
    void nameCopy();
    [[nodiscard]] Result<LabFiles> edited() const;

    AuthorDocument &m_document;
    Purpose m_purpose;
    LabFiles m_copy{};
    QString m_oldId; ///< of the original
    QString m_ownLanguage;
    std::vector<Title> m_titles;
    QLineEdit *m_version = nullptr;
    QLineEdit *m_id = nullptr;
    QComboBox *m_language = nullptr;
    QLabel *m_refusal = nullptr;
};

} // namespace cradle

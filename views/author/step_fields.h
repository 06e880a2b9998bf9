// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/author_document.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QBoxLayout;
class QCheckBox;
class QHBoxLayout;
class QLineEdit;
QT_END_NAMESPACE

namespace cradle {

class ChoiceBox;

/// The short fields of a step, in a row or, with large texts, in two: its id, title and commit
/// message, who moves the circles, and whether it counts.
class StepFields final : public QWidget
{
    Q_OBJECT
public:
    explicit StepFields(AuthorDocument &document, QWidget *parent = nullptr);

    void reload(); ///< shows the open step

    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool event(QEvent *event) override;

private:
    void takeId();
    void takeFields(const QString &field); ///< that was typed into
    void retranslate();
    void arrange();

    AuthorDocument &m_document;
    QLineEdit *m_id;
    QLineEdit *m_title;
    QLineEdit *m_commit;
    QCheckBox *m_extra;
    ChoiceBox *m_moves;             ///< by the values of "moves"
    QHBoxLayout *m_first = nullptr; ///< what it is called
    QHBoxLayout *m_second = nullptr;
    QBoxLayout *m_rows = nullptr; ///< of both
    QString m_shownStep{};
};

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

QT_BEGIN_NAMESPACE
class QPushButton;
class QVBoxLayout;
QT_END_NAMESPACE

namespace cradle {

/// What was found, a row each below headings, with a button for the way from there.
class ProofRows final : public QScrollArea
{
    Q_OBJECT
public:
    explicit ProofRows(QWidget *parent = nullptr);

    [[nodiscard]] bool isEmpty() const;
    void clear();
    void addHeading(const QString &text);
    /// \param action  the text of the button; empty: none
    /// \return the button, or nullptr
    QPushButton *addRow(const QString &text, bool warning, const QString &action);

private:
    QVBoxLayout *m_rows; ///< and a stretch below them
};

} // namespace cradle

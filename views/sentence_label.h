// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace cradle {

/// A sentence under a table: in as many lines as it needs, or where there is no room for them in
/// one that is cut off, with the whole sentence as its tooltip.
class SentenceLabel final : public QLabel
{
    Q_OBJECT
public:
    explicit SentenceLabel(QWidget *parent = nullptr);

    void setSentence(const QString &sentence);
    /// Takes what it needs of a room of \p size px, at least one line.
    void fitInto(QSize size);

private:
    void fit();

    QString m_sentence;
    QSize m_room;
};

} // namespace cradle

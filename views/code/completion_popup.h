// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/code/api_words.h"

#include <QFrame>

QT_BEGIN_NAMESPACE
class QLabel;
class QListWidget;
class QListWidgetItem;
QT_END_NAMESPACE

namespace cradle {

/// A list of words to choose from, over the window and without the focus; below it the
/// documentation of the chosen one.
class CompletionPopup final : public QFrame
{
    Q_OBJECT
public:
    explicit CompletionPopup(QWidget *window);

    /// Shows \p words, the first chosen, beside \p place of the window.
    void showWords(const std::vector<ApiWord> &words, const QRect &place);
    void move(int rows);
    [[nodiscard]] int rowsOnPage() const;
    [[nodiscard]] QString chosen() const;
    [[nodiscard]] QStringList words() const;

signals:
    void accepted(); ///< by the mouse

private:
    void showDoc();

    QListWidget *m_list;
    QLabel *m_doc;
    std::vector<ApiWord> m_words;
};

/// Where a frame of \p size stands beside \p place in \p room: below or else above.
/// \param above  to be preferred
[[nodiscard]] QRect placeBeside(const QRect &place, QSize size, const QRect &room, bool above);

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

#include <limits>

QT_BEGIN_NAMESPACE
class QBoxLayout;
class QLabel;
class QToolButton;
QT_END_NAMESPACE

namespace cradle {

/// Rows without a frame, as all lists of the author's window look, with a button for each thing
/// that can be done with them. Alt+Up, Alt+Down and Delete press these, as far as they are enabled.
/// Its heading counts the rows.
class RowsList final : public QListWidget
{
    Q_OBJECT
public:
    enum Button { Add, Duplicate, Rename, Remove, Up, Down, ButtonCount };

    /// \param name  of the object
    /// \param buttons  that it has; they are shown where underHeading() or the owner puts them
    RowsList(const QString &name, QWidget *parent, std::initializer_list<Button> buttons = {});
    ~RowsList() override;

    /// nullptr if there is none.
    [[nodiscard]] QToolButton *button(Button which) const { return m_buttons[which]; }
    /// The words of the list in the language of the moment.
    /// \param name  for screen readers
    /// \param buttons  tooltips and names of its buttons; the keys that press them are added
    /// \param heading  "%1" in it is the number of rows
    void setTexts(const QString &name, std::initializer_list<std::pair<Button, QString>> buttons,
                  const QString &heading = {});
    /// Enables the buttons as long as there are no more rows than \p most and no fewer than
    /// \p fewest; none of them if the rows are not \p writable.
    void enableButtons(bool writable, int fewest = 0, int most = std::numeric_limits<int>::max());
    /// The heading with the buttons at its right, and the list below.
    [[nodiscard]] QBoxLayout *underHeading();
    /// Lets long texts take several lines.
    void wrapRows();

    /// Shows \p texts, and makes row \p current, or the last one there is, the current one; says
    /// nothing of it.
    void showRows(const QStringList &texts, int current);

signals:
    void chosen(int row); ///< by a click or Return
    void addRequested();
    void duplicateRequested();
    void renameRequested(); ///< also by F2, which does what it always does if nobody listens
    void removeRequested();
    void moveRequested(int from, int to);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void followRow();
    void showHeading();

    QLabel *m_heading = nullptr; ///< if it stands under one
    QString m_headingText;
    QToolButton *m_buttons[ButtonCount]{};
    bool m_writable = false;
    int m_fewest = 0;
    int m_most = 0;
};

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QAction;
class QLabel;
class QListView;
QT_END_NAMESPACE

namespace cradle {

class ConsoleDelegate;
class ConsoleModel;
class ErrorLine;
class FrameThrottle;

/// What a program has printed, line by line with the step that did, and below that why it stopped.
/// Its window title is the title of its tab, in the language.
class ConsoleView final : public QWidget
{
    Q_OBJECT
public:
    explicit ConsoleView(const Simulation &simulation, QWidget *parent = nullptr);

    /// The error that is shown, with its place; empty if there is none.
    [[nodiscard]] QString errorText() const;
    [[nodiscard]] QSize sizeHint() const override { return {344, 240}; }

public slots:
    void clear();         ///< hides what was printed so far, until the run starts again
    void copySelection(); ///< the selected lines
    void copyAll();       ///< and the error

signals:
    void lineActivated(int line);     ///< the error's line of the program was asked for
    void seekRequested(qint64 index); ///< a line was chosen: the frame that its step made
    void errorShown(bool shown);      ///< an error came, or went with its run: for a mark on a tab

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void begin();
    void refresh();
    void followMoment();
    void showError();
    void activateError();
    void seekLine(const QModelIndex &index);
    void retranslate();

    const Simulation &m_simulation;
    ConsoleModel *m_model;
    ConsoleDelegate *m_delegate;
    QListView *m_list;
    QLabel *m_empty; ///< in place of an empty list
    ErrorLine *m_error;
    QAction *m_seekAction;
    QAction *m_copyAction;
    QAction *m_copyAllAction;
    QAction *m_clearAction;
    FrameThrottle *m_throttle;
    bool m_follows = true;     ///< the moment shown, until the student scrolls away
    bool m_isUpdating = false; ///< what scrolls now is not the student
};

} // namespace cradle

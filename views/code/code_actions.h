// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

QT_BEGIN_NAMESPACE
class QAction;
class QMenu;
class QWidget;
QT_END_NAMESPACE

namespace cradle {

/// What can be done in the code pane, with the keys for it while the pane has the focus.
class CodeActions final : public QObject
{
    Q_OBJECT
public:
    explicit CodeActions(QWidget *pane);

    void retranslate();
    void fillMenu(QMenu *menu) const;
    void setSolutionAvailable(bool available);
    void setSolutionShown(bool shown);
    [[nodiscard]] bool isSolutionShown() const { return m_solutionShown; }

    QAction *run;
    QAction *stepLine;
    QAction *finishStep;
    QAction *afresh;
    QAction *solution;
    QAction *help;
    QAction *find;
    QAction *replace;
    QAction *findNext;
    QAction *findPrevious;
    QAction *zoomIn;
    QAction *zoomOut;
    QAction *zoomReset;

private:
    bool m_solutionAvailable = false;
    bool m_solutionShown = false;
};

} // namespace cradle

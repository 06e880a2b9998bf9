// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

#include <QStringList>
#include <QWidget>

#include <vector>

class QAction;
class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QSlider;

namespace cradle {

class ActionButton;

/// The row of controls above the scene: runs, steps and restarts the simulation, sets its speed,
/// shows the moment, and asks for a check. Its actions can be put into menus, too; the window
/// that holds them gives them their shortcuts.
class TransportBar final : public QWidget
{
    Q_OBJECT
public:
    /// \param simulation  must outlive the bar
    explicit TransportBar(Simulation &simulation, QWidget *parent = nullptr);

    [[nodiscard]] QAction *restartAction() const { return m_restart; }
    [[nodiscard]] QAction *stepBackAction() const { return m_stepBack; }
    [[nodiscard]] QAction *runAction() const { return m_run; } ///< Run or Pause
    [[nodiscard]] QAction *stepAction() const { return m_step; }
    [[nodiscard]] QAction *previousHitAction() const { return m_previousHit; }
    [[nodiscard]] QAction *nextHitAction() const { return m_nextHit; } ///< Next hit or Stop
    [[nodiscard]] QAction *slowerAction() const { return m_slower; }
    [[nodiscard]] QAction *fasterAction() const { return m_faster; }
    [[nodiscard]] QAction *checkAction() const { return m_check; } ///< Check or Stop

    /// The modes to choose from; no choice is shown for fewer than two.
    void setModes(const QStringList &titles, int current);
    /// Without Check where there is nothing to be checked.
    void setCheckShown(bool shown);

    [[nodiscard]] bool isChecking() const { return m_checking; }
    /// Wide enough for the controls without their texts.
    [[nodiscard]] QSize minimumSizeHint() const override;

public slots:
    void setChecking(bool checking);
    void setCheckProgress(double share); ///< 0 to 1

signals:
    void checkRequested();
    void checkCancelled();
    void modeChosen(int index);

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    static constexpr int progressRange = 1000;

    void makeActions();
    void makeLayout();
    void addReadout(QHBoxLayout *row);
    [[nodiscard]] QProgressBar *addProgress();
    void retranslate();
    void showRunning();
    void showMoment();
    void showSpeed();
    void showCheck();
    void showSearch();
    void spread();
    void setSpacing(int between, int beside);
    void relayout();
    void collapse();
    void turnOrder();
    void measureReadout();
    void setReadoutSize(double share);

    Simulation &m_simulation;
    QAction *m_restart = nullptr;
    QAction *m_stepBack = nullptr;
    QAction *m_run = nullptr;
    QAction *m_step = nullptr;
    QAction *m_previousHit = nullptr;
    QAction *m_nextHit = nullptr;
    QAction *m_slower = nullptr;
    QAction *m_faster = nullptr;
    QAction *m_check = nullptr;
    QHBoxLayout *m_order = nullptr;        ///< of what goes back and on in time
    std::vector<ActionButton *> m_buttons; ///< in the order in which they lose their text
    ActionButton *m_runButton = nullptr;
    ActionButton *m_checkButton = nullptr;
    ActionButton *m_nextHitButton = nullptr;
    QLabel *m_speedCaption = nullptr;
    QSlider *m_speed = nullptr;
    QLabel *m_speedValue = nullptr;
    QLabel *m_time = nullptr;
    QLabel *m_stepCount = nullptr;
    QWidget *m_modes = nullptr;
    QButtonGroup *m_modeGroup = nullptr;
    QProgressBar *m_progress = nullptr;       ///< of the check
    QProgressBar *m_searchProgress = nullptr; ///< of the search for the next hit
    double m_readoutSize = 1.0;               ///< of that of other texts
    bool m_checking = false;
};

} // namespace cradle

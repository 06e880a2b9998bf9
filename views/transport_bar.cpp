// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/transport_bar.h"

#include "views/action_button.h"
#include "views/shortcut_guard.h"
#include "views/theme.h"

#include <QAction>
#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QSlider>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

// The slider counts powers of two: −4 is 1/16, 3 is 8.
const int slowestPower = static_cast<int>(std::log2(Simulation::slowest));
const int fastestPower = static_cast<int>(std::log2(Simulation::fastest));

int powerOf(double speed)
{
    return static_cast<int>(std::lround(std::log2(speed)));
}

QString speedText(int power)
{
    return power < 0 ? QStringLiteral("1/%1×").arg(1 << -power)
                     : QStringLiteral("%1×").arg(1 << power);
}

} // namespace

TransportBar::TransportBar(Simulation &simulation, QWidget *parent)
    : QWidget(parent)
    , m_simulation(simulation)
{
    guardShortcuts();
    makeActions();
    makeLayout();
    retranslate();
    showRunning();
    showSpeed();
    showMoment();
    connect(&m_simulation, &Simulation::frameReady, this, &TransportBar::showMoment);
    connect(&m_simulation, &Simulation::runningChanged, this, &TransportBar::showRunning);
    connect(&m_simulation, &Simulation::searchingChanged, this, &TransportBar::showSearch);
    connect(&m_simulation, &Simulation::paceChanged, this, &TransportBar::showSpeed);
}

void TransportBar::makeActions()
{
    const auto make = [this](const QString &iconName, const QKeySequence &key) {
        auto *action = new QAction(icon(iconName), QString(), this);
        action->setShortcut(key);
        addAction(action);
        return action;
    };
    m_restart = make(QStringLiteral("restart"), Qt::Key_R);
    m_stepBack = make(QStringLiteral("step-back"), Qt::Key_Left);
    m_run = make(QStringLiteral("run"), Qt::Key_Space);
    m_step = make(QStringLiteral("step"), Qt::Key_Right);
    m_previousHit = make(QStringLiteral("previous-hit"), Qt::Key_P);
    m_nextHit = make(QStringLiteral("next-hit"), Qt::Key_N);
    m_slower = make({}, Qt::Key_BracketLeft);
    m_faster = make({}, Qt::Key_BracketRight);
    m_check = make(QStringLiteral("check"), Qt::CTRL | Qt::Key_Return);

    connect(m_restart, &QAction::triggered, &m_simulation, &Simulation::restart);
    connect(m_stepBack, &QAction::triggered, &m_simulation, &Simulation::stepBack);
    connect(m_run, &QAction::triggered, this,
            [this] { m_simulation.setRunning(!m_simulation.isRunning()); });
    connect(m_step, &QAction::triggered, &m_simulation, &Simulation::stepForward);
    connect(m_previousHit, &QAction::triggered, &m_simulation, &Simulation::seekPreviousHit);
    connect(m_nextHit, &QAction::triggered, &m_simulation, [this] {
        if (m_simulation.isSearching())
            m_simulation.pause();
        else
            m_simulation.seekNextHit();
    });
    connect(m_slower, &QAction::triggered, this,
            [this] { m_speed->setValue(m_speed->value() - 1); });
    connect(m_faster, &QAction::triggered, this,
            [this] { m_speed->setValue(m_speed->value() + 1); });
    connect(m_check, &QAction::triggered, this, [this] {
        if (m_checking)
            emit checkCancelled();
        else
            emit checkRequested();
    });
}

void TransportBar::addReadout(QHBoxLayout *row)
{
    m_speedCaption = new QLabel(this);
    setKind(m_speedCaption, "muted");
    m_speed = new QSlider(Qt::Horizontal, this);
    m_speed->setRange(slowestPower, fastestPower);
    m_speed->setPageStep(1);
    m_speed->setFocusPolicy(Qt::TabFocus);
    m_speedCaption->setBuddy(m_speed);
    m_speedValue = new QLabel(this);
    m_time = new QLabel(this);
    m_stepCount = new QLabel(this);
    m_stepCount->setFont(numericFont()); // before the style sheet takes hold of the label
    setKind(m_stepCount, "muted");
    for (QWidget *widget : {static_cast<QWidget *>(m_speedCaption), static_cast<QWidget *>(m_speed),
                            static_cast<QWidget *>(m_speedValue)})
        row->addWidget(widget);
    row->addSpacing(8);
    row->addWidget(m_time);
    row->addWidget(m_stepCount);
    connect(m_speed, &QSlider::valueChanged, this, [this](int power) {
        m_simulation.setSpeed(std::exp2(power));
        showSpeed();
    });
}

void TransportBar::setChecking(bool checking)
{
    m_checking = checking;
    m_progress->setValue(0);
    m_progress->setVisible(checking);
    showCheck();
}

void TransportBar::setCheckProgress(double share)
{
    m_progress->setValue(
        static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * progressRange)));
}

void TransportBar::showRunning()
{
    const bool running = m_simulation.isRunning();
    const QString name = running ? QStringLiteral("pause") : QStringLiteral("run");
    m_run->setIcon(icon(name));
    m_run->setText(running ? tr("Pause") : tr("Run"));
    m_runButton->setIconName(name, IconTint::OnAccent);
}

void TransportBar::setCheckShown(bool shown)
{
    m_checkButton->setVisible(shown);
    m_check->setEnabled(shown);
}

void TransportBar::showCheck()
{
    const QString name = m_checking ? QStringLiteral("stop") : QStringLiteral("check");
    m_check->setIcon(icon(name));
    m_check->setText(m_checking ? tr("Stop") : tr("Check"));
    m_check->setToolTip(m_checking ? tr("Stop the check") : tr("Check this step"));
    m_checkButton->setIconName(name, IconTint::OnAccent);
    collapse();
}

/// While it looks for the next hit the button ends that; so does all else that moves the run.
void TransportBar::showSearch()
{
    const bool searching = m_simulation.isSearching();
    const QString name = searching ? QStringLiteral("stop") : QStringLiteral("next-hit");
    m_nextHit->setIcon(icon(name));
    m_nextHit->setText(searching ? tr("Stop", "search") : tr("Next hit"));
    m_nextHit->setToolTip(searching ? tr("End the search and go back to where it began")
                                    : tr("Run on to the next collision"));
    m_nextHitButton->setIconName(name, IconTint::Text);
    m_searchProgress->setVisible(searching);
    collapse();
}

void TransportBar::showMoment()
{
    m_searchProgress->setValue(
        static_cast<int>(std::lround(m_simulation.searchedShare() * progressRange)));
    const qint64 step = m_simulation.recording().step(m_simulation.current());
    m_time->setText(tr("t = %1 s").arg(m_simulation.time(), 0, 'f', 3));
    m_stepCount->setText(tr("step %1").arg(step));
    const bool hasPast = m_simulation.current() > m_simulation.recording().first();
    m_stepBack->setEnabled(hasPast);
    m_previousHit->setEnabled(hasPast);
}

void TransportBar::showSpeed()
{
    const int power = powerOf(m_simulation.speed());
    const QSignalBlocker blocked(m_speed);
    m_speed->setValue(power);
    m_speedValue->setText(speedText(powerOf(m_simulation.pace())));
    m_slower->setEnabled(power > slowestPower);
    m_faster->setEnabled(power < fastestPower);
}

/// Room for the longest text, so that nothing jumps as the numbers grow.
void TransportBar::measureReadout()
{
    // Of a fixed height as well: a new text then leaves the layout of the window alone.
    const auto fix = [this](QLabel *label, const QString &longest) {
        // Arabic letters are not for columns: in a font for those they stand apart.
        QFont numbers = longest.isRightToLeft() ? font() : numericFont();
        numbers.setPointSizeF(m_readoutSize * font().pointSizeF());
        label->setFont(numbers);
        const QFontMetrics metrics(label->font());
        label->setFixedSize(metrics.horizontalAdvance(longest) + 4, metrics.height());
    };
    fix(m_speedValue, speedText(slowestPower));
    fix(m_time, tr("t = %1 s").arg(1000.0, 0, 'f', 3));
    fix(m_stepCount, tr("step %1").arg(100'000));
}

void TransportBar::setReadoutSize(double share)
{
    if (std::exchange(m_readoutSize, share) != share)
        measureReadout();
}

void TransportBar::retranslate()
{
    m_restart->setText(tr("Restart"));
    m_restart->setToolTip(tr("Back to the start of the run"));
    m_stepBack->setText(tr("Step back"));
    m_stepBack->setIconText(tr("Step", "back"));
    m_stepBack->setToolTip(tr("One step back"));
    m_step->setText(tr("Step"));
    m_step->setToolTip(tr("One step on"));
    m_run->setToolTip(tr("Run or pause"));
    m_previousHit->setText(tr("Previous hit"));
    m_previousHit->setToolTip(tr("Back to the collision before, or to the start"));
    m_slower->setText(tr("Slower"));
    m_faster->setText(tr("Faster"));
    m_speedCaption->setText(tr("Speed"));
    m_speed->setAccessibleName(tr("Speed"));
    m_speedValue->setAccessibleName(tr("Speed now"));
    m_speedValue->setToolTip(tr("How fast it goes now: slower around a hit, if that is chosen"));
    m_speed->setToolTip(tr("Simulated time per real time ([ slower, ] faster)"));
    m_time->setAccessibleName(tr("Time"));
    m_stepCount->setAccessibleName(tr("Steps since the start"));
    m_progress->setAccessibleName(tr("Progress of the check"));
    m_searchProgress->setAccessibleName(tr("Progress of the search for a hit"));
    m_runButton->setTexts({tr("Run"), tr("Pause")});
    m_nextHitButton->setTexts({tr("Next hit"), tr("Stop", "search")});
    m_checkButton->setTexts({tr("Check"), tr("Stop")});
    showRunning();
    showMoment();
    measureReadout();
    showSearch();
    showCheck();
}

void TransportBar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    collapse();
}

void TransportBar::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LayoutDirectionChange)
        turnOrder();
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        measureReadout();
        // A new style sheet comes to the labels after the bar, and gives them their old font.
        QTimer::singleShot(0, this, [this] {
            measureReadout();
            collapse();
        });
    }
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/announcer.h"

#include "views/scene/handles.h"
#include "views/values/hits_model.h"

#include <QAccessible>

#include <algorithm>
#include <chrono>
#include <utility>

namespace cradle {

namespace {

using namespace std::chrono_literals;

constexpr auto restAfterHit = 1500ms; ///< wall time: about what a sentence takes

QString sentenceOf(const Hit &hit, const Preset &scene)
{
    const QString other =
        hit.kind == Hit::Kind::Circle ? circleName(scene, hit.b) : wallName(hit.b);
    return Announcer::tr("Hit at %1 s: %2 and %3, impulse %4 N s")
        .arg(QString::number(hit.time, 'f', 3), circleName(scene, hit.a), other,
             QString::number(hit.impulse, 'g', 4));
}

} // namespace

Announcer::Announcer(QWidget *window)
    : QLabel(window)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setGeometry(0, 0, 1, 1);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restAfterHit);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        if (!m_pending.isEmpty())
            say(std::exchange(m_pending, {}));
    });
}

void Announcer::follow(const Simulation &simulation)
{
    m_simulation = &simulation;
    connect(&simulation, &Simulation::frameReady, this, &Announcer::sayHit);
}

/// The same words twice are two events: the name changes to nothing between them.
void Announcer::say(const QString &text)
{
    for (const QString &name : {QString(), text}) {
        setAccessibleName(name);
        if (name.isEmpty() || !QAccessible::isActive())
            continue;
        QAccessibleEvent alert(this, QAccessible::Alert);
        QAccessible::updateAccessibility(&alert);
    }
}

/// Costs a search among the contacts, and a sentence where one is new.
void Announcer::sayHit()
{
    const Recording &recording = m_simulation->recording();
    const qint64 step = recording.step(m_simulation->current());
    const bool running = m_simulation->isRunning();
    const qint64 before = running && m_step < step ? m_step : step - 1;
    const bool moved = std::exchange(m_step, step) != step;
    if (!m_saysHits || !moved)
        return;
    const auto &contacts = recording.encounters();
    const auto after =
        std::partition_point(contacts.begin(), contacts.end(),
                             [step](const Encounter &each) { return each.step <= step; });
    if (after == contacts.begin() || std::prev(after)->step <= before)
        return;
    const QString text = sentenceOf(recording.hitOf(*std::prev(after)), m_simulation->preset());
    if (running && m_rest.isActive()) {
        m_pending = text;
        return;
    }
    m_pending.clear();
    say(text);
    if (running)
        m_rest.start();
}

} // namespace cradle

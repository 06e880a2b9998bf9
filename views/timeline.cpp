// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/timeline.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <limits>

namespace cradle {

namespace {

int toInt(qint64 index)
{
    return static_cast<int>(std::min<qint64>(index, std::numeric_limits<int>::max()));
}

} // namespace

Timeline::Timeline(Simulation &simulation, QWidget *parent)
    : QAbstractSlider(parent)
    , m_simulation(simulation)
{
    setLayoutDirection(Qt::LeftToRight); // time goes as in the charts
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&simulation, &Simulation::frameReady, this, &Timeline::showFrame);
    connect(&simulation, &Simulation::programFailed, this, &Timeline::showFrame);
    connect(this, &QAbstractSlider::valueChanged, this, [this](int value) {
        if (!m_following)
            m_simulation.seek(value);
    });
    retranslate();
    showFrame();
}

void Timeline::retranslate()
{
    setAccessibleName(tr("Timeline"));
    setAccessibleDescription(tr("The step shown. Left and Right go a step, Page Up and Page Down "
                                "to the previous and the next hit."));
    setToolTip(tr("Drag to any moment"));
}

void Timeline::setMarks(std::vector<Mark> marks)
{
    m_marks = std::move(marks);
    update();
}

void Timeline::showFrame()
{
    const Recording &recording = m_simulation.recording();
    m_following = true;
    setRange(toInt(recording.first()), toInt(recording.last()));
    setValue(toInt(m_simulation.current()));
    m_following = false;
    update();
}

std::vector<Timeline::Mark> Timeline::recordedMarks() const
{
    const Recording &recording = m_simulation.recording();
    std::vector<Mark> recorded;
    if (const auto &error = m_simulation.programError())
        recorded.push_back({.time = recording.time(recording.last()),
                            .kind = Mark::Kind::Error,
                            .label = error->line > 0
                                         ? tr("program stopped in line %1").arg(error->line)
                                         : tr("program stopped")});
    std::copy_if(m_marks.begin(), m_marks.end(), std::back_inserter(recorded),
                 [&](const Mark &mark) { return mark.time <= recording.time(recording.last()); });
    return recorded;
}

double Timeline::xOf(double time) const
{
    const Recording &recording = m_simulation.recording();
    const double first = recording.time(recording.first());
    const double span = recording.time(recording.last()) - first;
    const double part = span > 0.0 ? (time - first) / span : 0.0;
    return bar().left() + std::clamp(part, 0.0, 1.0) * bar().width();
}

double Timeline::timeAt(double x) const
{
    const Recording &recording = m_simulation.recording();
    const double first = recording.time(recording.first());
    const double last = recording.time(recording.last());
    const double part = (x - bar().left()) / std::max(1.0, bar().width());
    return first + std::clamp(part, 0.0, 1.0) * (last - first);
}

void Timeline::seekTo(double x)
{
    const Recording &recording = m_simulation.recording();
    const double time = timeAt(x);
    qint64 index = recording.indexAt(time);
    // The nearest frame, so that both ends can be reached.
    if (index < recording.last() && recording.time(index + 1) - time < time - recording.time(index))
        ++index;
    m_simulation.seek(index);
}

void Timeline::seekHit(const Encounter &hit)
{
    const Recording &recording = m_simulation.recording();
    m_simulation.seek(recording.first() + hit.step - recording.step(recording.first()));
}

void Timeline::seekPreviousHit()
{
    m_simulation.seekPreviousHit();
}

void Timeline::seekFollowingHit()
{
    const auto &hits = m_simulation.recording().encounters();
    const qint64 step = m_simulation.recording().step(m_simulation.current());
    const auto hit = lastHit(hits, step);
    const std::size_t next = hit ? *hit + 1 : 0;
    if (next < hits.size())
        seekHit(hits[next]);
    else
        m_simulation.seek(m_simulation.recording().last());
}

void Timeline::keyPressEvent(QKeyEvent *event)
{
    const Recording &recording = m_simulation.recording();
    switch (event->key()) {
    case Qt::Key_Left:
        return m_simulation.seek(m_simulation.current() - 1);
    case Qt::Key_Right:
        return m_simulation.seek(m_simulation.current() + 1);
    case Qt::Key_Home:
        return m_simulation.seek(recording.first());
    case Qt::Key_End:
        return m_simulation.seek(recording.last());
    case Qt::Key_PageUp:
        return seekPreviousHit();
    case Qt::Key_PageDown:
        return seekFollowingHit();
    default:
        event->ignore();
    }
}

void Timeline::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    setSliderDown(true);
    seekTo(event->position().x());
}

void Timeline::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons() & Qt::LeftButton)
        seekTo(event->position().x());
}

void Timeline::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        setSliderDown(false);
}

void Timeline::wheelEvent(QWheelEvent *event)
{
    const int turned = event->angleDelta().y();
    if (turned == 0)
        return event->ignore();
    m_simulation.seek(m_simulation.current() + (turned > 0 ? -1 : 1));
    event->accept();
}

void Timeline::changeEvent(QEvent *event)
{
    QAbstractSlider::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    update();
}

} // namespace cradle

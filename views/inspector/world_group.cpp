// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/world_group.h"

#include "model/world/shortest_number.h"
#include "views/inspector/number_field.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QGridLayout>
#include <QLabel>

namespace cradle {

namespace {

constexpr int columnGap = 16; ///< px between two columns of fields

template <typename P>
auto &worldNumber(P &preset, int field)
{
    switch (field) {
    case 0:
        return preset.gravity.x;
    case 1:
        return preset.gravity.y;
    case 2:
        return preset.restitution;
    case 3:
        return preset.timestep;
    default:
        return preset.halfWidth;
    }
}

} // namespace

WorldGroup::WorldGroup(PresetDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    m_heading = new QLabel(this);
    m_heading->setFont(headingFont());
    setKind(m_heading, "heading");
    m_fields[GravityX] = new NumberField(QString(), 0.1, this);
    m_fields[GravityY] = new NumberField(QStringLiteral("m/s²"), 0.1, this);
    m_fields[Restitution] = new NumberField(QString(), 0.05, this);
    m_fields[Timestep] = new NumberField(QStringLiteral("s"), 0.0, this);
    m_fields[HalfWidth] = new NumberField(QStringLiteral("m"), 0.5, this);
    at(Restitution)->setSpinRange(0.0, 1.0);
    at(Timestep)->setSpin(NumberField::Spin::Double);
    at(Timestep)->setSpinRange(limits::minTimestep, limits::maxTimestep);
    for (int i = 0; i < FieldCount; ++i) {
        const auto field = static_cast<Field>(i);
        at(field)->setFont(numericFont());
        connect(at(field), &NumberField::valueProposed, this,
                [this, field](double v, bool spinning) { propose(field, v, spinning); });
        connect(at(field), &NumberField::notANumber, this, &WorldGroup::notANumber);
        connect(at(field), &NumberField::reverted, this, &WorldGroup::reverted);
    }
    m_seconds = new QLabel(this);
    setKind(m_seconds, "muted");
    const std::array<std::array<QWidget *, 2>, 4> pairs{{{at(GravityX), at(GravityY)},
                                                         {at(Timestep), m_seconds},
                                                         {at(Restitution), nullptr},
                                                         {at(HalfWidth), nullptr}}};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        m_cells[i] = new QWidget(this);
        auto *row = new QHBoxLayout(m_cells[i]);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(4);
        for (QWidget *widget : pairs[i]) {
            if (widget)
                row->addWidget(widget);
        }
        m_captions[i] = new QLabel(this);
        m_captions[i]->setBuddy(pairs[i][0]);
    }
    m_grid = new QGridLayout(this);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(8);
    m_grid->setVerticalSpacing(4);
    arrange(TwoColumns);
    keepTranslated(this, &WorldGroup::retranslate);
    reload();
    connect(&document.simulation(), &Simulation::presetChanged, this, &WorldGroup::reload);
    connect(&document, &PresetDocument::lockedChanged, this, &WorldGroup::reload);
}

NumberField *WorldGroup::at(Field field) const
{
    return m_fields[static_cast<std::size_t>(field)];
}

void WorldGroup::arrange(Arrangement arrangement)
{
    if (arrangement == m_arrangement)
        return;
    m_arrangement = arrangement;
    m_grid->addWidget(m_heading, 0, 0, 1, 5);
    // Row, column and span of each field.
    using Places = std::array<std::array<int, 3>, 4>;
    const Places rows{{{1, 0, 4}, {2, 0, 4}, {3, 0, 4}, {4, 0, 4}}};
    const Places narrow{{{1, 0, 4}, {2, 0, 4}, {3, 0, 1}, {3, 3, 1}}};
    const Places wide{{{1, 0, 1}, {2, 0, 1}, {1, 3, 1}, {2, 3, 1}}};
    const Places &places = arrangement == OwnRows ? rows : arrangement == OneColumn ? narrow : wide;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto [row, column, span] = places[i];
        m_grid->addWidget(m_captions[i], row, column);
        m_grid->addWidget(m_cells[i], row, column + 1, 1, span);
    }
    m_grid->setColumnMinimumWidth(2, arrangement == TwoColumns ? columnGap - 8 : 0);
    m_grid->setRowStretch(4, arrangement == OwnRows ? 0 : 1);
}

int WorldGroup::twoColumnWidth() const
{
    const auto width = [](const auto *widget) { return widget->sizeHint().width(); };
    const auto column = [&](std::size_t a, std::size_t b) {
        return std::max(width(m_captions[a]), width(m_captions[b]))
               + std::max(width(m_cells[a]), width(m_cells[b])) + 8;
    };
    return column(0, 1) + column(2, 3) + columnGap;
}

void WorldGroup::retranslate()
{
    m_heading->setText(tr("World"));
    m_captions[0]->setText(tr("Gravity"));
    m_captions[2]->setText(tr("Restitution e"));
    m_captions[1]->setText(tr("Timestep"));
    m_captions[3]->setText(tr("Half width"));
    m_captions[0]->setToolTip(tr("Acceleration of every circle, to the right and upward"));
    m_captions[2]->setToolTip(tr("From 0, no rebound, to 1, elastic"));
    m_captions[1]->setToolTip(tr("Up doubles it, Down halves it; 1/240 can be typed"));
    m_captions[3]->setToolTip(tr("From the middle of the square to a wall"));
    at(GravityX)->setAccessibleName(tr("Gravity to the right, m/s²"));
    at(GravityY)->setAccessibleName(tr("Gravity upward, m/s²"));
    at(Restitution)->setAccessibleName(tr("Restitution e"));
    at(Timestep)->setAccessibleName(tr("Timestep, s"));
    at(HalfWidth)->setAccessibleName(tr("Half width of the square, m"));
}

void WorldGroup::reload()
{
    const Preset &preset = m_document.preset();
    for (int i = 0; i < FieldCount; ++i)
        at(static_cast<Field>(i))->setValue(worldNumber(preset, i));
    showLocks();
    const bool fraction = fractionOrNumber(preset.timestep).contains(QLatin1Char('/'));
    m_seconds->setText(fraction ? tr("= %1 s").arg(preset.timestep, 0, 'g', 3) : QString());
}

void WorldGroup::showLocks()
{
    const QString names[] = {QStringLiteral("gravity"), QStringLiteral("gravity"),
                             QStringLiteral("restitution"), QStringLiteral("timestep"),
                             QStringLiteral("half_width")};
    for (int i = 0; i < FieldCount; ++i) {
        const QString why = m_document.whyLocked(names[i]);
        at(static_cast<Field>(i))->setEnabled(why.isEmpty());
        if (!why.isEmpty())
            at(static_cast<Field>(i))->setToolTip(why);
    }
}

void WorldGroup::propose(Field field, double value, bool spinning)
{
    const QString texts[] = {tr("Change gravity"), tr("Change gravity"), tr("Change restitution"),
                             tr("Change timestep"), tr("Change half width")};
    Preset changed = m_document.preset();
    worldNumber(changed, field) = value;
    if (field == HalfWidth && changed != m_document.preset())
        changed.fill.reset(); // its circles belong to the old square
    const QString key = spinning ? QStringLiteral("spin:/world/%1").arg(int{field}) : QString();
    if (m_document.edit(texts[field], changed, key))
        at(field)->setValue(worldNumber(m_document.preset(), field));
    else
        at(field)->setRefused(true);
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/values/values_tab.h"

#include "views/hit_columns.h"
#include "views/number_text.h"
#include "views/sentence_label.h"
#include "views/theme.h"
#include "views/values/deviation_text.h"
#include "views/values/hits_model.h"
#include "views/values/number_table.h"
#include "views/values/values_model.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr int cellPad = 8;     ///< px left and right of a number together
constexpr int headerSpare = 6; ///< px that a title may lack of its usual room
constexpr int mostSpare = 16;  ///< px between two columns where there is room
constexpr int massPlaces = 7;  ///< characters of a mass

} // namespace

ValuesTab::ValuesTab(const Simulation &simulation, QWidget *parent)
    : QWidget(parent)
    , m_simulation(simulation)
    , m_model(new ValuesModel(simulation, this))
    , m_table(makeNumberTable(m_model, ValuesModel::unitRole))
    , m_sentence(new SentenceLabel)
    , m_exact(new SentenceLabel)
{
    setKind(m_sentence, "muted");
    setKind(m_exact, "muted");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(m_table, 1);
    column->addWidget(m_sentence);
    column->addWidget(m_exact);
    column->addStretch();
    connect(m_model, &QAbstractItemModel::modelReset, this, &ValuesTab::fit);
    fit();
}

void ValuesTab::reload()
{
    m_model->reload();
}

void ValuesTab::refresh()
{
    const int first = std::max(0, m_table->rowAt(0));
    const int below = m_table->rowAt(m_table->viewport()->height() - 1);
    m_model->refresh(first, below >= 0 ? below : m_model->rowCount() - 1);
    const QString exact = describeDeviation(m_simulation);
    m_exact->setSentence(exact);
    m_exact->setVisible(!exact.isEmpty());
    m_sentence->setSentence(hitSentence());
    fitSentences();
}

QString ValuesTab::hitSentence() const
{
    const Recording &recording = m_simulation.recording();
    const qint64 shown = m_simulation.current();
    const auto hit = lastHit(recording.encounters(), recording.step(shown));
    if (!hit)
        return tr("No hit so far.");
    const qint64 number = recording.droppedEncounters() + static_cast<qint64>(*hit) + 1;
    const Encounter &contact = recording.encounters()[*hit];
    // What has not happened yet at the moment shown is not told.
    const double until = std::min(contact.endTime, recording.time(shown));
    return contact.lasts() && recording.step(shown) > contact.step
               ? describeEncounter(number, recording.hitOf(contact), until)
               : describeHit(number, recording.hitOf(contact), recording.circles(shown));
}

void ValuesTab::fit()
{
    // Room for the usual numbers, so that widths rest while numbers change.
    const double figure = QFontMetricsF(columnFont()).horizontalAdvance(u'0');
    const auto widthOf = [&](int column) {
        const int places = column <= ValuesModel::Speed  ? ValuesModel::narrowPlaces
                           : column == ValuesModel::Mass ? massPlaces
                                                         : ValuesModel::widePlaces;
        const int title = m_table->horizontalHeader()->sectionSizeHint(column) - headerSpare;
        return std::max(title, static_cast<int>(std::ceil(places * figure)) + cellPad);
    };
    const int columns = m_model->columnCount();
    int needed = m_table->verticalHeader()->sizeHint().width() + cellPad;
    for (int column = 0; column < columns; ++column)
        needed += widthOf(column);
    // What is left over keeps them apart.
    const int spare = std::clamp((width() - needed) / columns, 0, mostSpare);
    for (int column = 0; column < columns; ++column)
        m_table->setColumnWidth(column, widthOf(column) + spare);
    fitHeights();
}

void ValuesTab::fitHeights()
{
    const int bar = m_table->horizontalScrollBar()->sizeHint().height();
    // The viewport has not its width yet when the pane is resized.
    const int needed =
        m_table->verticalHeader()->sizeHint().width() + m_table->horizontalHeader()->length();
    const bool scrolls = needed > width();
    const int rows = m_table->verticalHeader()->length();
    const int header = m_table->horizontalHeader()->sizeHint().height();
    m_table->setMaximumHeight(header + rows + (scrolls ? bar : 0));
    m_table->setMinimumHeight(
        std::min(m_table->maximumHeight(), header + scaledByText(numberRowHeight)));
    fitSentences();
}

void ValuesTab::fitSentences()
{
    const QSize tab = size();
    const int room = tab.height() - m_table->maximumHeight();
    m_exact->fitInto({tab.width(), room});
    m_sentence->fitInto({tab.width(), room - (m_exact->isHidden() ? 0 : m_exact->height())});
}

void ValuesTab::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fit();
}

void ValuesTab::retranslate()
{
    m_table->setAccessibleName(tr("Values of the circles at the moment shown"));
    m_sentence->setAccessibleName(tr("Last hit"));
    m_exact->setAccessibleName(tr("Distance from the exact motion"));
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sentence_label.h"

#include <QFontMetrics>

#include <algorithm>

namespace cradle {

namespace {

constexpr int sidePad = 14;     ///< px
constexpr int sentencePad = 10; ///< px above and below
constexpr int shortPad = 3;     ///< px above and below where room is scarce

} // namespace

SentenceLabel::SentenceLabel(QWidget *parent)
    : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void SentenceLabel::setSentence(const QString &sentence)
{
    if (sentence == m_sentence)
        return;
    m_sentence = sentence;
    fit();
}

void SentenceLabel::fitInto(QSize size)
{
    if (size == m_room)
        return;
    m_room = size;
    fit();
}

void SentenceLabel::fit()
{
    const QFontMetrics metrics(font());
    const int width = std::max(1, m_room.width() - 2 * sidePad);
    const QRect column(0, 0, width, 100 * metrics.lineSpacing());
    const int needed = metrics.boundingRect(column, Qt::TextWordWrap, m_sentence).height();
    const bool fits = needed + 2 * shortPad <= m_room.height();
    const QString line = metrics.elidedText(m_sentence, Qt::ElideRight, width);
    const int spare = (m_room.height() - needed) / 2;
    const int room = fits ? std::min(spare, sentencePad) : shortPad;
    setWordWrap(fits);
    setContentsMargins(sidePad, room, sidePad, room);
    setText(fits ? m_sentence : line);
    setToolTip(fits || line == m_sentence ? QString() : m_sentence);
    setFixedHeight((fits ? needed : metrics.lineSpacing()) + 2 * room);
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/notice_bar.h"

#include "views/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace cradle {

NoticeBar::NoticeBar(QWidget *parent)
    : QFrame(parent)
    , m_label(new QLabel(this))
    , m_close(new QPushButton(this))
{
    setObjectName(QStringLiteral("noticeBar"));
    setKind(this, "card");
    m_label->setWordWrap(true);
    m_label->setTextFormat(Qt::PlainText);
    setKind(m_close, "link");
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(12, 0, 8, 0);
    m_label->setContentsMargins(0, 4, 0, 4); // of the label: letters may reach into them
    row->addWidget(m_label, 1);
    row->addWidget(m_close);
    connect(m_close, &QPushButton::clicked, this, &NoticeBar::closeFirst);
    retranslate();
    hide();
}

void NoticeBar::showNotice(const QString &text, const std::vector<Offer> &offers)
{
    m_notice = {text, offers};
    showFirst();
}

void NoticeBar::clearNotice()
{
    m_notice = {};
    showFirst();
}

void NoticeBar::warn(const QString &text, const std::vector<Offer> &offers)
{
    const bool waits = std::any_of(m_warnings.begin(), m_warnings.end(),
                                   [&](const Notice &each) { return each.text == text; });
    if (!waits)
        m_warnings.push_back({text, offers});
    showFirst();
}

void NoticeBar::retract(const QString &text)
{
    std::erase_if(m_warnings, [&](const Notice &each) { return each.text == text; });
    showFirst();
}

void NoticeBar::closeFirst()
{
    if (m_warnings.empty())
        m_notice = {};
    else
        m_warnings.erase(m_warnings.begin());
    showFirst();
}

void NoticeBar::showFirst()
{
    for (QPushButton *button : m_buttons) {
        button->hide(); // it goes later, and would stand beside the new ones until then
        button->deleteLater();
    }
    m_buttons.clear();
    const Notice &first = m_warnings.empty() ? m_notice : m_warnings.front();
    m_label->setText(first.text);
    // Warnings name files. What can be selected has the tops of tall letters cut off.
    m_label->setTextInteractionFlags(m_warnings.empty() ? Qt::NoTextInteraction
                                                        : Qt::TextSelectableByMouse);
    for (const Offer &offer : first.offers)
        addButton(offer);
    // What is only offered is closed by taking it.
    m_close->setVisible(!m_warnings.empty() || first.offers.empty());
    setVisible(!first.text.isEmpty());
}

void NoticeBar::addButton(const Offer &offer)
{
    auto *button = new QPushButton(offer.name, this);
    setKind(button, "link");
    auto *row = static_cast<QHBoxLayout *>(layout());
    row->insertWidget(row->count() - 1, button);
    // The offer goes with the notice, which is closed before it is done: it may say something new.
    connect(button, &QPushButton::clicked, this, [this, act = offer.act] {
        const auto done = act;
        closeFirst();
        done();
    });
    m_buttons.push_back(button);
    button->show();
}

QString NoticeBar::text() const
{
    return m_label->text();
}

void NoticeBar::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QFrame::changeEvent(event);
}

void NoticeBar::retranslate()
{
    setAccessibleName(tr("Notice"));
    m_close->setText(tr("Got it"));
}

} // namespace cradle

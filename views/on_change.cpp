// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/on_change.h"

#include <QWidget>

#include <algorithm>
#include <vector>

namespace cradle {

namespace {

class ChangeFilter final : public QObject
{
public:
    ChangeFilter(QWidget *widget, std::initializer_list<QEvent::Type> kinds,
                 const std::function<void()> &answer)
        : QObject(widget)
        , m_kinds(kinds)
        , m_answer(answer)
    {
        widget->installEventFilter(this);
    }

    bool eventFilter(QObject *, QEvent *event) override
    {
        if (std::find(m_kinds.begin(), m_kinds.end(), event->type()) != m_kinds.end())
            m_answer();
        return false;
    }

private:
    std::vector<QEvent::Type> m_kinds;
    std::function<void()> m_answer;
};

} // namespace

void onChange(QWidget *widget, std::initializer_list<QEvent::Type> kinds,
              const std::function<void()> &answer)
{
    new ChangeFilter(widget, kinds, answer);
}

} // namespace cradle

// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/fitted_tabs.h"

#include "views/style_sheet.h"

#include <QApplication>
#include <QEvent>
#include <QFontMetrics>
#include <QScopedValueRollback>
#include <QTabBar>
#include <QTabWidget>

#include <algorithm>

namespace cradle {

namespace {

constexpr double finest = 0.5; ///< points by which titles become smaller

} // namespace

FittedTabs::FittedTabs(QTabBar &bar, Distance distance)
    : QObject(&bar)
    , m_bar(bar)
    , m_distance(distance)
{
    bar.setElideMode(Qt::ElideNone);
    bar.setUsesScrollButtons(true);
    bar.installEventFilter(this);
    if (qobject_cast<QTabWidget *>(bar.parentWidget()))
        bar.parentWidget()->installEventFilter(this);
    fit();
}

/// Over its pages a bar is only as wide as its tabs are.
int FittedTabs::room() const
{
    const auto *pages = qobject_cast<const QTabWidget *>(m_bar.parentWidget());
    if (!pages)
        return m_bar.width();
    int width = pages->width();
    for (const Qt::Corner corner : {Qt::TopLeftCorner, Qt::TopRightCorner}) {
        if (const QWidget *beside = pages->cornerWidget(corner))
            width -= beside->sizeHint().width();
    }
    return width;
}

FittedTabs::Grounds FittedTabs::grounds() const
{
    Grounds all{.titles = {}, .room = room(), .font = QApplication::font(&m_bar)};
    for (int tab = 0; tab < m_bar.count(); ++tab)
        all.titles.append(m_bar.tabText(tab));
    return all;
}

int FittedTabs::widthOf(const QStringList &titles, const QFont &font)
{
    const QFontMetrics metrics(font);
    int width = 0;
    for (const QString &title : titles)
        width += metrics.size(Qt::TextShowMnemonic, title).width();
    return width;
}

void FittedTabs::fit()
{
    const QScopedValueRollback fitting(m_fitting, true);
    m_fitted = grounds();
    const auto &[titles, room, full] = m_fitted;
    const auto padding = [count = static_cast<int>(titles.size())](int aside) {
        return 2 * aside * count;
    };
    const bool isNarrow =
        m_distance == Distance::Narrow || widthOf(titles, full) + padding(tabPadding) > room;
    const double least = full.pointSizeF() / textScale();
    QFont font = full;
    while (isNarrow && widthOf(titles, font) + padding(narrowTabPadding) > room
           && font.pointSizeF() > least)
        font.setPointSizeF(std::max(least, font.pointSizeF() - finest));
    const QLatin1String kind(isNarrow ? "narrow" : "");
    if (m_bar.property("kind").toString() != kind) {
        setKind(&m_bar, kind.data());
        QEvent changed(QEvent::StyleChange); // else it keeps the widths of its tabs
        QCoreApplication::sendEvent(&m_bar, &changed);
    }
    if (m_bar.font().pointSizeF() != font.pointSizeF())
        m_bar.setFont(font);
}

/// A bar tells nobody of a new title; it paints it.
bool FittedTabs::eventFilter(QObject *watched, QEvent *event)
{
    const bool mayChange = event->type() == QEvent::Resize || event->type() == QEvent::FontChange
                           || event->type() == QEvent::StyleChange
                           || event->type() == QEvent::Paint;
    if (!mayChange || m_fitting)
        return QObject::eventFilter(watched, event);
    const bool isOtherFont = event->type() == QEvent::FontChange; // a new style gives it its own
    if (isOtherFont || grounds() != m_fitted) {
        if (event->type() == QEvent::Resize)
            fit();
        else
            QMetaObject::invokeMethod(this, &FittedTabs::fit, Qt::QueuedConnection);
    }
    return QObject::eventFilter(watched, event);
}

} // namespace cradle

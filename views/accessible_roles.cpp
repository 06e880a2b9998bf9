// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/accessible_roles.h"

#include "views/markdown_view.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QHash>

namespace cradle {

namespace {

/// What a widget shows stands in its description; a screen reader asks for it as a value, too.
class ShownValue final : public QAccessibleWidget
{
public:
    using QAccessibleWidget::QAccessibleWidget;

    /// What it is made of is nothing to go into.
    int childCount() const override { return 0; }

    QString text(QAccessible::Text kind) const override
    {
        return kind == QAccessible::Value ? widget()->accessibleDescription()
                                          : QAccessibleWidget::text(kind);
    }
};

/// A text with formulas, which Qt would tell as U+FFFC.
class SpokenText final : public QAccessibleWidget
{
public:
    explicit SpokenText(MarkdownView *view)
        : QAccessibleWidget(view, QAccessible::StaticText)
        , m_view(view)
    {
    }

    QString text(QAccessible::Text kind) const override
    {
        if (kind == QAccessible::Value)
            return m_view->spokenText();
        const QString said = QAccessibleWidget::text(kind);
        if (kind != QAccessible::Name)
            return said;
        return said.isEmpty() ? m_view->spokenText()
                              : QStringLiteral("%1. %2").arg(said, m_view->spokenText());
    }

private:
    MarkdownView *m_view;
};

QAccessibleInterface *makeInterface(const QString &className, QObject *object)
{
    static const QHash<QString, QAccessible::Role> roles{
        {QStringLiteral("cradle::SceneView"), QAccessible::Canvas},
        {QStringLiteral("cradle::ChartPlot"), QAccessible::Chart},
        {QStringLiteral("cradle::PhasePlot"), QAccessible::Chart},
        {QStringLiteral("cradle::SpeedPlot"), QAccessible::Chart},
        {QStringLiteral("cradle::Announcer"), QAccessible::AlertMessage},
        {QStringLiteral("cradle::StepDots"), QAccessible::List},
    };
    if (className == QLatin1String("cradle::MarkdownView"))
        return new SpokenText(static_cast<MarkdownView *>(object));
    const auto role = roles.constFind(className);
    return role != roles.constEnd() ? new ShownValue(static_cast<QWidget *>(object), *role)
                                    : nullptr;
}

} // namespace

void installAccessibleRoles()
{
    QAccessible::installFactory(makeInterface);
}

} // namespace cradle

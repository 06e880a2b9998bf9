// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/circles_line.h"

#include <QRegularExpression>

namespace cradle {

namespace {

constexpr int mostCircles = 100;

QString textOf(const std::vector<int> &circles)
{
    QStringList numbers;
    for (const int circle : circles)
        numbers.append(QString::number(circle + 1));
    return numbers.join(QStringLiteral(", "));
}

} // namespace

CirclesLine::CirclesLine(QWidget *parent)
    : QLineEdit(parent)
{
    setPlaceholderText(QStringLiteral("1"));
    connect(this, &QLineEdit::editingFinished, this, &CirclesLine::take);
}

void CirclesLine::showCircles(const std::vector<int> &circles)
{
    m_circles = circles;
    if (text() != textOf(circles))
        setText(textOf(circles));
}

void CirclesLine::take()
{
    std::vector<int> circles;
    static const QRegularExpression between(QStringLiteral("[,;\\s]+"));
    for (const QString &part : text().split(between, Qt::SkipEmptyParts)) {
        bool ok = false;
        const int circle = part.toInt(&ok);
        if (!ok || circle < 1 || circle > mostCircles) {
            showCircles(m_circles);
            emit refused(tr("Circles: numbers from 1 to 100 as “1, 2” are right"));
            return;
        }
        circles.push_back(circle - 1);
    }
    if (circles == m_circles)
        return;
    m_circles = circles;
    emit circlesEdited(circles);
}

void CirclesLine::retranslate()
{
    setAccessibleName(tr("Circles that it looks at"));
    setToolTip(tr("Numbers of the circles, as “1, 2”"));
}

} // namespace cradle

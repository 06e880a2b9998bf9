// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/circles_line.h"

#include "views/author/form_rows.h"
#include "views/author/refused_texts.h"

#include <QRegularExpression>

namespace cradle {

namespace {

constexpr int mostNumbered = 100;

QString textOf(const std::vector<int> &circles)
{
    QStringList numbers;
    for (const int circle : circles)
        numbers.append(QString::number(circle + 1));
    return numbers.join(QStringLiteral(", "));
}

} // namespace

CirclesLine::CirclesLine(RefusedTexts &texts, QWidget *parent)
    : QLineEdit(parent)
    , m_texts(texts)
{
    setPlaceholderText(QStringLiteral("1"));
    connect(this, &QLineEdit::editingFinished, this, &CirclesLine::take);
}

void CirclesLine::showCircles(const std::vector<int> &circles)
{
    m_circles = circles;
    m_texts.show(this, textOf(circles));
}

void CirclesLine::take()
{
    std::vector<int> circles;
    static const QRegularExpression between(QStringLiteral("[,;\\s]+"));
    for (const QString &part : text().split(between, Qt::SkipEmptyParts)) {
        bool ok = false;
        const int circle = part.toInt(&ok);
        if (!ok || circle < 1 || circle > mostNumbered) {
            m_texts.judge(this, textOf(m_circles),
                          tr("Circles: numbers from 1 to 100 as “1, 2” are right"));
            return;
        }
        circles.push_back(circle - 1);
    }
    m_texts.judge(this, {}, {});
    if (circles == m_circles)
        return;
    m_circles = circles;
    emit circlesEdited(circles);
}

void CirclesLine::retranslate()
{
    nameField(this, tr("Circles"), tr("Numbers of the circles, as “1, 2”"),
              tr("Circles that it looks at"));
}

} // namespace cradle

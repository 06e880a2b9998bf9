// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/keys_dialog.h"

#include "views/focus_ring.h"

#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Tables of Qt are not mirrored: where one reads from the right, so are the cells put in.
QString rowOf(QStringList cells)
{
    if (QGuiApplication::isRightToLeft())
        std::reverse(cells.begin(), cells.end());
    return QStringLiteral("<tr>%1</tr>").arg(cells.join(QString()));
}

/// Keys stand beside what they do; what the mouse does takes more words, and stands below it.
QString htmlOf(const KeyTable &table)
{
    constexpr qsizetype widest = 24; // letters
    const QString cell = QStringLiteral("<td style='white-space: nowrap'>%1</td>");
    const QString wide = QStringLiteral("<td colspan='2' style='white-space: nowrap'>%1</td>");
    const QString space = QStringLiteral("&nbsp;&nbsp;");
    QString text;
    for (const auto &[what, how] : table.rows) {
        const QString name = what.toHtmlEscaped();
        const QString keys = QStringLiteral("<b>%1</b>").arg(how.toHtmlEscaped());
        text += how.size() > widest ? rowOf({wide.arg(name)}) + rowOf({wide.arg(space + keys)})
                                    : rowOf({cell.arg(name + space), cell.arg(keys)});
    }
    const QString direction = QGuiApplication::isRightToLeft() ? QStringLiteral("rtl") : QString();
    return QStringLiteral("<p><b>%1</b></p><table dir='%3'>%2</table>")
        .arg(table.title.toHtmlEscaped(), text, direction);
}

} // namespace

KeysDialog::KeysDialog(const std::vector<std::vector<KeyTable>> &columns, QWidget *parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Keyboard shortcuts"));
    QStringList cells;
    for (const std::vector<KeyTable> &column : columns) {
        QString tables;
        for (const KeyTable &table : column)
            tables += htmlOf(table);
        cells << QStringLiteral("<td>%1</td><td>&nbsp;&nbsp;</td>").arg(tables);
    }
    auto *page = new QTextBrowser(this);
    page->setAccessibleName(windowTitle());
    page->setFrameShape(QFrame::NoFrame);
    page->setTabChangesFocus(true);
    ringFocus(page);
    page->setHtml(QStringLiteral("<table>%1</table>").arg(rowOf(cells)));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(page, 1);
    layout->addWidget(buttons);

    QTextDocument &text = *page->document();
    text.setTextWidth(text.idealWidth());
    const QSize whole(static_cast<int>(std::ceil(text.idealWidth())),
                      static_cast<int>(std::ceil(text.size().height())));
    const QMargins margins = layout->contentsMargins();
    const int bar = page->verticalScrollBar()->sizeHint().width();
    const QSize wanted(whole.width() + margins.left() + margins.right() + bar,
                       whole.height() + margins.top() + margins.bottom() + bar + layout->spacing()
                           + buttons->sizeHint().height());
    resize(parent ? wanted.boundedTo(parent->size()) : wanted);
}

/// Where one reads from the right, the first column stands there.
void KeysDialog::showEvent(QShowEvent *event)
{
    QDialog::showEvent(event);
    QScrollBar *bar = findChild<QTextBrowser *>()->horizontalScrollBar();
    bar->setValue(isRightToLeft() ? bar->maximum() : bar->minimum());
}

} // namespace cradle

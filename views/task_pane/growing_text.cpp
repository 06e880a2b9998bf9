// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/growing_text.h"

#include <QAbstractTextDocumentLayout>
#include <QTextBrowser>

#include <cmath>

namespace cradle {

/// Makes \p view as high as its text, so that what is around it scrolls.
void growWithText(QTextBrowser *view)
{
    view->setFrameShape(QFrame::NoFrame);
    view->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QObject::connect(view->document()->documentLayout(),
                     &QAbstractTextDocumentLayout::documentSizeChanged, view,
                     [view](const QSizeF &size) {
                         view->setFixedHeight(static_cast<int>(std::ceil(size.height())) + 2);
                     });
}

} // namespace cradle

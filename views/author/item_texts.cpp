// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/item_texts.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>

namespace cradle {

void setItemTexts(QComboBox &box, const QStringList &texts)
{
    for (int i = 0; i < texts.size(); ++i) {
        if (i >= box.count())
            box.addItem(texts[i]);
        box.setItemText(i, texts[i]);
    }
    // Qt 6.4 works the least width out once, and anew only for another style.
    QEvent changed(QEvent::StyleChange);
    QCoreApplication::sendEvent(&box, &changed);
    box.updateGeometry();
}

} // namespace cradle

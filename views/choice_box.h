// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace cradle {

/// A list that opens, as wide as its longest choice in whatever language and size of texts. Qt
/// keeps the least width that the choices had when it was first asked for.
class ChoiceBox : public QComboBox
{
public:
    explicit ChoiceBox(QWidget *parent = nullptr)
        : QComboBox(parent)
    {
        setSizeAdjustPolicy(AdjustToContents);
    }

    /// Writes \p texts as the items, which keep what they hold; the choice stays.
    void setTexts(const QStringList &texts)
    {
        for (int i = 0; i < texts.size(); ++i) {
            if (i < count())
                setItemText(i, texts[i]);
            else
                addItem(texts[i]);
        }
    }

    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace cradle

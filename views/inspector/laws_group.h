// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/preset_document.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QGridLayout;
class QLabel;

namespace cradle {

/// The laws of a preset: what walls and circles do on a hit, and how its moment is found.
class LawsGroup final : public QWidget
{
    Q_OBJECT
public:
    explicit LawsGroup(PresetDocument &document, QWidget *parent = nullptr);

    enum Arrangement {
        Column,       ///< below each other, the name beside each
        HeadedColumn, ///< the same, with the heading at the left: a line less
        Row,          ///< beside each other, the name above each
        OwnRows       ///< below each other, the name above each: the narrowest
    };
    void arrange(Arrangement arrangement);
    [[nodiscard]] int columnWidth() const;       ///< px that a column of them needs
    [[nodiscard]] int headedColumnWidth() const; ///< px
    [[nodiscard]] int rowWidth() const;          ///< px that a row of them needs

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void retranslate();
    void reload();
    void choose(const QString &text, const Laws &laws);

    PresetDocument &m_document;
    QGridLayout *m_grid = nullptr;
    std::optional<Arrangement> m_arrangement{};
    QLabel *m_heading = nullptr;
    QLabel *m_captions[3] = {};
    QComboBox *m_walls = nullptr;
    QComboBox *m_circles = nullptr;
    QComboBox *m_timing = nullptr;
};

} // namespace cradle
